#include <drivecodec/drives/vlt6000/parameter.hpp>

#include <drivecodec/drives/vlt6000/parameters.hpp>
#include <drivecodec/fc/telegram.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;
using vlt6000::parameter;

constexpr auto none = fc::data_not_valid;

/// PKE IND PWEhigh PWElow of a request.
template <typename Request>
[[nodiscard]] constexpr bool has_block(Request const& given, std::uint16_t pke, std::uint16_t ind, std::uint32_t pwe)
{
    return given.pke.raw == pke and given.ind.raw == ind and given.pwe == pwe;
}

[[nodiscard]] constexpr fc::parameter_response response(std::uint16_t pke, std::uint32_t pwe)
{
    return {fc::pke::from_raw(pke), {}, pwe, {}};
}

//=== the worked examples of the manual ===//

TEST(parameter, example_read_615_index_1)
{
    VERIFY(has_block(parameter<615>.read(1, none), 0x1267, 0x0001, 0));
}

TEST(parameter, example_write_202_100_hz_to_eeprom)
{
    constexpr auto asked = parameter<202>.write(100_Hz, fc::storage::ram_and_eeprom, none);
    VERIFY(has_block(asked, 0xE0CA, 0, 0x03E8));
    // STX LGE ADR PKE IND PWE PCD1 PCD2 BCC: 02^0E^01 = 0D, ^E0^CA = 27, ^03^E8 = CC
    static constexpr auto telegram = "02 0E 01 E0 CA 00 00 00 00 03 E8 00 00 00 00 CC"_hex;
    VERIFY(fc::encode(fc::address::short_format(1), asked) == telegram);
    VERIFY(*parameter<202>.value(response(0x10CA, 0x03E8)) == 100_Hz);
}

TEST(parameter, example_read_206_ten_seconds_not_one)
{
    VERIFY(has_block(parameter<206>.read(none), 0x10CE, 0, 0));
    VERIFY(*parameter<206>.value(response(0x10CE, 0x000A)) == 10_s);
}

TEST(parameter, example_write_415_kilowatt_to_eeprom)
{
    constexpr auto kilowatt = vlt6000::process_unit::kilowatt;
    VERIFY(has_block(parameter<415>.write(kilowatt, fc::storage::ram_and_eeprom, none), 0xE19F, 0, 0x0014));
    VERIFY(*parameter<415>.value(response(0x119F, 0x0014)) == kilowatt);
}

TEST(parameter, example_201_is_transferred_in_tenths)
{
    constexpr auto low_limit = parameter<201>.as<fc::data_type::unsigned_16, -1>;
    VERIFY(low_limit.write(10_Hz, fc::storage::ram, none).pwe == 100);
    // What the manual states need not be said, and is not forgotten.
    VERIFY(parameter<201>.as<fc::data_type::unsigned_16>.write(10_Hz, fc::storage::ram, none).pwe == 100);
    VERIFY(*parameter<201>.value(response(0x10C9, 100)) == 10_Hz);
}

//=== the process data are the caller's, and may be known at run time only ===//

TEST(parameter, a_constant_value_goes_with_any_process_data)
{
    for (unsigned raw = 0; raw <= 0xFFFF; raw += 0x101) {
        auto const process = fc::data_valid(static_cast<std::uint16_t>(raw), 50_percent);
        EXPECT_EQ(parameter<202>.write(100_Hz, fc::storage::ram, process).process, process);
    }
}

TEST(parameter, storage_chooses_between_ram_and_eeprom)
{
    VERIFY(parameter<202>.write(1_Hz, fc::storage::ram, none).command() == fc::ak_command::write_word);
    VERIFY(parameter<202>.write(1_Hz, fc::storage::ram_and_eeprom, none).command()
           == fc::ak_command::write_word_to_eeprom);
    constexpr auto wide = parameter<207>.as<fc::data_type::unsigned_32, -2, unit::second>;
    VERIFY(wide.write(1_s, fc::storage::ram, none).command() == fc::ak_command::write_double_word);
    VERIFY(wide.write(1_s, fc::storage::ram_and_eeprom, none).command() == fc::ak_command::write_double_word_to_eeprom);
    VERIFY(wide.write(1_s, fc::storage::ram, none).pwe == 100);
}

//=== at run time ===//

TEST(parameter, run_time_values_are_refused_with_a_reason)
{
    auto const high_limit = parameter<202>;
    auto const write      = [&](quantity<unit::hertz> wanted) {
        return high_limit.make_write(wanted, fc::storage::ram, none);
    };
    EXPECT_EQ(write(opaque(100.0_Hz))->pwe, 1000U);
    EXPECT_EQ(write(opaque(50.05_Hz)).error(), (error{errc::inexact, 0}));
    EXPECT_EQ(write(opaque(3276.7_Hz))->pwe, 0x7FFFU);
    EXPECT_EQ(write(opaque(3276.8_Hz)).error(), (error{errc::out_of_range, 0}));
    EXPECT_EQ(write(opaque(-0.1_Hz)).error(), (error{errc::out_of_range, 0}));
}

