#include <drivecodec/modbus/raw_pdu.hpp>

#include <drivecodec/modbus/exception.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <vector>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

constexpr auto pdu   = "03 00 6B 00 03"_hex;
constexpr auto frame = "11 03 00 6B 00 03 76 87"_hex;

TEST(raw_pdu, is_passed_on_as_it_is)
{
    constexpr auto raw = *raw_pdu::make(pdu);
    VERIFY(same_bytes(raw.wire(), pdu) and raw.function() == function_code::read_holding_registers);

    std::array<std::uint8_t, 8> out{};
    ASSERT_TRUE(rtu::encode(17, raw, out));
    EXPECT_EQ(out, frame);
    EXPECT_EQ(rtu::decode<raw_pdu>(frame)->message, raw);
}

TEST(raw_pdu, may_be_of_a_function_that_nobody_knows)
{
    static constexpr auto unknown = "64 01 02"_hex;
    VERIFY(raw_pdu::make(unknown)->function() == static_cast<function_code>(100));
}

TEST(raw_pdu, has_1_to_253_bytes)
{
    std::vector<std::uint8_t> const bytes_254(254);
    for (std::size_t size = 1; size <= 253; ++size) {
        auto const made = raw_pdu::make(bytes{bytes_254}.first(size));
        ASSERT_TRUE(made) << size;
        std::vector<std::uint8_t> out(size + 3);
        auto const                written = rtu::encode(17, *made, out);
        ASSERT_TRUE(written and written->size() == size + 3);
        ASSERT_TRUE(rtu::decode<raw_pdu>(out));
    }
    EXPECT_EQ(raw_pdu::make({}).error(), (error{errc::truncated, 1}));
    EXPECT_EQ(raw_pdu::make(bytes_254).error(), (error{errc::trailing_bytes, 253}));
}

TEST(raw_pdu, and_exceptions_are_framed_like_messages)
{
    constexpr auto refusal = exception_response{function_code::read_holding_registers, exception_code::illegal_data_address};
    VERIFY(rtu::encode(1, refusal) == "01 83 02 C0 F1"_hex);
    VERIFY(rtu::decode<exception_response>("01 83 02 C0 F1"_hex)->message == refusal);
}

}  // namespace
