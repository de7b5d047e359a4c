// SPDX-License-Identifier: MIT
//
// A Lauritz Knudsen xD1000 drive on a serial device, or on a pseudo-terminal that it opens and names:
//
//     xd1000_simulator --address 2 --link /tmp/drive &
//     xd1000_control --device /tmp/drive --address 2 start 50.0
//
// The first line it prints is the path of the device; then a line whenever its state changes. Keys, each with Enter: f
// for a fault, s for the STOP key, l for local and remote. SIGUSR1 is a fault too. It ends with Ctrl-C.
#include "support/arguments.hpp"
#include "support/keyboard.hpp"
#include "support/line_server.hpp"
#include "support/rtu_line.hpp"
#include "support/xd1000_drive.hpp"

#include <drivecodec/text/cia402.hpp>

#include <chrono>
#include <csignal>
#include <iostream>
#include <string>

namespace rtu = drivecodec::modbus::rtu;

namespace {

using line_options = support::line_options<support::rtu_line>;
using line_server  = support::line_server<support::rtu_line>;

std::sig_atomic_t volatile fault_signal = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// The drive as the server `own` on a line, in real time.
class line_drive {
public:
    line_drive(rtu::server_address own, support::xd1000_drive::settings chosen) : own_{own}, drive_{chosen} {}

    [[nodiscard]] drivecodec::bytes answer(rtu::frame const& found, drivecodec::mutable_bytes room)
    {
        auto const is_ours = found.address() == own_.byte() or found.address() == 0;
        if (is_ours and found.direction == drivecodec::modbus::direction::request) { drive_.hear(); }
        auto const reply = rtu::serve(own_, found, room, drive_);
        tell();
        return reply;
    }

    void hear(drivecodec::dropped_bytes const&) {}

    void go_on()
    {
        if (fault_signal != 0) {
            fault_signal = 0;
            drive_.fault();
        }
        read_keys();
        auto const now = clock::now();
        drive_.go_on(now - last_);
        last_ = now;
        tell();
    }

private:
    using clock = std::chrono::steady_clock;

    void read_keys()
    {
        while (auto const line = keyboard_.next()) {
            for (auto const key : *line) {
                if (key == 'f') { drive_.fault(); }
                if (key == 's') { drive_.press_stop(); }
                if (key == 'l') { drive_.toggle_local(); }
            }
        }
    }

    void tell()
    {
        if (drive_.state() == told_) { return; }
        told_ = drive_.state();
        std::cout << to_string(told_) << std::endl;
    }

    rtu::server_address       own_;
    support::xd1000_drive     drive_;
    clock::time_point         last_ = clock::now();
    drivecodec::cia402::state told_ = drivecodec::cia402::state::not_ready_to_switch_on;
    support::keyboard         keyboard_;
};

//=== the command line ===//

constexpr auto usage = R"(usage: xd1000_simulator [options]
  --address N       the drive's address, 1 to 247 (1)
  --pole-pairs N    of the motor (2)
  --ignore-time-out parameter 611 is 00: silence is no fault)";

constexpr rtu::server_address default_address{1};

struct options {
    line_options                    line;
    rtu::server_address             address = default_address;
    support::xd1000_drive::settings drive;
};

options parse(support::arguments words)
{
    options given;
    while (not words.empty()) {
        auto const word = words.next("an option");
        if (given.line.take(word, words)) { continue; }
        auto const value = [&] { return words.next("the value of " + word); };
        if (word == "--address") {
            given.address = *rtu::server_address::make(support::to<std::uint8_t>(value(), 1, 247));
        } else if (word == "--pole-pairs") {
            given.drive.pole_pairs = support::to<unsigned>(value(), 1, 100);
        } else if (word == "--ignore-time-out") {
            given.drive.ignores_time_out = true;
        } else {
            throw support::usage_error{"unknown option '" + word + "'"};
        }
    }
    return given;
}

}  // namespace

int main(int argc, char** argv)
{
    support::stop_signal::listen();
    struct sigaction action {};
    action.sa_handler = [](int) { fault_signal = 1; };
    sigaction(SIGUSR1, &action, nullptr);
    try {
        auto const     given = parse({argc, argv});
        line_drive     drive{given.address, given.drive};
        line_server    server{given.line, given.address};
        constexpr auto idle = 10'000;  // microseconds: how often the motor's speed is reckoned anew
        server.run(drive, idle);
        return 0;
    } catch (support::help_wanted) {
        std::cout << usage << line_options::usage() << '\n';
        return 0;
    } catch (support::usage_error const& fault) {
        std::cerr << "xd1000_simulator: " << fault.what() << '\n' << usage << line_options::usage() << '\n';
    } catch (std::exception const& fault) {
        std::cerr << "xd1000_simulator: " << fault.what() << '\n';
    }
    return 2;
}
