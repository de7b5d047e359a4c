#include <drivecodec/drives/holding_register.hpp>

#include "support/lamps.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::drives;
using namespace drivecodec::literals;

constexpr register_row row_of(std::uint16_t address, raw_type type, int exponent, unit of, raw_limits limits,
                              drives::access may)
{
    return {address,        "",     "",         "",  type,          static_cast<std::int8_t>(exponent), of,
            source::manual, limits, no_default, may, source::manual};
}

constexpr register_table<5> table{
    row_of(1, raw_type::unsigned_number, -1, unit::hertz, {0, 4000, source::manual}, drives::access::read_write),
    row_of(2, raw_type::signed_number, 0, unit::revolution_per_minute, no_limits_signed, drives::access::read_write),
    row_of(3, raw_type::bits, 0, unit::none, no_limits_unsigned, drives::access::read_only),
    row_of(4, raw_type::enumeration, 0, unit::none, {1, 2, source::manual}, drives::access::read_write),
    row_of(5, raw_type::unsigned_number, 0, unit::none, {0, 247, source::manual}, drives::access::read_write),
};

using read_function = modbus::read_holding_registers;
constexpr holding_register<table, 1, read_function>         frequency{};
constexpr holding_register<table, 2, read_function>         speed{};
constexpr holding_register<table, 3, read_function, lamps>  status{};
constexpr holding_register<table, 4, read_function, colour> shade{};
constexpr holding_register<table, 5, read_function>         number{};

TEST(holding_register, asks_for_one_register)
{
    constexpr auto asked = frequency.read();
    VERIFY(asked.range.first() == 1 and asked.range.count() == 1);
}

TEST(holding_register, writes_constants_exactly)
{
    constexpr auto written = frequency.write(41.2_Hz);
    VERIFY(written.address == 1 and written.value == 412);
    VERIFY(frequency.write(0.4_kHz).value == 4000);
    VERIFY(speed.write(-1500_rpm).value == 0xFA24);
    VERIFY(shade.write(colour::green).value == 2);
    VERIFY(number.write(247).value == 247);
}

TEST(holding_register, says_at_run_time_why_it_does_not_write)
{
    VERIFY(frequency.make_write(41.2_Hz)->value == 412);
    VERIFY(frequency.make_write(41.25_Hz).error() == error{errc::inexact, 0});
    VERIFY(frequency.make_write(400.1_Hz).error() == error{errc::out_of_range, 0});
    VERIFY(frequency.make_write(-0.1_Hz).error() == error{errc::out_of_range, 0});
    VERIFY(speed.make_write(32768_rpm).error() == error{errc::out_of_range, 0});
    VERIFY(shade.make_write(colour{3}).error() == error{errc::out_of_range, 0});
    VERIFY(number.make_write(248).error() == error{errc::out_of_range, 0});
    VERIFY(number.make_write(65536 + 1).error() == error{errc::out_of_range, 0});
    VERIFY(status.make_write(lamps::of(lamps::red)).error() == error{errc::read_only, 0});
}

TEST(holding_register, gives_back_what_it_was_given_for_all_65536_words)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const word = static_cast<std::uint16_t>(raw);
        ASSERT_EQ(frequency.value(word).scaled_to(-1), result<std::int32_t>{static_cast<std::int32_t>(raw)});
        ASSERT_EQ(*speed.raw(speed.value(word)), raw);
        ASSERT_EQ(*status.raw(status.value(word)), raw);
        ASSERT_EQ(static_cast<unsigned>(shade.value(word)), raw);  // an unknown code survives
        ASSERT_EQ(number.value(word), static_cast<std::int32_t>(raw));
    }
}

TEST(holding_register, takes_another_scale)
{
    constexpr auto tenfold = frequency.with_exponent<0>;
    VERIFY(tenfold.write(41_Hz).value == 41 and tenfold.value(41) == 41_Hz and tenfold.address() == 1);
    VERIFY(tenfold.make_write(41.2_Hz).error().code() == errc::inexact);
}

}  // namespace
