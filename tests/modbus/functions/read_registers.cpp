#include <drivecodec/modbus/functions/read_registers.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

//=== the specification's examples ===//

TEST(read_holding_registers, is_what_the_specification_prints)
{
    constexpr read_holding_registers::request asked{.range = {0x6B, 3}};
    VERIFY(encode(asked) == vectors::read_holding_registers_request);
    VERIFY(*decode<read_holding_registers::request>(vectors::read_holding_registers_request) == asked);

    constexpr auto given = *decode<read_holding_registers::response>(vectors::read_holding_registers_response);
    VERIFY(given.values.size() == 3);
    VERIFY(given.values[0] == 555 and given.values[1] == 0 and given.values[2] == 100);
    VERIFY(asked.matches(given).ok());

    constexpr read_holding_registers::basic_response<register_array<3>> owned{
        .values = register_array<3>{{555, 0, 100}}};
    VERIFY(encode(owned) == vectors::read_holding_registers_response);
    VERIFY(asked.matches(owned).ok());
}

TEST(read_input_registers, is_what_the_specification_prints)
{
    constexpr read_input_registers::request asked{.range = {8, 1}};
    VERIFY(encode(asked) == vectors::read_input_registers_request);
    VERIFY(*decode<read_input_registers::request>(vectors::read_input_registers_request) == asked);
    VERIFY(decode<read_input_registers::response>(vectors::read_input_registers_response)->values[0] == 10);
}

//=== limits ===//

template <typename Function>
class read_registers : public testing::Test {};
using both = testing::Types<read_holding_registers, read_input_registers>;
TYPED_TEST_SUITE(read_registers, both);

template <typename Function>
std::array<std::uint8_t, 5> request_pdu(unsigned first, unsigned count)
{
    return {to_byte(Function::code), static_cast<std::uint8_t>(first >> 8), static_cast<std::uint8_t>(first),
            static_cast<std::uint8_t>(count >> 8), static_cast<std::uint8_t>(count)};
}

TYPED_TEST(read_registers, ask_for_1_to_125)
{
    using request = typename TypeParam::request;
    for (unsigned count = 0; count <= 0xFFFF; ++count) {
        auto const expected = count < 1 or count > 125 ? error{errc::bad_quantity, 3} : error{};
        ASSERT_EQ(request::check(request_pdu<TypeParam>(0, count)), expected) << count;
    }
}

TYPED_TEST(read_registers, ask_for_none_beyond_65535)
{
    using request = typename TypeParam::request;
    EXPECT_TRUE(request::check(request_pdu<TypeParam>(0xFFFF, 1)).ok());
    EXPECT_EQ(request::check(request_pdu<TypeParam>(0xFFFF, 2)), (error{errc::bad_address, 1}));
    EXPECT_TRUE(request::check(request_pdu<TypeParam>(0xFF83, 125)).ok());
    EXPECT_EQ(request::check(request_pdu<TypeParam>(0xFF84, 125)), (error{errc::bad_address, 1}));
}

TYPED_TEST(read_registers, get_1_to_125)
{
    using response = typename TypeParam::response;
    std::vector<std::uint16_t> const words(126);
    auto const make_of = [&](std::size_t count) { return response::make(std::span{words}.first(count)); };
    EXPECT_EQ(make_of(0).error(), (error{errc::bad_quantity, 1}));
    EXPECT_EQ(make_of(1)->wire_size(), 4U);
    EXPECT_EQ(make_of(125)->wire_size(), 252U);
    EXPECT_EQ(make_of(126).error(), (error{errc::bad_quantity, 1}));

    for (unsigned size = 0; size <= 0xFF; ++size) {
        properties::byte_vector pdu(2 + size);
        pdu[0] = to_byte(TypeParam::code);
        pdu[1] = static_cast<std::uint8_t>(size);

        auto expected = error{};
        if (size % 2 != 0) {
            expected = {errc::bad_length, 1};
        } else if (size < 2 or size > 250) {
            expected = {errc::bad_quantity, 1};
        }
        EXPECT_EQ(response::check(pdu), expected) << size;
    }
}

TYPED_TEST(read_registers, survive_encoding_and_decoding)
{
    using request  = typename TypeParam::request;
    using response = typename TypeParam::response;
    std::mt19937 random{11};
    for (unsigned count = 1; count <= 125; ++count) {
        auto const range = register_range<125>::make(static_cast<std::uint16_t>(random() % (0x10001 - count)),
                                                     static_cast<std::uint16_t>(count));
        ASSERT_TRUE(range);
        ASSERT_TRUE(properties::round_trips(request{.range = *range}));

        std::vector<std::uint16_t> words(count);
        for (auto& word : words) { word = static_cast<std::uint16_t>(random()); }
        auto const made = response::make(register_view{words});
        ASSERT_TRUE(made);
        ASSERT_TRUE(properties::round_trips(*made));

        // From wire bytes as from host words.
        auto const wire = properties::wire_of(*made);
        EXPECT_EQ(properties::wire_of(*decode<response>(wire)), wire);
    }
}

TYPED_TEST(read_registers, are_answered_by_as_many_registers)
{
    using request  = typename TypeParam::request;
    using response = typename TypeParam::response;
    std::vector<std::uint16_t> const words(125);
    for (unsigned asked = 1; asked <= 125; ++asked) {
        for (unsigned given = 1; given <= 125; ++given) {
            auto const reply = *response::make(std::span{words}.first(given));
            ASSERT_EQ(request::read(request_pdu<TypeParam>(0, asked)).matches(reply),
                      (asked == given ? error{} : error{errc::unexpected_reply, 1}));
        }
    }
}

//=== of one device ===//

template <std::uint16_t Max>
void expect_limit_of_device()
{
    using device = basic_read_holding_registers<Max>;
    std::vector<std::uint16_t> const words(Max + 1U);
    EXPECT_TRUE(device::request::check(request_pdu<device>(0, Max)).ok());
    EXPECT_EQ(device::request::check(request_pdu<device>(0, Max + 1U)), (error{errc::bad_quantity, 3}));
    EXPECT_TRUE(device::response::make(std::span{words}.first(Max)));
    EXPECT_EQ(device::response::make(register_view{words}).error(), (error{errc::bad_quantity, 1}));

    auto const wire = properties::wire_of(*read_holding_registers::response::make(register_view{words}));
    EXPECT_EQ(device::response::check(wire), (error{errc::bad_quantity, 1}));
}

TEST(read_holding_registers, has_the_limit_of_its_device)
{
    expect_limit_of_device<63>();
    expect_limit_of_device<61>();
    expect_limit_of_device<4>();
    expect_limit_of_device<1>();
}

}  // namespace
