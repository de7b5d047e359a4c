// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/pattern.hpp>
#include <drivecodec/core/word.hpp>

namespace drivecodec::modbus {

/// What a byte of the event log tells of.
enum class comm_event_kind : std::uint8_t {
    communication_restart,     ///< 00: the server's communication was restarted.
    entered_listen_only_mode,  ///< 04
    receive,                   ///< Stored before a request was processed; see `comm_event`'s receive flags.
    send,                      ///< Stored after a request was processed; see `comm_event`'s send flags.
    unknown,                   ///< None of the specification's four; the byte survives in `raw`.
};

/// One byte of the log of Get Comm Event Log. MODBUS Application Protocol V1.1b3, 6.10.
struct comm_event : word<comm_event, std::uint8_t> {
    //=== receive event: bit 7 is set ===//
    static constexpr flag<comm_event> communication_error{1};
    static constexpr flag<comm_event> character_overrun{4};
    static constexpr flag<comm_event> broadcast_received{6};

    //=== send event: bit 7 is clear, bit 6 is set ===//
    static constexpr flag<comm_event> read_exception_sent{0};          ///< Exception codes 1 to 3.
    static constexpr flag<comm_event> server_abort_exception_sent{1};  ///< Exception code 4.
    static constexpr flag<comm_event> server_busy_exception_sent{2};   ///< Exception codes 5 and 6.
    static constexpr flag<comm_event> program_nak_exception_sent{3};   ///< Exception code 7.
    static constexpr flag<comm_event> write_timeout{4};

    //=== both ===//
    static constexpr flag<comm_event> in_listen_only_mode{5};

    [[nodiscard]] constexpr comm_event_kind kind() const noexcept
    {
        for (auto const& row : codings) {
            if (row.pattern.matches(raw)) { return row.kind; }
        }
        return comm_event_kind::unknown;
    }

private:
    struct coding {
        pattern_8       pattern;
        comm_event_kind kind;
    };
    static constexpr coding codings[] = {
        {"1xxx xxxx", comm_event_kind::receive},
        {"01xx xxxx", comm_event_kind::send},
        {"0000 0100", comm_event_kind::entered_listen_only_mode},
        {"0000 0000", comm_event_kind::communication_restart},
    };
};

}  // namespace drivecodec::modbus
