// SPDX-License-Identifier: MIT
//
// Who says what on a Modbus RTU or FC line, live or recorded, and how well it goes: `bus_monitor --help`.
#include "support/bus_monitor.hpp"
#include "support/arguments.hpp"
#include "support/listen.hpp"
#include "support/recorded_line.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <system_error>

#include <sys/ioctl.h>
#include <unistd.h>

namespace {

constexpr auto usage =
    R"(Shows what is said on a line of drives, in Modbus RTU or the FC protocol, and counts by address. It only listens.

    bus_monitor [options] --device PATH    a serial device or pseudo-terminal, until Ctrl-C
    bus_monitor [options] [FILE]           a recorded file, or standard input: lines of hexadecimal; # begins a comment

    --drive 5=smd      the drive at this address: xd1000, vlt6000 or smd. Its name is shown, and its registers or
                       parameters are explained as far as they are known. 5=smd:pump gives it a name of one's own
    --protocol P       modbus, fc, or auto (default) to find out, for all of the line
    --request-first    the first FC telegram is a request; else a silence of --timeout tells that
    --timeout MS       a request without a reply for so long was not answered (1000)
    --absolute         times of day, or of the recording, not since the begin
    --quiet            no traffic, only the table, which a terminal shows anew each second
    --every S          shows the table every so many seconds while it listens
    --width N          of the lines, in characters (120, or as wide as the terminal)
    --json             one JSON object a line: those of `decode`, with time and response_time in microseconds
    --colour WHEN      auto (default: on a terminal, unless NO_COLOR is set), always, never
    --baud N           of the device (default 19200, with --protocol fc 9600)
    --format 8E1       of the device: data bits, parity (N, E, O), stop bits
    --silence US       what ends a frame on the device, in microseconds, as in `decode`
    --pcd N            words of process data in an FC telegram, 2 (default) to 16
    --pnu-bits N       bits of an FC parameter number, 11 (default) or 12
    --help

Each line has the time in seconds, the address, who speaks, the time of the response, and what is said:

    ->  a request            <-  its reply              <!  a refusal: an exception, or "cannot be executed"
    --  there was no reply   xx  bytes were dropped     <>  nothing tells whether it is a request

The time of a response is from when the last bytes of the request were received until the first of the reply. Dropped
bytes are counted for the slave that is to reply; else for the one whose address a damaged frame begins with, if that
was heard before or is given; else for none.

A line of a recorded file is what was heard between two silences. A time may stand before the bytes, in seconds with six
digits behind the point: `12.345678 01 03 00 6B 00 03 74 17`. Without it no times are shown.

Exit status: 0, 1 if bytes were dropped or requests not answered, 2 for wrong usage or bad hexadecimal.
)";

constexpr int healthy     = 0;
constexpr int unhealthy   = 1;
constexpr int wrong_usage = 2;  // and whatever else keeps the program from its work

struct options {
    support::bus_monitor_options monitor;
    std::string                  file;
    std::optional<std::uint32_t> every;  // seconds
    bool                         is_terminal = false;
};

//=== command line ===//

bool has_colours(std::string const& when, bool is_terminal)
{
    if (when == "always" or when == "never") { return when == "always"; }
    if (when != "auto") { throw support::usage_error{"'" + when + "' is none of auto, always, never"}; }
    auto const* refused = std::getenv("NO_COLOR");  // NOLINT(concurrency-mt-unsafe): there is one thread
    return is_terminal and (refused == nullptr or *refused == '\0');
}

std::size_t width_of_output(bool is_terminal)
{
    winsize size{};
    if (not is_terminal or ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0 or size.ws_col == 0) {
        return support::bus_look{}.width;
    }
    return size.ws_col;
}

