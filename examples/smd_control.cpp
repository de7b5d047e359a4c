// SPDX-License-Identifier: MIT
//
// Controls a Lenze / AC Tech smd over Modbus RTU.
//
//     smd_control --device /dev/ttyUSB0 --address 5 start 41.2
//
// Whatever it does, it first reads register 50, which tells where that drive has its parameters, and writes nothing to
// one that has them where the manual does not say.
#include "support/arguments.hpp"
#include "support/client.hpp"
#include "support/serial_port.hpp"
#include "support/smd_line.hpp"
#include "support/smd_traffic.hpp"

#include <drivecodec/drives/smd/controller.hpp>
#include <drivecodec/drives/smd/watchdog.hpp>
#include <drivecodec/text/drives/smd/parameters.hpp>
#include <drivecodec/text/modbus.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;
namespace smd    = drivecodec::smd;

namespace {

using hertz  = drivecodec::quantity<drivecodec::unit::hertz>;
using second = drivecodec::quantity<drivecodec::unit::second>;

constexpr int done        = 0;
constexpr int refused     = 1;
constexpr int wrong_usage = 2;

constexpr auto usage = R"(usage: smd_control --device PATH [options] COMMAND

  unlock            what can be written with --password: control and parameters; parameters only, if C01 is not 10 or 11
  start HZ          unlocks the drive, sets its serial speed, as 41.2, and starts it in the direction that it has
  stop              lets go of the motor; unlocks the drive if it has to
  forward, reverse  the direction
  status            shows version, speeds, load, direction, sources and fault
  get WORD          a register, by its code or name: C12, acceleration_time. C01 is not c01
  set WORD VALUE    the same, in its unit: set C12 5.0
  lock              nothing can be written any more
  watch             shows the status whenever it changes, until Ctrl-C, and talks to the drive often enough for n23

  --device PATH     a serial device or pseudo-terminal
  --address N       of the drive, 1 to 247 (1)
  --password N      C94, 0 to 999 (0)
)";

constexpr auto other_options = R"(
  --timeout MS      how long to wait for a reply (500)
  --verbose         shows every frame in words

A drive with a time-out, n22, locks itself and stops when it is asked nothing for the milliseconds of n23: after start,
let watch run. Exit status: 0 done, 1 when the drive refuses or does not answer, 2 for wrong usage.
)";

constexpr auto pause = std::chrono::milliseconds{50};  // between two looks at the drive

struct options {
    std::string               device;
    support::smd_line         line;
    smd::network_address      address  = smd::factory_address;
    std::uint16_t             password = 0;
    support::client::settings client;
    bool                      verbose = false;
};

/// What stands behind the command, options apart.
using words_of_command = std::vector<std::string>;

std::sig_atomic_t volatile interrupted = 0;  // by a signal. NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

template <typename... Things>
std::string text_of(Things const&... things)
{
    std::array<char, 1200>  room{};
    drivecodec::text_writer text{room};
    write_text(text, things...);
    return std::string{text.view_with_ellipsis()};
}

int say(std::string_view what)
{
    std::cout << what << std::endl;  // at once, also into a pipe. NOLINT(performance-avoid-endl)
    return done;
}

//=== the drive at the other end ===//

/// The drive did not do what it was told; `what()` tells the user why.
struct drive_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// An exception.
struct drive_refusal : drive_error {
    explicit drive_refusal(modbus::exception_code given) : drive_error{text(given)}, code{given} {}

    modbus::exception_code code;

private:
    static std::string text(modbus::exception_code given)
    {
        auto const meaning = support::smd_traffic::refusal(given);
        auto const is_lock = given == modbus::exception_code::illegal_function;
        return "exception " + std::to_string(static_cast<unsigned>(given)) + (meaning.empty() ? "" : ": ") + meaning
               + (is_lock ? "; unlock it first" : "");
    }
};

class drive {
public:
    drive(support::client& line, smd::network_address address) : line_{&line}, address_{address} {}

    /// The response, or the exception; nothing if there is neither. Throws a drive_error if the drive sends what it
    /// must not. Views in it are valid until the next call.
    template <modbus::message Request>
    [[nodiscard]] auto try_to_ask(Request const& request)
    {
        auto const answer = line_->ask(address_, request);
        if (answer and not *answer and answer->error().code() != drivecodec::errc::exception_reply) {
            throw drive_error{std::string{explain(answer->error().code())}};
        }
        return answer;
    }

    /// The response. Throws a drive_error if there is none.
    template <modbus::message Request>
    [[nodiscard]] typename Request::function::response ask(Request const& request)
    {
        auto const answer = try_to_ask(request);
        if (not answer) { throw drive_error{"no answer from drive " + std::to_string(address_.byte())}; }
        if (not *answer) { throw drive_refusal{answer->error().exception()}; }
        return **answer;
    }

