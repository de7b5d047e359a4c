#include <drivecodec/text/modbus/rtu/describe.hpp>

#include "support/hex.hpp"
#include "support/modbus_vectors.hpp"
#include "support/verify.hpp"

#include <drivecodec/modbus/rtu/reader.hpp>

#include <array>
#include <string>

namespace {

namespace modbus = drivecodec::modbus;
namespace rtu    = drivecodec::modbus::rtu;
using drivecodec::bytes;
using modbus::direction;

std::string text_of(bytes raw, direction which, bool aligned = true, bytes request = {})
{
    std::array<char, 300> buffer;
    return std::string{describe(rtu::frame{raw, which, aligned}, buffer, request)};
}

TEST(text_rtu_describe, is_a_constant_expression)
{
    constexpr auto is_right = [] {
        std::array<char, 80> buffer{};
        return describe(rtu::frame{vectors::introduction_read_request, direction::request, true}, buffer)
               == "server 17  request  03 read_holding_registers  first=107 count=3";
    }();
    VERIFY(is_right);
}

TEST(text_rtu_describe, shows_frames)
{
    EXPECT_EQ(text_of(vectors::xd1000_read_request, direction::request),
              "server 2  request  03 read_holding_registers  first=3102 count=4");
    EXPECT_EQ(text_of(vectors::xd1000_read_response, direction::response),
              "server 2  response  03 read_holding_registers  byte_count=8 registers=[40 600 500 0]");
    EXPECT_EQ(text_of(vectors::xd1000_write_request, direction::request),
              "server 2  request  06 write_single_register  register_address=9001 value=13");
}

TEST(text_rtu_describe, shows_addresses)
{
    EXPECT_EQ(text_of("00 06 00 01 00 03 00 00"_hex, direction::request),
              "broadcast  request  06 write_single_register  register_address=1 value=3");
    EXPECT_EQ(text_of("F7 07 00 00"_hex, direction::request), "server 247  request  07 read_exception_status");
    EXPECT_EQ(text_of("F8 07 00 00"_hex, direction::request),
              "server 248 (reserved)  request  07 read_exception_status");
}

TEST(text_rtu_describe, reads_a_response_in_the_light_of_its_request)
{
    EXPECT_EQ(text_of("01 01 01 05 00 00"_hex, direction::response, true, "01 00 13 00 03"_hex),
              "server 1  response  01 read_coils  byte_count=1 coils=[1 0 1]");
}

TEST(text_rtu_describe, counts_from_the_first_byte_of_the_frame)
{
    EXPECT_EQ(text_of("01 03 00 00 00 7E C5 EA"_hex, direction::request),
              "server 1  request  03 read_holding_registers  bad_quantity at byte 4: 01 03 00 00 00 7E C5 EA");
    EXPECT_EQ(text_of("01 03 00 00 C5 EA"_hex, direction::request),
              "server 1  request  03 read_holding_registers  truncated, 8 bytes needed: 01 03 00 00 C5 EA");
}

TEST(text_rtu_describe, marks_what_stood_amid_dropped_bytes)
{
    EXPECT_EQ(text_of("F7 07 00 00"_hex, direction::request, false),
              "server 247  request  07 read_exception_status  (found amid dropped bytes)");
}

TEST(text_rtu_describe, describes_what_a_reader_gives)
{
    rtu::reader           reader;
    std::array<char, 200> buffer;
    EXPECT_TRUE(reader.push(vectors::xd1000_read_request).empty());
    auto const item = reader.next();
    ASSERT_NE(item.frame(), nullptr);
    EXPECT_EQ(describe(*item.frame(), buffer), "server 2  request  03 read_holding_registers  first=3102 count=4");
}

}  // namespace