options parse(support::arguments words)
{
    options chosen;
    auto&   monitor    = chosen.monitor;
    auto    colour     = std::string{"auto"};
    chosen.is_terminal = isatty(STDOUT_FILENO) != 0;
    monitor.look.width = width_of_output(chosen.is_terminal);
    while (not words.empty()) {
        if (not words.is_option()) {
            if (not chosen.file.empty()) { throw support::usage_error{"there is more than one file"}; }
            chosen.file = words.next("");
            continue;
        }
        support::option word{words};
        auto const      name = word.name();
        auto const      flag = [&](bool& which) {
            word.has_no_value();
            which = true;
        };
        if (name == "--drive") {
            monitor.drives.add(word.value());
        } else if (name == "--absolute") {
            flag(monitor.look.is_absolute);
        } else if (name == "--quiet") {
            flag(monitor.is_quiet);
        } else if (name == "--json") {
            flag(monitor.json);
        } else if (name == "--every") {
            chosen.every = support::to<std::uint32_t>(word.value(), 1, 86'400);
        } else if (name == "--width") {
            monitor.look.width = support::to<std::size_t>(word.value(), 1, 10'000);
        } else if (name == "--colour") {
            colour = word.value();
        } else if (not monitor.line.take(word)) {
            word.refuse();
        }
    }
    if (not chosen.file.empty() and not monitor.line.device.empty()) {
        throw support::usage_error{"either a file or --device, not both"};
    }
    monitor.look.has_colours = has_colours(colour, chosen.is_terminal) and not monitor.json;
    return chosen;
}

//=== what comes out ===//

int finish(support::bus_monitor const& monitor, bool is_json)
{
    if (monitor.has_written() and not is_json) { std::cout << '\n'; }
    monitor.write_table();
    return monitor.is_healthy() ? healthy : unhealthy;
}

/// Shows the table in between, when it is time for it.
class table_clock {
public:
    table_clock(options const& chosen, support::bus_monitor const& monitor)
        : monitor_{monitor}, redraws_{chosen.monitor.is_quiet and chosen.is_terminal and not chosen.monitor.json},
          period_{support::timestamp{chosen.every.value_or(redraws_ ? 1 : 0)} * 1'000'000},
          due_{support::time_now() + (redraws_ ? 0 : period_)}
    {}

    void look()
    {
        constexpr auto home_and_clear = "\033[H\033[J";
        if (period_ != 0 and support::time_now() >= due_) {
            due_ += period_ * ((support::time_now() - due_) / period_ + 1);
            std::cout << (redraws_ ? home_and_clear : "");
            monitor_.write_table();
        }
        std::cout.flush();
    }

    [[nodiscard]] bool redraws() const { return redraws_; }

private:
    support::bus_monitor const& monitor_;
    bool                        redraws_;
    support::timestamp          period_;  // microseconds; 0: never
    support::timestamp          due_;
};

//=== where it comes from ===//

int monitor_device(options const& chosen)
{
    support::bus_monitor monitor{chosen.monitor, std::cout};
    table_clock          table{chosen, monitor};
    auto const           is_fc = chosen.monitor.line.protocol == support::line_protocol::fc;
    support::listen(chosen.monitor.line, is_fc ? 9600 : 19200, monitor, [&] { table.look(); });
    monitor.end(false);
    if (table.redraws()) { std::cout << '\n'; }
    return finish(monitor, chosen.monitor.json);
}

int monitor_lines(options const& chosen, std::istream& in)
{
    support::stop_on_signals();
    support::bus_monitor monitor{chosen.monitor, std::cout};
    std::string          line;
    for (std::size_t number = 1; not support::is_stopped() and std::getline(in, line); ++number) {
        auto const parsed = support::parse_recorded(line);
        if (parsed.heard.column != 0) {
            monitor.end(true);
            finish(monitor, chosen.monitor.json);
            throw support::usage_error{"line " + std::to_string(number) + ", character "
                                       + std::to_string(parsed.heard.column) + ": " + parsed.heard.problem};
        }
        if (not parsed.heard.bytes.empty()) { monitor.hear(parsed.heard.bytes, parsed.time); }
        monitor.hear_nothing(parsed.time);
        if (chosen.is_terminal) { std::cout.flush(); }
    }
    monitor.end(not support::is_stopped());
    return finish(monitor, chosen.monitor.json);
}

int monitor_file(options const& chosen)
{
    if (chosen.file.empty()) { return monitor_lines(chosen, std::cin); }
    std::ifstream file{chosen.file};
    if (not file) {
        throw support::usage_error{"cannot read " + chosen.file + ": "
                                   + std::error_code{errno, std::generic_category()}.message()};
    }
    return monitor_lines(chosen, file);
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        auto const chosen = parse({argc, argv});
        auto const status = chosen.monitor.line.device.empty() ? monitor_file(chosen) : monitor_device(chosen);
        if (std::cout.flush()) { return status; }
        std::cerr << "bus_monitor: cannot write what was heard; is the disk full?\n";
    } catch (support::help_wanted) {
        std::cout << usage;
        return healthy;
    } catch (support::usage_error const& problem) {
        std::cerr << "bus_monitor: " << problem.what() << "; see bus_monitor --help\n";
    } catch (std::exception const& problem) {
        std::cerr << "bus_monitor: " << problem.what() << '\n';
    }
    return wrong_usage;
}
