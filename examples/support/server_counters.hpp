// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus.hpp>

#include <cstdint>
#include <vector>

// What a server counts for the functions Diagnostics (08), Get Comm Event Counter (11) and Get Comm Event Log (12).

namespace support {

struct server_counters {
    std::uint16_t bus_messages     = 0;  ///< Whole frames on the line, also of others.
    std::uint16_t bus_errors       = 0;  ///< Damaged ones.
    std::uint16_t exceptions_sent  = 0;
    std::uint16_t server_messages  = 0;  ///< Requests to this server, broadcasts too.
    std::uint16_t without_response = 0;  ///< Of these: those that were not answered.
    std::uint16_t events           = 0;  ///< Requests that were carried out.

    /// The counter that this sub-function of Diagnostics asks for; nullptr if it asks for none.
    [[nodiscard]] std::uint16_t const* find(drivecodec::modbus::diagnostic sub_function) const noexcept
    {
        static constexpr std::uint16_t never = 0;  // this server is never busy, and the operating system buffers
        using enum drivecodec::modbus::diagnostic;
        switch (sub_function) {
        case return_bus_message_count: return &bus_messages;
        case return_bus_communication_error_count: return &bus_errors;
        case return_bus_exception_error_count: return &exceptions_sent;
        case return_server_message_count: return &server_messages;
        case return_server_no_response_count: return &without_response;
        case return_diagnostic_register:
        case return_server_nak_count:
        case return_server_busy_count:
        case return_bus_character_overrun_count: return &never;
        default: return nullptr;
        }
    }
};

/// The last 64 events, the latest first.
class event_log {
public:
    using comm_event     = drivecodec::modbus::comm_event;
    using exception_code = drivecodec::modbus::exception_code;

    static constexpr auto restarted          = comm_event{};
    static constexpr auto entered_listen_only = comm_event::from_raw(0x04);
    static constexpr auto received           = comm_event::from_raw(0x80);
    static constexpr auto sent               = comm_event::from_raw(0x40);

    void add(comm_event event)
    {
        if (events_.size() == drivecodec::modbus::get_comm_event_log::max_events) { events_.pop_back(); }
        events_.insert(events_.begin(), event.raw);
    }

    void clear() noexcept { events_.clear(); }

    [[nodiscard]] drivecodec::bytes events() const noexcept { return events_; }

    /// The event of a reply that was this exception.
    [[nodiscard]] static constexpr comm_event sent_exception(exception_code code) noexcept
    {
        switch (code) {
        case exception_code::illegal_function:
        case exception_code::illegal_data_address:
        case exception_code::illegal_data_value: return sent.with(comm_event::read_exception_sent);
        case exception_code::server_device_failure: return sent.with(comm_event::server_abort_exception_sent);
        case exception_code::acknowledge:
        case exception_code::server_device_busy: return sent.with(comm_event::server_busy_exception_sent);
        default: return sent;
        }
    }

private:
    std::vector<std::uint8_t> events_;
};

}  // namespace support
