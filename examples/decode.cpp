// SPDX-License-Identifier: MIT
//
// Bytes of a Modbus RTU line, in hexadecimal or live from a serial device, as readable frames: `decode --help`.
#include "support/hex.hpp"
#include "support/modbus_json.hpp"
#include "support/serial_port.hpp"

#include <drivecodec/modbus/rtu/reader.hpp>
#include <drivecodec/text/modbus.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace modbus = drivecodec::modbus;
namespace rtu    = drivecodec::modbus::rtu;
using drivecodec::bytes;

constexpr auto usage = R"(Prints the Modbus RTU frames in bytes given in hexadecimal, or on a serial line.

    decode [options] HEX...           all arguments together are one line
    decode [options] < FILE           lines of hexadecimal; # begins a comment
    decode [options] --device PATH    listens to a serial device or pseudo-terminal until Ctrl-C, then counts

The end of a line is a silence of the bus. A response is read in the light of the request before it.

    --expect WHAT    request, response or either (default) is what is on the line
    --json           one JSON object a line
    --baud N         of the device (default 19200)
    --format 8E1     of the device: data bits, parity (N, E, O), stop bits
    --silence US     what ends a frame on the device, in microseconds; default: 3.5 characters, at least 20 000,
                     since USB adapters hold bytes back for up to 16 ms
    --timeout MS     a request without a response for so long on the device was not answered (default 1000)
    --help

Exit status: 0, 1 if bytes were dropped that belong to no frame, 2 for wrong usage or bad hexadecimal.
)";

constexpr int nothing_dropped = 0;
constexpr int bytes_dropped   = 1;
constexpr int wrong_usage     = 2;

struct options {
    rtu::expecting               expect = rtu::expecting::either;
    bool                         json   = false;
    bool                         help   = false;
    std::string                  device;
    std::uint32_t                baud   = 19200;
    rtu::character_format        format = rtu::format_8e1;
    std::optional<std::uint32_t> silence;  // microseconds
    std::uint32_t                timeout = 1000;
    std::string                  hex;
    bool                         has_hex = false;
};

//=== command line ===//

/// Says what is wrong and what to do about it.
bool refuse(std::string_view problem)
{
    std::cerr << "decode: " << problem << "; see decode --help\n";
    return false;
}

bool parse(std::string_view text, std::uint32_t& number)
{
    auto const [end, fault] = std::from_chars(text.data(), text.data() + text.size(), number);
    return fault == std::errc{} and end == text.data() + text.size() and number > 0;
}

bool parse(std::string_view text, rtu::expecting& expect)
{
    for (auto const what : {rtu::expecting::either, rtu::expecting::request, rtu::expecting::response}) {
        if (text == to_string(what)) {
            expect = what;
            return true;
        }
    }
    return false;
}

bool parse(std::string_view text, rtu::character_format& format)
{
    for (auto const parity : {rtu::parity::none, rtu::parity::even, rtu::parity::odd}) {
        for (auto const stop_bits : {rtu::stop_bits::one, rtu::stop_bits::two}) {
            std::array<char, 3> name;
            format = {parity, stop_bits};
            if (text == drivecodec::describe(format, name)) { return true; }
        }
    }
    return false;
}

bool parse(std::string_view text, std::optional<std::uint32_t>& number)
{
    return parse(text, number.emplace());
}

bool parse(std::string_view text, std::string& path)
{
    path = text;
    return not path.empty();
}

/// `--name=value` or `--name value`: takes the value that belongs to the option at `index`.
template <typename Value>
bool take(std::vector<std::string_view> const& arguments, std::size_t& index, Value& into)
{
    auto const argument = arguments[index];
    auto const equals   = argument.find('=');
    if (equals == std::string_view::npos and index + 1 == arguments.size()) {
        return refuse(std::string{argument} + " needs a value");
    }
    auto const value = equals == std::string_view::npos ? arguments[++index] : argument.substr(equals + 1);
    if (parse(value, into)) { return true; }
    return refuse(std::string{argument.substr(0, equals)} + " cannot be '" + std::string{value} + "'");
}

bool parse(std::vector<std::string_view> const& arguments, options& chosen)
{
    auto only_hex = false;
    for (std::size_t index = 0; index < arguments.size(); ++index) {
        auto const argument = arguments[index];
        auto const name     = argument.substr(0, argument.find('='));
        auto       is_fine  = true;
        if (only_hex or not argument.starts_with("--")) {
            chosen.hex.append(argument).append(" ");
            chosen.has_hex = true;
        } else if (argument == "--") {
            only_hex = true;
        } else if (argument == "--help") {
            chosen.help = true;
        } else if (argument == "--json") {
            chosen.json = true;
        } else if (name == "--expect") {
            is_fine = take(arguments, index, chosen.expect);
        } else if (name == "--device") {
            is_fine = take(arguments, index, chosen.device);
        } else if (name == "--baud") {
            is_fine = take(arguments, index, chosen.baud);
        } else if (name == "--format") {
            is_fine = take(arguments, index, chosen.format);
        } else if (name == "--silence") {
            is_fine = take(arguments, index, chosen.silence);
        } else if (name == "--timeout") {
            is_fine = take(arguments, index, chosen.timeout);
        } else {
            is_fine = refuse("there is no option " + std::string{argument});
        }
        if (not is_fine) { return false; }
    }
    if (chosen.has_hex and not chosen.device.empty()) { return refuse("either hexadecimal or --device, not both"); }
    return true;
}