TEST(parameter, the_bus_time_interval_has_its_limits)
{
    constexpr auto interval = parameter<555>.as<fc::data_type::unsigned_16, 0>;
    for (std::int32_t seconds = 0; seconds <= 65536; ++seconds) {
        auto const asked = interval.make_write({seconds, 0}, fc::storage::ram, none);
        ASSERT_EQ(asked.has_value(), seconds >= 1 and seconds <= 65534) << seconds;
    }
}

TEST(parameter, a_choice_must_be_one_that_the_manual_prints)
{
    constexpr auto start_gating = parameter<505>.as<fc::data_type::unsigned_8>;
    for (std::uint16_t code = 0; code < 300; ++code) {
        auto const asked = start_gating.make_write(static_cast<vlt6000::gating>(code), fc::storage::ram, none);
        EXPECT_EQ(asked.has_value(), code <= 3) << code;
    }
    // Of the process units the manual names one.
    EXPECT_TRUE(parameter<415>.make_write(static_cast<vlt6000::process_unit>(7), fc::storage::ram, none).has_value());
}

TEST(parameter, a_choice_of_more_than_16_bits_is_none_of_those_of_16)
{
    for (std::uint32_t code = 0; code <= 3; ++code) {
        EXPECT_EQ(*parameter<505>.value(response(0x21F9, code)), static_cast<vlt6000::gating>(code));
        for (unsigned bit = 16; bit < 32; ++bit) {
            auto const bits = response(0x21F9, std::uint32_t{1} << bit | code);
            EXPECT_EQ(parameter<505>.value(bits).error(), (error{errc::out_of_range, 0})) << bit;
            EXPECT_EQ(parameter<323>.value(response(0x2143, bits.pwe)).error(), (error{errc::out_of_range, 0})) << bit;
        }
    }
    constexpr auto with_sign = parameter<505>.as<fc::data_type::integer_16>;
    VERIFY(with_sign.value(response(0x11F9, 0xFFFF)).error() == error{errc::out_of_range, 0});
    VERIFY(*parameter<505>.as<fc::data_type::unsigned_16>.value(response(0x11F9, 0xFFFF))
           == static_cast<vlt6000::gating>(0xFFFF));
}

TEST(parameter, address_and_baud_rate_cannot_be_set_over_the_bus)
{
    EXPECT_EQ(parameter<501>.make_write(5, fc::storage::ram, none).error(), (error{errc::read_only, 0}));
    EXPECT_EQ(parameter<502>.make_write(vlt6000::baud_rate::baud_9600, fc::storage::ram, none).error(),
              (error{errc::read_only, 0}));
    VERIFY(has_block(parameter<501>.read(none), 0x11F5, 0, 0));
    VERIFY(*parameter<501>.value(response(0x11F5, 22)) == 22);
}

TEST(parameter, a_read_out_cannot_be_written)
{
    EXPECT_EQ(parameter<512>.make_write(5_Hz, fc::storage::ram, none).error(), (error{errc::read_only, 0}));
    VERIFY(*parameter<512>.as<fc::data_type::unsigned_32, -1>.value(response(0x2200, 412)) == 41.2_Hz);
}

TEST(parameter, units_with_a_prefix_keep_it)
{
    VERIFY(*parameter<515>.as<fc::data_type::unsigned_16, -2>.value(response(0x1203, 1100)) == 11_kW);
    VERIFY(*parameter<524>.as<fc::data_type::unsigned_16, -1>.value(response(0x120C, 200)) == 20.0_mA);
}

TEST(parameter, words_survive_bit_for_bit)
{
    for (std::uint32_t raw = 0; raw <= 0xFFFF; ++raw) {
        ASSERT_EQ(parameter<527>.value(response(0x120F, raw))->raw, raw);
    }
    for (unsigned bit = 0; bit < 32; ++bit) {
        auto const raw = std::uint32_t{1} << bit;
        EXPECT_EQ(parameter<529>.value(response(0x2211, raw))->raw, raw);
        EXPECT_EQ(parameter<531>.value(response(0x2213, raw))->raw, raw);
        EXPECT_EQ(parameter<532>.value(response(0x2214, raw))->raw, raw);
    }
}

//=== texts ===//

TEST(parameter, display_texts_are_written_and_the_name_plate_is_read)
{
    constexpr auto asked = parameter<533>.write("12345678", none);
    VERIFY(asked.pke.raw == 0xF215 and asked.ind.raw == 0x0500 and asked.characters.size() == 8);
    VERIFY(parameter<534>.write("12345678901234567890", none).characters.size() == 20);
    VERIFY(parameter<621>.read(none).pke.raw == 0xF26D and parameter<621>.read(none).ind.raw == 0x0400);
    VERIFY(parameter<631>.read(none).pke.raw == 0xF277);
}

TEST(parameter, texts_of_every_length_to_one_too_many)
{
    static constexpr std::array<std::uint8_t, 30> letters{};
    for (std::size_t size = 0; size <= letters.size(); ++size) {
        auto const text = bytes{letters}.first(size);
        EXPECT_EQ(parameter<533>.make_write(text, none).has_value(), size <= 8) << size;
        EXPECT_EQ(parameter<534>.make_write(text, none).has_value(), size <= 20) << size;
        EXPECT_EQ(parameter<621>.make_write(text, none).error(), (error{errc::read_only, 0}));
    }
}

}  // namespace
