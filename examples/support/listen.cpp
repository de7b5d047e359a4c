// SPDX-License-Identifier: MIT
#include "listen.hpp"

#include "serial_port.hpp"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <system_error>

namespace support {

namespace {

std::sig_atomic_t volatile& stopped()
{
    static volatile std::sig_atomic_t flag = 0;
    return flag;
}

void stop(int)
{
    stopped() = 1;
}

}  // namespace

void stop_on_signals()
{
    struct sigaction action {};  // without SA_RESTART: a read(2) that waits comes back
    action.sa_handler = stop;    // NOLINT(cppcoreguidelines-pro-type-union-access)
    static_cast<void>(sigaction(SIGINT, &action, nullptr));
    static_cast<void>(sigaction(SIGTERM, &action, nullptr));
}

bool is_stopped()
{
    return stopped() != 0;
}

timestamp time_now()
{
    using namespace std::chrono;
    static auto const began_at = system_clock::now().time_since_epoch();
    static auto const began    = steady_clock::now();
    return static_cast<timestamp>(duration_cast<microseconds>(began_at + (steady_clock::now() - began)).count());
}

void listen(line_options const& line, std::uint32_t usual_baud, ear& to, std::function<void()> const& each_turn)
{
    constexpr std::uint32_t patience = 200'000;  // to look at `is_stopped` on a line without traffic

    auto const baud = line.baud.value_or(usual_baud);
    auto       port = serial_port::open_to_listen(line.device, baud, line.format);
    if (not port) {
        auto const reason = errno == EINVAL ? std::string{"not a baud rate of this device"}
                                            : std::error_code{errno, std::generic_category()}.message();
        throw usage_error{"cannot open " + line.device + " with " + std::to_string(baud) + " baud: " + reason};
    }
    auto const silence = line.silence_at(baud);

    stop_on_signals();
    to.hear_nothing(time_now());
    std::array<std::uint8_t, 256> room;
    for (auto is_silent = true; not is_stopped();) {
        auto const is_idle  = is_silent and not to.is_waiting_for_response();
        auto const received = port->read(room, is_idle ? patience : silence);
        if (not received) { break; }
        is_silent = *received == 0;
        if (is_silent) {
            to.hear_nothing(time_now());
        } else {
            to.hear(drivecodec::bytes{room}.first(*received), time_now());
        }
        each_turn();
    }
    to.hear_nothing(time_now());
}

}  // namespace support
