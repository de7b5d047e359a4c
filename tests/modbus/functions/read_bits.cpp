#include <drivecodec/modbus/functions/read_bits.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <memory>
#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

//=== the specification's examples ===//

TEST(read_coils, is_what_the_specification_prints)
{
    constexpr read_coils::request asked{.range = {0x13, 19}};
    VERIFY(encode(asked) == vectors::read_coils_request);
    VERIFY(*decode<read_coils::request>(vectors::read_coils_request) == asked);

    constexpr auto given = *decode<read_coils::response>(vectors::read_coils_response);
    VERIFY(given.values.size() == 24);
    VERIFY(given.values[0] and not given.values[1] and given.values[2] and given.values[3]);  // CDh, from coil 20 on
    VERIFY(given.values[18] and not given.values[19]);                                        // 05h: coil 38 is on
    VERIFY(asked.matches(given).ok());
}

TEST(read_discrete_inputs, is_what_the_specification_prints)
{
    constexpr read_discrete_inputs::request asked{.range = {0xC4, 22}};
    VERIFY(encode(asked) == vectors::read_discrete_inputs_request);
    VERIFY(*decode<read_discrete_inputs::request>(vectors::read_discrete_inputs_request) == asked);

    constexpr auto given = *decode<read_discrete_inputs::response>(vectors::read_discrete_inputs_response);
    VERIFY(not given.values[0] and given.values[2] and given.values[7]);  // ACh, from input 197 on
    VERIFY(given.values[21]);
    VERIFY(asked.matches(given).ok());
}

//=== limits ===//

template <typename Function>
class read_bits : public testing::Test {};
using both = testing::Types<read_coils, read_discrete_inputs>;
TYPED_TEST_SUITE(read_bits, both);

template <typename Function>
std::array<std::uint8_t, 5> request_pdu(unsigned first, unsigned count)
{
    return {to_byte(Function::code), static_cast<std::uint8_t>(first >> 8), static_cast<std::uint8_t>(first),
            static_cast<std::uint8_t>(count >> 8), static_cast<std::uint8_t>(count)};
}

TYPED_TEST(read_bits, ask_for_1_to_2000)
{
    using request = typename TypeParam::request;
    for (unsigned count = 0; count <= 0xFFFF; ++count) {
        auto const expected = count < 1 or count > 2000 ? error{errc::bad_quantity, 3} : error{};
        ASSERT_EQ(request::check(request_pdu<TypeParam>(0, count)), expected) << count;
    }
}

TYPED_TEST(read_bits, ask_for_none_beyond_65535)
{
    using request = typename TypeParam::request;
    EXPECT_TRUE(request::check(request_pdu<TypeParam>(0xFFFF, 1)).ok());
    EXPECT_EQ(request::check(request_pdu<TypeParam>(0xFFFF, 2)), (error{errc::bad_address, 1}));
    EXPECT_TRUE(request::check(request_pdu<TypeParam>(0xF830, 2000)).ok());
    EXPECT_EQ(request::check(request_pdu<TypeParam>(0xF831, 2000)), (error{errc::bad_address, 1}));
}

TYPED_TEST(read_bits, get_1_to_2000)
{
    using response     = typename TypeParam::response;
    auto const states  = std::make_unique<bool[]>(2001);
    auto const make_of = [&](std::size_t count) { return response::make(std::span<bool const>{states.get(), count}); };
    EXPECT_EQ(make_of(0).error(), (error{errc::bad_quantity, 1}));
    EXPECT_EQ(make_of(1)->wire_size(), 3U);
    EXPECT_EQ(make_of(2000)->wire_size(), 252U);
    EXPECT_EQ(make_of(2001).error(), (error{errc::bad_quantity, 1}));

    for (unsigned size = 0; size <= 0xFF; ++size) {
        properties::byte_vector pdu(2 + size);
        pdu[0] = to_byte(TypeParam::code);
        pdu[1] = static_cast<std::uint8_t>(size);
        EXPECT_EQ(response::check(pdu), (size < 1 or size > 250 ? error{errc::bad_quantity, 1} : error{})) << size;
    }
}

TYPED_TEST(read_bits, survive_encoding_and_decoding_as_a_request)
{
    using request = typename TypeParam::request;
    std::mt19937 random{9};
    for (int trial = 0; trial < 500; ++trial) {
        auto const count = 1 + random() % 2000;
        auto const range = coil_range<2000>::make(static_cast<std::uint16_t>(random() % (0x10001 - count)),
                                                  static_cast<std::uint16_t>(count));
        ASSERT_TRUE(range);
        ASSERT_TRUE(properties::round_trips(request{.range = *range}));
    }
}

