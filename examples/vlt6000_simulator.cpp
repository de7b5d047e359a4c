// SPDX-License-Identifier: MIT
//
// A Danfoss VLT 6000 HVAC on a serial device, or on a pseudo-terminal that it opens and names:
//
//     vlt6000_simulator --address 1 --link /tmp/drive &
//     vlt6000_control --device /tmp/drive --address 1 start 50%
//
// The first line it prints is the path of the device; then a line whenever its status word, a relay or a line of its
// display changes. What is typed works the drive: `vlt6000_simulator --help`.
#include "support/arguments.hpp"
#include "support/fc_line.hpp"
#include "support/keyboard.hpp"
#include "support/line_server.hpp"
#include "support/vlt6000_drive.hpp"

#include <drivecodec/text/drives/vlt6000/words.hpp>

#include <array>
#include <chrono>
#include <csignal>
#include <iostream>
#include <optional>
#include <sstream>
#include <string>

namespace fc      = drivecodec::fc;
namespace vlt6000 = drivecodec::vlt6000;

namespace {

using line_options = support::line_options<support::fc_line>;
using line_server  = support::line_server<support::fc_line>;

std::sig_atomic_t volatile trip_signal  = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)
std::sig_atomic_t volatile mains_signal = 0;  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

constexpr auto usual_alarm   = vlt6000::alarm_word::of(vlt6000::alarm_word::overcurrent);
constexpr auto usual_warning = vlt6000::warning_word::of(vlt6000::warning_word::voltage_warning_high);

/// The terminal with this number, or nothing.
std::optional<drivecodec::flag<vlt6000::digital_inputs>> find_terminal(std::string const& number)
{
    using inputs = vlt6000::digital_inputs;
    static constexpr struct {
        std::string_view         number;
        drivecodec::flag<inputs> input;
    } rows[] = {{"16", inputs::terminal_16}, {"17", inputs::terminal_17}, {"18", inputs::terminal_18},
                {"19", inputs::terminal_19}, {"27", inputs::terminal_27}, {"29", inputs::terminal_29},
                {"32", inputs::terminal_32}, {"33", inputs::terminal_33}};
    for (auto const& row : rows) {
        if (row.number == number) { return row.input; }
    }
    return std::nullopt;
}

/// The drive as the slave `own` on a line, in real time.
class line_drive {
public:
    line_drive(fc::address own, support::vlt6000_drive::settings const& chosen) : own_{own}, drive_{chosen} {}

    [[nodiscard]] drivecodec::bytes answer(fc::frame const& found, drivecodec::mutable_bytes room)
    {
        if (not drive_.speaks_fc()) { return {}; }
        auto const reply = fc::serve(own_, found, room, drive_);
        tell();
        return reply;
    }

    void hear(drivecodec::dropped_bytes const&) {}

    void go_on()
    {
        if (std::exchange(trip_signal, 0) != 0) { drive_.trip(usual_alarm); }
        if (std::exchange(mains_signal, 0) != 0) { drive_.power_cycle(); }
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
        std::string        bits;
        words >> word >> bits;
        try {
            auto const number = [&](std::uint32_t usual) {
                return bits.empty() ? usual : support::to<std::uint32_t>(bits);
            };
            if (word == "t") {
                drive_.trip(vlt6000::alarm_word::from_raw(number(usual_alarm.raw)));
            } else if (word == "w") {
                drive_.warn(vlt6000::warning_word::from_raw(number(usual_warning.raw)));
            } else if (word == "c") {
                drive_.warn({});
            } else if (word == "p") {
                drive_.power_cycle();
            } else if (word == "l") {
                drive_.toggle_local();
            } else if (auto const terminal = find_terminal(word)) {
                drive_.toggle(*terminal);
            }
        } catch (support::usage_error const& fault) {
            std::cerr << fault.what() << '\n';
        }
    }

    /// What changed.
    void tell()
    {
        auto const tell_if_new = [](auto& told, auto const& now, auto const& text) {
            if (told == now) { return; }
            told = now;
            std::cout << text() << std::endl;
        };
        std::array<char, 300> room;
        tell_if_new(told_status_, drive_.status(), [&] { return describe(told_status_, room); });
        tell_if_new(told_relays_[0], drive_.relay_1(), [&] { return told_relays_[0] ? "relay 1 on" : "relay 1 off"; });
        tell_if_new(told_relays_[1], drive_.relay_2(), [&] { return told_relays_[1] ? "relay 2 on" : "relay 2 off"; });
        for (std::size_t i = 0; i < told_lines_.size(); ++i) {
            tell_if_new(told_lines_.at(i), drive_.line(i), [&] { return "display: " + told_lines_.at(i); });
        }
    }

