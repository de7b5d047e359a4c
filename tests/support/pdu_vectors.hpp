#pragma once

#include "support/hex.hpp"

#include <array>
#include <cstdint>
#include <span>

/// The examples that MODBUS Application Protocol V1.1b3 prints: PDUs, without server address and CRC.
namespace vectors {

//=== 6.1 Read Coils: 20 to 38 ===//
inline constexpr auto read_coils_request  = "01 00 13 00 13"_hex;
inline constexpr auto read_coils_response = "01 03 CD 6B 05"_hex;

//=== 6.2 Read Discrete Inputs: 197 to 218 ===//
inline constexpr auto read_discrete_inputs_request  = "02 00 C4 00 16"_hex;
inline constexpr auto read_discrete_inputs_response = "02 03 AC DB 35"_hex;

//=== 6.3 Read Holding Registers: 108 to 110 ===//
inline constexpr auto read_holding_registers_request  = "03 00 6B 00 03"_hex;
inline constexpr auto read_holding_registers_response = "03 06 02 2B 00 00 00 64"_hex;

//=== 6.4 Read Input Registers: 9 ===//
inline constexpr auto read_input_registers_request  = "04 00 08 00 01"_hex;
inline constexpr auto read_input_registers_response = "04 02 00 0A"_hex;

//=== 6.5 Write Single Coil: 173 on; the response repeats the request ===//
inline constexpr auto write_single_coil = "05 00 AC FF 00"_hex;

//=== 6.6 Write Single Register: 2 := 3; the response repeats the request ===//
inline constexpr auto write_single_register = "06 00 01 00 03"_hex;

//=== 6.7 Read Exception Status ===//
inline constexpr auto read_exception_status_request  = "07"_hex;
inline constexpr auto read_exception_status_response = "07 6D"_hex;

//=== 6.8 Diagnostics: Return Query Data; the response repeats the request ===//
inline constexpr auto diagnostics = "08 00 00 A5 37"_hex;

//=== 6.9 Get Comm Event Counter ===//
inline constexpr auto get_comm_event_counter_request  = "0B"_hex;
inline constexpr auto get_comm_event_counter_response = "0B FF FF 01 08"_hex;

//=== 6.10 Get Comm Event Log ===//
inline constexpr auto get_comm_event_log_request  = "0C"_hex;
inline constexpr auto get_comm_event_log_response = "0C 08 00 00 01 08 01 21 20 00"_hex;

//=== 6.11 Write Multiple Coils: 20 to 29 ===//
inline constexpr auto write_multiple_coils_request  = "0F 00 13 00 0A 02 CD 01"_hex;
inline constexpr auto write_multiple_coils_response = "0F 00 13 00 0A"_hex;

//=== 6.12 Write Multiple Registers: 2 and 3 ===//
inline constexpr auto write_multiple_registers_request  = "10 00 01 00 02 04 00 0A 01 02"_hex;
inline constexpr auto write_multiple_registers_response = "10 00 01 00 02"_hex;

//=== 6.14 Read File Record: two groups of two registers ===//
inline constexpr auto read_file_record_request  = "14 0E 06 00 04 00 01 00 02 06 00 03 00 09 00 02"_hex;
inline constexpr auto read_file_record_response = "14 0C 05 06 0D FE 00 20 05 06 33 CD 00 40"_hex;

//=== 6.15 Write File Record: three registers; the response repeats the request ===//
inline constexpr auto write_file_record = "15 0D 06 00 04 00 07 00 03 06 AF 04 BE 10 0D"_hex;

//=== 6.16 Mask Write Register: 5; the response repeats the request ===//
inline constexpr auto mask_write_register = "16 00 04 00 F2 00 25"_hex;

//=== 6.17 Read/Write Multiple Registers: reads six from 4 on, writes three from 15 on ===//
inline constexpr auto read_write_multiple_registers_request =
    "17 00 03 00 06 00 0E 00 03 06 00 FF 00 FF 00 FF"_hex;
inline constexpr auto read_write_multiple_registers_response = "17 0C 00 FE 0A CD 00 01 00 03 00 0D 00 FF"_hex;

//=== 6.18 Read FIFO Queue: 1246 ===//
inline constexpr auto read_fifo_queue_request  = "18 04 DE"_hex;
inline constexpr auto read_fifo_queue_response = "18 00 06 00 02 01 B8 12 84"_hex;

//=== 6.21 Read Device Identification: "Company identification", "Product code XX", "V2.11" ===//
// The lengths of the objects are those of their texts.
inline constexpr auto read_device_identification_request  = "2B 0E 01 00"_hex;
inline constexpr auto read_device_identification_response =
    "2B 0E 01 01 00 00 03"
    "00 16 43 6F 6D 70 61 6E 79 20 69 64 65 6E 74 69 66 69 63 61 74 69 6F 6E"
    "01 0F 50 72 6F 64 75 63 74 20 63 6F 64 65 20 58 58"
    "02 05 56 32 2E 31 31"_hex;

//=== 7 Exception responses: no coil 1186 ===//
inline constexpr auto exception_request  = "01 04 A1 00 01"_hex;
inline constexpr auto exception_response = "81 02"_hex;

//=== all of them, for corpora and loops ===//

struct printed_pdu {
    char const*                   name;
    std::span<std::uint8_t const> pdu;
};

inline constexpr std::array printed_requests{
    printed_pdu{"read_coils", read_coils_request},
    printed_pdu{"read_discrete_inputs", read_discrete_inputs_request},
    printed_pdu{"read_holding_registers", read_holding_registers_request},
    printed_pdu{"read_input_registers", read_input_registers_request},
    printed_pdu{"write_single_coil", write_single_coil},
    printed_pdu{"write_single_register", write_single_register},
    printed_pdu{"read_exception_status", read_exception_status_request},
    printed_pdu{"diagnostics", diagnostics},
    printed_pdu{"get_comm_event_counter", get_comm_event_counter_request},
    printed_pdu{"get_comm_event_log", get_comm_event_log_request},
    printed_pdu{"write_multiple_coils", write_multiple_coils_request},
    printed_pdu{"write_multiple_registers", write_multiple_registers_request},
    printed_pdu{"read_file_record", read_file_record_request},
    printed_pdu{"write_file_record", write_file_record},
    printed_pdu{"mask_write_register", mask_write_register},
    printed_pdu{"read_write_multiple_registers", read_write_multiple_registers_request},
    printed_pdu{"read_fifo_queue", read_fifo_queue_request},
    printed_pdu{"read_device_identification", read_device_identification_request},
    printed_pdu{"read_coils", exception_request},
};

inline constexpr std::array printed_responses{
    printed_pdu{"read_coils", read_coils_response},
    printed_pdu{"read_discrete_inputs", read_discrete_inputs_response},
    printed_pdu{"read_holding_registers", read_holding_registers_response},
    printed_pdu{"read_input_registers", read_input_registers_response},
    printed_pdu{"write_single_coil", write_single_coil},
    printed_pdu{"write_single_register", write_single_register},
    printed_pdu{"read_exception_status", read_exception_status_response},
    printed_pdu{"diagnostics", diagnostics},
    printed_pdu{"get_comm_event_counter", get_comm_event_counter_response},
    printed_pdu{"get_comm_event_log", get_comm_event_log_response},
    printed_pdu{"write_multiple_coils", write_multiple_coils_response},
    printed_pdu{"write_multiple_registers", write_multiple_registers_response},
    printed_pdu{"read_file_record", read_file_record_response},
    printed_pdu{"write_file_record", write_file_record},
    printed_pdu{"mask_write_register", mask_write_register},
    printed_pdu{"read_write_multiple_registers", read_write_multiple_registers_response},
    printed_pdu{"read_fifo_queue", read_fifo_queue_response},
    printed_pdu{"read_device_identification", read_device_identification_response},
    printed_pdu{"read_coils", exception_response},
};

}  // namespace vectors
