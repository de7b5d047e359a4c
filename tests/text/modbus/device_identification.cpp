#include <drivecodec/text/modbus/device_identification.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

namespace {

using drivecodec::modbus::device_conformity;
using drivecodec::modbus::device_object_id;
using drivecodec::modbus::mei_type;
using drivecodec::modbus::read_device_id_code;

TEST(text_mei_type, has_both_names)
{
    EXPECT_EQ(names_of_all_values<mei_type>().size(), 2);
    VERIFY(to_string(mei_type::canopen_general_reference) == "canopen_general_reference");
    VERIFY(to_string(mei_type::read_device_identification) == "read_device_identification");
}

TEST(text_read_device_id_code, has_all_four_names)
{
    EXPECT_EQ(names_of_all_values<read_device_id_code>().size(), 4);
    VERIFY(to_string(read_device_id_code::basic) == "basic");
    VERIFY(to_string(read_device_id_code::specific) == "specific");
    VERIFY(to_string(static_cast<read_device_id_code>(0)).empty());
}

TEST(text_device_conformity, has_all_six_names)
{
    EXPECT_EQ(names_of_all_values<device_conformity>().size(), 6);
    VERIFY(to_string(device_conformity::regular_stream) == "regular_stream");
    VERIFY(to_string(device_conformity::extended_and_specific) == "extended_and_specific");
}

TEST(text_device_object_id, has_all_seven_names)
{
    EXPECT_EQ(names_of_all_values<device_object_id>().size(), 7);
    VERIFY(to_string(device_object_id::vendor_name) == "vendor_name");
    VERIFY(to_string(device_object_id::user_application_name) == "user_application_name");
    VERIFY(to_string(static_cast<device_object_id>(0x80)).empty());
}

}  // namespace