    fc::address                own_;
    support::vlt6000_drive     drive_;
    clock::time_point          last_ = clock::now();
    vlt6000::status_word       told_status_{};
    std::array<bool, 2>        told_relays_{};
    std::array<std::string, 2> told_lines_{};
    support::keyboard          keyboard_;
};

//=== the command line ===//

constexpr auto usage = R"(
  --eeprom FILE     keeps what is written to EEPROM; without it, it is lost at the end
  --terminals LIST  that are closed, as 18,27 (27); 27 open is a coasting stop
  --terminal-19-brakes
                    terminal 19 is DC braking inverse, not reversing)";

constexpr auto typed = R"(
What is typed, each with Enter:
  t [BITS]   a trip: the bits of the alarm word, as 0x1000, overcurrent, which is also taken without them
  w [BITS]   warnings: the bits of the warning word; 0x2000, voltage warning high, without them
  c          no warnings any more
  p          mains off and on: what was written to RAM only is lost
  l          the OFF/STOP key, and the Auto key: no control word is obeyed while it is off
  16 ... 33  opens or closes a terminal
SIGUSR1 is a trip too, SIGUSR2 mains off and on. Ctrl-C ends it.
)";

struct options {
    line_options                     line;
    support::fc_address_options      address;
    support::vlt6000_drive::settings drive;
};

vlt6000::digital_inputs to_terminals(std::string const& list)
{
    vlt6000::digital_inputs closed;
    std::istringstream      numbers{list};
    for (std::string number; std::getline(numbers, number, ',');) {
        auto const terminal = find_terminal(number);
        if (not terminal) { throw support::usage_error{"'" + number + "' is not a terminal, such as 27"}; }
        closed = closed.with(*terminal);
    }
    return closed;
}

/// The code of parameter 502.
std::int32_t to_baud_code(std::uint32_t baud)
{
    for (auto const code : vlt6000::baud_rate_codes) {
        if (bits_per_second(static_cast<vlt6000::baud_rate>(code)) == baud) { return code; }
    }
    throw support::usage_error{"the drive has 300, 600, 1200, 2400, 4800 and 9600 baud"};
}

options parse(support::arguments words)
{
    options given;
    while (not words.empty()) {
        auto const word  = words.next("an option");
        auto const value = [&] { return words.next("the value of " + word); };
        if (given.line.take(word, words) or given.address.take(word, words)) { continue; }
        if (word == "--eeprom") {
            given.drive.eeprom = value();
        } else if (word == "--terminals") {
            given.drive.closed = to_terminals(value());
        } else if (word == "--terminal-19-brakes") {
            given.drive.terminal_19_brakes = true;
        } else {
            throw support::usage_error{"unknown option '" + word + "'"};
        }
    }
    given.drive.address   = given.address.number;
    given.drive.baud_code = to_baud_code(given.line.line.baud);
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
    out << "usage: vlt6000_simulator [options]\n"
        << support::fc_address_options::usage << usage << line_options::usage() << '\n'
        << typed;
}

}  // namespace

int main(int argc, char** argv)
{
    support::stop_signal::listen();
    listen(SIGUSR1, [](int) { trip_signal = 1; });
    listen(SIGUSR2, [](int) { mains_signal = 1; });
    try {
        auto const     given = parse({argc, argv});
        auto const     own   = given.address.address();
        line_drive     drive{own, given.drive};
        line_server    server{given.line, own};
        constexpr auto idle = 10'000;  // microseconds: how often the output frequency is reckoned anew
        server.run(drive, idle);
        return 0;
    } catch (support::help_wanted) {
        print_usage(std::cout);
        return 0;
    } catch (support::usage_error const& fault) {
        std::cerr << "vlt6000_simulator: " << fault.what() << '\n';
        print_usage(std::cerr);
    } catch (std::exception const& fault) {
        std::cerr << "vlt6000_simulator: " << fault.what() << '\n';
    }
    return 2;
}
