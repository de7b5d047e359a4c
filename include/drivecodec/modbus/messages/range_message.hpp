// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/address_range.hpp>
#include <drivecodec/modbus/coil_view.hpp>
#include <drivecodec/modbus/message.hpp>

namespace drivecodec::modbus {

namespace layout::range_message {  // | function | first hi lo | count hi lo |
inline constexpr be16_at<1> first{};
inline constexpr be16_at<3> count{};
}  // namespace layout::range_message

/// A function code and a range of addresses: the requests 01 to 04, the responses 15 and 16.
template <typename Function, typename Range>
struct range_message {
    using function = Function;

    Range range;

    [[nodiscard]] static constexpr std::size_t    wire_size() noexcept { return layout::range_message::count.end; }
    [[nodiscard]] static constexpr message_length length(bytes) noexcept
    {
        return message_length::exactly(wire_size());
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::range_message;
        if (auto const fault = check_head(pdu, Function::code, wire_size(), wire_size()); not fault.ok()) {
            return fault;
        }
        auto const fault = check_range_at(pdu, at::first.begin, Range::max_count);
        return fault.ok() ? check_size(pdu, wire_size()) : fault;
    }

    [[nodiscard]] static constexpr range_message read(bytes pdu) noexcept
    {
        namespace at = layout::range_message;
        return {.range = Range::from_checked(at::first.load(pdu), at::count.load(pdu))};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::range_message;
        layout::function.store(out, to_byte(Function::code));
        at::first.store(out, range.first());
        at::count.store(out, range.count());
    }

    /// As a request: are these as many values as it asks for? Coils may fill up their last byte.
    template <typename Values>
        requires std::same_as<typename Values::addressed, typename Range::addressed>
    [[nodiscard]] constexpr bool asks_for(Values const& values) const noexcept
    {
        if constexpr (std::same_as<typename Range::addressed, registers>) { return values.size() == range.count(); }
        return values.size() >= range.count() and values.wire_size() == coils::wire_size(range.count());
    }

    /// As a request: just the values that it asks for. Precondition: asks_for(values).
    template <typename Values>
    [[nodiscard]] constexpr decltype(auto) exactly(Values const& values) const noexcept
    {
        if constexpr (std::same_as<typename Range::addressed, coils>) {
            return coil_view{values}.first(range.count());
        } else {
            return (values);
        }
    }

    /// As a request: does the response hold as many values as it asks for?
    template <typename Response>
        requires requires(Response const& given) { given.values; }
    [[nodiscard]] constexpr error matches(Response const& given) const noexcept
    {
        return expect_equal(asks_for(given.values), Response::byte_count_offset);
    }

    friend constexpr bool operator==(range_message const&, range_message const&) noexcept = default;
};

}  // namespace drivecodec::modbus
