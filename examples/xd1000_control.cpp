// SPDX-License-Identifier: MIT
//
// Controls a Lauritz Knudsen xD1000 drive over Modbus RTU.
//
//     xd1000_control --device /dev/ttyUSB0 --address 2 start 41.2
#include "support/arguments.hpp"
#include "support/client.hpp"
#include "support/serial_port.hpp"

#include <drivecodec/cia402.hpp>
#include <drivecodec/core/decimal.hpp>
#include <drivecodec/text/cia402.hpp>
#include <drivecodec/text/modbus.hpp>
#include <drivecodec/text/xd1000.hpp>
#include <drivecodec/xd1000.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

namespace cia402 = drivecodec::cia402;
namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;
namespace xd1000 = drivecodec::xd1000;

namespace {

constexpr int done        = 0;
constexpr int refused     = 1;
constexpr int wrong_usage = 2;

constexpr auto usage = R"(usage: xd1000_control --device PATH [options] COMMAND

  start HZ      sets the reference and takes the drive to Operation enabled; a negative one turns the other way
  stop          takes the drive to Ready to switch on and then to Switch on disabled
  reverse       turns the direction bit round; the state stays
  quick-stop    takes the drive from Operation enabled to Quick stop active
  reset         resets a fault; the drive is then in Switch on disabled
  status        shows state, flags, reference and speed
  watch         shows them whenever something changes, until Ctrl-C

  --device PATH      a serial device or pseudo-terminal
  --address N        of the drive, 1 to 247 (1)
  --baud N           (19200)
  --format 8E1       data bits, parity, stop bits (8E1)
  --timeout MS       how long to wait for a reply (500)
  --pole-pairs N     of the motor: 50 Hz are 1500 rpm with 2 (2)
  --verbose          shows every frame in words

A drive that is asked nothing for its communication time-out trips: after start, let watch run.
Exit status: 0 done, 1 when the drive refuses, is in fault or does not answer, 2 for wrong usage.
)";

constexpr auto pause      = std::chrono::milliseconds{20};  // between two looks at the drive
constexpr auto time_limit = std::chrono::seconds{10};       // for the drive to reach a state, ramps included

constexpr rtu::server_address default_server{1};

struct options {
    std::string               device;
    rtu::server_address       address = default_server;
    std::uint32_t             baud    = 19200;
    rtu::character_format     format  = rtu::format_8e1;
    support::client::settings line;
    std::uint8_t              pole_pairs = 2;
    bool                      verbose    = false;
};

std::sig_atomic_t volatile interrupted = 0;  // by a signal. NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

//=== the drive at the other end ===//

/// The drive did not do what it was told; `what()` tells the user why.
struct drive_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class drive {
public:
    drive(support::client& line, rtu::server_address address) : line_{&line}, address_{address} {}

    template <typename Register>
    [[nodiscard]] auto read(Register which)
    {
        return which.value(ask(which.read()).values[0]);
    }

    void write(modbus::write_single_register::request const& what) { static_cast<void>(ask(what)); }

private:
    /// The response. Throws a drive_error if there is none.
    template <modbus::message Request>
    [[nodiscard]] typename Request::function::response ask(Request const& request)
    {
        auto const answer = line_->ask(address_, request);
        if (not answer) { throw drive_error{"no answer from drive " + std::to_string(address_.byte())}; }
        if (*answer) { return **answer; }
        auto const fault = answer->error();
        if (fault.code() != drivecodec::errc::exception_reply) {
            throw drive_error{std::string{explain(fault.code())}};
        }
        throw drive_error{"the drive answers with exception " + std::to_string(static_cast<unsigned>(fault.exception()))
                          + ' ' + std::string{to_string(fault.exception())}};
    }

    support::client*    line_;
    rtu::server_address address_;
};

/// "operation_enabled", or the word itself if it is no state.
std::string state_of(xd1000::status_word status)
{
    auto const state = decode_state(status);
    return state ? std::string{to_string(*state)} : "no state (ETA is " + std::to_string(status.raw) + ')';
}

//=== taking the drive to a state ===//

/// What became of it, and the last that the drive said.
struct outcome {
    cia402::progress    progress;
    xd1000::status_word status;
};

/// Feeds the controller until it is done. `waiting` when the time is over.
outcome run_controller(drive& target, cia402::controller& control)
{
    std::optional<cia402::control_word> written;
    auto const                          deadline = std::chrono::steady_clock::now() + time_limit;
    for (;;) {
        auto const status   = target.read(xd1000::eta);
        auto const progress = control.update(status.standard());
        if (not written or *written != control.word()) {
            written = control.word();
            target.write(xd1000::cmd.write(xd1000::command_word{*written}));
        }
        if (progress != cia402::progress::waiting or std::chrono::steady_clock::now() >= deadline) {
            return {progress, status};
        }
        if (interrupted != 0) { throw drive_error{"interrupted; the drive is in " + state_of(status)}; }
        std::this_thread::sleep_for(pause);
    }
}

