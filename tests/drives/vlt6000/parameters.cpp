#include <drivecodec/drives/vlt6000/parameters.hpp>

#include "support/verify.hpp"

#include <concepts>
#include <utility>

namespace {

using namespace drivecodec;
using namespace drivecodec::vlt6000;

template <int Number, typename Value>
constexpr bool is_a = std::same_as<typename decltype(vlt6000::parameter<Number>)::value_type, Value>;

TEST(parameters, read_as_what_they_are)
{
    VERIFY(is_a<1, language> and is_a<7, large_display_read_out> and is_a<415, process_unit>);
    VERIFY(is_a<500, protocol> and is_a<501, std::int32_t> and is_a<502, baud_rate>);
    VERIFY(is_a<503, gating> and is_a<504, gating> and is_a<505, gating>);
    VERIFY(is_a<506, gating> and is_a<507, gating> and is_a<508, gating>);
    VERIFY(is_a<509, quantity<unit::percent>> and is_a<512, quantity<unit::hertz>>);
    VERIFY(is_a<514, quantity<unit::ampere>> and is_a<515, quantity<unit::watt>>);
    VERIFY(is_a<516, quantity<unit::horsepower>> and is_a<528, quantity<unit::degree_celsius>>);
    VERIFY(is_a<510, quantity<unit::none>> and is_a<511, quantity<unit::none>>);  // in the unit of 415
    VERIFY(is_a<521, digital_inputs> and is_a<527, status_word> and is_a<529, alarm_word>);
    VERIFY(is_a<530, control_word> and is_a<531, warning_word> and is_a<532, extended_status_word>);
    VERIFY(is_a<535, std::int32_t> and is_a<555, quantity<unit::second>>);
    VERIFY(is_a<556, bus_time_interval_function> and is_a<615, std::int32_t>);
}

TEST(parameters, the_name_plate_and_the_display_texts_are_texts)
{
    VERIFY(std::same_as<std::remove_cvref_t<decltype(vlt6000::parameter<533>)>, text_parameter<533>>);
    VERIFY(std::same_as<std::remove_cvref_t<decltype(vlt6000::parameter<621>)>, text_parameter<621>>);
    VERIFY(std::same_as<std::remove_cvref_t<decltype(vlt6000::parameter<631>)>, text_parameter<631>>);
}

template <std::size_t... Rows>
[[nodiscard]] consteval bool all_have_objects(std::index_sequence<Rows...>)
{
    return ((vlt6000::parameter<table[Rows].number>.number() == table[Rows].number) and ...);
}

TEST(parameters, every_row_of_the_table_has_an_object)
{
    VERIFY(all_have_objects(std::make_index_sequence<table.size()>{}));
}

TEST(parameters, names_are_those_of_the_table)
{
    VERIFY(find("output_frequency_high_limit")->number == parameters::output_frequency_high_limit.number());
    VERIFY(find("ramp_down_time")->number == parameters::ramp_down_time.number());
    VERIFY(find("bus_time_interval_function")->number == parameters::bus_time_interval_function.number());
    VERIFY(find("unit_type")->number == parameters::unit_type.number());
}

TEST(parameters, factory_settings_are_said_once)
{
    VERIFY(parameter<506>.row.factory_setting == stated<decimal>{decimal{0, 0}});
    VERIFY(parameter<505>.row.factory_setting == stated<decimal>{decimal{3, 0}});
    VERIFY(parameter<555>.row.factory_setting == stated<decimal>{decimal{1, 0}});
    VERIFY(parameter<556>.row.factory_setting == stated<decimal>{decimal{0, 0}});
}

}  // namespace
