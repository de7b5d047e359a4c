#include <drivecodec/drives/smd/speed_source.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::smd;

// smd manual, table 14.
static_assert(speed_source{0} == speed_source::analog);
static_assert(speed_source{1} == speed_source::preset_c40);
static_assert(speed_source{2} == speed_source::preset_1);
static_assert(speed_source{3} == speed_source::preset_2);
static_assert(speed_source{4} == speed_source::preset_3);
static_assert(speed_source{5} == speed_source::mop);
static_assert(speed_source{6} == speed_source::serial);

TEST(smd_speed_reference, is_0_serial_and_1_local)
{
    VERIFY(speed_reference{0} == speed_reference::serial and speed_reference{1} == speed_reference::local);
}

}  // namespace