/// Throws a drive_error that says why if the goal is not reached.
void expect_reached(outcome const& result, cia402::state goal)
{
    auto const wanted = std::string{to_string(goal)};
    switch (result.progress) {
    case cia402::progress::reached: return;
    case cia402::progress::faulted: throw drive_error{"the drive is in fault; see its display, then reset"};
    case cia402::progress::unreachable:
        throw drive_error{"no command leads from " + state_of(result.status) + " to " + wanted};
    case cia402::progress::waiting:
    case cia402::progress::refused: break;
    }
    if (decode_state(result.status) == cia402::state::fault) { throw drive_error{"the fault cannot be reset yet"}; }
    throw drive_error{"the drive did not reach " + wanted + " in time: it is in " + state_of(result.status)
                      + (result.status.is_local() ? ", and in local mode" : "")};
}

/// A controller whose words keep these bits. How long to wait is a matter of time here, not of the number of answers.
cia402::controller controller_with(xd1000::command_word others)
{
    cia402::controller control{{.way = {}, .patience = std::numeric_limits<std::uint16_t>::max()}};
    control.set_other_bits(others.standard());
    return control;
}

void take_to(cia402::state goal, drive& target, cia402::controller& control)
{
    control.set_goal(goal);
    expect_reached(run_controller(target, control), goal);
}

//=== the commands ===//

xd1000::command_word direction_of(xd1000::command_word word)
{
    using xd1000::command_word;
    return command_word{}.with(command_word::direction, word.get(command_word::direction));
}

/// The whole rpm of a motor whose supply has this frequency, calculated without rounding.
int to_rpm(std::string const& hertz, unsigned pole_pairs)
{
    auto const frequency = drivecodec::parse_decimal(hertz);
    if (not frequency) { throw support::usage_error{"'" + hertz + "' is not a frequency such as 41.2"}; }
    auto rpm   = std::int64_t{frequency->number} * 60;
    auto exact = rpm % pole_pairs == 0;
    rpm /= pole_pairs;
    for (auto exponent = frequency->exponent; exponent < 0; ++exponent) {
        exact = exact and rpm % 10 == 0;
        rpm /= 10;
    }
    if (not exact) {
        throw support::usage_error{hertz + " Hz are no whole rpm with " + std::to_string(pole_pairs) + " pole pairs"};
    }
    if (rpm < -0x8000 or rpm > 0x7FFF) { throw support::usage_error{hertz + " Hz are more rpm than LFRD can hold"}; }
    return static_cast<int>(rpm);
}

int say(std::string_view what)
{
    std::cout << what << '\n';
    return done;
}

int start(drive& target, options const& given, support::arguments& words)
{
    auto const rpm       = to_rpm(words.next("the frequency in Hz"), given.pole_pairs);
    auto const reference = xd1000::lfrd.make_write({rpm, 0});
    if (not reference) { throw support::usage_error{std::string{explain(reference.error().code())}}; }

    auto control = controller_with(direction_of(target.read(xd1000::cmd)));  // and without halt
    target.write(*reference);
    take_to(cia402::state::operation_enabled, target, control);
    return say("operation_enabled, reference " + std::to_string(rpm) + " rpm");
}

int stop(drive& target, options const&, support::arguments&)
{
    auto       control = controller_with(target.read(xd1000::cmd));
    auto const state   = decode_state(target.read(xd1000::eta));
    // From below, Ready to switch on would be a step up.
    if (state == cia402::state::operation_enabled or state == cia402::state::switched_on) {
        take_to(cia402::state::ready_to_switch_on, target, control);
    }
    take_to(cia402::state::switch_on_disabled, target, control);
    return say("switch_on_disabled");
}

int reverse(drive& target, options const&, support::arguments&)
{
    using enum xd1000::direction;
    using xd1000::command_word;
    auto const before = target.read(xd1000::cmd);
    auto const now    = before.get(command_word::direction) == forward ? xd1000::direction::reverse : forward;
    auto const status = target.read(xd1000::eta);
    auto const state  = decode_state(status);
    if (not state) { throw drive_error{"the drive is in " + state_of(status)}; }

    auto control = controller_with(before.with(command_word::direction, now));
    take_to(*state, target, control);
    return say(std::string{"direction "} + (now == forward ? "forward, " : "reverse, ")
               + std::string{to_string(*state)});
}

int quick_stop(drive& target, options const&, support::arguments&)
{
    using enum cia402::state;
    auto const before  = decode_state(target.read(xd1000::eta));
    auto       control = controller_with(target.read(xd1000::cmd));
    control.set_goal(quick_stop_active);
    auto const result = run_controller(target, control);
    // A drive may leave Quick stop active by itself, before it is seen there.
    auto const is_over = before == operation_enabled and decode_state(result.status) == switch_on_disabled;
    if (not is_over) { expect_reached(result, quick_stop_active); }
    return say(state_of(result.status));
}

