// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/word.hpp>

namespace drivecodec::cia402 {

/// Statusword, object 6041h: what the drive says of itself. IEC 61800-7-201, "Statusword".
///
/// Names say what a 1 means. The state is in bits 0 to 3, 5 and 6: see `decode_state`. Bits 10, 12 and 13 mean
/// something in each mode of operation: see mode_specific.hpp.
struct status_word : word<status_word, std::uint16_t> {
    static constexpr flag<status_word> ready_to_switch_on{0};
    static constexpr flag<status_word> switched_on{1};
    static constexpr flag<status_word> operation_enabled{2};
    static constexpr flag<status_word> fault{3};
    static constexpr flag<status_word> voltage_enabled{4};  ///< The power stage is supplied.
    static constexpr flag<status_word> no_quick_stop{5};
    static constexpr flag<status_word> switch_on_disabled{6};
    static constexpr flag<status_word> warning{7};
    static constexpr flag<status_word> manufacturer_specific_8{8};
    static constexpr flag<status_word> remote{9};  ///< The control word is obeyed; 0: the drive is operated locally.
    static constexpr flag<status_word> target_reached{10};
    static constexpr flag<status_word> internal_limit_active{11};
    static constexpr flag<status_word> mode_specific_12{12};
    static constexpr flag<status_word> mode_specific_13{13};
    static constexpr flag<status_word> manufacturer_specific_14{14};
    static constexpr flag<status_word> manufacturer_specific_15{15};
};

}  // namespace drivecodec::cia402
