// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/messages/echo_of.hpp>

namespace drivecodec::modbus {

namespace layout::write_single_register {  // | function | address hi lo | value hi lo |
inline constexpr be16_at<1> address{};
inline constexpr be16_at<3> value{};
}  // namespace layout::write_single_register

/// Write Single Register (06), MODBUS Application Protocol V1.1b3, 6.6. The response repeats the request.
struct write_single_register {
    static constexpr auto        code     = function_code::write_single_register;
    static constexpr char const* name     = "write_single_register";
    static constexpr bool        is_write = true;

    struct request;
    using response = echo_of<request>;
};

struct write_single_register::request {
    using function = write_single_register;

    std::uint16_t address;
    std::uint16_t value;

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept { return layout::write_single_register::value.end; }
    [[nodiscard]] static constexpr message_length length(bytes) noexcept
    {
        return message_length::exactly(wire_size());
    }
    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        return check_fixed(pdu, function::code, wire_size());
    }

    [[nodiscard]] static constexpr request read(bytes pdu) noexcept
    {
        namespace at = layout::write_single_register;
        return {.address = at::address.load(pdu), .value = at::value.load(pdu)};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::write_single_register;
        layout::function.store(out, to_byte(function::code));
        at::address.store(out, address);
        at::value.store(out, value);
    }

    /// What a server says when it has done this: the first `echo_size()` bytes of the request, which are all.
    [[nodiscard]] static constexpr std::size_t echo_size() noexcept { return wire_size(); }
    [[nodiscard]] constexpr response           reply() const noexcept;

    [[nodiscard]] constexpr error matches(request const& given) const noexcept
    {
        namespace at = layout::write_single_register;
        if (given.address != address) { return expect_equal(false, at::address.begin); }
        return expect_equal(given.value == value, at::value.begin);
    }

    friend constexpr bool operator==(request const&, request const&) noexcept = default;
};

constexpr auto write_single_register::request::reply() const noexcept -> response
{
    return {*this};
}

}  // namespace drivecodec::modbus
