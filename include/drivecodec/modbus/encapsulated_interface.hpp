// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/message.hpp>

// Encapsulated Interface Transport (43): one function code, of which a second byte says which function it is.
// MODBUS Application Protocol V1.1b3, 6.19.

namespace drivecodec::modbus {

/// The MODBUS Encapsulated Interface types that are public. Any other number is a value without a name.
enum class mei_type : std::uint8_t {
    canopen_general_reference  = 0x0D,
    read_device_identification = 0x0E,
};

namespace layout::encapsulated_interface {  // | function | MEI type | MEI data ...
inline constexpr u8_at<1>    type{};
inline constexpr std::size_t data = type.end;
}  // namespace layout::encapsulated_interface

/// As `check_head`, and the MEI type too. Precondition: header >= 2.
[[nodiscard]] constexpr error check_mei_head(bytes pdu, mei_type type, std::size_t header, std::size_t least) noexcept
{
    namespace at     = layout::encapsulated_interface;
    auto const fault = check_head(pdu, function_code::encapsulated_interface_transport, header, least);
    if (fault.code() == errc::unexpected_function) { return fault; }
    if (pdu.size() >= at::data and at::type.load(pdu) != static_cast<std::uint8_t>(type)) {
        return {errc::unexpected_function, at::type.begin};
    }
    return fault;
}

constexpr void write_mei_head(mutable_bytes out, mei_type type) noexcept
{
    layout::function.store(out, to_byte(function_code::encapsulated_interface_transport));
    layout::encapsulated_interface::type.store(out, static_cast<std::uint8_t>(type));
}

}  // namespace drivecodec::modbus
