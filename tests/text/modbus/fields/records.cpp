#include <drivecodec/text/modbus/fields/records.hpp>

#include "support/field_log.hpp"
#include "support/pdu_vectors.hpp"

namespace {

namespace modbus = drivecodec::modbus;

TEST(text_fields_records, of_20)
{
    EXPECT_EQ(fields_of<modbus::read_file_record::request>(vectors::read_file_record_request),
              "byte_count=14 records=[{reference_type=6 file=4 record=1 length=2 }"
              "{reference_type=6 file=3 record=9 length=2 }] ");
    EXPECT_EQ(fields_of<modbus::read_file_record::response>(vectors::read_file_record_response),
              "byte_count=12 records=[{length=5 reference_type=6 registers=[3582 32 ] }"
              "{length=5 reference_type=6 registers=[13261 64 ] }] ");
}

TEST(text_fields_records, of_21)
{
    constexpr auto expected = "byte_count=13 records=[{reference_type=6 file=4 record=7 length=3 "
                              "registers=[1711 1214 4109 ] }] ";
    EXPECT_EQ(fields_of<modbus::write_file_record::request>(vectors::write_file_record), expected);
    EXPECT_EQ(fields_of<modbus::write_file_record::response>(vectors::write_file_record), expected);
    EXPECT_EQ(fields_of_message(modbus::write_file_record::of(4, 7, {1711, 1214, 4109})), expected);
}

TEST(text_fields_records, of_43_14)
{
    EXPECT_EQ(fields_of<modbus::read_device_identification::request>("2B 0E 04 80"_hex),
              "mei_type=14(read_device_identification) read_device_id_code=4(specific) object_id=128 ");
    EXPECT_EQ(fields_of<modbus::read_device_identification::response>("2B 0E 02 82 FF 06 02 05 02 41 42 80 00"_hex),
              "mei_type=14(read_device_identification) read_device_id_code=2(regular) "
              "conformity=130(regular_and_specific) more_follows=255(yes) next_object_id=6(user_application_name) "
              "object_count=2 objects=[{id=5(model_name) value='AB' }{id=128 value='' }] ");
}

}  // namespace