int reset(drive& target, options const&, support::arguments&)
{
    auto const status = target.read(xd1000::eta);
    auto const state  = decode_state(status);
    if (state != cia402::state::fault and state != cia402::state::fault_reaction_active) {
        return say("no fault to reset: " + state_of(status));  // Switch on disabled would stop a motor that runs
    }
    auto control = controller_with(target.read(xd1000::cmd));
    control.reset_fault();
    take_to(cia402::state::switch_on_disabled, target, control);
    return say("fault reset, switch_on_disabled");
}

/// All that is shown of the drive.
std::string status_line(drive& target)
{
    auto const status    = target.read(xd1000::eta);
    auto const reference = target.read(xd1000::lfrd);
    auto const speed     = target.read(xd1000::rfrd);

    std::array<char, 200>   room{};
    drivecodec::text_writer text{room};
    write_text(text, status);
    return std::string{text.view()} + "; reference " + std::to_string(reference.number) + " rpm, speed "
           + std::to_string(speed.number) + " rpm";
}

int status(drive& target, options const&, support::arguments&)
{
    return say(status_line(target));
}

int watch(drive& target, options const&, support::arguments&)
{
    std::string shown;
    while (interrupted == 0) {
        if (auto now = status_line(target); now != shown) {
            std::cout << now << std::endl;  // at once, also into a pipe. NOLINT(performance-avoid-endl)
            shown = std::move(now);
        }
        std::this_thread::sleep_for(pause);
    }
    return done;
}

struct command {
    std::string_view name;
    int (*run)(drive&, options const&, support::arguments&);
    std::size_t words;  // that follow it
};
constexpr command commands[] = {
    {"start", start, 1}, {"stop", stop, 0},     {"reverse", reverse, 0}, {"quick-stop", quick_stop, 0},
    {"reset", reset, 0}, {"status", status, 0}, {"watch", watch, 0}};

command const& find_command(std::string const& name)
{
    for (auto const& known : commands) {
        if (known.name == name) { return known; }
    }
    throw support::usage_error{"there is no command '" + name + "'"};
}

//=== the command line ===//

/// Takes the options that come before the command.
options parse(support::arguments& words)
{
    options given;
    while (words.is_option()) {
        auto const word  = words.next("an option");
        auto const value = [&] { return words.next("the value of " + word); };
        if (word == "--device") {
            given.device = value();
        } else if (word == "--address") {
            given.address = *rtu::server_address::make(support::to<std::uint8_t>(value(), 1, 247));
        } else if (word == "--baud") {
            given.baud = support::to<std::uint32_t>(value(), 1);
        } else if (word == "--format") {
            given.format = support::to_format(value());
        } else if (word == "--timeout") {
            given.line.timeout = std::chrono::milliseconds{support::to<std::uint32_t>(value(), 1, 3'600'000)};
        } else if (word == "--pole-pairs") {
            given.pole_pairs = support::to<std::uint8_t>(value(), 1);
        } else if (word == "--verbose") {
            given.verbose = true;
        } else {
            throw support::usage_error{"unknown option '" + word + "'"};
        }
    }
    if (given.device.empty()) { throw support::usage_error{"--device is missing"}; }
    return given;
}

/// Before anything is sent: a command that is not understood whole is not carried out.
void check_words(command const& chosen, options const& given, support::arguments words)
{
    if (chosen.words > 0) { static_cast<void>(to_rpm(words.next("the frequency in Hz"), given.pole_pairs)); }
    if (not words.empty()) { throw support::usage_error{"'" + words.next("a word") + "' is one word too many"}; }
}

int run(support::arguments words)
{
    auto        given  = parse(words);
    auto const& chosen = find_command(words.next("the command"));
    check_words(chosen, given, words);

    auto port = support::serial_port::open(given.device, given.baud, given.format);
    if (not port) { throw std::system_error{errno, std::generic_category(), given.device}; }
    support::rtu_line const line{given.baud, given.format};
    given.line.silence = std::max(given.line.silence, std::chrono::microseconds{line.silence()});
    support::client client{std::move(*port), line, given.line};
    if (given.verbose) {
        client.trace = [](rtu::frame const& frame) {
            std::array<char, 2000> text{};
            std::cerr << rtu::describe(frame, text) << '\n';
        };
    }
    drive target{client, given.address};
    return chosen.run(target, given, words);
}

}  // namespace

int main(int argc, char** argv)
{
    struct sigaction action {};
    action.sa_handler = [](int) { interrupted = 1; };
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    try {
        return run({argc, argv});
    } catch (drive_error const& fault) {
        std::cerr << "xd1000_control: " << fault.what() << '\n';
        return refused;
    } catch (support::help_wanted) {
        std::cout << usage;
        return 0;
    } catch (support::usage_error const& fault) {
        std::cerr << "xd1000_control: " << fault.what() << "\n\n" << usage;
    } catch (std::exception const& fault) {
        std::cerr << "xd1000_control: " << fault.what() << '\n';
    }
    return wrong_usage;
}
