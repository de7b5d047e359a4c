// SPDX-License-Identifier: MIT
//
// Bytes of a Modbus RTU or FC line, in hexadecimal or live from a serial device, as readable frames: `decode --help`.
#include "support/arguments.hpp"
#include "support/hex.hpp"
#include "support/known_drives.hpp"
#include "support/line_options.hpp"
#include "support/listen.hpp"

#include <drivecodec/text/fc.hpp>
#include <drivecodec/text/modbus.hpp>

#include <exception>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

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
    --drive D        xd1000, vlt6000 or smd: names the registers or parameters of this drive and explains their values,
                     in JSON as `meaning`; vlt6000 has the FC protocol; an smd has the parameters of PV507, until its
                     register 50 is heard
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

struct options {
    support::line_options       line;
    support::known_drive const* drive         = nullptr;
    rtu::expecting              expect_modbus = rtu::expecting::either;
    fc::expecting               expect_fc     = fc::expecting::either;
    bool                        json          = false;
    std::optional<std::string>  hex;
};

//=== command line ===//

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
    auto&   line = chosen.line;
    while (not words.empty()) {
        if (not words.is_option()) {
            chosen.hex = chosen.hex.value_or("") + words.next("") + ' ';
            continue;
        }
        support::option word{words};
        auto const      name = word.name();
        if (name == "--json") {
            word.has_no_value();
            chosen.json = true;
        } else if (name == "--drive") {
            chosen.drive = &support::to_drive(word.value());
        } else if (name == "--expect") {
            auto const what      = word.value();
            chosen.expect_modbus = to_expecting<rtu::expecting>(what);
            chosen.expect_fc     = to_expecting<fc::expecting>(what);
        } else if (not line.take(word)) {
            word.refuse();
        }
    }
    if (chosen.hex and not line.device.empty()) {
        throw support::usage_error{"either hexadecimal or --device, not both"};
    }
    using support::line_protocol;
    auto const needs_fc = chosen.drive != nullptr and not chosen.drive->has_modbus;
    if (not line.protocol) { line.protocol = needs_fc ? line_protocol::fc : line_protocol::modbus; }
    if (chosen.drive == nullptr) { return chosen; }
    auto const with_article = std::string{chosen.drive->with_article};
    if (not chosen.drive->has_fc and line.protocol == line_protocol::fc) {
        throw support::usage_error{with_article + " does not have the FC protocol"};
    }
    if (not chosen.drive->has_modbus and line.protocol == line_protocol::modbus) {
        throw support::usage_error{with_article + " does not have Modbus"};
    }
    if (chosen.drive->has_fc and (line.process_words != 2 or line.parameter_bits != 11)) {
        throw support::usage_error{with_article + " has two process words and parameter numbers of 11 bits"};
    }
    return chosen;
}

//=== what comes out ===//

std::unique_ptr<support::decoder> make_decoder(options const& chosen)
{
    auto const how     = chosen.json ? support::style::json : support::style::text;
    auto const explain = chosen.drive != nullptr ? chosen.drive->make_explainer() : support::drive_explainer{};
    return support::make_decoder(chosen.line, {.expect = chosen.expect_modbus, .how = how, .explain = explain.modbus},
                                 {.expect = chosen.expect_fc, .how = how, .explain = explain.fc},
                                 support::lines_to(std::cout, chosen.json));
}

std::unique_ptr<support::decoder> make_hex_decoder(options const& chosen)
{
    auto out = make_decoder(chosen);
    if (chosen.line.request_first) { out->request_timed_out(); }
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

int listen(options const& chosen)
{
    auto const         out = make_decoder(chosen);
    support::timed_ear ear{*out, std::uint64_t{chosen.line.timeout} * 1000};
    auto const         has_fc = chosen.drive != nullptr and chosen.drive->has_fc;
    auto const         baud   = chosen.line.protocol == support::line_protocol::fc or has_fc ? 9600U : 19200U;
    support::listen(chosen.line, baud, ear, [] { std::cout.flush(); });
    out->end(false);
    std::cout << support::line_of(out->counters(), chosen.json) << std::endl;
    return exit_status(*out);
}

}  // namespace

int main(int argc, char** argv)
{
    try {
        auto const chosen = parse({argc, argv});
        auto const status = not chosen.line.device.empty() ? listen(chosen)
                            : chosen.hex                   ? decode_arguments(chosen)
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
