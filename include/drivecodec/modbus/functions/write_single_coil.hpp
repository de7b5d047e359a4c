// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/messages/echo_of.hpp>

namespace drivecodec::modbus {

namespace layout::write_single_coil {  // | function | address hi lo | value hi lo |
inline constexpr be16_at<1> address{};
inline constexpr be16_at<3> value{};
}  // namespace layout::write_single_coil

/// Write Single Coil (05), MODBUS Application Protocol V1.1b3, 6.5. The response repeats the request.
struct write_single_coil {
    static constexpr auto        code     = function_code::write_single_coil;
    static constexpr char const* name     = "write_single_coil";
    static constexpr bool        is_write = true;

    /// The only two values on the wire.
    static constexpr std::uint16_t on  = 0xFF00;
    static constexpr std::uint16_t off = 0x0000;

    struct request;
    using response = echo_of<request>;
};

struct write_single_coil::request {
    using function = write_single_coil;

    std::uint16_t address;
    bool          value;

    [[nodiscard]] static constexpr std::size_t    wire_size() noexcept { return layout::write_single_coil::value.end; }
    [[nodiscard]] static constexpr message_length length(bytes) noexcept
    {
        return message_length::exactly(wire_size());
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::write_single_coil;
        if (auto const fault = check_head(pdu, function::code, wire_size(), wire_size()); not fault.ok()) {
            return fault;
        }
        auto const wanted = at::value.load(pdu);
        if (wanted != on and wanted != off) { return {errc::bad_value, at::value.begin}; }
        return check_size(pdu, wire_size());
    }

    [[nodiscard]] static constexpr request read(bytes pdu) noexcept
    {
        namespace at = layout::write_single_coil;
        return {.address = at::address.load(pdu), .value = at::value.load(pdu) == on};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::write_single_coil;
        layout::function.store(out, to_byte(function::code));
        at::address.store(out, address);
        at::value.store(out, value ? on : off);
    }

    /// What a server says when it has done this: the first `echo_size()` bytes of the request, which are all.
    [[nodiscard]] static constexpr std::size_t echo_size() noexcept { return wire_size(); }
    [[nodiscard]] constexpr response           reply() const noexcept;

    [[nodiscard]] constexpr error matches(request const& given) const noexcept
    {
        namespace at = layout::write_single_coil;
        if (given.address != address) { return expect_equal(false, at::address.begin); }
        return expect_equal(given.value == value, at::value.begin);
    }

    friend constexpr bool operator==(request const&, request const&) noexcept = default;
};

constexpr auto write_single_coil::request::reply() const noexcept -> response
{
    return {*this};
}

}  // namespace drivecodec::modbus
