// SPDX-License-Identifier: MIT
//
// Controls a Danfoss VLT 6000 HVAC over the FC protocol.
//
//     vlt6000_control --device /dev/ttyUSB0 --address 1 start 50%
//
// A command changes the bits of the control word that it is about and keeps the others: it first reads parameter 530,
// which is the word that the drive has. No parameter tells the reference that came with it; so every command but start
// sends 0 % along. Whatever only reads or writes parameters says that its process data are to be ignored.
#include "support/arguments.hpp"
#include "support/fc_client.hpp"
#include "support/serial_port.hpp"
#include "support/vlt6000_traffic.hpp"
#include "support/vlt6000_values.hpp"

#include <drivecodec/text/vlt6000.hpp>
#include <drivecodec/vlt6000.hpp>

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

namespace fc      = drivecodec::fc;
namespace vlt6000 = drivecodec::vlt6000;

namespace {

using hertz = drivecodec::quantity<drivecodec::unit::hertz>;

constexpr int done        = 0;
constexpr int refused     = 1;
constexpr int wrong_usage = 2;

constexpr auto usage = R"(usage: vlt6000_control --device PATH [options] COMMAND

  start REFERENCE      as 50% or -12.5%; 25Hz with --scale, the conversion index of parameters 204 and 205
  stop                 a ramp down, also of a frozen output
  quick-stop           a ramp down while the start command stays
  coast                lets go of the motor
  brake                brakes it with direct current
  jog                  the frequency of parameter 209
  freeze               keeps the output frequency
  reset                resets a trip; the motor does not start by it
  status               shows the words of the drive and its frequency
  watch                shows status word and frequency when they change, until Ctrl-C
  read NUMBER          a parameter
  write NUMBER VALUE   a parameter, to RAM
  text NUMBER [TEXT]   reads a text, as 621, or writes it, as 533

  --device PATH     a serial device or pseudo-terminal
)";

constexpr auto other_options = R"(
  --timeout MS      how long to wait for a reply (500)
  --retries N       how often to ask again without a reply (2)
  --echo            the adapter hears what it sends
  --verbose         shows every telegram in words

A drive with a bus time-out, parameter 556, reacts when it is asked nothing for the seconds of 555: after start, let
watch run. Exit status: 0 done, 1 when the drive refuses or does not answer, 2 for wrong usage.
)";

constexpr auto pause      = std::chrono::milliseconds{50};  // between two looks at the drive
constexpr auto time_limit = std::chrono::seconds{1};        // for the drive to do as it is told; a ramp may take longer

struct options {
    std::string                    device;
    support::fc_line               line;
    support::fc_address_options    address;
    support::fc_client::settings   client;
    bool                           verbose = false;
    support::vlt6000_value_options parameter;
};

/// What stands behind the command, options apart.
using words_of_command = std::vector<std::string>;

std::sig_atomic_t volatile interrupted = 0;  // by a signal. NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

//=== the drive at the other end ===//

/// The drive did not do what it was told; `what()` tells the user why.
struct drive_error : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class drive {
public:
    drive(support::fc_client& line, fc::address address) : line_{&line}, address_{address} {}

    /// The response. Throws a drive_error if there is none. A text in it is valid until the next call.
    template <fc::request Request>
    [[nodiscard]] auto ask(Request const& request)
    {
        auto const answer = line_->ask(address_, request);
        if (not answer) { throw drive_error{"no answer from drive " + std::to_string(address_.number())}; }
        if (*answer) { return **answer; }
        auto const fault = answer->error();
        if (fault.code() != drivecodec::errc::exception_reply) {
            throw drive_error{std::string{explain(fault.code())}};
        }
        auto const number  = static_cast<unsigned>(fault.number());
        auto const meaning = explain(fault.number());
        throw drive_error{"the drive refuses with error " + std::to_string(number) + (meaning.empty() ? "" : ": ")
                          + std::string{meaning}};
    }

    /// The value of a parameter of which the manual states how it is transferred.
    template <typename Parameter>
    [[nodiscard]] auto read(Parameter which)
    {
        auto const value = which.value(ask(which.read(fc::data_not_valid)));
        if (not value) {
            throw drive_error{"the drive gives parameter " + std::to_string(which.number())
                              + " as something that it cannot be"};
        }
        return *value;
    }

