// SPDX-License-Identifier: MIT
//
// A Modbus RTU client: asks a server once or again and again, and prints what it answers.
//
//     modbus_poll --device /dev/ttyUSB0 --address 17 read-holding 107 3
#include "support/arguments.hpp"
#include "support/client.hpp"
#include "support/hex.hpp"
#include "support/serial_port.hpp"

#include <drivecodec/modbus.hpp>
#include <drivecodec/text/modbus.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;

namespace {

constexpr int answered     = 0;
constexpr int not_answered = 1;
constexpr int wrong_usage  = 2;

constexpr auto usage = R"(usage: modbus_poll --device PATH [options] COMMAND

  read-holding FIRST COUNT           03    read-coils FIRST COUNT             01
  read-input FIRST COUNT             04    read-inputs FIRST COUNT            02
  write-register ADDRESS VALUE       06    write-coil ADDRESS on|off          05
  write-registers FIRST VALUE...     16    write-coils FIRST 0|1...           15
  mask-write ADDRESS AND OR          22    read-write FIRST COUNT FIRST VALUE... 23
  fifo ADDRESS                       24    read-file FILE RECORD COUNT ...    20
  identify [basic|regular|extended|ID]     write-file FILE RECORD VALUE...    21
                                  43/14    server-id                          17
  exception-status                   07    diagnostics SUB-FUNCTION [WORD...] 08
  event-counter                      11    event-log                          12
  raw BYTES: a PDU in hexadecimal, as 03006B0003

  --device PATH    a serial device or pseudo-terminal
  --address N      of the server, 1 to 247, or 0 for a broadcast (1)
  --baud N         (19200)
  --format 8E1     data bits, parity, stop bits (8E1)
  --timeout MS     how long to wait for a reply (500)
  --retries N      how often to ask again without a reply (2)
  --every MS       asks again and again, until Ctrl-C
  --echo           the adapter hears what it sends (two-wire lines)
  --silence US     what ends a frame, in microseconds (3.5 characters, at least 20000: USB adapters hold bytes back)
  --as TYPE        shows registers as uint16 (default), int16, uint32, int32 or float
  --order ORDER    of the bytes of 32-bit values: abcd (default), cdab, badc, dcba
  --verbose        shows every frame in words

Addresses count from 0. Exit status: 0, 1 without an answer or with an exception, 2 for wrong usage.
)";

/// How registers are shown.
enum class value_type : std::uint8_t { uint16, int16, uint32, int32, float32 };

constexpr struct {
    std::string_view name;
    value_type       type;
} value_types[] = {{"uint16", value_type::uint16}, {"int16", value_type::int16}, {"uint32", value_type::uint32},
                   {"int32", value_type::int32}, {"float", value_type::float32}};

constexpr rtu::server_address default_server{1};

struct options {
    std::string                  device;
    rtu::server_address          address = default_server;
    std::uint32_t                baud    = 19200;
    rtu::character_format        format  = rtu::format_8e1;
    support::client::settings    line;
    std::optional<std::uint32_t> silence;
    std::chrono::milliseconds    every{0};
    value_type                   type    = value_type::uint16;
    modbus::word_order           order   = modbus::word_order::abcd;
    bool                         verbose = false;
};

//=== how values are shown ===//

std::size_t words_of(value_type type) { return type == value_type::uint16 or type == value_type::int16 ? 1 : 2; }

void print_value(options const& given, modbus::register_view values, std::size_t i)
{
    switch (given.type) {
    case value_type::uint16: std::cout << values[i]; break;
    case value_type::int16: std::cout << static_cast<std::int16_t>(values[i]); break;
    case value_type::uint32: std::cout << modbus::from_registers<std::uint32_t>(values, i, given.order); break;
    case value_type::int32: std::cout << modbus::from_registers<std::int32_t>(values, i, given.order); break;
    case value_type::float32: std::cout << modbus::from_registers<float>(values, i, given.order); break;
    }
}

/// What was asked for, one line a value.
template <typename Range>
void print_values(options const& given, Range asked, modbus::register_view values)
{
    auto const step = words_of(given.type);
    for (std::size_t i = 0; i + step <= values.size(); i += step) {
        std::cout << asked.first() + i << ": ";
        print_value(given, values, i);
        std::cout << '\n';
    }
}
template <typename Range>
void print_values(options const&, Range asked, modbus::coil_view states)
{
    // A response has whole bytes; only the request knows how many states count.
    for (std::size_t i = 0; i < asked.count(); ++i) {
        std::cout << asked.first() + i << ": " << (states[i] ? "on" : "off") << '\n';
    }
}

