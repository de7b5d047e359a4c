// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/bounded.hpp>
#include <drivecodec/modbus/message.hpp>
#include <drivecodec/modbus/messages/range_message.hpp>

namespace drivecodec::modbus {

namespace layout::block_request {  // | function | first hi lo | count hi lo | byte count | values ...
inline constexpr be16_at<1>  first{};
inline constexpr be16_at<3>  count{};
inline constexpr u8_at<5>    byte_count{};
inline constexpr std::size_t values = byte_count.end;
}  // namespace layout::block_request

/// Values for a run of consecutive addresses: the requests 15 and 16.
template <typename Function, typename Values, std::uint16_t Max>
struct block_request {
    using function  = Function;
    using addressed = typename Values::addressed;
    using response  = range_message<Function, address_range<addressed, Max>>;

    address_block<Values, Max> block;

    /// Errors: `bad_quantity`, `bad_address` at their offset in the PDU.
    [[nodiscard]] static constexpr result<block_request> make(std::uint16_t first, Values values) noexcept
    {
        auto const made = address_block<Values, Max>::make(first, values);
        if (not made) { return made.error().moved_by(layout::block_request::first.begin); }
        return block_request{.block = *made};
    }

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        requires fixed_size<Values>
    {
        return layout::block_request::values + Values::wire_size();
    }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
        requires(not fixed_size<Values>)
    {
        return layout::block_request::values + block.values().wire_size();
    }

    [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
    {
        namespace at = layout::block_request;
        if (pdu.size() < at::values) { return message_length::at_least(at::values); }
        return message_length::exactly(at::values + at::byte_count.load(pdu));
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at     = layout::block_request;
        auto const fault = check_head(pdu, Function::code, at::values, at::values + addressed::wire_size(1));
        if (not fault.ok()) { return fault; }
        if (auto const range = check_range_at(pdu, at::first.begin, Max); not range.ok()) { return range; }
        auto const size = addressed::wire_size(at::count.load(pdu));
        if (at::byte_count.load(pdu) != size) { return {errc::bad_length, at::byte_count.begin}; }
        return check_size(pdu, at::values + size);
    }

    [[nodiscard]] static constexpr block_request read(bytes pdu) noexcept
    {
        namespace at = layout::block_request;
        return {.block = address_block<Values, Max>::of_wire(at::first.load(pdu), pdu.subspan(at::values),
                                                             at::count.load(pdu))};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::block_request;
        layout::function.store(out, to_byte(Function::code));
        at::first.store(out, block.first());
        at::count.store(out, block.count());
        at::byte_count.store(out, static_cast<std::uint8_t>(block.values().wire_size()));
        block.values().write(out.subspan(at::values));
    }

    /// What a server says when it has done this: the first `echo_size()` bytes of the request.
    [[nodiscard]] static constexpr std::size_t echo_size() noexcept { return response::wire_size(); }
    [[nodiscard]] constexpr response           reply() const noexcept { return {.range = block.range()}; }

    [[nodiscard]] constexpr error matches(response const& given) const noexcept
    {
        namespace at = layout::range_message;
        if (given.range.first() != block.first()) { return expect_equal(false, at::first.begin); }
        return expect_equal(given.range.count() == block.count(), at::count.begin);
    }

    friend constexpr bool operator==(block_request const&, block_request const&) noexcept = default;
};

}  // namespace drivecodec::modbus
