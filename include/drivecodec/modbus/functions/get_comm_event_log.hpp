// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/comm_event.hpp>
#include <drivecodec/modbus/comm_status.hpp>
#include <drivecodec/modbus/messages/bare_request.hpp>

namespace drivecodec::modbus {

// | function | byte count | status hi lo | event count hi lo | message count hi lo | events ...
namespace layout::get_comm_event_log_response {
inline constexpr u8_at<1>    byte_count{};
inline constexpr be16_at<2>  status{};
inline constexpr be16_at<4>  event_count{};
inline constexpr be16_at<6>  message_count{};
inline constexpr std::size_t events = message_count.end;
}  // namespace layout::get_comm_event_log_response

/// Get Comm Event Log (12), MODBUS Application Protocol V1.1b3, 6.10.
struct get_comm_event_log {
    static constexpr auto        code = function_code::get_comm_event_log;
    static constexpr char const* name = "get_comm_event_log";

    static constexpr std::size_t max_events = 64;

    using request = bare_request<get_comm_event_log>;
    class response;
};

/// The counters and up to 64 events, the latest first.
class get_comm_event_log::response {
public:
    using function = get_comm_event_log;

    /// `log` has one byte an event, the latest first. Errors: `bad_quantity` for more than 64, at the byte count.
    [[nodiscard]] static constexpr result<response> make(bool is_busy, std::uint16_t events_counted,
                                                         std::uint16_t messages_counted, bytes log) noexcept
    {
        if (log.size() > max_events) { return error{errc::bad_quantity, at_byte_count}; }
        return response{is_busy, events_counted, messages_counted, log};
    }

    [[nodiscard]] constexpr bool          busy() const noexcept { return busy_; }
    [[nodiscard]] constexpr std::uint16_t event_count() const noexcept { return event_count_; }
    [[nodiscard]] constexpr std::uint16_t message_count() const noexcept { return message_count_; }
    /// One byte an event, the latest first.
    [[nodiscard]] constexpr bytes events() const noexcept { return events_; }
    /// Precondition: index < events().size().
    [[nodiscard]] constexpr comm_event event(std::size_t index) const noexcept
    {
        return comm_event::from_raw(events_.data()[index]);
    }

    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
    {
        return layout::get_comm_event_log_response::events + events_.size();
    }

    [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
    {
        namespace at = layout::get_comm_event_log_response;
        if (pdu.size() < at::byte_count.end) { return message_length::at_least(at::byte_count.end); }
        return message_length::exactly(at::byte_count.end + at::byte_count.load(pdu));
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::get_comm_event_log_response;
        if (auto const fault = check_head(pdu, code, at::byte_count.end, at::events); not fault.ok()) { return fault; }
        constexpr auto    counters = at::events - at::byte_count.end;
        std::size_t const size     = at::byte_count.load(pdu);
        if (size < counters) { return {errc::bad_length, at::byte_count.begin}; }
        if (size > counters + max_events) { return {errc::bad_quantity, at::byte_count.begin}; }
        if (auto const fault = check_size(pdu, at::byte_count.end + size); not fault.ok()) { return fault; }
        return comm_status::is_valid(at::status.load(pdu)) ? error{} : error{errc::bad_value, at::status.begin};
    }

    [[nodiscard]] static constexpr response read(bytes pdu) noexcept
    {
        namespace at = layout::get_comm_event_log_response;
        return {at::status.load(pdu) == comm_status::busy, at::event_count.load(pdu), at::message_count.load(pdu),
                pdu.subspan(at::events)};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::get_comm_event_log_response;
        layout::function.store(out, to_byte(code));
        at::byte_count.store(out, static_cast<std::uint8_t>(wire_size() - at::byte_count.end));
        at::status.store(out, comm_status::to_wire(busy_));
        at::event_count.store(out, event_count_);
        at::message_count.store(out, message_count_);
        copy_bytes(events_, out.subspan(at::events));
    }

    friend constexpr bool operator==(response const& a, response const& b) noexcept
    {
        return a.busy_ == b.busy_ and a.event_count_ == b.event_count_ and a.message_count_ == b.message_count_
               and same_bytes(a.events_, b.events_);
    }

private:
    static constexpr std::size_t at_byte_count = layout::get_comm_event_log_response::byte_count.begin;

    constexpr response(bool is_busy, std::uint16_t events_counted, std::uint16_t messages_counted, bytes log) noexcept
        : events_{log}, event_count_{events_counted}, message_count_{messages_counted}, busy_{is_busy}
    {}

    bytes         events_;
    std::uint16_t event_count_;
    std::uint16_t message_count_;
    bool          busy_;
};

}  // namespace drivecodec::modbus
