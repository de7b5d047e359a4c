// SPDX-License-Identifier: MIT
#pragma once

#include "arguments.hpp"
#include "auto_decoder.hpp"
#include "fc_decoder.hpp"
#include "modbus_decoder.hpp"

#include <drivecodec/fc/timing.hpp>
#include <drivecodec/modbus/rtu/timing.hpp>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

// What a command line says of a line that is listened to.

namespace support {

enum class line_protocol : std::uint8_t { modbus, fc, unknown };

[[nodiscard]] inline line_protocol to_protocol(std::string const& word)
{
    if (word == "modbus") { return line_protocol::modbus; }
    if (word == "fc") { return line_protocol::fc; }
    if (word == "auto") { return line_protocol::unknown; }
    throw usage_error{"'" + word + "' is none of modbus, fc, auto"};
}

struct line_options {
    std::optional<line_protocol>              protocol;
    bool                                      request_first  = false;
    std::size_t                               process_words  = fc_options{}.process_words;
    unsigned                                  parameter_bits = fc_options{}.parameter_bits;
    std::string                               device;
    std::optional<std::uint32_t>              baud;
    drivecodec::modbus::rtu::character_format format = drivecodec::modbus::rtu::format_8e1;
    std::optional<std::uint32_t>              silence;  // microseconds
    std::uint32_t                             timeout = 1000;

    /// False: this is none of its options.
    [[nodiscard]] bool take(option& word)
    {
        if (word.name() == "--request-first") {
            word.has_no_value();
            request_first = true;
        } else if (word.name() == "--protocol") {
            protocol = to_protocol(word.value());
        } else if (word.name() == "--pcd") {
            process_words = to<std::size_t>(word.value(), 2, 16);
        } else if (word.name() == "--pnu-bits") {
            parameter_bits = to<unsigned>(word.value(), 11, 12);
        } else if (word.name() == "--device") {
            device = word.value();
        } else if (word.name() == "--baud") {
            baud = to<std::uint32_t>(word.value(), 1);
        } else if (word.name() == "--format") {
            format = to_format(word.value());
        } else if (word.name() == "--silence") {
            silence = to<std::uint32_t>(word.value(), 1);
        } else if (word.name() == "--timeout") {
            timeout = to<std::uint32_t>(word.value(), 1);
        } else {
            return false;
        }
        return true;
    }

    /// Behind which a frame begins anew, in microseconds.
    [[nodiscard]] std::uint32_t silence_at(std::uint32_t baud_rate) const
    {
        constexpr std::uint32_t usb_latency = 20'000;
        auto const              by_protocol = [&] {
            if (protocol == line_protocol::fc) { return drivecodec::fc::timing::make(baud_rate)->silence(); }
            return drivecodec::modbus::rtu::timing::make(baud_rate, format)->inter_frame();
        }();
        return silence.value_or(std::max(by_protocol, usb_latency));
    }
};

/// Of the protocol that was chosen, or of the one that the line turns out to have.
[[nodiscard]] inline std::unique_ptr<decoder> make_decoder(line_options const& line, modbus_options const& modbus,
                                                           fc_options fc, sink out)
{
    fc.process_words       = line.process_words;
    fc.parameter_bits      = line.parameter_bits;
    auto const make_modbus = [modbus](sink to) { return std::make_unique<modbus_decoder>(modbus, std::move(to)); };
    auto const make_fc     = [fc](sink to) { return make_fc_decoder(fc, std::move(to)); };
    switch (line.protocol.value_or(line_protocol::unknown)) {
    case line_protocol::modbus: return make_modbus(std::move(out));
    case line_protocol::fc: return make_fc(std::move(out));
    case line_protocol::unknown: break;
    }
    return std::make_unique<auto_decoder>(make_modbus, make_fc, std::move(out));
}

}  // namespace support
