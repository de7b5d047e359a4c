// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/bounded.hpp>
#include <drivecodec/modbus/message.hpp>

namespace drivecodec::modbus {

namespace layout::values_response {  // | function | byte count | values ...
inline constexpr u8_at<1>    byte_count{};
inline constexpr std::size_t values = byte_count.end;
}  // namespace layout::values_response

/// The wire form of all such responses; one function for all, for the sake of firmware.
template <typename Values>
struct values_payload {
    function_code code;
    Values const& values;

    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
    {
        return layout::values_response::values + values.wire_size();
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::values_response;
        layout::function.store(out, to_byte(code));
        at::byte_count.store(out, static_cast<std::uint8_t>(out.size() - at::values));
        values.write(out.subspan(at::values));
    }
};
template <typename Values>
values_payload(function_code, Values const&) -> values_payload<Values>;

/// The values that a read asked for: the responses 01 to 04 and 23.
///
/// `Values` is a view or an array of registers or of coils; of coils, which come eight a byte, a whole number of
/// bytes is decoded.
template <typename Function, typename Values, std::uint16_t Max>
struct values_response {
    using function    = Function;
    using values_type = Values;
    using addressed   = typename Values::addressed;

    static constexpr std::size_t byte_count_offset = layout::values_response::byte_count.begin;
    static constexpr std::size_t max_byte_count    = addressed::wire_size(Max);
    static constexpr std::size_t min_byte_count    = addressed::wire_size(1);

    using bounded_values = bounded<Values, 1, static_cast<std::uint16_t>(addressed::max_count(max_byte_count))>;

    bounded_values values;

    /// Errors: `bad_quantity` at the byte count.
    [[nodiscard]] static constexpr result<values_response> make(Values values_to_send) noexcept
    {
        if (not bounded_values::fits(values_to_send.size())) { return error{errc::bad_quantity, byte_count_offset}; }
        return values_response{.values = bounded_values::from_checked(values_to_send)};
    }

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        requires fixed_size<Values>
    {
        return layout::values_response::values + Values::wire_size();
    }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
        requires(not fixed_size<Values>)
    {
        return layout::values_response::values + values.wire_size();
    }

    [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
    {
        namespace at = layout::values_response;
        if (pdu.size() < at::values) { return message_length::at_least(at::values); }
        return message_length::exactly(at::values + at::byte_count.load(pdu));
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at     = layout::values_response;
        auto const fault = check_head(pdu, Function::code, at::values, at::values + min_byte_count);
        if (not fault.ok()) { return fault; }
        std::size_t const size = at::byte_count.load(pdu);
        if (size % min_byte_count != 0) { return {errc::bad_length, byte_count_offset}; }
        if (size < min_byte_count or size > max_byte_count) { return {errc::bad_quantity, byte_count_offset}; }
        return check_size(pdu, at::values + size);
    }

    [[nodiscard]] static constexpr values_response read(bytes pdu) noexcept
    {
        auto const wire = pdu.subspan(layout::values_response::values);
        return {.values = bounded_values::from_checked(Values::of_wire(wire))};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        values_payload{Function::code, values.values()}.write(out);
    }

    friend constexpr bool operator==(values_response const&, values_response const&) noexcept = default;
};

}  // namespace drivecodec::modbus
