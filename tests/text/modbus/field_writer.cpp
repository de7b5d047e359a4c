#include <drivecodec/text/modbus/field_writer.hpp>

#include "support/hex.hpp"
#include "support/pdu_vectors.hpp"
#include "support/verify.hpp"

#include <array>

namespace maker {

struct reading {
    bool                          valid;
    int                           offset;
    std::string_view              unit;
    std::array<std::uint16_t, 2>  words;
};
constexpr void for_each_field(reading const& message, auto&& visit)
{
    visit("valid", message.valid);
    visit("offset", message.offset);
    visit("unit", message.unit);
    visit("words", message.words);
}

struct untold {};

}  // namespace maker

namespace {

namespace modbus = drivecodec::modbus;
using drivecodec::text_writer;

template <typename Message>
constexpr bool reads(Message const& message, std::string_view expected, std::string_view before = {})
{
    std::array<char, 300> buffer{};
    text_writer           out{buffer};
    modbus::write_fields(out, message, before);
    return out.view() == expected;
}

template <typename Message>
constexpr bool wire_reads(drivecodec::bytes pdu, std::string_view expected)
{
    return reads(Message::read(pdu), expected);
}

TEST(text_field_writer, writes_numbers_and_names)
{
    VERIFY(wire_reads<modbus::read_coils::request>(vectors::read_coils_request, "first=19 count=19"));
    VERIFY(wire_reads<modbus::write_single_coil::request>(vectors::write_single_coil, "output_address=172 value=on"));
}

TEST(text_field_writer, writes_numbers_without_a_name_in_hexadecimal)
{
    VERIFY(wire_reads<modbus::mask_write_register::request>(vectors::mask_write_register,
                                                            "reference_address=4 and_mask=0x00F2 or_mask=0x0025"));
    VERIFY(wire_reads<modbus::exception_response>("83 0C"_hex, "exception=0x0C"));
}

TEST(text_field_writer, writes_lists)
{
    VERIFY(wire_reads<modbus::read_coils::response>("01 01 0D"_hex, "byte_count=1 coils=[1 0 1 1 0 0 0 0]"));
    VERIFY(wire_reads<modbus::read_fifo_queue::response>("18 00 02 00 00"_hex,
                                                         "byte_count=2 fifo_count=0 registers=[]"));
    VERIFY(wire_reads<modbus::report_server_id::response>("11 02 2A FF"_hex, "byte_count=2 data=[0x2A 0xFF]"));
    VERIFY(wire_reads<modbus::canopen_general_reference::request>("2B 0D"_hex,
                                                                  "mei_type=canopen_general_reference payload=[]"));
    VERIFY(wire_reads<modbus::get_comm_event_log::response>(
        "0C 08 00 00 00 00 00 00 80 00"_hex,
        "byte_count=8 status=ready event_count=0 message_count=0 events=[receive communication_restart]"));
}

TEST(text_field_writer, writes_records)
{
    VERIFY(wire_reads<modbus::read_file_record::response>(
        vectors::read_file_record_response, "byte_count=12 records=[{length=5 reference_type=6 registers=[3582 32]} "
                                            "{length=5 reference_type=6 registers=[13261 64]}]"));
    VERIFY(wire_reads<modbus::read_device_identification::response>(
        "2B 0E 04 81 00 00 01 00 03 41 22 07"_hex,
        R"(mei_type=read_device_identification read_device_id_code=specific conformity=basic_and_specific )"
        R"(more_follows=no next_object_id=vendor_name object_count=1 objects=[{id=vendor_name value="A\"\x07"}])"));
}

TEST(text_field_writer, writes_what_a_user_s_message_may_have)
{
    VERIFY(reads(maker::reading{true, -5, "rpm", {1, 2}}, "valid=1 offset=-5 unit=rpm words=[1 2]"));
    VERIFY(reads(maker::untold{}, ""));
}

TEST(text_field_writer, writes_what_comes_before_the_first_field_only_if_there_is_one)
{
    VERIFY(reads(modbus::write_single_register::request{1, 2}, "  register_address=1 value=2", "  "));
    VERIFY(reads(modbus::read_exception_status::request{}, "", "  "));
}

}  // namespace
