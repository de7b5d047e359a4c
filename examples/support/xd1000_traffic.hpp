// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus.hpp>
#include <drivecodec/text/xd1000.hpp>

#include <string>

// What the frames of an xD1000 mean.

namespace support {

/// Names the registers in frames, and explains CMD and ETA. It remembers the last state heard, for 0007 has two names.
class xd1000_traffic {
public:
    /// Of a frame, with the PDU of the request heard before if this is its response. Empty if it holds no registers.
    [[nodiscard]] std::string explain(drivecodec::modbus::rtu::frame const& found, drivecodec::bytes asked)
    {
        using drivecodec::decode;
        namespace modbus = drivecodec::modbus;
        auto const pdu   = found.pdu();
        if (auto const write = decode<modbus::write_single_register::request>(pdu)) {
            return text_of(write->address, std::array{write->value});
        }
        if (found.direction == modbus::direction::request) {
            if (auto const write = decode<modbus::write_multiple_registers::request>(pdu)) {
                return text_of(write->block.first(), write->block.values());
            }
            if (auto const exchange = decode<modbus::read_write_multiple_registers::request>(pdu)) {
                return text_of(exchange->write_block.first(), exchange->write_block.values());
            }
            return {};
        }
        if (auto const read = decode<modbus::read_holding_registers::request>(asked)) {
            auto const given = decode<modbus::read_holding_registers::response>(pdu);
            if (given and read->matches(*given).ok()) { return text_of(read->range.first(), given->values); }
        }
        if (auto const exchange = decode<modbus::read_write_multiple_registers::request>(asked)) {
            auto const given = decode<modbus::read_write_multiple_registers::response>(pdu);
            if (given and exchange->matches(*given).ok()) {
                return text_of(exchange->read_range.first(), given->values);
            }
        }
        return {};
    }

private:
    [[nodiscard]] std::string text_of(std::uint16_t first, drivecodec::modbus::register_view values)
    {
        namespace xd1000 = drivecodec::xd1000;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (first + i != xd1000::eta.address()) { continue; }
            if (auto const state = decode_state(xd1000::eta.value(values[i]))) { present_ = *state; }
        }
        std::array<char, 8192>  room;
        drivecodec::text_writer text{room};
        write_text(text, xd1000::register_values{first, values}, present_);
        return std::string{text.view_with_ellipsis()};
    }

    drivecodec::cia402::state present_ = drivecodec::cia402::state::switch_on_disabled;
};

}  // namespace support