    [[nodiscard]] fc::process_status look() { return ask(fc::process_command{fc::data_not_valid}); }

    /// The control word that the drive has.
    [[nodiscard]] vlt6000::control_word word() { return read(vlt6000::parameters::control_word); }

    fc::process_status obey(vlt6000::control_word word, fc::reference reference = {})
    {
        auto const answer = ask(fc::data_valid(word, reference));
        if (status_of(answer).is_local()) {
            throw drive_error{"the drive is in local operation, OFF/STOP or Hand, and obeys no control word"};
        }
        return answer;
    }

    [[nodiscard]] static vlt6000::status_word status_of(fc::process_status const& given)
    {
        return vlt6000::status_word::from_raw(given.status_word());
    }

private:
    support::fc_client* line_;
    fc::address         address_;
};

using vlt6000::status_word;

template <typename Thing>
std::string text_of(Thing const& thing)
{
    std::array<char, 1200>  room{};
    drivecodec::text_writer text{room};
    write_text(text, thing);
    return std::string{text.view_with_ellipsis()};
}

int say(std::string_view what)
{
    std::cout << what << std::endl;  // at once, also into a pipe. NOLINT(performance-avoid-endl)
    return done;
}

/// Status word and frequency.
int say(fc::process_status const& given)
{
    return say(text_of(drive::status_of(given)) + ", output frequency " + text_of(given.output_frequency()));
}

//=== references on the command line ===//

/// "50%": in percent; "25Hz": in Hz.
struct wanted_reference {
    drivecodec::decimal value;
    bool                is_in_hertz;

    static wanted_reference from(std::string_view word)
    {
        auto const is_in_hertz = word.ends_with("Hz");
        if (not is_in_hertz and not word.ends_with('%')) {
            throw support::usage_error{"'" + std::string{word} + "' is not a reference such as 50% or 25Hz"};
        }
        word.remove_suffix(is_in_hertz ? 2 : 1);
        return {support::to_decimal(word), is_in_hertz};
    }
};

/// A limit of the reference, parameter 204 or 205.
hertz read_limit(drive& target, fc::parameter_number number, int scale)
{
    auto const given = target.ask(fc::read_value(number, fc::data_not_valid));
    auto const value = vlt6000::number_in(given, {});
    if (not value) { throw drive_error{"parameter " + std::to_string(number.number()) + " is not a frequency"}; }
    return {*value, static_cast<std::int8_t>(scale)};
}

fc::reference to_reference(drive& target, wanted_reference wanted, support::vlt6000_value_options const& how)
{
    auto const made = [&] {
        if (not wanted.is_in_hertz) {
            return fc::reference::make(drivecodec::quantity<drivecodec::unit::percent>::of(wanted.value));
        }
        auto const at_0_percent   = read_limit(target, 204, *how.scale);
        auto const at_100_percent = read_limit(target, 205, *how.scale);
        return fc::reference::make(hertz::of(wanted.value), at_0_percent, at_100_percent);
    }();
    if (not made) {
        throw support::value_error{wanted.is_in_hertz ? "the frequency is beyond 204 and 205 of the drive"
                                                      : "a reference is at most 199.994 %, of either sign"};
    }
    return *made;
}

//=== the commands that move a motor ===//

int start(drive& target, options const& given, words_of_command const& words)
{
    auto const wanted = wanted_reference::from(words[0]);
    if (wanted.is_in_hertz and not given.parameter.scale) {
        throw support::value_error{"the manual does not state how 204 and 205 are transferred: for a reference in Hz, "
                                   "say their --scale, such as -3"};
    }
    auto const reference = to_reference(target, wanted, given.parameter);
    auto       answer    = target.obey(start(end_jog(target.word())), reference);
    auto const deadline  = std::chrono::steady_clock::now() + time_limit;
    while (not drive::status_of(answer).test(status_word::running)) {
        if (drive::status_of(answer).test(status_word::tripped)) {
            throw drive_error{"the drive has tripped: reset it"};
        }
        if (std::chrono::steady_clock::now() >= deadline) {
            throw drive_error{"the drive does not start; its terminals may say no: "
                              + text_of(drive::status_of(answer))};
        }
        std::this_thread::sleep_for(pause);
        answer = target.look();
    }
    return say(answer);
}

