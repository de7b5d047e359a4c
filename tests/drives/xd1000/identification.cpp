#include <drivecodec/drives/xd1000/identification.hpp>
#include <drivecodec/modbus/rtu/client.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <array>
#include <string_view>

namespace {

using namespace drivecodec;
using modbus::exception_code;
namespace rtu = modbus::rtu;

/// The manual's response, with lengths that fit its texts: 39, 12 and 4 characters.
constexpr auto printed = "02 2B 0E 01 02 00 00 03"
                         "00 27 4C 61 75 72 69 74 7A 20 4B 6E 75 64 73 65 6E 20 45 6C 65 63 74 72 69 63 61 6C 20 26 20"
                         "      41 75 74 6F 6D 61 74 69 6F 6E"
                         "01 0C 78 44 31 30 30 30 48 30 33 37 4E 34"
                         "02 04 30 32 30 31 35 A3"_hex;

bool is(bytes seen, std::string_view wanted)
{
    return std::string_view{reinterpret_cast<char const*>(seen.data()), seen.size()} == wanted;
}

TEST(xd1000_identification, is_asked_for_with_the_manual_s_request)
{
    VERIFY(encode(xd1000::identify) == "2B 0E 01 00"_hex);
}

TEST(xd1000_manual, prints_lengths_of_18_11_and_50_bytes_that_do_not_fit_the_texts_beside_them)
{
    static_assert(printed.size() == 71);
    auto const reply = rtu::check(2, xd1000::identify, printed);
    ASSERT_TRUE(reply);
    xd1000::identification drive;
    drive.take(*reply);
    EXPECT_TRUE(is(drive.vendor_name, "Lauritz Knudsen Electrical & Automation"));
    EXPECT_TRUE(is(drive.product_code, "xD1000H037N4"));
    EXPECT_TRUE(is(drive.major_minor_revision, "0201"));
    EXPECT_EQ(*drive.version(), (xd1000::version{2, 1}));
}

TEST(xd1000_manual, has_its_fields_under_other_names_than_the_specification)
{
    auto const reply = rtu::check(2, xd1000::identify, printed);
    ASSERT_TRUE(reply);
    EXPECT_FALSE(reply->more_follows());                                        // "number of additional frames"
    EXPECT_EQ(reply->next_object_id(), modbus::device_object_id{});             // "next object"
    EXPECT_EQ(reply->conformity(), modbus::device_conformity::regular_stream);  // though all objects are basic ones
    EXPECT_EQ(reply->objects().size(), 3U);
}

TEST(xd1000_manual, has_conformity_2_but_only_the_basic_objects_so_the_count_and_more_follows_decide)
{
    // The same drive, as if it had no room: two responses, whatever the conformity says.
    constexpr auto first  = "2B 0E 01 02 FF 02 02 00 01 41 01 01 42"_hex;
    constexpr auto second = "2B 0E 01 02 00 00 01 02 04 30 32 30 31"_hex;
    using response        = modbus::read_device_identification::response;
    auto const half       = decode<response>(bytes{first});
    ASSERT_TRUE(half);
    ASSERT_TRUE(half->more_follows());
    EXPECT_EQ(half->next_object_id(), modbus::device_object_id::major_minor_revision);
    xd1000::identification drive;
    drive.take(*half);
    EXPECT_FALSE(drive.version());
    auto const rest = decode<response>(bytes{second});
    ASSERT_TRUE(rest);
    drive.take(*rest);
    EXPECT_FALSE(rest->more_follows());
    EXPECT_TRUE(is(drive.vendor_name, "A") and is(drive.product_code, "B"));
    EXPECT_EQ(*drive.version(), (xd1000::version{2, 1}));
}

TEST(xd1000_manual, leaves_out_the_negative_answer_so_both_forms_are_read)
{
    auto frame = std::array<std::uint8_t, 6>{0x02, 0xAB, 0x0E, 0x02};
    rtu::write_crc(frame);
    auto const sister = rtu::check(2, xd1000::identify, bytes{frame});
    auto       three  = std::array<std::uint8_t, 5>{0x02, 0xAB, 0x01};
    rtu::write_crc(three);
    auto const standard_form = rtu::check(2, xd1000::identify, bytes{three});
    ASSERT_FALSE(standard_form);
    EXPECT_EQ(standard_form.error().code(), errc::exception_reply);
    EXPECT_EQ(standard_form.error().offset(), 1);
    ASSERT_FALSE(sister);
    EXPECT_EQ(sister.error().code(), errc::exception_reply);
    EXPECT_EQ(sister.error().offset(), 2);
}

TEST(xd1000_identification, reads_any_length_and_refuses_a_revision_that_is_none)
{
    xd1000::identification drive;
    EXPECT_EQ(drive.version().error(), (error{errc::truncated, 4}));
    auto const with = [&](auto const& text) {
        drive.major_minor_revision = text;
        return drive.version();
    };
    EXPECT_EQ(*with("31 32 33 34"_hex), (xd1000::version{12, 34}));
    EXPECT_EQ(with("31 32 33"_hex).error(), (error{errc::truncated, 4}));
    EXPECT_EQ(with("31 32 33 34 35"_hex).error(), (error{errc::trailing_bytes, 4}));
    EXPECT_EQ(with("31 2E 33 34"_hex).error(), (error{errc::bad_value, 1}));
}

TEST(xd1000_identification, is_what_the_drive_s_side_answers)
{
    static constexpr auto        vendor   = "41 42"_hex;
    static constexpr auto        product  = "43"_hex;
    static constexpr auto        revision = "30 32 30 31"_hex;
    xd1000::identification const own{vendor, product, revision};
    auto const                   objects = own.objects();
    auto const answer = modbus::read_device_identification::answer(xd1000::identify, xd1000::conformity, objects);
    ASSERT_TRUE(answer);
    std::array<std::uint8_t, 64> room{};
    auto const                   pdu = encode(*answer, room);
    ASSERT_TRUE(pdu);
    xd1000::identification seen;
    seen.take(*decode<modbus::read_device_identification::response>(bytes{*pdu}));
    EXPECT_TRUE(is(seen.vendor_name, "AB") and is(seen.product_code, "C") and is(seen.major_minor_revision, "0201"));
}

}  // namespace