    template <typename Register>
    [[nodiscard]] auto read(Register which)
    {
        return which.value(ask(which.read()).values[0]);
    }
    [[nodiscard]] smd::status_block status() { return *smd::drive_status.value(ask(smd::drive_status.read()).values); }

    /// Refuses unless the drive is known. Throws a drive_error.
    void write(smd::write_single_register::request const& what)
    {
        static_cast<void>(map());
        static_cast<void>(ask(what));
    }

    /// Where the parameters are. Throws a drive_error if nobody knows.
    [[nodiscard]] smd::map map()
    {
        if (auto const known = smd::map::make(version())) { return *known; }
        throw drive_error{"register 50 says version " + std::to_string(version())
                          + ", of which nobody here knows what its registers mean: nothing is written to that drive"};
    }

    /// Register 50.
    [[nodiscard]] std::uint16_t version()
    {
        if (not version_) { version_ = read(smd::register_version); }
        return *version_;
    }

private:
    support::client*             line_;
    smd::network_address         address_;
    std::optional<std::uint16_t> version_;
};

//=== to run and to stop ===//

std::string reason(smd::refusal why)
{
    switch (why) {
    case smd::refusal::locked:
        return "the drive locks itself again and again: somebody else may lock it, or n23 is short";
    case smd::refusal::unlock_rejected: return "the drive does not let itself be unlocked: is it this --password?";
    case smd::refusal::no_such_register: return "the drive does not have a register that every smd has";
    case smd::refusal::out_of_range: return "the speed is not between C10 and C11 of the drive";
    case smd::refusal::wrong_format: return "the drive says that the format is wrong";
    case smd::refusal::busy: return "the drive is busy";
    case smd::refusal::unknown_exception: return "the drive answers with an exception that it should not have";
    case smd::refusal::no_reply: return "no answer from the drive";
    case smd::refusal::no_serial_control: return "Modbus does not control the drive: C01 is neither 10 nor 11";
    case smd::refusal::inhibited: return "the drive is inhibited: terminal 28 is open";
    case smd::refusal::stopped_elsewhere: return "the drive was stopped by somebody else";
    case smd::refusal::not_followed: return "the drive answers, but does not do it";
    case smd::refusal::none: break;
    }
    return "refused";
}

/// Sends what the controller wants to be sent.
void carry_out(drive& target, smd::controller& control, smd::exchange const& what)
{
    auto const tell = [&](auto const& answer, auto const& take) {
        if (not answer) {
            control.lost();
        } else if (not *answer) {
            control.refused(smd::to_exception(answer->error().exception()));
        } else {
            take(**answer);
        }
    };
    if (what.is_write()) {
        tell(target.try_to_ask(what.write), [&](auto const& echo) {
            control.answered(smd::write_single_register::request{echo.address, echo.value});
        });
    } else {
        tell(target.try_to_ask(smd::drive_status.read()),
             [&](auto const& given) { control.answered(*smd::drive_status.value(given.values)); });
    }
}

/// Until it is where it should be. Throws a drive_error if it does not get there.
void take_to_goal(drive& target, smd::controller& control)
{
    static_cast<void>(target.map());
    while (control.progress() == smd::progress::waiting) {
        if (interrupted != 0) { throw drive_error{"interrupted: " + text_of(control.status())}; }
        std::this_thread::sleep_for(std::chrono::microseconds{control.due_in()});
        control.pass(control.due_in());
        carry_out(target, control, control.next());
    }
    if (control.progress() == smd::progress::faulted) {
        throw drive_error{"the drive is in fault: " + text_of(control.status().fault)};
    }
    if (control.progress() == smd::progress::refused) { throw drive_error{reason(control.why())}; }
}

smd::controller controller_for(options const& given)
{
    constexpr auto interval = std::chrono::microseconds{pause}.count();
    return smd::controller{{.password = given.password, .interval = interval}};
}

hertz to_speed(std::string const& word)
{
    auto const speed = hertz::of(support::to_decimal(word));
    if (auto const raw = smd::serial_speed_command.raw(speed); not raw) {
        throw support::value_error{raw.error().code() == drivecodec::errc::inexact
                                       ? word + " Hz: the drive takes tenths of a hertz"
                                       : word + " Hz: the drive takes 0 to 240.0 Hz, and its direction apart"};
    }
    return speed;
}

/// A time-out may have inhibited the drive: to be told to stop ends that, and not what terminal 28 does.
void end_inhibit(drive& target, options const& given)
{
    try {
        target.write({.address = smd::unlock_commands.address(), .value = given.password});
        target.write(smd::drive_control.write(smd::command::stop));
    } catch (drive_refusal const&) {
        return;  // what follows says why
    }
}

