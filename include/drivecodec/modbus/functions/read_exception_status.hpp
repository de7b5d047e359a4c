// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/messages/bare_request.hpp>

namespace drivecodec::modbus {

namespace layout::read_exception_status_response {  // | function | outputs |
inline constexpr u8_at<1> outputs{};
}

/// Read Exception Status (07), MODBUS Application Protocol V1.1b3, 6.7: eight outputs whose meaning is the device's.
struct read_exception_status {
    static constexpr auto        code = function_code::read_exception_status;
    static constexpr char const* name = "read_exception_status";

    using request = bare_request<read_exception_status>;

    struct response {
        using function = read_exception_status;

        std::uint8_t outputs;  ///< Exception status output 1 in the lowest bit.

        [[nodiscard]] static constexpr response make(std::uint8_t outputs_to_send) noexcept
        {
            return {outputs_to_send};
        }

        [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        {
            return layout::read_exception_status_response::outputs.end;
        }
        [[nodiscard]] static constexpr message_length length(bytes) noexcept
        {
            return message_length::exactly(wire_size());
        }
        [[nodiscard]] static constexpr error check(bytes pdu) noexcept { return check_fixed(pdu, code, wire_size()); }

        [[nodiscard]] static constexpr response read(bytes pdu) noexcept
        {
            return {.outputs = layout::read_exception_status_response::outputs.load(pdu)};
        }

        constexpr void write(mutable_bytes out) const noexcept
        {
            layout::function.store(out, to_byte(code));
            layout::read_exception_status_response::outputs.store(out, outputs);
        }

        friend constexpr bool operator==(response const&, response const&) noexcept = default;
    };
};

}  // namespace drivecodec::modbus
