// SPDX-License-Identifier: MIT
//
// Bytes of a Modbus RTU line, in hexadecimal or live from a serial device, as readable frames: `decode --help`.
#include "support/arguments.hpp"
#include "support/hex.hpp"
#include "support/modbus_json.hpp"
#include "support/serial_port.hpp"
#include "support/xd1000_traffic.hpp"

#include <drivecodec/modbus/rtu/reader.hpp>
#include <drivecodec/text/modbus.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <exception>
#include <iostream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
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
    --drive xd1000   names the registers of this drive and explains their values; not with --json
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
constexpr int wrong_usage     = 2;  // and whatever else keeps the program from its work

struct options {
    rtu::expecting               expect = rtu::expecting::either;
    bool                         json   = false;
    bool                         help   = false;
    bool                         xd1000 = false;
    std::string                  device;
    std::uint32_t                baud   = 19200;
    rtu::character_format        format = rtu::format_8e1;
    std::optional<std::uint32_t> silence;  // microseconds
    std::uint32_t                timeout = 1000;
    std::optional<std::string>   hex;
};

//=== command line ===//

rtu::expecting to_expecting(std::string const& word)
{
    for (auto const what : {rtu::expecting::either, rtu::expecting::request, rtu::expecting::response}) {
        if (word == to_string(what)) { return what; }
    }
    throw support::usage_error{"'" + word + "' is none of request, response, either"};
}

options parse(support::arguments words)
{
    options chosen;
    while (not words.empty()) {
        if (not words.is_option()) {
            chosen.hex = chosen.hex.value_or("") + words.next("") + ' ';
            continue;
        }
        auto const word   = words.next("");
        auto const equals = word.find('=');
        auto const name   = word.substr(0, equals);
        auto const value  = [&] {  // --name value or --name=value
            return equals == std::string::npos ? words.next("the value of " + name) : word.substr(equals + 1);
        };
        if (word == "--help") {
            chosen.help = true;
        } else if (word == "--json") {
            chosen.json = true;
        } else if (name == "--drive") {
            if (auto const drive = value(); drive != "xd1000") {
                throw support::usage_error{"'" + drive + "' is no drive that is known here: xd1000"};
            }
            chosen.xd1000 = true;
        } else if (name == "--expect") {
            chosen.expect = to_expecting(value());
        } else if (name == "--device") {
            chosen.device = value();
        } else if (name == "--baud") {
            chosen.baud = support::to<std::uint32_t>(value(), 1);
        } else if (name == "--format") {
            chosen.format = support::to_format(value());
        } else if (name == "--silence") {
            chosen.silence = support::to<std::uint32_t>(value(), 1);
        } else if (name == "--timeout") {
            chosen.timeout = support::to<std::uint32_t>(value(), 1);
        } else {
            throw support::usage_error{"there is no option " + word};
        }
    }
    if (chosen.hex and not chosen.device.empty()) {
        throw support::usage_error{"either hexadecimal or --device, not both"};
    }
    if (chosen.xd1000 and chosen.json) { throw support::usage_error{"either --drive or --json, not both"}; }
    return chosen;
}

//=== what comes out ===//

/// Feeds a reader and prints what it finds.
class printer {
public:
    explicit printer(options const& chosen) : reader_{chosen.expect}, json_{chosen.json}, names_registers_{chosen.xd1000}
    {}

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
            if (auto const meaning = names_registers_ ? drive_.explain(found, asked) : ""; not meaning.empty()) {
                std::cout << "    " << meaning << '\n';
            }
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
    bool                      names_registers_;
    support::xd1000_traffic   drive_;
};

//=== hexadecimal ===//

void decode_line(printer& out, std::string_view line, std::string const& where)
{
    auto const parsed = support::parse_hex(line);
    if (parsed.column != 0) {
        throw support::usage_error{where + "character " + std::to_string(parsed.column) + ": " + parsed.problem};
    }
    out.push(parsed.bytes);
    out.silence();
}

int decode_arguments(options const& chosen)
{
    printer out{chosen};
    decode_line(out, *chosen.hex, "");
    return out.exit_status();
}

int decode_lines(options const& chosen)
{
    printer     out{chosen};
    std::string line;
    for (std::size_t number = 1; std::getline(std::cin, line); ++number) {
        decode_line(out, line, "line " + std::to_string(number) + ", ");
    }
    return out.exit_status();
}

//=== a live line ===//

volatile std::sig_atomic_t& stopped()
{
    static volatile std::sig_atomic_t flag = 0;
    return flag;
}

void stop(int)
{
    stopped() = 1;
}

int listen(options const& chosen)
{
    using clock = std::chrono::steady_clock;
    constexpr std::uint32_t usb_latency = 20'000;
    constexpr std::uint32_t patience    = 200'000;  // to look at `stopped` on a line without traffic

    auto port = support::serial_port::open(chosen.device, chosen.baud, chosen.format);
    if (not port) {
        auto const reason = errno == EINVAL ? std::string{"not a baud rate of this device"}
                                            : std::error_code{errno, std::generic_category()}.message();
        throw support::usage_error{"cannot open " + chosen.device + " with " + std::to_string(chosen.baud)
                                   + " baud: " + reason};
    }
    auto const silence = chosen.silence.value_or(
        std::max(rtu::timing::make(chosen.baud, chosen.format)->inter_frame(), usb_latency));

    static_cast<void>(std::signal(SIGINT, stop));
    static_cast<void>(std::signal(SIGTERM, stop));
    printer out{chosen};
    auto    heard = clock::now();
    for (auto is_silent = true; stopped() == 0;) {
        auto const is_idle  = is_silent and not out.is_waiting_for_response();
        auto const received = port->read(out.reader().prepare(), is_idle ? patience : silence);
        if (not received) { break; }
        if (out.is_waiting_for_response() and clock::now() - heard > std::chrono::milliseconds{chosen.timeout}) {
            out.request_timed_out();
        }
        is_silent = *received == 0;
        if (is_silent) {
            out.silence();
        } else {
            out.reader().commit(*received);
            out.print_all();
            heard = clock::now();
        }
    }
    out.silence();
    out.print_counters();
    return out.exit_status();
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        auto const chosen = parse({argc, argv});
        if (chosen.help) {
            std::cout << usage;
            return nothing_dropped;
        }
        auto const status = not chosen.device.empty() ? listen(chosen)
                            : chosen.hex              ? decode_arguments(chosen)
                                                      : decode_lines(chosen);
        if (std::cout.flush()) { return status; }
        std::cerr << "decode: cannot write what was decoded; is the disk full?\n";
    } catch (support::usage_error const& problem) {
        std::cerr << "decode: " << problem.what() << "; see decode --help\n";
    } catch (std::exception const& problem) {
        std::cerr << "decode: " << problem.what() << '\n';
    }
    return wrong_usage;
}
