// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/messages/values_response.hpp>
#include <drivecodec/modbus/register_view.hpp>

namespace drivecodec::modbus {

// | function | read first hi lo | read count hi lo | write first hi lo | write count hi lo | byte count | values ...
namespace layout::read_write_multiple_registers_request {
inline constexpr be16_at<1>  read_first{};
inline constexpr be16_at<3>  read_count{};
inline constexpr be16_at<5>  write_first{};
inline constexpr be16_at<7>  write_count{};
inline constexpr u8_at<9>    byte_count{};
inline constexpr std::size_t values = byte_count.end;
}  // namespace layout::read_write_multiple_registers_request

/// Read/Write Multiple Registers (23), MODBUS Application Protocol V1.1b3, 6.17: writes 1 to `MaxWrite` registers, then
/// reads 1 to `MaxRead`. The write happens before the read.
template <std::uint16_t MaxRead, std::uint16_t MaxWrite>
struct basic_read_write_multiple_registers {
    static_assert(MaxRead >= 1 and MaxRead <= 125, "a response holds at most 125 registers");
    static_assert(MaxWrite >= 1 and MaxWrite <= 121, "a request holds at most 121 registers");

    static constexpr auto        code = function_code::read_write_multiple_registers;
    static constexpr char const* name = "read_write_multiple_registers";

    using range_to_read = register_range<MaxRead>;

    template <typename Values>
    struct basic_request;
    using request = basic_request<register_view>;
    template <typename Values>
    using basic_response = values_response<basic_read_write_multiple_registers, Values, MaxRead>;
    using response       = basic_response<register_view>;

    /// A constant request, checked by the compiler: `of({3, 6}, 14, {0x00FF, 0x00FF})`.
    template <std::size_t N>
    [[nodiscard]] static consteval basic_request<register_array<N>> of(range_to_read range, int first,
                                                                       std::uint16_t const (&words)[N])
    {
        return {.read_range = range, .write_block = {first, {std::to_array(words)}}};
    }
};
using read_write_multiple_registers = basic_read_write_multiple_registers<125, 121>;

template <std::uint16_t MaxRead, std::uint16_t MaxWrite>
template <typename Values>
struct basic_read_write_multiple_registers<MaxRead, MaxWrite>::basic_request {
    using function       = basic_read_write_multiple_registers;
    using block_to_write = address_block<Values, MaxWrite>;

    range_to_read  read_range;
    block_to_write write_block;

    /// Errors: `bad_quantity`, `bad_address` at their offset in the PDU.
    [[nodiscard]] static constexpr result<basic_request> make(range_to_read range, std::uint16_t first,
                                                              Values values) noexcept
    {
        auto const made = block_to_write::make(first, values);
        if (not made) {
            return made.error().moved_by(layout::read_write_multiple_registers_request::write_first.begin);
        }
        return basic_request{.read_range = range, .write_block = *made};
    }

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        requires fixed_size<Values>
    {
        return layout::read_write_multiple_registers_request::values + Values::wire_size();
    }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
        requires(not fixed_size<Values>)
    {
        return layout::read_write_multiple_registers_request::values + write_block.values().wire_size();
    }

    [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
    {
        namespace at = layout::read_write_multiple_registers_request;
        if (pdu.size() < at::values) { return message_length::at_least(at::values); }
        return message_length::exactly(at::values + at::byte_count.load(pdu));
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::read_write_multiple_registers_request;
        if (auto const fault = check_head(pdu, code, at::values, at::values + 2); not fault.ok()) { return fault; }
        if (auto const fault = check_range_at(pdu, at::read_first.begin, MaxRead); not fault.ok()) { return fault; }
        if (auto const fault = check_range_at(pdu, at::write_first.begin, MaxWrite); not fault.ok()) { return fault; }
        auto const size = registers::wire_size(at::write_count.load(pdu));
        if (at::byte_count.load(pdu) != size) { return {errc::bad_length, at::byte_count.begin}; }
        return check_size(pdu, at::values + size);
    }

    [[nodiscard]] static constexpr basic_request read(bytes pdu) noexcept
    {
        namespace at = layout::read_write_multiple_registers_request;
        return {.read_range  = range_to_read::from_checked(at::read_first.load(pdu), at::read_count.load(pdu)),
                .write_block = block_to_write::of_wire(at::write_first.load(pdu), pdu.subspan(at::values),
                                                       at::write_count.load(pdu))};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::read_write_multiple_registers_request;
        layout::function.store(out, to_byte(code));
        at::read_first.store(out, read_range.first());
        at::read_count.store(out, read_range.count());
        at::write_first.store(out, write_block.first());
        at::write_count.store(out, write_block.count());
        at::byte_count.store(out, static_cast<std::uint8_t>(write_block.values().wire_size()));
        write_block.values().write(out.subspan(at::values));
    }

    /// Are these as many registers as this asks for?
    template <typename Given>
        requires std::same_as<typename Given::addressed, registers>
    [[nodiscard]] constexpr bool asks_for(Given const& values) const noexcept
    {
        return values.size() == read_range.count();
    }

    /// Just these. Precondition: asks_for(values).
    template <typename Given>
    [[nodiscard]] constexpr Given const& exactly(Given const& values) const noexcept
    {
        return values;
    }

    /// Does the response hold as many registers as this asks for?
    template <typename Response>
    [[nodiscard]] constexpr error matches(Response const& given) const noexcept
    {
        return expect_equal(asks_for(given.values), Response::byte_count_offset);
    }

    friend constexpr bool operator==(basic_request const&, basic_request const&) noexcept = default;
};

}  // namespace drivecodec::modbus