template <typename Message>
void print_fields(Message const& message)
{
    std::array<char, 4096>  text{};
    drivecodec::text_writer out{text};
    modbus::write_fields(out, message);
    std::cout << out.view_with_ellipsis() << '\n';
}

//=== asking ===//

struct session {
    support::client& line;
    options const&   given;

    /// Asks, and lets `show` print the response. Returns the exit status.
    template <modbus::message Request, typename Show>
    int ask(Request const& request, Show show)
    {
        if (given.address.is_broadcast() and not modbus::is_write<typename Request::function>()) {
            throw support::usage_error{"only a write can be broadcast: nobody answers a broadcast"};
        }
        auto const answer = line.ask(given.address, request);
        if (not answer) { return complain("no answer from the server"); }
        if (*answer) {
            show(**answer);
            return answered;
        }
        auto const fault = answer->error();
        if (fault.code() == drivecodec::errc::no_reply) {
            std::cout << "sent; nobody answers this\n";
            return answered;
        }
        if (fault.code() != drivecodec::errc::exception_reply) { return complain(explain(fault.code())); }
        auto const number = static_cast<unsigned>(fault.exception());
        return complain("exception " + std::to_string(number) + ' ' + std::string{to_string(fault.exception())});
    }

    /// The same for a request that `make` checked.
    template <typename Request, typename Show>
    int ask(drivecodec::result<Request> const& request, Show show)
    {
        if (not request) { throw support::usage_error{std::string{explain(request.error().code())}}; }
        return ask(*request, show);
    }

    static int complain(std::string_view what)
    {
        std::cout.flush();
        std::cerr << what << '\n';
        return not_answered;
    }
};

//=== the commands ===//

using support::arguments;

std::uint16_t next_word(arguments& words, char const* what)
{
    return support::to<std::uint16_t>(words.next(what));
}

/// All that is left: at least one.
std::vector<std::uint16_t> rest_as_registers(arguments& words)
{
    std::vector<std::uint16_t> values;
    do { values.push_back(support::to_register(words.next("a value"))); } while (not words.empty());
    return values;
}

bool to_state(std::string const& word)
{
    if (word == "1" or word == "on") { return true; }
    if (word == "0" or word == "off") { return false; }
    throw support::usage_error{"'" + word + "' is neither on, 1, off nor 0"};
}

constexpr auto say_done   = [](auto const&) { std::cout << "done\n"; };
constexpr auto say_fields = [](auto const& given) { print_fields(given); };

/// FIRST COUNT, as a range or why it is none.
template <typename Range>
drivecodec::result<Range> next_range(arguments& words)
{
    auto const first = next_word(words, "the first address");
    return Range::make(first, next_word(words, "the count"));
}

template <typename Function>
int read_values(session& s, arguments& words)
{
    auto const range = next_range<decltype(Function::request::range)>(words);
    if (not range) { throw support::usage_error{std::string{explain(range.error().code())}}; }
    return s.ask(typename Function::request{.range = *range},
                 [&](auto const& given) { print_values(s.given, *range, given.values); });
}

int write_register(session& s, arguments& words)
{
    auto const address = next_word(words, "the address");
    auto const value   = support::to_register(words.next("the value"));
    return s.ask(modbus::write_single_register::request{.address = address, .value = value}, say_done);
}

int write_registers(session& s, arguments& words)
{
    auto const first  = next_word(words, "the first address");
    auto const values = rest_as_registers(words);
    return s.ask(modbus::write_multiple_registers::request::make(first, std::span{values}), say_done);
}

int write_coil(session& s, arguments& words)
{
    auto const address = next_word(words, "the address");
    auto const value   = to_state(words.next("on or off"));
    return s.ask(modbus::write_single_coil::request{.address = address, .value = value}, say_done);
}

int write_coils(session& s, arguments& words)
{
    auto const             first = next_word(words, "the first address");
    std::array<bool, 2000> states{};
    std::size_t            count = 0;
    do { states.at(count++) = to_state(words.next("a state")); } while (not words.empty());
    return s.ask(modbus::write_multiple_coils::request::make(first, std::span<bool const>{states}.first(count)),
                 say_done);
}

int mask_write(session& s, arguments& words)
{
    auto const address  = next_word(words, "the address");
    auto const and_mask = next_word(words, "the AND mask");
    auto const or_mask  = next_word(words, "the OR mask");
    return s.ask(modbus::mask_write_register::request{.address = address, .and_mask = and_mask, .or_mask = or_mask},
                 say_done);
}

