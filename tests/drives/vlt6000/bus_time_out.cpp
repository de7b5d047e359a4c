#include <drivecodec/drives/vlt6000/bus_time_out.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::literals;
using namespace drivecodec::vlt6000;

// VLT 6000 manual, parameter 556: the values in brackets.
static_assert(bus_time_interval_function{0} == bus_time_interval_function::off);
static_assert(bus_time_interval_function{1} == bus_time_interval_function::freeze_output);
static_assert(bus_time_interval_function{2} == bus_time_interval_function::stop);
static_assert(bus_time_interval_function{3} == bus_time_interval_function::jogging);
static_assert(bus_time_interval_function{4} == bus_time_interval_function::max_output_frequency);
static_assert(bus_time_interval_function{5} == bus_time_interval_function::stop_and_trip);

TEST(vlt6000_bus_time_interval, is_1_to_65534_seconds_and_1_from_the_factory)
{
    VERIFY(shortest_bus_time_interval == 1_s);
    VERIFY(longest_bus_time_interval == 65'534_s);
    VERIFY(factory_bus_time_interval == 1_s);
}

TEST(vlt6000_manual, speaks_of_the_time_out_period_of_556_where_556_is_the_reaction_and_off)
{
    // The period is a time, of parameter 555; the reaction is a choice, and a drive from the factory has none.
    VERIFY(factory_bus_time_interval == 1_s);
    VERIFY(factory_bus_time_interval_function == bus_time_interval_function::off);
}

TEST(vlt6000_manual, describes_preset_reference_1_where_the_choice_of_556_is_jogging)
{
    VERIFY(static_cast<int>(bus_time_interval_function::jogging) == 3);
}

}  // namespace
