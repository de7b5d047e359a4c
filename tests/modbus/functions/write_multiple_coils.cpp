#include <drivecodec/modbus/functions/write_multiple_coils.hpp>

#include "support/pdu_properties.hpp"
#include "support/pdu_vectors.hpp"

#include <memory>
#include <random>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

using request  = write_multiple_coils::request;
using response = write_multiple_coils::response;

constexpr std::array<bool, 10> states{true, false, true, true, false, false, true, true, true, false};

TEST(write_multiple_coils, is_what_the_specification_prints)
{
    constexpr auto constant =
        write_multiple_coils::of(19, {true, false, true, true, false, false, true, true, true, false});
    constexpr auto asked = *request::make(19, states);
    VERIFY(encode(constant) == vectors::write_multiple_coils_request);
    VERIFY(*decode<request>(vectors::write_multiple_coils_request) == asked);
    VERIFY(encode(asked.reply()) == vectors::write_multiple_coils_response);
    VERIFY(*decode<response>(vectors::write_multiple_coils_response) == asked.reply());
    EXPECT_EQ(properties::wire_of(asked), properties::copy_of(vectors::write_multiple_coils_request));
}

TEST(write_multiple_coils, ignores_unused_bits_and_writes_them_as_0)
{
    static constexpr auto dirty = "0F 00 13 00 0A 02 CD FD"_hex;
    VERIFY(*decode<request>(dirty) == *request::make(19, states));
    EXPECT_EQ(properties::wire_of(*decode<request>(dirty)),
              properties::copy_of(vectors::write_multiple_coils_request));
}

//=== limits ===//

TEST(write_multiple_coils, writes_1_to_1968)
{
    auto const many    = std::make_unique<bool[]>(1969);
    auto const make_of = [&](std::size_t count) { return request::make(0, std::span<bool const>{many.get(), count}); };
    EXPECT_EQ(make_of(0).error(), (error{errc::bad_quantity, 3}));
    EXPECT_EQ(make_of(1)->wire_size(), 7U);
    EXPECT_EQ(make_of(1968)->wire_size(), 252U);
    EXPECT_EQ(make_of(1969).error(), (error{errc::bad_quantity, 3}));

    for (unsigned count = 0; count <= 0xFFFF; ++count) {
        std::array<std::uint8_t, 6> const pdu{0x0F,
                                              0,
                                              0,
                                              static_cast<std::uint8_t>(count >> 8),
                                              static_cast<std::uint8_t>(count),
                                              static_cast<std::uint8_t>((count + 7) / 8)};
        auto const allowed = count >= 1 and count <= 1968;
        ASSERT_EQ(request::check(pdu),
                  (allowed ? error{errc::truncated, 6 + (count + 7) / 8} : error{errc::bad_quantity, 3}))
            << count;
        ASSERT_EQ(response::check(bytes{pdu}.first(5)), (allowed ? error{} : error{errc::bad_quantity, 3})) << count;
    }
}

TEST(write_multiple_coils, writes_none_beyond_65535)
{
    VERIFY(request::make(0xFFF6, states).has_value());
    VERIFY(request::make(0xFFF7, states).error() == error{errc::bad_address, 1});
    VERIFY(request::check("0F FF F7 00 0A 02 00 00"_hex) == error{errc::bad_address, 1});
}

TEST(write_multiple_coils, has_a_byte_count_that_agrees)
{
    for (unsigned count = 1; count <= 40; ++count) {
        for (unsigned size = 0; size <= 0xFF; ++size) {
            properties::byte_vector pdu(6 + size);
            pdu[0] = 0x0F;
            pdu[4] = static_cast<std::uint8_t>(count);
            pdu[5] = static_cast<std::uint8_t>(size);
            ASSERT_EQ(request::check(pdu), (size == (count + 7) / 8 ? error{} : error{errc::bad_length, 5}))
                << count << " " << size;
        }
    }
}

TEST(write_multiple_coils, has_the_limit_of_its_device)
{
    using small = basic_write_multiple_coils<4>;
    VERIFY(small::request::check("0F 00 00 00 04 01 0F"_hex).ok());
    VERIFY(small::request::check("0F 00 00 00 05 01 0F"_hex) == error{errc::bad_quantity, 3});
    VERIFY(small::request::make(0, states).error() == error{errc::bad_quantity, 3});
}

//=== both ways ===//

TEST(write_multiple_coils, survives_encoding_and_decoding)
{
    std::mt19937 random{15};
    auto const   host = std::make_unique<bool[]>(1968);
    for (std::size_t i = 0; i < 1968; ++i) { host[i] = random() % 2 != 0; }
    for (std::size_t count = 1; count <= 1968; count += count < 40 or count > 1950 ? 1 : 61) {
        auto const made = request::make(static_cast<std::uint16_t>(random() % (0x10001 - count)),
                                        std::span<bool const>{host.get(), count});
        ASSERT_TRUE(made);
        ASSERT_TRUE(properties::round_trips(*made)) << count;
        ASSERT_TRUE(properties::round_trips(made->reply())) << count;
        ASSERT_TRUE(made->matches(made->reply()).ok());
        auto const wire = properties::wire_of(*made);
        auto const back = encode(made->reply());
        ASSERT_TRUE(same_bytes(back, bytes{wire}.first(made->echo_size())));
    }
}

TEST(write_multiple_coils, is_answered_by_its_range)
{
    constexpr auto     asked = *request::make(19, states);
    constexpr response other_first{.range = {20, 10}};
    constexpr response other_count{.range = {19, 16}};
    VERIFY(asked.matches(other_first) == error{errc::unexpected_reply, 1});
    VERIFY(asked.matches(other_count) == error{errc::unexpected_reply, 3});
}

}  // namespace
