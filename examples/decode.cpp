// SPDX-License-Identifier: MIT
//
// Bytes of a Modbus RTU or FC line, in hexadecimal or live from a serial device, as readable frames: `decode --help`.
#include "support/arguments.hpp"
#include "support/auto_decoder.hpp"
#include "support/fc_decoder.hpp"
#include "support/hex.hpp"
#include "support/modbus_decoder.hpp"
#include "support/serial_port.hpp"

#include <drivecodec/fc/timing.hpp>
#include <drivecodec/text/fc.hpp>
#include <drivecodec/text/modbus.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

namespace {

namespace fc  = drivecodec::fc;
namespace rtu = drivecodec::modbus::rtu;

constexpr auto usage =
    R"(Prints the Modbus RTU frames, or FC telegrams, in bytes given in hexadecimal, or on a serial line.

    decode [options] HEX...           all arguments together are one line
    decode [options] < FILE           lines of hexadecimal; # begins a comment
    decode [options] --device PATH    listens to a serial device or pseudo-terminal until Ctrl-C, then counts

The end of a line is a silence of the bus. A response is read in the light of the request before it.

    --protocol P     modbus (default), fc for the FC protocol of Danfoss drives, or auto to find out
    --expect WHAT    request, response or either (default) is what is on the line
    --request-first  the first FC telegram in hexadecimal is a request; live a silence of --timeout tells that. Until
                     something tells who speaks, telegrams are `to or from` a slave, and --drive explains little
    --json           one JSON object a line
    --drive D        xd1000 or vlt6000: names the registers or parameters of this drive and explains their values, in
                     JSON as `meaning`; vlt6000 has the FC protocol
    --pcd N          words of process data in an FC telegram, 2 (default) to 16
    --pnu-bits N     bits of an FC parameter number, 11 (default), or 12 as in newer drives
    --baud N         of the device (default 19200, for fc and for a vlt6000 9600)
    --format 8E1     of the device: data bits, parity (N, E, O), stop bits
    --silence US     what ends a frame on the device, in microseconds; default: 3.5 characters, for fc 3, at least
                     20 000, since USB adapters hold bytes back for up to 16 ms
    --timeout MS     a request without a response for so long on the device was not answered (default 1000)
    --help

With --protocol auto the first frame with a right CRC tells that it is Modbus, and two telegrams with a right BCC, of
which no such frame begins before the end, that it is FC; for the rest of the input it is that. Until then nothing is
printed. Where 4096 bytes have not told, they are printed as dropped bytes, and the search begins anew. Bytes that are
both are Modbus. In hexadecimal, at the end of the input, one FC telegram is enough if it stands at the begin of a line;
live it is not.

Exit status: 0, 1 if bytes were dropped that belong to no frame, 2 for wrong usage or bad hexadecimal.
)";

constexpr int nothing_dropped = 0;
constexpr int bytes_dropped   = 1;
constexpr int wrong_usage     = 2;  // and whatever else keeps the program from its work

enum class protocol { modbus, fc, unknown };

struct options {
    std::optional<::protocol>    protocol;
    support::modbus_options      modbus;
    support::fc_options          fc;
    bool                         request_first = false;
    std::string                  device;
    std::optional<std::uint32_t> baud;
    rtu::character_format        format = rtu::format_8e1;
    std::optional<std::uint32_t> silence;  // microseconds
    std::uint32_t                timeout = 1000;
    std::optional<std::string>   hex;
};

//=== command line ===//

protocol to_protocol(std::string const& word)
{
    if (word == "modbus") { return protocol::modbus; }
    if (word == "fc") { return protocol::fc; }
    if (word == "auto") { return protocol::unknown; }
    throw support::usage_error{"'" + word + "' is none of modbus, fc, auto"};
}

