// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/messages/echo_of.hpp>

namespace drivecodec::modbus {

namespace layout::mask_write_register {  // | function | address hi lo | and mask hi lo | or mask hi lo |
inline constexpr be16_at<1> address{};
inline constexpr be16_at<3> and_mask{};
inline constexpr be16_at<5> or_mask{};
}  // namespace layout::mask_write_register

/// Mask Write Register (22), MODBUS Application Protocol V1.1b3, 6.16. The response repeats the request.
struct mask_write_register {
    static constexpr auto        code     = function_code::mask_write_register;
    static constexpr char const* name     = "mask_write_register";
    static constexpr bool        is_write = true;

    struct request;
    using response = echo_of<request>;
};

struct mask_write_register::request {
    using function = mask_write_register;

    std::uint16_t address;
    std::uint16_t and_mask;
    std::uint16_t or_mask;

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept { return layout::mask_write_register::or_mask.end; }
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
        namespace at = layout::mask_write_register;
        return {.address = at::address.load(pdu), .and_mask = at::and_mask.load(pdu), .or_mask = at::or_mask.load(pdu)};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::mask_write_register;
        layout::function.store(out, to_byte(function::code));
        at::address.store(out, address);
        at::and_mask.store(out, and_mask);
        at::or_mask.store(out, or_mask);
    }

    /// What the register holds afterwards: the AND mask keeps bits of `current`, the OR mask sets those not kept.
    [[nodiscard]] constexpr std::uint16_t apply(std::uint16_t current) const noexcept
    {
        return static_cast<std::uint16_t>((current & and_mask) | (or_mask & ~and_mask));
    }

    /// What a server says when it has done this: the first `echo_size()` bytes of the request, which are all.
    [[nodiscard]] static constexpr std::size_t echo_size() noexcept { return wire_size(); }
    [[nodiscard]] constexpr response           reply() const noexcept;

    [[nodiscard]] constexpr error matches(request const& given) const noexcept
    {
        namespace at = layout::mask_write_register;
        if (given.address != address) { return expect_equal(false, at::address.begin); }
        if (given.and_mask != and_mask) { return expect_equal(false, at::and_mask.begin); }
        return expect_equal(given.or_mask == or_mask, at::or_mask.begin);
    }

    friend constexpr bool operator==(request const&, request const&) noexcept = default;
};

constexpr auto mask_write_register::request::reply() const noexcept -> response
{
    return {*this};
}

}  // namespace drivecodec::modbus
