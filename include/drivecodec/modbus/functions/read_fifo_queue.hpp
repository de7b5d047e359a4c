// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/bounded.hpp>
#include <drivecodec/modbus/message.hpp>
#include <drivecodec/modbus/register_view.hpp>

namespace drivecodec::modbus {

namespace layout {

namespace read_fifo_queue_request {  // | function | FIFO pointer address hi lo |
inline constexpr be16_at<1> address{};
}

namespace read_fifo_queue_response {  // | function | byte count hi lo | FIFO count hi lo | values ...
inline constexpr be16_at<1>  byte_count{};  // of all that follows it
inline constexpr be16_at<3>  fifo_count{};
inline constexpr std::size_t values = fifo_count.end;
}  // namespace read_fifo_queue_response

}  // namespace layout

/// Read FIFO Queue (24), MODBUS Application Protocol V1.1b3, 6.18: the up to 31 registers queued behind an address.
struct read_fifo_queue {
    static constexpr auto        code = function_code::read_fifo_queue;
    static constexpr char const* name = "read_fifo_queue";

    static constexpr std::uint16_t max_count = 31;

    struct request;
    template <typename Values>
    struct basic_response;
    using response = basic_response<register_view>;
};

struct read_fifo_queue::request {
    using function = read_fifo_queue;

    std::uint16_t address;  ///< The FIFO pointer address.

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
    {
        return layout::read_fifo_queue_request::address.end;
    }
    [[nodiscard]] static constexpr message_length length(bytes) noexcept
    {
        return message_length::exactly(wire_size());
    }
    [[nodiscard]] static constexpr error check(bytes pdu) noexcept { return check_fixed(pdu, code, wire_size()); }

    [[nodiscard]] static constexpr request read(bytes pdu) noexcept
    {
        return {.address = layout::read_fifo_queue_request::address.load(pdu)};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        layout::function.store(out, to_byte(code));
        layout::read_fifo_queue_request::address.store(out, address);
    }

    /// Every response of the function answers it: only the server knows how many registers are queued.
    [[nodiscard]] constexpr error matches(auto const&) const noexcept { return {}; }

    friend constexpr bool operator==(request const&, request const&) noexcept = default;
};

template <typename Values>
struct read_fifo_queue::basic_response {
    using function       = read_fifo_queue;
    using bounded_values = bounded<Values, 0, max_count>;

    bounded_values values;  ///< The oldest first.

    /// Errors: `bad_quantity` at the FIFO count.
    [[nodiscard]] static constexpr result<basic_response> make(Values values_to_send) noexcept
    {
        if (not bounded_values::fits(values_to_send.size())) {
            return error{errc::bad_quantity, layout::read_fifo_queue_response::fifo_count.begin};
        }
        return basic_response{.values = bounded_values::from_checked(values_to_send)};
    }

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        requires fixed_size<Values>
    {
        return layout::read_fifo_queue_response::values + Values::wire_size();
    }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
        requires(not fixed_size<Values>)
    {
        return layout::read_fifo_queue_response::values + values.wire_size();
    }

    [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
    {
        namespace at = layout::read_fifo_queue_response;
        if (pdu.size() < at::byte_count.end) { return message_length::at_least(at::byte_count.end); }
        return message_length::exactly(std::size_t{at::byte_count.end} + at::byte_count.load(pdu));
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::read_fifo_queue_response;
        if (auto const fault = check_head(pdu, code, at::byte_count.end, at::values); not fault.ok()) { return fault; }
        auto const size = std::size_t{at::byte_count.end} + at::byte_count.load(pdu);
        if (size < at::values or size > at::values + registers::wire_size(max_count)) {
            return {errc::bad_length, at::byte_count.begin};
        }
        if (pdu.size() < at::values) { return {errc::truncated, size}; }
        auto const count = at::fifo_count.load(pdu);
        if (count > max_count) { return {errc::bad_quantity, at::fifo_count.begin}; }
        if (size != at::values + registers::wire_size(count)) { return {errc::bad_length, at::byte_count.begin}; }
        return check_size(pdu, size);
    }

    [[nodiscard]] static constexpr basic_response read(bytes pdu) noexcept
    {
        auto const wire = pdu.subspan(layout::read_fifo_queue_response::values);
        return {.values = bounded_values::from_checked(Values::of_wire(wire))};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::read_fifo_queue_response;
        layout::function.store(out, to_byte(code));
        at::byte_count.store(out, static_cast<std::uint16_t>(wire_size() - at::byte_count.end));
        at::fifo_count.store(out, static_cast<std::uint16_t>(values.size()));
        values.write(out.subspan(at::values));
    }

    friend constexpr bool operator==(basic_response const&, basic_response const&) noexcept = default;
};

}  // namespace drivecodec::modbus
