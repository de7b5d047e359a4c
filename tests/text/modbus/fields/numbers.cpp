#include <drivecodec/text/modbus/fields/numbers.hpp>

#include "support/field_log.hpp"
#include "support/pdu_vectors.hpp"

namespace {

namespace modbus = drivecodec::modbus;

TEST(text_fields_numbers, of_a_bare_request_there_are_none)
{
    EXPECT_EQ(fields_of<modbus::read_exception_status::request>("07"_hex), "");
    EXPECT_EQ(fields_of<modbus::get_comm_event_counter::request>("0B"_hex), "");
    EXPECT_EQ(fields_of<modbus::get_comm_event_log::request>("0C"_hex), "");
    EXPECT_EQ(fields_of<modbus::report_server_id::request>("11"_hex), "");
}

TEST(text_fields_numbers, of_05)
{
    EXPECT_EQ(fields_of<modbus::write_single_coil::request>(vectors::write_single_coil),
              "output_address=172 value=65280(on) ");
    EXPECT_EQ(fields_of<modbus::write_single_coil::response>("05 00 AC 00 00"_hex), "output_address=172 value=0(off) ");
}

TEST(text_fields_numbers, of_06)
{
    EXPECT_EQ(fields_of<modbus::write_single_register::request>(vectors::write_single_register),
              "register_address=1 value=3 ");
    EXPECT_EQ(fields_of<modbus::write_single_register::response>(vectors::write_single_register),
              "register_address=1 value=3 ");
}

TEST(text_fields_numbers, of_07)
{
    EXPECT_EQ(fields_of<modbus::read_exception_status::response>(vectors::read_exception_status_response),
              "outputs=109 ");
}

TEST(text_fields_numbers, of_11)
{
    EXPECT_EQ(fields_of<modbus::get_comm_event_counter::response>(vectors::get_comm_event_counter_response),
              "status=65535(busy) event_count=264 ");
}

TEST(text_fields_numbers, of_12)
{
    EXPECT_EQ(fields_of<modbus::get_comm_event_log::response>(vectors::get_comm_event_log_response),
              "byte_count=8 status=0(ready) event_count=264 message_count=289 events=[32 0 ] ");
}

TEST(text_fields_numbers, of_17)
{
    EXPECT_EQ(fields_of<modbus::report_server_id::response>("11 03 2A FF 07"_hex), "byte_count=3 data=[42 255 7 ] ");
}

TEST(text_fields_numbers, of_22)
{
    EXPECT_EQ(fields_of<modbus::mask_write_register::request>(vectors::mask_write_register),
              "reference_address=4 and_mask=242 or_mask=37 ");
    EXPECT_EQ(fields_of<modbus::mask_write_register::response>(vectors::mask_write_register),
              "reference_address=4 and_mask=242 or_mask=37 ");
}

TEST(text_fields_numbers, of_43_13)
{
    EXPECT_EQ(fields_of<modbus::canopen_general_reference::request>("2B 0D 01 02"_hex),
              "mei_type=13(canopen_general_reference) payload=[1 2 ] ");
    EXPECT_EQ(fields_of<modbus::canopen_general_reference::response>("2B 0D"_hex),
              "mei_type=13(canopen_general_reference) payload=[] ");
}

TEST(text_fields_numbers, of_an_exception)
{
    EXPECT_EQ(fields_of<modbus::exception_response>(vectors::exception_response), "exception=2(illegal_data_address) ");
    EXPECT_EQ(fields_of<modbus::exception_response>("83 0C"_hex), "exception=12 ");
}

}  // namespace
