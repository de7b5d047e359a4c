#include <drivecodec/modbus/function_code.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::modbus;

// MODBUS Application Protocol V1.1b3, 5.1: the decimal numbers of its table.
TEST(function_code, has_the_number_of_the_specification)
{
    VERIFY(to_byte(function_code::read_coils) == 1);
    VERIFY(to_byte(function_code::read_discrete_inputs) == 2);
    VERIFY(to_byte(function_code::read_holding_registers) == 3);
    VERIFY(to_byte(function_code::read_input_registers) == 4);
    VERIFY(to_byte(function_code::write_single_coil) == 5);
    VERIFY(to_byte(function_code::write_single_register) == 6);
    VERIFY(to_byte(function_code::read_exception_status) == 7);
    VERIFY(to_byte(function_code::diagnostics) == 8);
    VERIFY(to_byte(function_code::get_comm_event_counter) == 11);
    VERIFY(to_byte(function_code::get_comm_event_log) == 12);
    VERIFY(to_byte(function_code::write_multiple_coils) == 15);
    VERIFY(to_byte(function_code::write_multiple_registers) == 16);
    VERIFY(to_byte(function_code::report_server_id) == 17);
    VERIFY(to_byte(function_code::read_file_record) == 20);
    VERIFY(to_byte(function_code::write_file_record) == 21);
    VERIFY(to_byte(function_code::mask_write_register) == 22);
    VERIFY(to_byte(function_code::read_write_multiple_registers) == 23);
    VERIFY(to_byte(function_code::read_fifo_queue) == 24);
    VERIFY(to_byte(function_code::encapsulated_interface_transport) == 43);
}

TEST(function_code, without_a_name_keeps_its_number)
{
    for (unsigned byte = 0; byte <= 0xFF; ++byte) {
        EXPECT_EQ(to_byte(static_cast<function_code>(byte)), byte);
    }
}

TEST(function_code, leaves_a_pdu_253_bytes)
{
    VERIFY(max_pdu_size == 256 - 1 - 2);
    VERIFY(exception_bit == 128);
}

}  // namespace
