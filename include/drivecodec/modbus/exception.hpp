// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/message.hpp>

namespace drivecodec::modbus {

/// Why a server refused. Any other number is a value without a name. MODBUS Application Protocol V1.1b3, 7.
enum class exception_code : std::uint8_t {
    illegal_function                        = 0x01,
    illegal_data_address                    = 0x02,
    illegal_data_value                      = 0x03,
    server_device_failure                   = 0x04,
    acknowledge                             = 0x05,
    server_device_busy                      = 0x06,
    memory_parity_error                     = 0x08,
    gateway_path_unavailable                = 0x0A,
    gateway_target_device_failed_to_respond = 0x0B,
};

/// The exception that tells a client of this fault in its request: 01 for a function, sub-function or MEI type that is
/// not served, 02 for an address or a range past the last one, 03 for a wrong quantity, byte count, value or length.
[[nodiscard]] constexpr exception_code to_exception(error fault) noexcept
{
    switch (fault.code()) {
    case errc::unsupported_function:
    case errc::unexpected_function: return exception_code::illegal_function;
    case errc::bad_address: return exception_code::illegal_data_address;
    default: return exception_code::illegal_data_value;
    }
}

/// A server's refusal: | function + 80h | exception code |.
///
/// Some drives refuse function 43 with three bytes, | ABh | MEI type | exception code | (Schneider ATV71 guide); that
/// form is read too, and never written.
struct exception_response {
    static constexpr bool         is_pdu   = true;
    static constexpr std::size_t  mei_size = 3;
    static constexpr std::uint8_t mei_function =
        to_byte(function_code::encapsulated_interface_transport) | exception_bit;

    function_code  refused;  ///< The function that was asked for, without the exception bit.
    exception_code code;

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept { return 2; }

    [[nodiscard]] static constexpr bool is_exception(bytes pdu) noexcept
    {
        return not pdu.empty() and (layout::function.load(pdu) & exception_bit) != 0;
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        if (not pdu.empty() and not is_exception(pdu)) { return {errc::unexpected_function, layout::function.begin}; }
        return is_mei_form(pdu) ? error{} : check_size(pdu, wire_size());
    }

    [[nodiscard]] static constexpr exception_response read(bytes pdu) noexcept
    {
        return {.refused = static_cast<function_code>(layout::function.load(pdu) & ~exception_bit),
                .code    = static_cast<exception_code>(pdu.back())};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        layout::function.store(out, static_cast<std::uint8_t>(to_byte(refused) | exception_bit));
        u8_at<1>::store(out, static_cast<std::uint8_t>(code));
    }

    friend constexpr bool operator==(exception_response, exception_response) noexcept = default;

private:
    static constexpr bool is_mei_form(bytes pdu) noexcept
    {
        return pdu.size() == mei_size and layout::function.load(pdu) == mei_function;
    }
};

}  // namespace drivecodec::modbus
