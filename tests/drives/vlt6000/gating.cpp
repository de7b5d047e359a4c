#include <drivecodec/drives/vlt6000/control_word.hpp>
#include <drivecodec/drives/vlt6000/gating.hpp>

#include "support/verify.hpp"

#include <array>

namespace {

using namespace drivecodec::vlt6000;
using drivecodec::errc;

constexpr std::array all_gatings{gating::digital_input, gating::serial_communication, gating::logic_and,
                                 gating::logic_or};

//=== the choices ===//

// VLT 6000 manual, parameters 503 to 508: the values in brackets.
static_assert(gating{0} == gating::digital_input and gating{1} == gating::serial_communication);
static_assert(gating{2} == gating::logic_and and gating{3} == gating::logic_or);

TEST(vlt6000_gating, has_the_factory_settings_of_the_manual)
{
    VERIFY(gating_settings{}.coasting_stop == gating::logic_or);
    VERIFY(gating_settings{}.dc_brake == gating::logic_or);
    VERIFY(gating_settings{}.start == gating::logic_or);
    VERIFY(gating_settings{}.reversing == gating::digital_input);
    VERIFY(gating_settings{}.setup == gating::logic_or);
    VERIFY(gating_settings{}.preset_reference == gating::logic_or);
    VERIFY(gating_settings{} == gating_settings{} and gating_settings{} != gating_settings{.start = gating::logic_and});
}

TEST(vlt6000_gating, is_one_of_four_and_any_other_number_is_refused)
{
    VERIFY(*make_gating(0) == gating::digital_input and *make_gating(3) == gating::logic_or);
    for (unsigned number = 0; number <= 0xFFFF; ++number) {
        auto const made = make_gating(static_cast<std::uint16_t>(number));
        ASSERT_EQ(made.has_value(), number < 4);
        if (made) {
            ASSERT_EQ(static_cast<unsigned>(*made), number);
        } else {
            ASSERT_EQ(made.error().code(), errc::bad_value);
            ASSERT_EQ(made.error().offset(), 0);
        }
    }
}

//=== 503 to 506: the manual's rows, by terminal and serial communication ===//

struct row {
    bool terminal;
    bool bus;
    bool function;
};
using table = std::array<row, 4>;

constexpr bool holds(gating how, table const& rows, bool (*function)(gating, sources<bool>) noexcept)
{
    for (auto const& each : rows) {
        if (function(how, {.terminal = each.terminal, .bus = each.bus}) != each.function) { return false; }
    }
    return true;
}

// The function column of 503: "Coasting" or "Motor run."; of 504: "DC-brake" or "Motor run.".
constexpr bool coasting   = true;
constexpr bool dc_brake   = true;
constexpr bool motor_runs = false;

TEST(vlt6000_gating, of_the_coasting_stop_is_that_of_the_manual_s_tables)
{
    VERIFY(holds(gating::digital_input,
                 table{{{0, 0, coasting}, {0, 1, coasting}, {1, 0, motor_runs}, {1, 1, motor_runs}}}, is_coasting));
    VERIFY(holds(gating::serial_communication,
                 table{{{0, 0, coasting}, {0, 1, motor_runs}, {1, 0, coasting}, {1, 1, motor_runs}}}, is_coasting));
    VERIFY(holds(gating::logic_and,
                 table{{{0, 0, coasting}, {0, 1, motor_runs}, {1, 0, motor_runs}, {1, 1, motor_runs}}}, is_coasting));
    VERIFY(holds(gating::logic_or, table{{{0, 0, coasting}, {0, 1, coasting}, {1, 0, coasting}, {1, 1, motor_runs}}},
                 is_coasting));
}

TEST(vlt6000_gating, of_the_dc_brake_is_that_of_the_manual_s_tables)
{
    VERIFY(holds(gating::digital_input,
                 table{{{0, 0, dc_brake}, {0, 1, dc_brake}, {1, 0, motor_runs}, {1, 1, motor_runs}}}, is_dc_braking));
    VERIFY(holds(gating::serial_communication,
                 table{{{0, 0, dc_brake}, {0, 1, motor_runs}, {1, 0, dc_brake}, {1, 1, motor_runs}}}, is_dc_braking));
    VERIFY(holds(gating::logic_and,
                 table{{{0, 0, dc_brake}, {0, 1, motor_runs}, {1, 0, motor_runs}, {1, 1, motor_runs}}}, is_dc_braking));
    VERIFY(holds(gating::logic_or, table{{{0, 0, dc_brake}, {0, 1, dc_brake}, {1, 0, dc_brake}, {1, 1, motor_runs}}},
                 is_dc_braking));
}

constexpr bool start = true;
constexpr bool stop  = false;

TEST(vlt6000_gating, of_start_is_that_of_the_manual_s_tables)
{
    VERIFY(holds(gating::digital_input, table{{{0, 0, stop}, {0, 1, stop}, {1, 0, start}, {1, 1, start}}}, is_started));
    VERIFY(holds(gating::serial_communication, table{{{0, 0, stop}, {0, 1, start}, {1, 0, stop}, {1, 1, start}}},
                 is_started));
    VERIFY(holds(gating::logic_and, table{{{0, 0, stop}, {0, 1, stop}, {1, 0, stop}, {1, 1, start}}}, is_started));
    VERIFY(holds(gating::logic_or, table{{{0, 0, stop}, {0, 1, start}, {1, 0, start}, {1, 1, start}}}, is_started));
}

constexpr bool clockwise      = false;
constexpr bool anti_clockwise = true;

TEST(vlt6000_gating, of_reversing_is_that_of_the_manual_s_tables)
{
    VERIFY(holds(gating::digital_input,
                 table{{{0, 0, clockwise}, {0, 1, clockwise}, {1, 0, anti_clockwise}, {1, 1, anti_clockwise}}},
                 is_anti_clockwise));
    // serial_communication: the next test
    VERIFY(holds(gating::logic_and,
                 table{{{0, 0, clockwise}, {0, 1, clockwise}, {1, 0, clockwise}, {1, 1, anti_clockwise}}},
                 is_anti_clockwise));
    VERIFY(holds(gating::logic_or,
                 table{{{0, 0, clockwise}, {0, 1, anti_clockwise}, {1, 0, anti_clockwise}, {1, 1, anti_clockwise}}},
                 is_anti_clockwise));
}

TEST(vlt6000_manual, prints_clockwise_where_serial_communication_alone_reverses)
{
    constexpr table printed{{{0, 0, clockwise}, {0, 1, clockwise}, {1, 0, clockwise}, {1, 1, anti_clockwise}}};
    constexpr table mended{{{0, 0, clockwise}, {0, 1, anti_clockwise}, {1, 0, clockwise}, {1, 1, anti_clockwise}}};
    VERIFY(holds(gating::serial_communication, mended, is_anti_clockwise));
    VERIFY(not holds(gating::serial_communication, printed, is_anti_clockwise));

    // As printed, it would be another choice; and as start, the function of the same shape, it is only when mended.
    VERIFY(holds(gating::logic_and, printed, is_anti_clockwise));
    VERIFY(holds(gating::serial_communication, mended, is_started));
}

TEST(vlt6000_manual, says_bit_03_of_the_dc_brake_where_it_means_bit_02)
{
    constexpr auto brakes = control_word::from_raw(0x047B);  // bit 02 at 0
    constexpr auto coasts = control_word::from_raw(0x0477);  // bit 03 at 0
    VERIFY(is_dc_braking(gating::logic_or, {.terminal = true, .bus = brakes.test(control_word::no_dc_brake)}));
    VERIFY(not is_dc_braking(gating::logic_or, {.terminal = true, .bus = coasts.test(control_word::no_dc_brake)}));
    VERIFY(not is_coasting(gating::logic_or, {.terminal = true, .bus = brakes.test(control_word::no_coasting_stop)}));
    VERIFY(is_coasting(gating::logic_or, {.terminal = true, .bus = coasts.test(control_word::no_coasting_stop)}));
}

TEST(vlt6000_gating, hears_only_the_source_that_it_names)
{
    for (bool const level : {false, true}) {
        for (bool const other : {false, true}) {
            EXPECT_EQ(is_coasting(gating::digital_input, {.terminal = level, .bus = other}), not level);
            EXPECT_EQ(is_coasting(gating::serial_communication, {.terminal = other, .bus = level}), not level);
            EXPECT_EQ(is_dc_braking(gating::digital_input, {.terminal = level, .bus = other}), not level);
            EXPECT_EQ(is_dc_braking(gating::serial_communication, {.terminal = other, .bus = level}), not level);
            EXPECT_EQ(is_started(gating::digital_input, {.terminal = level, .bus = other}), level);
            EXPECT_EQ(is_started(gating::serial_communication, {.terminal = other, .bus = level}), level);
            EXPECT_EQ(is_anti_clockwise(gating::digital_input, {.terminal = level, .bus = other}), level);
            EXPECT_EQ(is_anti_clockwise(gating::serial_communication, {.terminal = other, .bus = level}), level);
        }
    }
}

TEST(vlt6000_gating, agrees_where_both_sources_do)
{
    for (auto const how : all_gatings) {
        for (bool const level : {false, true}) {
            EXPECT_EQ(is_coasting(how, {.terminal = level, .bus = level}), not level);
            EXPECT_EQ(is_dc_braking(how, {.terminal = level, .bus = level}), not level);
            EXPECT_EQ(is_started(how, {.terminal = level, .bus = level}), level);
            EXPECT_EQ(is_anti_clockwise(how, {.terminal = level, .bus = level}), level);
        }
    }
}

//=== 507 and 508: the manual's rows, by bus msb, bus lsb, input msb, input lsb; it prints 16 numbers a choice ===//

struct numbers {
    gating                       how;
    std::array<std::uint8_t, 16> by_row;
};

// clang-format off
constexpr std::array<numbers, 4> printed_numbers{{
    //                            bus 0 0,     bus 0 1,     bus 1 0,     bus 1 1; each with inputs 0 0, 0 1, 1 0, 1 1
    {gating::digital_input,        {1, 2, 3, 4,  1, 2, 3, 4,  1, 2, 3, 4,  1, 2, 3, 4}},
    {gating::serial_communication, {1, 1, 1, 1,  2, 2, 2, 2,  3, 3, 3, 3,  4, 4, 4, 4}},
    {gating::logic_and,            {1, 1, 1, 1,  1, 2, 1, 2,  1, 1, 3, 3,  1, 2, 3, 4}},
    {gating::logic_or,             {1, 2, 3, 4,  2, 2, 4, 4,  3, 4, 3, 4,  4, 4, 4, 4}},
}};
// clang-format on

template <typename Choice>
constexpr bool holds(Choice (*active)(gating, sources<Choice>) noexcept)
{
    for (auto const& printed : printed_numbers) {
        for (std::uint8_t row = 0; row < 16; ++row) {
            auto const bus    = static_cast<Choice>(row >> 2);
            auto const inputs = static_cast<Choice>(row & 3);
            if (number(active(printed.how, {.terminal = inputs, .bus = bus})) != printed.by_row[row]) { return false; }
        }
    }
    return true;
}

TEST(vlt6000_manual, has_the_tables_of_setup_and_preset_reference_before_their_headings)
{
    // The four tables of 16 rows are one set for both parameters.
    VERIFY(holds(active_setup));
    VERIFY(holds(active_preset_reference));
}

TEST(vlt6000_gating, of_a_choice_of_four_can_choose_more_than_either_source)
{
    VERIFY(active_setup(gating::logic_or, {.terminal = setup::setup_2, .bus = setup::setup_3}) == setup::setup_4);
    VERIFY(active_setup(gating::logic_and, {.terminal = setup::setup_2, .bus = setup::setup_3}) == setup::setup_1);
}

}  // namespace
