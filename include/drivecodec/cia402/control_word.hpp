// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/word.hpp>

namespace drivecodec::cia402 {

/// Controlword, object 6040h: what the drive is told. IEC 61800-7-201, "Controlword".
///
/// Names say what a 1 does. Bits 0 to 3 and 7 are set by `apply` of command.hpp, which keeps all others. Bits 4 to 6
/// and 9 mean something in each mode of operation: see mode_specific.hpp.
struct control_word : word<control_word, std::uint16_t> {
    static constexpr flag<control_word> switch_on{0};
    static constexpr flag<control_word> enable_voltage{1};
    static constexpr flag<control_word> no_quick_stop{2};
    static constexpr flag<control_word> enable_operation{3};
    static constexpr flag<control_word> mode_specific_4{4};
    static constexpr flag<control_word> mode_specific_5{5};
    static constexpr flag<control_word> mode_specific_6{6};
    static constexpr flag<control_word> fault_reset{7};  ///< Acts when it changes from 0 to 1.
    static constexpr flag<control_word> halt{8};
    static constexpr flag<control_word> mode_specific_9{9};
    static constexpr flag<control_word> reserved_10{10};
    static constexpr flag<control_word> manufacturer_specific_11{11};
    static constexpr flag<control_word> manufacturer_specific_12{12};
    static constexpr flag<control_word> manufacturer_specific_13{13};
    static constexpr flag<control_word> manufacturer_specific_14{14};
    static constexpr flag<control_word> manufacturer_specific_15{15};
};

}  // namespace drivecodec::cia402
