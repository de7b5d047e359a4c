// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/comm_status.hpp>
#include <drivecodec/modbus/messages/bare_request.hpp>

namespace drivecodec::modbus {

namespace layout::get_comm_event_counter_response {  // | function | status hi lo | event count hi lo |
inline constexpr be16_at<1> status{};
inline constexpr be16_at<3> event_count{};
}  // namespace layout::get_comm_event_counter_response

/// Get Comm Event Counter (11), MODBUS Application Protocol V1.1b3, 6.9.
struct get_comm_event_counter {
    static constexpr auto        code = function_code::get_comm_event_counter;
    static constexpr char const* name = "get_comm_event_counter";

    using request = bare_request<get_comm_event_counter>;

    struct response {
        using function = get_comm_event_counter;

        bool          busy;         ///< A program command is still being processed.
        std::uint16_t event_count;  ///< Requests that were carried out.

        [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        {
            return layout::get_comm_event_counter_response::event_count.end;
        }
        [[nodiscard]] static constexpr message_length length(bytes) noexcept
        {
            return message_length::exactly(wire_size());
        }

        [[nodiscard]] static constexpr error check(bytes pdu) noexcept
        {
            namespace at = layout::get_comm_event_counter_response;
            if (auto const fault = check_head(pdu, code, wire_size(), wire_size()); not fault.ok()) { return fault; }
            if (not comm_status::is_valid(at::status.load(pdu))) { return {errc::bad_value, at::status.begin}; }
            return check_size(pdu, wire_size());
        }

        [[nodiscard]] static constexpr response read(bytes pdu) noexcept
        {
            namespace at = layout::get_comm_event_counter_response;
            return {.busy = at::status.load(pdu) == comm_status::busy, .event_count = at::event_count.load(pdu)};
        }

        constexpr void write(mutable_bytes out) const noexcept
        {
            namespace at = layout::get_comm_event_counter_response;
            layout::function.store(out, to_byte(code));
            at::status.store(out, comm_status::to_wire(busy));
            at::event_count.store(out, event_count);
        }

        friend constexpr bool operator==(response const&, response const&) noexcept = default;
    };
};

}  // namespace drivecodec::modbus