int start(drive& target, options const& given, words_of_command const& words)
{
    auto       control = controller_for(given);
    auto const status  = target.status();
    auto const way     = status.commanded_direction;
    if (status.operational_status == smd::operational_status::inhibit) { end_inhibit(target, given); }
    if (auto const fault = control.run(way, to_speed(words[0])); not fault.ok()) {
        throw drive_error{"the drive has an unknown direction"};
    }
    take_to_goal(target, control);
    return say(text_of(control.status()));
}

int stop(drive& target, options const& given, words_of_command const&)
{
    auto control = controller_for(given);
    control.stop();
    take_to_goal(target, control);
    return say(text_of(control.status()));
}

//=== single writes ===//

int unlock(drive& target, options const& given, words_of_command const&)
{
    auto const has_control = smd::modbus_controls(target.status().control_mode);
    auto const address     = has_control ? smd::unlock_commands.address() : smd::unlock_parameters.address();
    try {
        target.write({.address = address, .value = given.password});
    } catch (drive_refusal const& fault) {
        if (fault.code != modbus::exception_code::illegal_function) { throw; }
        throw drive_error{"the drive is not unlocked with this --password"};
    }
    return say(has_control ? "control unlocked; parameters too, if the password is C94" : "parameters unlocked");
}

int lock(drive& target, options const&, words_of_command const&)
{
    try {
        target.write(smd::drive_control.write(smd::command::lock));
    } catch (drive_refusal const& fault) {
        if (fault.code != modbus::exception_code::illegal_function) { throw; }
        return say("it is locked already");
    }
    return say("locked");
}

int give(drive& target, smd::write_single_register::request const& command)
{
    target.write(command);
    return say(text_of(target.status()));
}

int forward(drive& target, options const&, words_of_command const&)
{
    return give(target, smd::drive_control.write(smd::command::set_forward));
}

int reverse(drive& target, options const&, words_of_command const&)
{
    return give(target, smd::drive_control.write(smd::command::set_reverse));
}

//=== parameters ===//

/// The register with this code or name. Throws a value_error if the version has none.
drivecodec::drives::register_row const& find_register(smd::map const& map, std::string const& word)
{
    if (auto const* row = map.find(word); row != nullptr) { return *row; }
    throw support::value_error{"a drive of version " + std::to_string(static_cast<unsigned>(map.version()))
                               + " has no register '" + word + "'"};
}

int show(drive& target, drivecodec::drives::register_row const& row)
{
    auto const is_text = row.type == drivecodec::drives::raw_type::text;
    auto const asked   = target.map().make_read(row.address, is_text ? smd::software_version_words : std::uint16_t{1});
    if (not asked) { throw support::value_error{std::string{row.name} + " can only be written"}; }
    auto const values = target.ask(*asked).values;
    if (auto const version = smd::software_version::make(values); is_text and version) {
        return say("C99 software_version " + text_of(*version));
    }
    return say(text_of(smd::register_value{target.map().version(), row.address, values[0]}));
}

int get(drive& target, options const&, words_of_command const& words)
{
    return show(target, find_register(target.map(), words[0]));
}

/// "0.0 s to 999.0 s"
std::string limits_of(drivecodec::drives::register_row const& row)
{
    std::array<char, 100>   room{};
    drivecodec::text_writer text{room};
    write_quantity(text, {row.limits.min, row.exponent}, row.unit);
    write_quantity(text.put(" to "), {row.limits.max, row.exponent}, row.unit);
    return std::string{text.view()};
}

int set(drive& target, options const&, words_of_command const& words)
{
    using drivecodec::errc;
    auto const  value = support::to_decimal(words[1]);
    auto const& row   = find_register(target.map(), words[0]);
    auto const  asked = target.map().make_write(words[0], value);
    if (not asked) {
        auto const why = asked.error().code();
        throw support::value_error{words[0]
                                   + (why == errc::read_only ? " can only be read"
                                      : why == errc::inexact ? " does not have so many digits"
                                                             : " takes " + limits_of(row))};
    }
    target.write(*asked);
    return row.is_readable() ? show(target, row) : say("done");
}

//=== to be seen ===//

/// C99, if it is known where that is.
std::string software_of(drive& target)
{
    auto const map = smd::map::make(target.version());
    if (not map) { return "unknown here: nothing is written to it"; }
    auto const asked = map->make_read(map->find("C99")->address, smd::software_version_words);
    return "software " + text_of(*smd::software_version::make(target.ask(*asked).values));
}

int status(drive& target, options const&, words_of_command const&)
{
    say("version " + std::to_string(target.version()) + ", " + software_of(target));
    return say(text_of(target.status()));
}

