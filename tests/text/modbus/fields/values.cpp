#include <drivecodec/text/modbus/fields/values.hpp>

#include "support/field_log.hpp"
#include "support/pdu_vectors.hpp"

#include <drivecodec/modbus/functions/read_registers.hpp>
#include <drivecodec/modbus/functions/write_multiple_coils.hpp>
#include <drivecodec/modbus/functions/write_multiple_registers.hpp>

namespace {

namespace modbus = drivecodec::modbus;

TEST(text_fields_values, of_01)
{
    EXPECT_EQ(fields_of<modbus::read_coils::request>(vectors::read_coils_request), "first=19 count=19 ");
    EXPECT_EQ(fields_of<modbus::read_coils::response>("01 01 0D"_hex), "byte_count=1 coils=[1 0 1 1 0 0 0 0 ] ");
}

TEST(text_fields_values, of_02)
{
    EXPECT_EQ(fields_of<modbus::read_discrete_inputs::request>(vectors::read_discrete_inputs_request),
              "first=196 count=22 ");
    EXPECT_EQ(fields_of<modbus::read_discrete_inputs::response>("02 01 80"_hex),
              "byte_count=1 inputs=[0 0 0 0 0 0 0 1 ] ");
}

TEST(text_fields_values, of_03)
{
    EXPECT_EQ(fields_of<modbus::read_holding_registers::request>(vectors::read_holding_registers_request),
              "first=107 count=3 ");
    EXPECT_EQ(fields_of<modbus::read_holding_registers::response>(vectors::read_holding_registers_response),
              "byte_count=6 registers=[555 0 100 ] ");
}

TEST(text_fields_values, of_04)
{
    EXPECT_EQ(fields_of<modbus::read_input_registers::request>(vectors::read_input_registers_request),
              "first=8 count=1 ");
    EXPECT_EQ(fields_of<modbus::read_input_registers::response>(vectors::read_input_registers_response),
              "byte_count=2 registers=[10 ] ");
}

TEST(text_fields_values, of_08)
{
    EXPECT_EQ(fields_of<modbus::diagnostics::request>(vectors::diagnostics),
              "sub_function=0(return_query_data) data=[42295 ] ");
    EXPECT_EQ(fields_of<modbus::diagnostics::response>("08 00 63 00 01 00 02"_hex), "sub_function=99 data=[1 2 ] ");
}

TEST(text_fields_values, of_15)
{
    EXPECT_EQ(fields_of<modbus::write_multiple_coils::request>(vectors::write_multiple_coils_request),
              "first=19 count=10 byte_count=2 coils=[1 0 1 1 0 0 1 1 1 0 ] ");
    EXPECT_EQ(fields_of<modbus::write_multiple_coils::response>(vectors::write_multiple_coils_response),
              "first=19 count=10 ");
}

TEST(text_fields_values, of_16)
{
    EXPECT_EQ(fields_of<modbus::write_multiple_registers::request>(vectors::write_multiple_registers_request),
              "first=1 count=2 byte_count=4 registers=[10 258 ] ");
    EXPECT_EQ(fields_of<modbus::write_multiple_registers::response>(vectors::write_multiple_registers_response),
              "first=1 count=2 ");
}

TEST(text_fields_values, of_23)
{
    using modbus::read_write_multiple_registers;
    EXPECT_EQ(fields_of<read_write_multiple_registers::request>(vectors::read_write_multiple_registers_request),
              "read_first=3 read_count=6 write_first=14 write_count=3 byte_count=6 registers=[255 255 255 ] ");
    EXPECT_EQ(fields_of<read_write_multiple_registers::response>(vectors::read_write_multiple_registers_response),
              "byte_count=12 registers=[254 2765 1 3 13 255 ] ");
}

TEST(text_fields_values, of_24)
{
    EXPECT_EQ(fields_of<modbus::read_fifo_queue::request>(vectors::read_fifo_queue_request),
              "fifo_pointer_address=1246 ");
    EXPECT_EQ(fields_of<modbus::read_fifo_queue::response>(vectors::read_fifo_queue_response),
              "byte_count=6 fifo_count=2 registers=[440 4740 ] ");
}

TEST(text_fields_values, of_constant_messages)
{
    EXPECT_EQ(fields_of_message(modbus::write_multiple_registers::of(1, {10, 258})),
              "first=1 count=2 byte_count=4 registers=[10 258 ] ");
    EXPECT_EQ(fields_of_message(modbus::write_multiple_coils::of(19, {true, false, true})),
              "first=19 count=3 byte_count=1 coils=[1 0 1 ] ");
    EXPECT_EQ(fields_of_message(modbus::read_write_multiple_registers::of({3, 6}, 14, {255})),
              "read_first=3 read_count=6 write_first=14 write_count=1 byte_count=2 registers=[255 ] ");
    EXPECT_EQ(fields_of_message(modbus::diagnostics::of(modbus::diagnostic::return_bus_message_count)),
              "sub_function=11(return_bus_message_count) data=[0 ] ");
}

TEST(text_fields_values, of_a_device_with_limits_of_its_own)
{
    EXPECT_EQ(fields_of<modbus::basic_read_holding_registers<63>::request>("03 00 6B 00 03"_hex), "first=107 count=3 ");
    using both = modbus::basic_read_write_multiple_registers<4, 4>;
    EXPECT_EQ(fields_of<both::request>("17 00 03 00 01 00 0E 00 01 02 00 FF"_hex),
              "read_first=3 read_count=1 write_first=14 write_count=1 byte_count=2 registers=[255 ] ");
}

}  // namespace
