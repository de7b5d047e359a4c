// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/encapsulated_interface.hpp>

namespace drivecodec::modbus {

/// CANopen General Reference (43/13), MODBUS Application Protocol V1.1b3, 6.20. What it carries is CiA 309's: bytes
/// here.
struct canopen_general_reference {
    static constexpr auto        code = function_code::encapsulated_interface_transport;
    static constexpr auto        mei  = mei_type::canopen_general_reference;
    static constexpr char const* name = "canopen_general_reference";

    static constexpr std::size_t max_payload_size = max_pdu_size - layout::encapsulated_interface::data;

    template <direction Direction>
    class message;
    using request  = message<direction::request>;
    using response = message<direction::response>;
};

template <direction Direction>
class canopen_general_reference::message {
public:
    using function = canopen_general_reference;

    /// Errors: `bad_quantity` behind the MEI type for more bytes than a PDU carries.
    [[nodiscard]] static constexpr result<message> make(bytes payload_to_send) noexcept
    {
        if (payload_to_send.size() > max_payload_size) {
            return error{errc::bad_quantity, layout::encapsulated_interface::data};
        }
        return message{payload_to_send};
    }

    [[nodiscard]] constexpr bytes payload() const noexcept { return payload_; }

    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
    {
        return layout::encapsulated_interface::data + payload_.size();
    }
    [[nodiscard]] static constexpr message_length length(bytes) noexcept { return message_length::until_silence(); }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::encapsulated_interface;
        if (auto const fault = check_mei_head(pdu, mei, at::data, at::data); not fault.ok()) { return fault; }
        return pdu.size() > max_pdu_size ? error{errc::trailing_bytes, max_pdu_size} : error{};
    }

    [[nodiscard]] static constexpr message read(bytes pdu) noexcept
    {
        return message{pdu.subspan(layout::encapsulated_interface::data)};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        write_mei_head(out, mei);
        copy_bytes(payload_, out.subspan(layout::encapsulated_interface::data));
    }

    /// As a request: every response of the function answers it.
    [[nodiscard]] constexpr error matches(message<direction::response> const&) const noexcept { return {}; }

    friend constexpr bool operator==(message const& a, message const& b) noexcept
    {
        return same_bytes(a.payload_, b.payload_);
    }

private:
    constexpr explicit message(bytes payload) noexcept : payload_{payload} {}

    bytes payload_;
};

}  // namespace drivecodec::modbus