int read_write(session& s, arguments& words)
{
    using function   = modbus::read_write_multiple_registers;
    auto const range = next_range<function::range_to_read>(words);
    if (not range) { throw support::usage_error{std::string{explain(range.error().code())}}; }
    auto const first  = next_word(words, "the first address to write");
    auto const values = rest_as_registers(words);
    return s.ask(function::request::make(*range, first, std::span{values}),
                 [&](auto const& given) { print_values(s.given, *range, given.values); });
}

int fifo(session& s, arguments& words)
{
    return s.ask(modbus::read_fifo_queue::request{.address = next_word(words, "the address")}, say_fields);
}

int read_file(session& s, arguments& words)
{
    std::vector<modbus::file_record_range> ranges;
    do {
        auto const file   = next_word(words, "the file");
        auto const record = next_word(words, "the record");
        auto const made   = modbus::file_record_range::make(file, record, next_word(words, "the count"));
        if (not made) { throw support::usage_error{std::string{explain(made.error().code())}}; }
        ranges.push_back(*made);
    } while (not words.empty());
    auto const list = std::span<modbus::file_record_range const>{ranges};
    return s.ask(modbus::read_file_record::request::make(list), say_fields);
}

int write_file(session& s, arguments& words)
{
    auto const file   = next_word(words, "the file");
    auto const record = next_word(words, "the record");
    auto const values = rest_as_registers(words);
    auto const made   = modbus::file_record::make(file, record, std::span{values});
    if (not made) { throw support::usage_error{std::string{explain(made.error().code())}}; }
    return s.ask(modbus::write_file_record::request::make(std::array{*made}), say_done);
}

/// What has nothing to ask for but itself.
template <typename Function>
int read_fields(session& s, arguments&)
{
    return s.ask(typename Function::request{}, say_fields);
}

int diagnostics(session& s, arguments& words)
{
    auto const sub    = static_cast<modbus::diagnostic>(next_word(words, "the sub-function"));
    auto const values = words.empty() ? std::vector<std::uint16_t>{0} : rest_as_registers(words);
    return s.ask(modbus::diagnostics::request::make(sub, std::span{values}), say_fields);
}

/// A stream of objects may take several requests.
int identify(session& s, arguments& words)
{
    using enum modbus::read_device_id_code;
    auto const what = words.empty() ? std::string{"regular"} : words.next("what");
    auto const code = what == "basic" ? basic : what == "regular" ? regular : what == "extended" ? extended : specific;
    auto object = code == specific ? support::to<std::uint8_t>(what) : std::uint8_t{0};
    for (auto more = true; more;) {
        more = false;
        auto const request =
            modbus::read_device_identification::request::make(code, static_cast<modbus::device_object_id>(object));
        auto const status = s.ask(request, [&](modbus::read_device_identification::response const& given) {
            for (auto const found : given.objects()) {
                auto const name = to_string(found.id);
                std::cout << (name.empty() ? std::to_string(static_cast<unsigned>(found.id)) : std::string{name})
                          << ": " << std::string{found.value.begin(), found.value.end()} << '\n';
            }
            auto const next = static_cast<std::uint8_t>(given.next_object_id());
            more            = given.more_follows() and next > object;  // a server that goes in circles is not followed
            object          = next;
        });
        if (status != answered) { return status; }
    }
    return answered;
}

int raw(session& s, arguments& words)
{
    auto const pdu = support::parse_hex(words.next("the PDU"));
    if (not pdu.problem.empty()) { throw support::usage_error{pdu.problem}; }
    if (pdu.bytes.empty() or pdu.bytes.size() > modbus::max_pdu_size) {
        throw support::usage_error{"a PDU has 1 to 253 bytes"};
    }
    auto const answer = s.line.ask_raw(s.given.address, pdu.bytes);
    if (not answer) { return s.complain("no answer from the server"); }
    std::cout << support::to_hex(*answer) << '\n';
    return answered;
}

struct command {
    std::string_view name;
    int (*run)(session&, arguments&);
};
constexpr command commands[] = {
    {"read-coils", read_values<modbus::read_coils>},
    {"read-inputs", read_values<modbus::read_discrete_inputs>},
    {"read-holding", read_values<modbus::read_holding_registers>},
    {"read-input", read_values<modbus::read_input_registers>},
    {"write-coil", write_coil},
    {"write-register", write_register},
    {"write-coils", write_coils},
    {"write-registers", write_registers},
    {"mask-write", mask_write},
    {"read-write", read_write},
    {"fifo", fifo},
    {"read-file", read_file},
    {"write-file", write_file},
    {"exception-status", read_fields<modbus::read_exception_status>},
    {"diagnostics", diagnostics},
    {"event-counter", read_fields<modbus::get_comm_event_counter>},
    {"event-log", read_fields<modbus::get_comm_event_log>},
    {"server-id", read_fields<modbus::report_server_id>},
    {"identify", identify},
    {"raw", raw},
};

