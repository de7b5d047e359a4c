#include <drivecodec/modbus/messages/range_message.hpp>

#include "support/hex.hpp"
#include "support/pdu_properties.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

/// A device's own: at most 63 registers.
struct peek {
    static constexpr auto code = static_cast<function_code>(0x41);
};
using request = range_message<peek, register_range<63>>;

TEST(range_message, is_a_function_and_a_range)
{
    constexpr request asked{.range = {0x1234, 5}};
    VERIFY(encode(asked) == "41 12 34 00 05"_hex);
    VERIFY(*decode<request>("41 12 34 00 05"_hex) == asked);
    VERIFY(request::length({}) == message_length::exactly(5));
}

TEST(range_message, has_the_limits_of_its_range)
{
    VERIFY(request::check("41 00 00 00 00"_hex) == error{errc::bad_quantity, 3});
    VERIFY(request::check("41 00 00 00 01"_hex).ok());
    VERIFY(request::check("41 00 00 00 3F"_hex).ok());
    VERIFY(request::check("41 00 00 00 40"_hex) == error{errc::bad_quantity, 3});
    VERIFY(request::check("41 FF FF 00 01"_hex).ok());
    VERIFY(request::check("41 FF FF 00 02"_hex) == error{errc::bad_address, 1});
}

TEST(range_message, survives_encoding_and_decoding)
{
    std::mt19937 random{8};
    for (int trial = 0; trial < 1000; ++trial) {
        auto const range = register_range<63>::make(static_cast<std::uint16_t>(random() % 0xFFC0),
                                                    static_cast<std::uint16_t>(1 + random() % 63));
        ASSERT_TRUE(range);
        ASSERT_TRUE(properties::round_trips(request{.range = *range}));
    }
}

struct some_registers {
    using addressed = registers;

    std::size_t                         count;
    [[nodiscard]] constexpr std::size_t size() const { return count; }
    [[nodiscard]] constexpr std::size_t wire_size() const { return 2 * count; }
};

struct answer {
    static constexpr std::size_t byte_count_offset = 1;

    some_registers values;
};

TEST(range_message, is_answered_by_as_many_values_as_it_asks_for)
{
    constexpr request asked{.range = {0, 5}};
    VERIFY(asked.matches(answer{{5}}).ok());
    VERIFY(asked.matches(answer{{4}}) == error{errc::unexpected_reply, 1});
    VERIFY(asked.matches(answer{{6}}) == error{errc::unexpected_reply, 1});
    VERIFY(asked.asks_for(some_registers{5}) and not asked.asks_for(some_registers{4}));
}

}  // namespace
