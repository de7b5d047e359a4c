// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/comm_status.hpp>
#include <drivecodec/modbus/functions/write_single_coil.hpp>

#include <string_view>

// Fields that the messages keep as `bool` or as a plain number, but whose number on the wire says more than that. Here
// each is an enum of that number, so that whoever prints fields has one rule: the name, or else the number.

namespace drivecodec::modbus {

enum class coil_value : std::uint16_t { off = write_single_coil::off, on = write_single_coil::on };

enum class program_status : std::uint16_t { ready = comm_status::ready, busy = comm_status::busy };

enum class more_follows : std::uint8_t { no = 0x00, yes = 0xFF };

enum class bits_8 : std::uint8_t {};    ///< Eight bits that mean something each: best read in hexadecimal.
enum class bits_16 : std::uint16_t {};  ///< Sixteen of them.

/// Bytes that are an ASCII text if all is well.
struct ascii_text {
    bytes characters;
};

[[nodiscard]] constexpr std::string_view to_string(coil_value value) noexcept
{
    switch (value) {
    case coil_value::off: return "off";
    case coil_value::on: return "on";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(program_status status) noexcept
{
    switch (status) {
    case program_status::ready: return "ready";
    case program_status::busy: return "busy";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(more_follows follows) noexcept
{
    switch (follows) {
    case more_follows::no: return "no";
    case more_follows::yes: return "yes";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(bits_8) noexcept
{
    return {};
}
[[nodiscard]] constexpr std::string_view to_string(bits_16) noexcept
{
    return {};
}

}  // namespace drivecodec::modbus