command const& find_command(std::string const& name)
{
    for (auto const& known : commands) {
        if (known.name == name) { return known; }
    }
    throw support::usage_error{"there is no command '" + name + "'"};
}

//=== the command line ===//

modbus::word_order to_order(std::string const& word)
{
    using enum modbus::word_order;
    for (auto const order : {abcd, cdab, badc, dcba}) {
        if (word == to_string(order)) { return order; }
    }
    throw support::usage_error{"'" + word + "' is not an order such as abcd"};
}

value_type to_type(std::string const& word)
{
    for (auto const& row : value_types) {
        if (row.name == word) { return row.type; }
    }
    throw support::usage_error{"'" + word + "' is not a type such as uint16"};
}

/// Takes the options that come before the command.
options parse(arguments& words)
{
    options given;
    while (words.is_option()) {
        auto const word         = words.next("an option");
        auto const value        = [&] { return words.next("the value of " + word); };
        auto const milliseconds = [&] {
            return std::chrono::milliseconds{support::to<std::uint32_t>(value(), 1, 3'600'000)};
        };
        if (word == "--device") {
            given.device = value();
        } else if (word == "--address") {
            given.address = *rtu::server_address::make(support::to<std::uint8_t>(value(), 0, 247));
        } else if (word == "--baud") {
            given.baud = support::to<std::uint32_t>(value(), 1);
        } else if (word == "--format") {
            given.format = support::to_format(value());
        } else if (word == "--timeout") {
            given.line.timeout = milliseconds();
        } else if (word == "--retries") {
            given.line.retries = support::to<unsigned>(value(), 0, 1000);
        } else if (word == "--every") {
            given.every = milliseconds();
        } else if (word == "--echo") {
            given.line.echo = true;
        } else if (word == "--silence") {
            given.silence = support::to<std::uint32_t>(value(), 1);
        } else if (word == "--as") {
            given.type = to_type(value());
        } else if (word == "--order") {
            given.order = to_order(value());
        } else if (word == "--verbose") {
            given.verbose = true;
        } else {
            throw support::usage_error{"unknown option '" + word + "'"};
        }
    }
    if (given.device.empty()) { throw support::usage_error{"--device is missing"}; }
    return given;
}

std::sig_atomic_t volatile stop = 0;  // set by a signal. NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

void wait_until(std::chrono::steady_clock::time_point when)
{
    constexpr auto look_for_signals = std::chrono::milliseconds{50};
    while (stop == 0) {
        auto const left = when - std::chrono::steady_clock::now();
        if (left.count() <= 0) { return; }
        std::this_thread::sleep_for(std::min<std::chrono::nanoseconds>(left, look_for_signals));
    }
}

int run(arguments words)
{
    auto        given  = parse(words);
    auto const& chosen = find_command(words.next("the command"));

    auto port = support::serial_port::open(given.device, given.baud, given.format);
    if (not port) { throw std::system_error{errno, std::generic_category(), given.device}; }
    support::rtu_line const line{given.baud, given.format};
    given.line.silence = std::max(given.line.silence, std::chrono::microseconds{line.silence()});
    if (given.silence) { given.line.silence = std::chrono::microseconds{*given.silence}; }
    support::client client{std::move(*port), line, given.line};
    if (given.verbose) {
        client.trace = [](rtu::frame const& frame) {
            std::array<char, 2000> text{};
            std::cerr << rtu::describe(frame, text) << '\n';
        };
    }

    session s{client, given};
    for (auto due = std::chrono::steady_clock::now();;) {
        auto       rest   = words;
        auto const status = chosen.run(s, rest);
        if (not rest.empty()) { s.complain("ignored: '" + rest.next("a word") + "'"); }
        std::cout.flush();
        due += given.every;
        if (given.every.count() > 0) { wait_until(due); }
        if (given.every.count() == 0 or stop != 0) { return status; }
    }
}

}  // namespace

int main(int argc, char** argv)
{
    struct sigaction action{};
    action.sa_handler = [](int) { stop = 1; };
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    try {
        return run({argc, argv});
    } catch (support::help_wanted) {
        std::cout << usage;
        return 0;
    } catch (support::usage_error const& fault) {
        std::cerr << "modbus_poll: " << fault.what() << "\n\n" << usage;
    } catch (std::exception const& fault) {
        std::cerr << "modbus_poll: " << fault.what() << '\n';
    }
    return wrong_usage;
}
