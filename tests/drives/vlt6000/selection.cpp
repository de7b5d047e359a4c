#include <drivecodec/drives/vlt6000/selection.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::vlt6000;

TEST(vlt6000_manual, numbers_preset_references_from_1_but_their_bits_from_0)
{
    // Table of bits 00/01: 1 is 0 0, 2 is 0 1, 3 is 1 0, 4 is 1 1.
    VERIFY(number(preset_reference{0}) == 1 and preset_reference{0} == preset_reference::preset_reference_1);
    VERIFY(number(preset_reference{1}) == 2 and preset_reference{1} == preset_reference::preset_reference_2);
    VERIFY(number(preset_reference{2}) == 3 and preset_reference{2} == preset_reference::preset_reference_3);
    VERIFY(number(preset_reference{3}) == 4 and preset_reference{3} == preset_reference::preset_reference_4);
}

TEST(vlt6000_manual, numbers_setups_from_1_but_their_bits_from_0)
{
    VERIFY(number(setup{0}) == 1 and setup{0} == setup::setup_1);
    VERIFY(number(setup{1}) == 2 and setup{1} == setup::setup_2);
    VERIFY(number(setup{2}) == 3 and setup{2} == setup::setup_3);
    VERIFY(number(setup{3}) == 4 and setup{3} == setup::setup_4);
}

}  // namespace
