// SPDX-License-Identifier: MIT
//
// A Lenze / AC Tech smd on a serial device, or on a pseudo-terminal that it opens and names:
//
//     smd_simulator --address 5 --link /tmp/drive &
//     smd_control --device /tmp/drive --address 5 start 41.2
//
// The first line it prints is the path of the device; then a line whenever its status or its locks change. What is
// typed works the drive: `smd_simulator --help`. What the manual leaves open: support/smd_drive.hpp.
#include "support/arguments.hpp"
#include "support/keyboard.hpp"
#include "support/line_server.hpp"
#include "support/smd_drive.hpp"
#include "support/smd_line.hpp"

#include <drivecodec/text/drives/smd/parameters.hpp>

#include <chrono>
#include <csignal>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>

namespace rtu = drivecodec::modbus::rtu;
namespace smd = drivecodec::smd;

namespace {

using line_options = support::line_options<support::smd_line>;
using line_server  = support::line_server<support::smd_line>;

std::sig_atomic_t volatile fault_signal = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
std::sig_atomic_t volatile mains_signal = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

constexpr auto usual_fault = smd::fault::thermal_overload;

/// The drive in real time, on a line that has one format.
class line_drive {
public:
    line_drive(support::smd_drive::settings const& chosen, smd::serial_format format) : drive_{chosen}, format_{format}
    {}

    [[nodiscard]] drivecodec::bytes answer(rtu::frame const& found, drivecodec::mutable_bytes room)
    {
        if (drive_.format() != format_) { return {}; }
        auto const reply = drive_.answer_frame(found, room);
        tell();
        return reply;
    }

    void hear(drivecodec::dropped_bytes const&) {}

    void go_on()
    {
        if (std::exchange(fault_signal, 0) != 0) { drive_.trip(usual_fault); }
        if (std::exchange(mains_signal, 0) != 0) { drive_.power_up(); }
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
        while (auto const line = keyboard_.next()) { obey(*line); }
    }

    void obey(std::string const& line)
    {
        std::istringstream words{line};
        std::string        word;
        std::string        number;
        words >> word >> number;
        try {
            if (word == "f") {
                auto const code = number.empty() ? usual_fault : smd::fault{support::to<std::uint8_t>(number, 1, 26)};
                drive_.trip(code);
            } else if (word == "a") {
                drive_.set_analog_input(support::to<int>(number, 0, 240));
            } else if (word == "28") {
                drive_.toggle_terminal_28();
            } else if (word == "e1" or word == "e2" or word == "e3") {
                drive_.toggle_input(static_cast<std::size_t>(word[1] - '1'));
            } else if (word == "b") {
                drive_.set_busy(not drive_.is_busy());
            } else if (word == "p") {
                drive_.power_up();
            }
        } catch (support::usage_error const& fault) {
            std::cerr << fault.what() << '\n';
        }
    }

    /// What changed; of the speeds, loads and sources only what the operational status says of them.
    void tell()
    {
        auto const  now = drive_.status();
        std::string text{to_string(now.operational_status)};
        if (now.fault != smd::fault::no_fault) {
            std::array<char, 100>   room{};
            drivecodec::text_writer out{room};
            write_text(out, now.fault);
            text.append(": ").append(out.view());
        } else {
            text.append(" ").append(to_string(now.commanded_direction));
        }
        text.append(", ").append(unlocked());
        if (not drive_.speaks_modbus()) { text.append(", no Modbus by C01"); }
        if (text == told_) { return; }
        told_ = std::move(text);
        std::cout << told_ << std::endl;
    }

    [[nodiscard]] std::string_view unlocked() const
    {
        switch (drive_.lock_state()) {
        case smd::lock_state::locked: return "locked";
        case smd::lock_state::control: return "control unlocked";
        case smd::lock_state::parameters: return "parameters unlocked";
        case smd::lock_state::both: return "control and parameters unlocked";
        }
        return {};
    }

    support::smd_drive drive_;
    smd::serial_format format_;
    clock::time_point  last_ = clock::now();
    std::string        told_;
    support::keyboard  keyboard_;
};

//=== the command line ===//

constexpr auto usage = R"(usage: smd_simulator [options]
  --address N       C09, the drive's address, 1 to 247 (1)
  --version V       its registers: pv400 or pv507 (pv507)
  --control-mode N  C01, 0 to 11 (11): Modbus controls the drive with 10 and 11, and only sees it with 8 and 9
  --password N      C94, 0 to 999 (0)
  --open            terminal 28 is open: the drive does not start)";

constexpr auto typed = R"(
What is typed, each with Enter:
  f [CODE]   a fault, 1 to 26; 5, thermal overload, without CODE
  28         opens or closes terminal 28: open it stops the motor, closing it resets a fault
  e1 e2 e3   raises or lowers a digital input, which does what CE1 to CE3 say
  a HZ       the speed that the analog input stands for
  b          busy, and no longer: exception 06
  p          mains off and on
SIGUSR1 is a fault too, SIGUSR2 mains off and on. Ctrl-C ends it.
)";

struct options {
    line_options                 line;
    support::smd_drive::settings drive;
};

smd::version to_version(std::string const& word)
{
    if (word == "pv400") { return smd::pv400; }
    if (word == "pv507") { return smd::pv507; }
    throw support::usage_error{"'" + word + "' is none of pv400, pv507"};
}

options parse(support::arguments words)
{
    options given;
    while (not words.empty()) {
        auto const word = words.next("an option");
        if (given.line.take(word, words)) { continue; }
        auto const value = [&] { return words.next("the value of " + word); };
        if (word == "--address") {
            given.drive.link.address = *smd::network_address::make(support::to<std::uint8_t>(value(), 1, 247));
        } else if (word == "--version") {
            given.drive.version = to_version(value());
        } else if (word == "--control-mode") {
            given.drive.control_mode = smd::control_mode{support::to<std::uint16_t>(value(), 0, 11)};
        } else if (word == "--password") {
            given.drive.password = support::to<std::uint16_t>(value(), 0, smd::largest_password);
        } else if (word == "--open") {
            given.drive.terminal_28_closed = false;
        } else {
            throw support::usage_error{"unknown option '" + word + "'"};
        }
    }
    given.drive.link.format = given.line.line.code();
    return given;
}

void listen(int number, void (*handler)(int))
{
    struct sigaction action {};
    action.sa_handler = handler;
    sigaction(number, &action, nullptr);
}

void print_usage(std::ostream& out)
{
    out << usage << line_options::usage() << '\n' << typed;
}

}  // namespace

int main(int argc, char** argv)
{
    support::stop_signal::listen();
    listen(SIGUSR1, [](int) { fault_signal = 1; });
    listen(SIGUSR2, [](int) { mains_signal = 1; });
    try {
        auto const     given = parse({argc, argv});
        line_drive     drive{given.drive, given.drive.link.format};
        line_server    server{given.line, given.drive.link.address};
        constexpr auto idle = 5'000;  // microseconds: how often the motor's speed and the watchdog are looked at
        server.run(drive, idle);
        return 0;
    } catch (support::help_wanted) {
        print_usage(std::cout);
        return 0;
    } catch (support::usage_error const& fault) {
        std::cerr << "smd_simulator: " << fault.what() << '\n';
        print_usage(std::cerr);
    } catch (std::exception const& fault) {
        std::cerr << "smd_simulator: " << fault.what() << '\n';
    }
    return 2;
}
