// SPDX-License-Identifier: MIT
#pragma once

#include "support/rtu_line.hpp"

#include <drivecodec/drives/smd/link.hpp>

#include <string>

namespace support {

/// The line of an smd: 9600 baud, in the formats that c25 has.
struct smd_line : rtu_line {
    static constexpr auto usage =
        R"(  --format 8N2      data bits, parity, stop bits (8N2): what c25 says; always 9600 baud)";

    smd_line() : rtu_line{drivecodec::smd::baud_rate, modbus::rtu::format_8n2} {}

    [[nodiscard]] bool take(std::string const& word, arguments& rest)
    {
        if (word != "--format") { return false; }
        format = to_format(rest.next("the value of " + word));
        return true;
    }

    /// c25.
    [[nodiscard]] drivecodec::smd::serial_format code() const
    {
        using drivecodec::smd::serial_format;
        auto number = std::uint16_t{0};
        while (*drivecodec::smd::to_rtu(serial_format{number}) != format) { ++number; }  // it has all four
        return serial_format{number};
    }
};

}  // namespace support
