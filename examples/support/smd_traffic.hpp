// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/exception.hpp>
#include <drivecodec/modbus.hpp>
#include <drivecodec/text/drives/smd/parameters.hpp>

#include <array>
#include <string>

// What the frames of an smd mean.

namespace support {

/// Names the registers in frames. Which parameter a register is, depends on the drive's version: PV507, until register
/// 50 is heard to say another.
class smd_traffic {
public:
    /// Of a frame, with the PDU of the request heard before if this is its response. Empty if it holds no registers.
    [[nodiscard]] std::string explain(drivecodec::modbus::rtu::frame const& found, drivecodec::bytes asked)
    {
        using drivecodec::decode;
        namespace modbus = drivecodec::modbus;
        auto const pdu   = found.pdu();
        if (auto const refused = decode<modbus::exception_response>(pdu)) { return refusal(refused->code); }
        if (auto const write = decode<modbus::write_single_register::request>(pdu)) {
            return text_of(write->address, std::array{write->value});
        }
        if (found.direction == modbus::direction::request) {
            auto const write = decode<modbus::write_multiple_registers::request>(pdu);
            return write ? text_of(write->block.first(), write->block.values()) : std::string{};
        }
        if (auto const text = text_of_response<modbus::read_holding_registers>(pdu, asked); not text.empty()) {
            return text;
        }
        return text_of_response<modbus::read_input_registers>(pdu, asked);
    }

    /// What this drive means by an exception; empty for one that it does not have. smd manual, sections 2.3 E and 4.5,
    /// and note 1.
    [[nodiscard]] static std::string refusal(drivecodec::modbus::exception_code code)
    {
        using enum drivecodec::smd::exception;
        switch (drivecodec::smd::to_exception(code)) {
        case command_rejected: return "command rejected: the drive is locked, or does not do this now";
        case no_such_register: return "no such register";
        case data_out_of_range: return "data out of range";
        case wrong_data_format: return "wrong data format, or several commands at once";
        case slave_device_busy: return "the drive is busy";
        }
        return {};
    }

private:
    template <typename Read>
    [[nodiscard]] std::string text_of_response(drivecodec::bytes pdu, drivecodec::bytes asked)
    {
        auto const read  = drivecodec::decode<typename Read::request>(asked);
        auto const given = drivecodec::decode<typename Read::response>(pdu);
        return read and given and read->matches(*given).ok() ? text_of(read->range.first(), given->values)
                                                             : std::string{};
    }

    [[nodiscard]] std::string text_of(std::uint16_t first, drivecodec::modbus::register_view values)
    {
        namespace smd = drivecodec::smd;
        std::array<char, 2000>  room;
        drivecodec::text_writer text{room};
        auto const              is_text = first == smd::address_of("C99", version_);
        if (auto const status = smd::status_block::decode(values); status and first == smd::status_block::address) {
            write_text(text, *status);
        } else if (auto const version = smd::software_version::make(values); version and is_text) {
            write_text(text.put("C99 software_version "), *version);
        } else {
            write_each(text, first, values);
        }
        return std::string{text.view_with_ellipsis()};
    }

    void write_each(drivecodec::text_writer& text, std::uint16_t first, drivecodec::modbus::register_view values)
    {
        namespace smd = drivecodec::smd;
        for (std::size_t i = 0; i < values.size(); ++i) {
            auto const address = static_cast<std::uint16_t>(first + i);
            write_text(text.put(i == 0 ? "" : ", "), smd::register_value{version_, address, values[i]});
            if (address != smd::register_version.address()) { continue; }
            if (auto const version = smd::make_version(values[i])) { version_ = *version; }
        }
    }

    drivecodec::smd::version version_ = drivecodec::smd::pv507;
};

}  // namespace support