// A response has whole bytes: what is decoded has the states that were sent, and 0 up to the next multiple of eight.
TYPED_TEST(read_bits, survive_encoding_and_decoding_as_a_response_of_every_size)
{
    using response = typename TypeParam::response;
    std::mt19937 random{10};
    auto const   states = std::make_unique<bool[]>(2000);
    for (std::size_t i = 0; i < 2000; ++i) { states[i] = random() % 2 != 0; }
    for (std::size_t count = 1; count <= 2000; count += count < 40 or count > 1980 ? 1 : 97) {
        auto const sent     = coil_view{std::span<bool const>{states.get(), count}};
        auto const wire     = properties::wire_of(*response::make(sent));
        auto const received = decode<response>(wire);
        ASSERT_TRUE(received) << count;
        ASSERT_EQ(received->values.size(), (count + 7) / 8 * 8);
        ASSERT_EQ(received->values.first(count), sent) << count;
        for (std::size_t i = count; i < received->values.size(); ++i) { ASSERT_FALSE(received->values[i]); }
        ASSERT_TRUE(properties::round_trips(*received));
    }
}

// A client sees whole bytes; a server may give the states asked for or fill up their last byte.
TYPED_TEST(read_bits, are_answered_by_as_many_bytes_and_no_fewer_states)
{
    using request  = typename TypeParam::request;
    using response = typename TypeParam::response;
    auto const states = std::make_unique<bool[]>(2000);
    for (unsigned count = 1; count <= 2000; count += 7) {
        auto const asked = request::read(request_pdu<TypeParam>(0, count));
        for (std::size_t given : {std::size_t{1}, std::size_t{8}, std::size_t{9}, std::size_t{count}, std::size_t{2000}}) {
            auto const reply      = *response::make(std::span<bool const>{states.get(), given});
            auto const wire       = properties::wire_of(reply);
            auto const same_bytes = (given + 7) / 8 == (count + 7) / 8;
            auto const unexpected = error{errc::unexpected_reply, 1};
            ASSERT_EQ(asked.matches(*decode<response>(wire)), (same_bytes ? error{} : unexpected)) << count << " " << given;
            ASSERT_EQ(asked.matches(reply), (same_bytes and given >= count ? error{} : unexpected)) << count << " " << given;
        }
    }
}

TYPED_TEST(read_bits, are_cut_to_the_states_asked_for)
{
    using request = typename TypeParam::request;

    static constexpr auto wire   = "FF FF"_hex;
    auto const            asked  = request::read(request_pdu<TypeParam>(0, 10));
    auto const            states = coil_view::of_wire(wire);
    EXPECT_TRUE(asked.asks_for(states));
    EXPECT_EQ(asked.exactly(states).size(), 10U);
    EXPECT_FALSE(asked.asks_for(states.first(9)));
    EXPECT_TRUE(asked.asks_for(states.first(10)));
    EXPECT_FALSE(asked.asks_for(states.first(8)));
}

//=== of one device ===//

TEST(read_coils, has_the_limit_of_its_device)
{
    using small = basic_read_coils<61>;
    VERIFY(small::request::check("01 00 00 00 3D"_hex).ok());
    VERIFY(small::request::check("01 00 00 00 3E"_hex) == error{errc::bad_quantity, 3});
    VERIFY(small::response::check("01 08 00 00 00 00 00 00 00 00"_hex).ok());
    VERIFY(small::response::check("01 09 00 00 00 00 00 00 00 00 00"_hex) == error{errc::bad_quantity, 1});
    VERIFY(basic_read_discrete_inputs<1>::request::check("02 00 00 00 02"_hex) == error{errc::bad_quantity, 3});
}

TEST(read_coils, is_answered_by_an_array_with_a_known_size)
{
    using states = coil_array<19>;
    constexpr read_coils::basic_response<states> given{
        .values = states{{true,  false, true, true,  false, false, true, true, true, true,  //
                          false, true,  false, true, true,  false, true, false, true}}};
    VERIFY(encode(given) == vectors::read_coils_response);
    constexpr read_coils::request asked{.range = {0x13, 19}};
    VERIFY(asked.matches(given).ok());
}

}  // namespace
