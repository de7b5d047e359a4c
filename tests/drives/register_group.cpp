#include <drivecodec/drives/xd1000/registers.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::literals;
using namespace drivecodec::xd1000;

using ramps = registers<high_speed, low_speed>;

TEST(register_group, reads_its_registers_with_one_request)
{
    constexpr auto asked = ramps::read();
    VERIFY(asked.range.first() == 3104 and asked.range.count() == 2);
}

TEST(register_group, tells_the_value_of_each_in_a_response)
{
    static constexpr std::array<std::uint16_t, 2> words{500, 12};
    VERIFY(ramps::value(high_speed, words) == 50.0_Hz);
    VERIFY(ramps::value(low_speed, words) == 1.2_Hz);
}

TEST(register_group, writes_constants_and_run_time_values)
{
    constexpr auto written = ramps::write(50.0_Hz, 1.2_Hz);
    VERIFY(written.block.first() == 3104 and written.block.values()[0] == 500 and written.block.values()[1] == 12);
    VERIFY(*ramps::make_write(50.0_Hz, 1.2_Hz) == written);
    VERIFY(ramps::make_write(50.0_Hz, 1.25_Hz).error() == error{errc::inexact, 1});
    VERIFY(ramps::make_write(-1_Hz, 1.25_Hz).error() == error{errc::out_of_range, 0});
}

TEST(register_group, knows_the_place_of_each)
{
    VERIFY(drives::index_of<decltype(low_speed), high_speed, low_speed> == 1);
    VERIFY(drives::index_of<decltype(acc), high_speed, low_speed> == 2);
}

}  // namespace
