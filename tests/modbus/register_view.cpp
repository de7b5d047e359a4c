#include <drivecodec/modbus/register_view.hpp>

#include <drivecodec/core/codec.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <iterator>
#include <random>
#include <vector>

namespace {

using namespace drivecodec;
using modbus::register_array;
using modbus::register_view;

constexpr auto                         wire = "02 2B 00 00 80 64"_hex;
constexpr std::array<std::uint16_t, 3> words{0x022B, 0x0000, 0x8064};

TEST(register_view, of_nothing_is_empty)
{
    VERIFY(register_view{}.empty() and register_view{}.size() == 0 and register_view{}.wire_size() == 0);
    VERIFY(register_view{}.begin() == register_view{}.end());
    VERIFY(register_view{} == register_view::of_wire({}));
}

TEST(register_view, reads_wire_bytes_and_host_words_alike)
{
    VERIFY(register_view::of_wire(wire).size() == 3);
    VERIFY(register_view::of_wire(wire)[0] == 0x022B and register_view::of_wire(wire)[2] == 0x8064);
    VERIFY(register_view{words}.size() == 3);
    VERIFY(register_view{words}[0] == 0x022B and register_view{words}[2] == 0x8064);
    VERIFY(register_view{words} == register_view::of_wire(wire));
    VERIFY(register_view{words}.wire_size() == 6 and register_view::of_wire(wire).wire_size() == 6);
}

TEST(register_view, compares_values)
{
    VERIFY(register_view{words} != register_view{words}.subview(0, 2));
    VERIFY(register_view{words}.subview(0, 1) != register_view{words}.subview(1, 1));
    VERIFY(register_view{} != register_view{words});
}

TEST(register_view, leaves_out_an_odd_last_byte)
{
    VERIFY(register_view::of_wire("02 2B 00"_hex).size() == 1);
    VERIFY(register_view::of_wire("02"_hex).empty());
    VERIFY(register_view::of_wire(wire, 2).size() == 2);
}

TEST(register_view, is_iterated)
{
    VERIFY(std::input_iterator<decltype(register_view{}.begin())>);
    std::size_t at = 0;
    for (auto const value : register_view::of_wire(wire)) { EXPECT_EQ(value, words[at++]); }
    EXPECT_EQ(at, 3U);
    at = 0;
    for (auto const value : register_view{words}) { EXPECT_EQ(value, words[at++]); }
    EXPECT_EQ(at, 3U);
}

TEST(register_view, has_parts)
{
    VERIFY(register_view{words}.subview(1, 2) == register_view::of_wire(wire).subview(1, 2));
    VERIFY(register_view{words}.subview(1, 2)[1] == 0x8064);
    VERIFY(register_view::of_wire(wire).subview(2, 1)[0] == 0x8064);
    VERIFY(register_view{words}.subview(3, 0).empty());
    VERIFY(register_view::of_wire(wire).subview(3, 0).empty());
}

TEST(register_view, is_made_of_any_run_of_host_words)
{
    constexpr auto first_of = [](register_view view) { return view[0]; };
    std::vector<std::uint16_t> const vector{7, 8};
    std::array<std::uint16_t, 2>     array{9, 10};
    EXPECT_EQ(first_of(vector), 7);
    EXPECT_EQ(first_of(array), 9);
    EXPECT_EQ(first_of(std::span{array}), 9);
    EXPECT_EQ(first_of(std::span<std::uint16_t const>{vector}), 7);
}

TEST(register_view, of_more_words_than_any_message_holds_has_too_many)
{
    std::vector<std::uint16_t> const many(0x1'0001);
    EXPECT_EQ(register_view{many}.size(), 0xFFFFU);
}

//=== every size, every alignment, against a loop ===//

constexpr std::size_t max_words = 130;

struct random_registers {
    std::vector<std::uint8_t> wire = std::vector<std::uint8_t>(2 * max_words + 8);

    explicit random_registers(unsigned seed)
    {
        std::mt19937 random{seed};
        for (auto& byte : wire) { byte = static_cast<std::uint8_t>(random()); }
    }
    [[nodiscard]] std::uint16_t at(std::size_t alignment, std::size_t index) const
    {
        return static_cast<std::uint16_t>(wire[alignment + 2 * index] * 256 + wire[alignment + 2 * index + 1]);
    }
};

TEST(register_view, copies_to_host_words)
{
    random_registers const random{3};
    for (std::size_t alignment = 0; alignment < 8; ++alignment) {
        for (std::size_t count = 0; count <= max_words; ++count) {
            std::vector<std::uint16_t> expected;
            for (std::size_t i = 0; i < count; ++i) { expected.push_back(random.at(alignment, i)); }
            auto const view = register_view::of_wire(bytes{random.wire}.subspan(alignment, 2 * count));

            std::vector<std::uint16_t> to(count + 1, 0xBEEF);
            auto const                 filled = view.copy_to(std::span{to});
            ASSERT_EQ(filled.data(), to.data());
            ASSERT_EQ(std::vector<std::uint16_t>(filled.begin(), filled.end()), expected) << count << " at " << alignment;
            ASSERT_EQ(to[count], 0xBEEF);

            std::vector<std::uint16_t> again(count);
            ASSERT_EQ(register_view{expected}.copy_to(again).size(), count);
            ASSERT_EQ(again, expected) << count;
            ASSERT_EQ(register_view{expected}, view);
        }
    }
}

TEST(register_view, copies_as_many_as_there_is_room_for)
{
    std::array<std::uint16_t, 2> two{};
    EXPECT_EQ(register_view::of_wire(wire).copy_to(two).size(), 2U);
    EXPECT_EQ(two, (std::array<std::uint16_t, 2>{0x022B, 0x0000}));
    EXPECT_EQ(register_view{words}.copy_to(two).size(), 2U);
    EXPECT_EQ(two, (std::array<std::uint16_t, 2>{0x022B, 0x0000}));
    EXPECT_TRUE(register_view{words}.copy_to({}).empty());
    EXPECT_TRUE(register_view::of_wire(wire).copy_to({}).empty());
}

TEST(register_view, writes_the_same_bytes_from_both)
{
    random_registers const random{4};
    for (std::size_t alignment = 0; alignment < 8; ++alignment) {
        for (std::size_t count = 0; count <= max_words; ++count) {
            auto const                 from = bytes{random.wire}.subspan(alignment, 2 * count);
            std::vector<std::uint16_t> host(count);
            for (std::size_t i = 0; i < count; ++i) { host[i] = random.at(alignment, i); }

            std::vector<std::uint8_t> of_host(2 * count, 0xEE);
            std::vector<std::uint8_t> of_wire(2 * count, 0xEE);
            register_view{host}.write(of_host);
            register_view::of_wire(from).write(of_wire);
            ASSERT_TRUE(same_bytes(of_host, from)) << count << " at " << alignment;
            ASSERT_TRUE(same_bytes(of_wire, from)) << count << " at " << alignment;
        }
    }
}

TEST(register_view, copies_and_writes_constants)
{
    constexpr auto copied = [] {
        std::array<std::uint16_t, 3> to{};
        register_view::of_wire(wire).copy_to(to);
        return to;
    };
    constexpr auto written = [] {
        std::array<std::uint8_t, 6> to{};
        register_view{words}.write(to);
        return to;
    };
    VERIFY(copied() == words);
    VERIFY(written() == wire);
}

//=== owned ===//

TEST(register_array, is_a_view_s_equal_that_owns)
{
    constexpr register_array<3> owned{words};
    VERIFY(fixed_size<register_array<3>> and not fixed_size<register_view>);
    VERIFY(owned.size() == 3 and owned.wire_size() == 6);
    VERIFY(owned[2] == 0x8064);
    VERIFY(encode(owned) == wire);
    VERIFY(owned == register_array<3>{words});
    VERIFY(owned != register_array<3>{});
    VERIFY(std::distance(owned.begin(), owned.end()) == 3);
}

}  // namespace
