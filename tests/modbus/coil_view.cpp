#include <drivecodec/modbus/coil_view.hpp>

#include <drivecodec/core/codec.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <iterator>
#include <memory>
#include <random>
#include <vector>

namespace {

using namespace drivecodec;
using modbus::coil_array;
using modbus::coil_view;

// MODBUS Application Protocol V1.1b3, 6.1: coils 27 to 20 are CDh, 1100 1101.
constexpr auto                 wire = "CD 01"_hex;
constexpr std::array<bool, 10> states{true, false, true, true, false, false, true, true, true, false};

TEST(coil_view, of_nothing_is_empty)
{
    VERIFY(coil_view{}.empty() and coil_view{}.size() == 0 and coil_view{}.wire_size() == 0);
    VERIFY(coil_view{}.begin() == coil_view{}.end());
    VERIFY(coil_view{} == coil_view::of_wire({}));
}

TEST(coil_view, has_the_first_coil_in_the_lowest_bit)
{
    VERIFY(coil_view::of_wire("01"_hex)[0] and not coil_view::of_wire("01"_hex)[7]);
    VERIFY(coil_view::of_wire("80"_hex)[7] and not coil_view::of_wire("80"_hex)[0]);
    VERIFY(coil_view::of_wire("00 01"_hex)[8]);
    VERIFY(coil_view::of_wire(wire, 10) == coil_view{states});
}

TEST(coil_view, of_whole_bytes_has_eight_a_byte)
{
    VERIFY(coil_view::of_wire(wire).size() == 16 and coil_view::of_wire(wire).wire_size() == 2);
    VERIFY(coil_view::of_wire(wire, 10).size() == 10 and coil_view::of_wire(wire, 10).wire_size() == 2);
    VERIFY(coil_view::of_wire(wire).first(10) == coil_view{states});
    VERIFY(coil_view{states}.first(3) == coil_view::of_wire("05"_hex, 3));
}

TEST(coil_view, ignores_unused_bits_when_it_reads)
{
    VERIFY(coil_view::of_wire("CD FD"_hex, 10) == coil_view::of_wire("CD 01"_hex, 10));
    VERIFY(coil_view::of_wire("CD FD"_hex, 11) != coil_view::of_wire("CD 01"_hex, 11));
}

TEST(coil_view, compares_values)
{
    VERIFY(coil_view{states} != coil_view{states}.first(9));
    VERIFY(coil_view::of_wire("01"_hex, 1) != coil_view::of_wire("00"_hex, 1));
}

TEST(coil_view, writes_unused_bits_as_0)
{
    constexpr auto written = [](coil_view view) {
        std::array<std::uint8_t, 2> to{0xEE, 0xEE};
        view.write(to);
        return to;
    };
    VERIFY(written(coil_view::of_wire("CD FD"_hex, 10)) == wire);
    VERIFY(written(coil_view::of_wire("CD FD"_hex, 16)) == "CD FD"_hex);
    VERIFY(written(coil_view{states}) == wire);
}

TEST(coil_view, is_iterated)
{
    VERIFY(std::input_iterator<decltype(coil_view{}.begin())>);
    std::size_t at = 0;
    for (auto const state : coil_view::of_wire(wire, 10)) { EXPECT_EQ(state, states[at++]); }
    EXPECT_EQ(at, 10U);
}

TEST(coil_view, of_more_states_than_any_message_holds_has_too_many)
{
    auto const many = std::make_unique<bool[]>(0x1'0001);
    EXPECT_EQ((coil_view{std::span<bool const>{many.get(), 0x1'0001}}.size()), 0xFFFFU);
}

void expect_same_from_both(std::size_t count, std::mt19937& random)
{
    auto const                host = std::make_unique<bool[]>(count + 1);
    std::vector<std::uint8_t> expected((count + 7) / 8);
    for (std::size_t i = 0; i < count; ++i) {
        host[i] = random() % 2 != 0;
        if (host[i]) { expected[i / 8] = static_cast<std::uint8_t>(expected[i / 8] + (1 << i % 8)); }
    }
    auto const of_host = coil_view{std::span<bool const>{host.get(), count}};
    ASSERT_EQ(of_host.wire_size(), expected.size());

    std::vector<std::uint8_t> out(expected.size(), 0xEE);
    of_host.write(out);
    ASSERT_EQ(out, expected) << count;

    auto dirty = expected;
    if (count % 8 != 0) { dirty.back() = static_cast<std::uint8_t>(dirty.back() | 0xFF << count % 8); }
    auto const of_wire = coil_view::of_wire(dirty, count);
    ASSERT_EQ(of_wire, of_host) << count;
    of_wire.write(out);
    ASSERT_EQ(out, expected) << count;
    for (std::size_t i = 0; i < count; ++i) { ASSERT_EQ(of_wire[i], host[i]) << i << " of " << count; }
}

TEST(coil_view, is_the_same_from_wire_and_host_for_every_size)
{
    std::mt19937 random{5};
    for (std::size_t count = 0; count <= 40; ++count) { expect_same_from_both(count, random); }
    for (std::size_t count = 1960; count <= 2000; ++count) { expect_same_from_both(count, random); }
}

//=== owned ===//

TEST(coil_array, is_a_view_s_equal_that_owns)
{
    constexpr coil_array<10> owned{states};
    VERIFY(fixed_size<coil_array<10>> and not fixed_size<coil_view>);
    VERIFY(owned.size() == 10 and owned.wire_size() == 2);
    VERIFY(owned[0] and not owned[1]);
    VERIFY(encode(owned) == wire);
    VERIFY(owned == coil_array<10>{states});
    VERIFY(owned != coil_array<10>{});
    VERIFY(std::distance(owned.begin(), owned.end()) == 10);
}

}  // namespace
