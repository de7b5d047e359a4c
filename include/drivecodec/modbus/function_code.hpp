// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace drivecodec::modbus {

/// The public function codes. Any other byte is a valid `function_code` value without a name: users' own functions
/// and unknown ones stay representable. MODBUS Application Protocol V1.1b3, 5.1.
enum class function_code : std::uint8_t {
    read_coils                       = 0x01,
    read_discrete_inputs             = 0x02,
    read_holding_registers           = 0x03,
    read_input_registers             = 0x04,
    write_single_coil                = 0x05,
    write_single_register            = 0x06,
    read_exception_status            = 0x07,
    diagnostics                      = 0x08,
    get_comm_event_counter           = 0x0B,
    get_comm_event_log               = 0x0C,
    write_multiple_coils             = 0x0F,
    write_multiple_registers         = 0x10,
    report_server_id                 = 0x11,
    read_file_record                 = 0x14,
    write_file_record                = 0x15,
    mask_write_register              = 0x16,
    read_write_multiple_registers    = 0x17,
    read_fifo_queue                  = 0x18,
    encapsulated_interface_transport = 0x2B,
};

[[nodiscard]] constexpr std::uint8_t to_byte(function_code function) noexcept
{
    return static_cast<std::uint8_t>(function);
}

/// Set in the function code of an exception response, clear in everything else.
inline constexpr std::uint8_t exception_bit = 0x80;

/// What kind of message a PDU is.
enum class direction : std::uint8_t { request, response };

/// The longest protocol data unit: a serial line's 256 bytes less the server address and the CRC; 4.1.
inline constexpr std::size_t max_pdu_size = 253;

}  // namespace drivecodec::modbus