//=== what comes out ===//

/// Feeds a reader and prints what it finds.
class printer {
public:
    explicit printer(options const& chosen) : reader_{chosen.expect}, json_{chosen.json} {}

    [[nodiscard]] rtu::reader& reader() { return reader_; }
    [[nodiscard]] bool         is_waiting_for_response() const { return not request_.empty(); }

    void push(bytes received)
    {
        while (not received.empty()) {
            received = reader_.push(received);
            print_all();
        }
    }

    void silence()
    {
        reader_.silence();
        print_all();
    }

    void request_timed_out()
    {
        reader_.request_timed_out();
        request_.clear();
        print_all();
    }

    void print_all()
    {
        while (auto const item = reader_.next()) {
            if (auto const* found = item.frame()) {
                print(*found);
            } else {
                std::cout << (json_ ? support::to_json(*item.dropped()) : text_of(*item.dropped())) << '\n';
            }
        }
        std::cout.flush();
    }

    void print_counters()
    {
        auto const& counted = reader_.counters();
        std::cout << (json_ ? support::to_json(counted) : text_of(counted)) << std::endl;
    }

    [[nodiscard]] int exit_status() const
    {
        return reader_.counters().dropped_bytes == 0 ? nothing_dropped : bytes_dropped;
    }

private:
    void print(rtu::frame const& found)
    {
        auto const is_request = found.direction == modbus::direction::request;
        auto const is_answer  = not is_request and not request_.empty() and request_.front() == found.address();
        auto const asked      = is_answer ? bytes{request_}.subspan(1) : bytes{};
        if (json_) {
            std::cout << support::to_json(found, asked) << '\n';
        } else {
            std::array<char, modbus::max_description_size> buffer;
            std::cout << describe(found, buffer, asked) << '\n';
        }
        request_.clear();
        if (is_request) {
            auto const address_and_pdu = found.raw.first(1 + found.pdu().size());
            request_.assign(address_and_pdu.begin(), address_and_pdu.end());
        }
    }

    [[nodiscard]] static std::string text_of(auto const& thing)
    {
        std::array<char, 1024> buffer;
        return std::string{drivecodec::describe(thing, buffer)};
    }

    rtu::reader               reader_;
    std::vector<std::uint8_t> request_;  // address and PDU, until its response came
    bool                      json_;
};

//=== hexadecimal ===//

bool decode_line(printer& out, std::string_view line, std::string_view where)
{
    auto const parsed = support::parse_hex(line);
    if (parsed.column != 0) {
        return refuse(std::string{where} + "character " + std::to_string(parsed.column) + ": " + parsed.problem);
    }
    out.push(parsed.bytes);
    out.silence();
    return true;
}

int decode_arguments(options const& chosen)
{
    printer out{chosen};
    return decode_line(out, chosen.hex, "") ? out.exit_status() : wrong_usage;
}

int decode_lines(options const& chosen)
{
    printer     out{chosen};
    std::string line;
    for (std::size_t number = 1; std::getline(std::cin, line); ++number) {
        if (not decode_line(out, line, "line " + std::to_string(number) + ", ")) { return wrong_usage; }
    }
    return out.exit_status();
}

//=== a live line ===//

volatile std::sig_atomic_t stopped = 0;

void stop(int)
{
    stopped = 1;
}

int listen(options const& chosen)
{
    using clock = std::chrono::steady_clock;
    constexpr std::uint32_t usb_latency = 20'000;
    constexpr std::uint32_t patience    = 200'000;  // to look at `stopped` on a line without traffic

    auto port = support::serial_port::open(chosen.device, chosen.baud, chosen.format);
    if (not port) {
        auto const* reason = errno == EINVAL ? "no serial device, or none with this baud rate" : std::strerror(errno);
        refuse("cannot open " + chosen.device + " with " + std::to_string(chosen.baud) + " baud: " + reason);
        return wrong_usage;
    }
    auto const silence = chosen.silence.value_or(
        std::max(rtu::timing::make(chosen.baud, chosen.format)->inter_frame(), usb_latency));

    static_cast<void>(std::signal(SIGINT, stop));
    static_cast<void>(std::signal(SIGTERM, stop));
    printer out{chosen};
    auto    heard = clock::now();
    for (auto is_silent = true; stopped == 0;) {
        auto const received = port->read(out.reader().prepare(), is_silent ? patience : silence);
        if (not received) { break; }
        if (*received > 0) {
            out.reader().commit(*received);
            out.print_all();
            heard = clock::now();
        } else {
            out.silence();
            auto const waited = clock::now() - heard;
            if (out.is_waiting_for_response() and waited > std::chrono::milliseconds{chosen.timeout}) {
                out.request_timed_out();
            }
        }
        is_silent = *received == 0;
    }
    out.silence();
    out.print_counters();
    return out.exit_status();
}

}  // namespace

int main(int argc, char** argv)
{
    options chosen;
    if (not parse({argv + 1, argv + argc}, chosen)) { return wrong_usage; }
    if (chosen.help) {
        std::cout << usage;
        return nothing_dropped;
    }
    if (not chosen.device.empty()) { return listen(chosen); }
    return chosen.has_hex ? decode_arguments(chosen) : decode_lines(chosen);
}