/// How long to wait between two polls, so that the drive does not time out.
std::chrono::microseconds polling_pause(drive& target, options const& given)
{
    using std::chrono::microseconds;
    auto const map = smd::map::make(target.version());
    if (not map) { return pause; }
    auto const value = [&](char const* code) {
        return target.ask(*map->make_read(map->find(code)->address)).values[0];
    };
    if (value("n22") == 0) { return pause; }
    auto const fault_time = second{value("n23"), -3};
    auto const exchange   = smd::status_poll_time(*rtu::timing::make(smd::baud_rate, given.line.format));
    auto const interval   = smd::keep_alive_interval(fault_time, exchange);
    if (interval) { return std::min<microseconds>(pause, microseconds{*interval - exchange}); }
    std::cerr << "smd_control: n23, " << text_of(fault_time) << ", is too short to ask the drive twice within it\n";
    return microseconds{0};
}

int watch(drive& target, options const& given, words_of_command const&)
{
    auto const  wait = polling_pause(target, given);
    std::string shown;
    while (interrupted == 0) {
        if (auto now = text_of(target.status()); now != shown) {
            say(now);
            shown = std::move(now);
        }
        std::this_thread::sleep_for(wait);
    }
    return done;
}

//=== the command line ===//

struct command {
    std::string_view name;
    int (*run)(drive&, options const&, words_of_command const&);
    std::size_t words = 0;  // that follow it
};
constexpr command commands[] = {
    {"unlock", unlock}, {"start", start, 1}, {"stop", stop},  {"forward", forward}, {"reverse", reverse},
    {"status", status}, {"get", get, 1},     {"set", set, 2}, {"lock", lock},       {"watch", watch},
};

/// Before anything is sent: a command that is not understood whole is not carried out.
command const& find_command(std::string const& name, words_of_command const& words)
{
    for (auto const& known : commands) {
        if (known.name != name) { continue; }
        if (words.size() < known.words) { throw support::usage_error{"a word is missing behind '" + name + "'"}; }
        if (words.size() > known.words) {
            throw support::usage_error{"'" + words[known.words] + "' is one word too many"};
        }
        if (name == "start") { static_cast<void>(to_speed(words[0])); }
        if (name == "set") { static_cast<void>(support::to_decimal(words[1])); }
        return known;
    }
    throw support::usage_error{"there is no command '" + name + "'"};
}

/// Takes `word` if it is an option.
bool take(options& given, std::string const& word, support::arguments& rest)
{
    auto const value = [&] { return rest.next("the value of " + word); };
    if (given.line.take(word, rest)) { return true; }
    if (word == "--device") {
        given.device = value();
    } else if (word == "--address") {
        given.address = *smd::network_address::make(support::to<std::uint8_t>(value(), 1, 247));
    } else if (word == "--password") {
        given.password = support::to<std::uint16_t>(value(), 0, smd::largest_password);
    } else if (word == "--timeout") {
        given.client.timeout = std::chrono::milliseconds{support::to<std::uint32_t>(value(), 1, 3'600'000)};
    } else if (word == "--verbose") {
        given.verbose = true;
    } else {
        return false;
    }
    return true;
}

int run(support::arguments rest)
{
    options          given;
    words_of_command words;
    while (not rest.empty()) {
        auto const is_option = rest.is_option();
        auto const word      = rest.next("a word");
        if (is_option and not take(given, word, rest)) { throw support::usage_error{"unknown option '" + word + "'"}; }
        if (not is_option) { words.push_back(word); }
    }
    if (words.empty()) { throw support::usage_error{"the command is missing"}; }
    if (given.device.empty()) { throw support::usage_error{"--device is missing"}; }
    auto const name = words.front();
    words.erase(words.begin());
    auto const& chosen = find_command(name, words);

    auto port = support::serial_port::open(given.device, given.line.baud, given.line.format);
    if (not port) { throw std::system_error{errno, std::generic_category(), given.device}; }
    given.client.silence = std::max(given.client.silence, std::chrono::microseconds{given.line.silence()});
    support::client client{std::move(*port), given.line, given.client};
    if (given.verbose) {
        client.trace = [](rtu::frame const& frame) {
            std::array<char, 2000> text{};
            std::cerr << rtu::describe(frame, text) << '\n';
        };
    }
    drive target{client, given.address};
    return chosen.run(target, given, words);
}

void print_usage(std::ostream& out)
{
    out << usage << support::smd_line::usage << other_options;
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
    } catch (support::help_wanted) {
        print_usage(std::cout);
        return done;
    } catch (drive_error const& fault) {
        std::cerr << "smd_control: " << fault.what() << '\n';
        return refused;
    } catch (support::usage_error const& fault) {
        std::cerr << "smd_control: " << fault.what() << "\n\n";
        print_usage(std::cerr);
    } catch (std::exception const& fault) {
        std::cerr << "smd_control: " << fault.what() << '\n';
    }
    return wrong_usage;
}