/// A command that stops the motor: also of a drive that does not say what control word it has.
template <vlt6000::control_word (*Change)(vlt6000::control_word)>
int give_stop(drive& target, options const&, words_of_command const&)
{
    auto const before = [&] {
        try {
            return target.word();
        } catch (drive_error const&) {
            return vlt6000::neutral;
        }
    }();
    return say(target.obey(Change(before)));
}

/// A command that is one word.
template <vlt6000::control_word (*Change)(vlt6000::control_word)>
int give(drive& target, options const&, words_of_command const&)
{
    return say(target.obey(Change(target.word())));
}

/// From any word: nothing that would prevent it, and no start command that would outlast it.
vlt6000::control_word jog_alone(vlt6000::control_word word)
{
    return jog(stop(start(word)));
}

int reset(drive& target, options const&, words_of_command const&)
{
    if (not drive::status_of(target.look()).test(status_word::tripped)) {
        return say("no trip to reset");  // the words below would stop a motor that runs
    }
    auto const word = stop(target.word());
    target.obey(prepare_reset(word));
    target.obey(reset(word));
    auto const answer = target.obey(prepare_reset(word));
    if (drive::status_of(answer).test(status_word::tripped)) {
        throw drive_error{"the trip cannot be reset: " + text_of(target.read(vlt6000::parameters::alarm_word))};
    }
    return say(answer);
}

//=== the commands that show something ===//

/// Alarm word, warning word, extended status word.
constexpr std::array<fc::parameter_number, 3> other_words{529, 531, 532};

int status(drive& target, options const&, words_of_command const&)
{
    using namespace vlt6000::parameters;
    auto const now     = target.look();
    auto const lowest  = target.read(output_frequency_low_limit);
    auto const highest = target.read(output_frequency_high_limit);
    auto const is_at   = now.output_frequency().frequency(lowest, highest, -2);
    say(now);
    // A drive that stands still sends 0 %, too, although that is its low limit.
    if (is_at and drive::status_of(now).test(status_word::running)) {
        say("which is " + text_of(*is_at) + " between " + text_of(lowest) + " and " + text_of(highest));
    }
    for (auto const number : other_words) {
        say(support::explain_value(target.ask(fc::read_value(number, fc::data_not_valid)), {}));
    }
    return done;
}

int watch(drive& target, options const&, words_of_command const&)
{
    std::optional<fc::process_status> shown;
    while (interrupted == 0) {
        auto const now = target.look();
        if (shown != now) { say(now); }
        shown = now;
        std::this_thread::sleep_for(pause);
    }
    return done;
}

//=== parameters and texts ===//

fc::parameter_number to_number(std::string const& word)
{
    return *fc::parameter_number::make(support::to<std::uint16_t>(word, 0, fc::parameter_number::last));
}

int read(drive& target, options const& given, words_of_command const& words)
{
    auto const number = to_number(words[0]);
    return say(support::explain_value(target.ask(fc::read_value(number, given.parameter.index, fc::data_not_valid)),
                                      given.parameter));
}

int write(drive& target, options const& given, words_of_command const& words)
{
    auto const  number = to_number(words[0]);
    auto const  value  = support::to_decimal(words[1]);
    auto const& chosen = given.parameter;
    auto const  how    = support::transfer_of(vlt6000::find(number.number()), chosen);
    auto const  pwe    = support::to_pwe(number.number(), value, how);
    auto const  asked =
        *how.width == fc::width::word
             ? fc::write_word(number, chosen.index, static_cast<std::uint16_t>(pwe), chosen.where, fc::data_not_valid)
             : fc::write_double_word(number, chosen.index, pwe, chosen.where, fc::data_not_valid);
    return say(support::explain_value(target.ask(asked), chosen));
}