template <typename Expecting>
Expecting to_expecting(std::string const& word)
{
    for (auto const what : {Expecting::either, Expecting::request, Expecting::response}) {
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
        if (word == "--request-first") {
            chosen.request_first = true;
        } else if (word == "--json") {
            chosen.modbus.json = chosen.fc.json = true;
        } else if (name == "--protocol") {
            chosen.protocol = to_protocol(value());
        } else if (name == "--drive") {
            auto const drive     = value();
            chosen.modbus.xd1000 = drive == "xd1000";
            chosen.fc.vlt6000    = drive == "vlt6000";
            if (not chosen.modbus.xd1000 and not chosen.fc.vlt6000) {
                throw support::usage_error{"'" + drive + "' is no drive that is known here: xd1000, vlt6000"};
            }
        } else if (name == "--expect") {
            auto const what      = value();
            chosen.modbus.expect = to_expecting<rtu::expecting>(what);
            chosen.fc.expect     = to_expecting<fc::expecting>(what);
        } else if (name == "--pcd") {
            chosen.fc.process_words = support::to<std::size_t>(value(), 2, 16);
        } else if (name == "--pnu-bits") {
            chosen.fc.parameter_bits = support::to<unsigned>(value(), 11, 12);
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
    if (not chosen.protocol) { chosen.protocol = chosen.fc.vlt6000 ? protocol::fc : protocol::modbus; }
    if (chosen.modbus.xd1000 and chosen.protocol == protocol::fc) {
        throw support::usage_error{"an xd1000 does not have the FC protocol"};
    }
    if (chosen.fc.vlt6000 and chosen.protocol == protocol::modbus) {
        throw support::usage_error{"a vlt6000 does not have Modbus"};
    }
    if (chosen.fc.vlt6000 and (chosen.fc.process_words != 2 or chosen.fc.parameter_bits != 11)) {
        throw support::usage_error{"a vlt6000 has two process words and parameter numbers of 11 bits"};
    }
    return chosen;
}

//=== what comes out ===//

std::unique_ptr<support::decoder> make_decoder(options const& chosen)
{
    auto const make_modbus = [chosen](std::ostream& out) {
        return std::make_unique<support::modbus_decoder>(chosen.modbus, out);
    };
    auto const make_fc = [chosen](std::ostream& out) { return support::make_fc_decoder(chosen.fc, out); };
    switch (*chosen.protocol) {
    case protocol::modbus: return make_modbus(std::cout);
    case protocol::fc: return make_fc(std::cout);
    case protocol::unknown: break;
    }
    return std::make_unique<support::auto_decoder>(make_modbus, make_fc, std::cout);
}

std::unique_ptr<support::decoder> make_hex_decoder(options const& chosen)
{
    auto out = make_decoder(chosen);
    if (chosen.request_first) { out->request_timed_out(); }
    return out;
}

int exit_status(support::decoder const& out)
{
    return out.counters().dropped_bytes == 0 ? nothing_dropped : bytes_dropped;
}

//=== hexadecimal ===//

void decode_line(support::decoder& out, std::string_view line, std::string const& where)
{
    auto const parsed = support::parse_hex(line);
    if (parsed.column != 0) {
        out.end(true);
        throw support::usage_error{where + "character " + std::to_string(parsed.column) + ": " + parsed.problem};
    }
    out.push(parsed.bytes);
    out.silence();
}

int decode_arguments(options const& chosen)
{
    auto const out = make_hex_decoder(chosen);
    decode_line(*out, *chosen.hex, "");
    out->end(true);
    return exit_status(*out);
}

int decode_lines(options const& chosen)
{
    auto const  out = make_hex_decoder(chosen);
    std::string line;
    for (std::size_t number = 1; std::getline(std::cin, line); ++number) {
        decode_line(*out, line, "line " + std::to_string(number) + ", ");
    }
    out->end(true);
    return exit_status(*out);
}

//=== a live line ===//

std::sig_atomic_t volatile& stopped()
{
    static volatile std::sig_atomic_t flag = 0;
    return flag;
}

void stop(int)
{
    stopped() = 1;
}

/// Behind which a frame begins anew, in microseconds.
std::uint32_t silence_at(options const& chosen, std::uint32_t baud)
{
    constexpr std::uint32_t usb_latency = 20'000;
    auto const              by_protocol = chosen.protocol == protocol::fc ? fc::timing::make(baud)->silence()
                                                                          : rtu::timing::make(baud, chosen.format)->inter_frame();
    return chosen.silence.value_or(std::max(by_protocol, usb_latency));
}

int listen(options const& chosen)
{
    using clock                      = std::chrono::steady_clock;
    constexpr std::uint32_t patience = 200'000;  // to look at `stopped` on a line without traffic

    auto const baud = chosen.baud.value_or(chosen.protocol == protocol::fc or chosen.fc.vlt6000 ? 9600 : 19200);
    auto       port = support::serial_port::open(chosen.device, baud, chosen.format);
    if (not port) {
        auto const reason = errno == EINVAL ? std::string{"not a baud rate of this device"}
                                            : std::error_code{errno, std::generic_category()}.message();
        throw support::usage_error{"cannot open " + chosen.device + " with " + std::to_string(baud)
                                   + " baud: " + reason};
    }
    auto const silence = silence_at(chosen, baud);

    static_cast<void>(std::signal(SIGINT, stop));
    static_cast<void>(std::signal(SIGTERM, stop));
    auto const                    out   = make_decoder(chosen);
    auto                          heard = clock::now();
    std::array<std::uint8_t, 256> room;
    for (auto is_silent = true; stopped() == 0;) {
        auto const is_idle  = is_silent and not out->is_waiting_for_response();
        auto const received = port->read(room, is_idle ? patience : silence);
        if (not received) { break; }
        if (out->is_waiting_for_response() and clock::now() - heard > std::chrono::milliseconds{chosen.timeout}) {
            out->request_timed_out();
        }
        is_silent = *received == 0;
        if (is_silent) {
            out->silence();
        } else {
            out->push(drivecodec::bytes{room}.first(*received));
            heard = clock::now();
        }
    }
    out->silence();
    out->end(false);
    std::cout << support::line_of(out->counters(), chosen.modbus.json) << std::endl;
    return exit_status(*out);
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        auto const chosen = parse({argc, argv});
        auto const status = not chosen.device.empty() ? listen(chosen)
                            : chosen.hex              ? decode_arguments(chosen)
                                                      : decode_lines(chosen);
        if (std::cout.flush()) { return status; }
        std::cerr << "decode: cannot write what was decoded; is the disk full?\n";
    } catch (support::help_wanted) {
        std::cout << usage;
        return nothing_dropped;
    } catch (support::usage_error const& problem) {
        std::cerr << "decode: " << problem.what() << "; see decode --help\n";
    } catch (std::exception const& problem) {
        std::cerr << "decode: " << problem.what() << '\n';
    }
    return wrong_usage;
}