int text(drive& target, options const&, words_of_command const& words)
{
    auto const number = to_number(words[0]);
    auto const show   = [&](fc::text_response const& given) {
        std::array<char, 1200>  room{};
        drivecodec::text_writer out{room};
        vlt6000::write_title(out, number.number());
        out.put(' ').quoted(given.characters);
        return say(out.view_with_ellipsis());
    };
    if (words.size() == 1) { return show(target.ask(fc::read_text(number, fc::data_not_valid))); }
    std::vector<std::uint8_t> const bytes{words[1].begin(), words[1].end()};
    if (auto const* row = vlt6000::find(number.number()); row != nullptr and not row->check_text(bytes.size()).ok()) {
        auto const is_too_long = row->is_writable() and row->kind == vlt6000::kind::text;
        throw support::value_error{"the manual says that " + std::to_string(number.number())
                                   + (is_too_long
                                          ? " takes at most " + std::to_string(row->max_text_length) + " characters"
                                          : " is no text that can be written")};
    }
    auto const asked = fc::make_write_text(number, bytes, fc::data_not_valid);
    if (not asked) { throw support::value_error{"a telegram has no room for that text"}; }
    return show(target.ask(*asked));
}

struct command {
    std::string_view name;
    int (*run)(drive&, options const&, words_of_command const&);
    std::size_t least_words = 0;  // that follow it
    std::size_t most_words  = least_words;
};
constexpr command commands[] = {
    {"start", start, 1},
    {"stop", give_stop<vlt6000::stop>},
    {"quick-stop", give_stop<vlt6000::quick_stop>},
    {"coast", give_stop<vlt6000::coast>},
    {"brake", give_stop<vlt6000::dc_brake>},
    {"jog", give<jog_alone>},
    {"freeze", give<vlt6000::freeze_output>},
    {"reset", reset},
    {"status", status},
    {"watch", watch},
    {"read", read, 1},
    {"write", write, 2},
    {"text", text, 1, 2},
};

/// Before anything is sent: a command that is not understood whole is not carried out.
command const& find_command(std::string const& name, words_of_command const& words)
{
    for (auto const& known : commands) {
        if (known.name != name) { continue; }
        if (words.size() < known.least_words) { throw support::usage_error{"a word is missing behind '" + name + "'"}; }
        if (words.size() > known.most_words) {
            throw support::usage_error{"'" + words[known.most_words] + "' is one word too many"};
        }
        return known;
    }
    throw support::usage_error{"there is no command '" + name + "'"};
}

//=== the command line ===//

/// Takes `word` if it is an option.
bool take(options& given, std::string const& word, support::arguments& rest)
{
    auto const value = [&] { return rest.next("the value of " + word); };
    if (given.line.take(word, rest) or given.address.take(word, rest) or given.parameter.take(word, rest)) {
        return true;
    }
    if (word == "--device") {
        given.device = value();
    } else if (word == "--timeout") {
        given.client.timeout = std::chrono::milliseconds{support::to<std::uint32_t>(value(), 1, 3'600'000)};
    } else if (word == "--retries") {
        given.client.retries = support::to<unsigned>(value(), 0, 1000);
    } else if (word == "--echo") {
        given.client.echo = true;
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
    auto const name    = words.front();
    auto const address = given.address.address();
    words.erase(words.begin());
    auto const& chosen = find_command(name, words);

    auto port = support::serial_port::open(given.device, given.line.baud, support::fc_line::format);
    if (not port) { throw std::system_error{errno, std::generic_category(), given.device}; }
    given.client.silence = std::max(given.client.silence, std::chrono::microseconds{given.line.silence()});
    support::fc_client client{std::move(*port), given.line, given.client};
    if (given.verbose) {
        client.trace = [](fc::frame const& frame) {
            std::cerr << text_of(frame) << "\n    " << support::explain_vlt6000(frame) << '\n';
        };
    }
    drive target{client, address};
    return chosen.run(target, given, words);
}

void print_usage(std::ostream& out)
{
    out << usage << support::vlt6000_value_options::usage << support::fc_address_options::usage << '\n'
        << support::fc_line::usage << other_options;
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
        std::cerr << "vlt6000_control: " << fault.what() << '\n';
        return refused;
    } catch (support::usage_error const& fault) {
        std::cerr << "vlt6000_control: " << fault.what() << "\n\n";
        print_usage(std::cerr);
    } catch (std::exception const& fault) {
        std::cerr << "vlt6000_control: " << fault.what() << '\n';
    }
    return wrong_usage;
}
