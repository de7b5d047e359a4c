// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/word.hpp>
#include <drivecodec/drives/vlt6000/selection.hpp>

namespace drivecodec::vlt6000 {

/// PCD1 from master to slave, and parameter 530: what the drive is told. VLT 6000 manual, "Control word as per FC
/// protocol".
///
/// Names say what a 1 does; five bits command something at 0, so the word 0 with valid data brakes, coasts and stops.
/// What comes of bits 0 to 3, 6 and 13 to 15 depends on the terminals, too: see gating.hpp.
struct control_word : word<control_word, std::uint16_t> {
    /// Bits 0 (lsb) and 1 (msb); gated by parameter 508.
    static constexpr field<control_word, vlt6000::preset_reference, 0, 2> preset_reference{};
    /// 0: DC braking and stop, by parameters 114 and 115. 1: none. Gated by parameter 504.
    static constexpr flag<control_word> no_dc_brake{2};
    /// 0: coasting stop, the transistors are off at once. 1: the motor may start. Gated by parameter 503.
    static constexpr flag<control_word> no_coasting_stop{3};
    /// 0: quick stop, a ramp down by parameter 207, which is also that of the ramp stop. 1: none.
    static constexpr flag<control_word> no_quick_stop{4};
    /// 0: the output frequency is frozen; only speed up and speed down of the digital inputs change it, and bit 6 does
    /// not stop it. 1: it is not frozen.
    static constexpr flag<control_word> no_freeze_output{5};
    /// 0: ramp stop, by parameter 207. 1: start, if nothing else prevents it. Gated by parameter 505.
    ///
    /// The manual's text on ramp stop says "Bit 04"; it stands under bit 06.
    static constexpr flag<control_word> start{6};
    /// 0: no reset. The change from 0 to 1 resets a trip.
    static constexpr flag<control_word> reset{7};
    /// 0: no jog. 1: the output frequency is that of parameter 209.
    static constexpr flag<control_word> jog{8};
    static constexpr flag<control_word> no_function_9{9};  ///< No function at 0 nor at 1.
    /// 0: the whole control word is ignored, as for a telegram that is only about a parameter. 1: it is used.
    static constexpr flag<control_word> data_valid{10};
    /// 0: relay 1 is not activated. 1: it is, if parameter 323 is control word bits 11/12.
    ///
    /// Both relays drop when no telegram comes for the bus time interval of parameter 555.
    static constexpr flag<control_word> relay_1{11};
    /// 0: relay 2 is not activated. 1: it is, if parameter 326 is control word bits 11/12.
    static constexpr flag<control_word> relay_2{12};
    /// Bits 13 (lsb) and 14 (msb); gated by parameter 507. Needs multi-setup in parameter 004.
    static constexpr field<control_word, vlt6000::setup, 13, 2> setup{};
    /// 0: no reversing. 1: reversing. Gated by parameter 506, by which a drive from the factory ignores this bit.
    static constexpr flag<control_word> reversing{15};
};

}  // namespace drivecodec::vlt6000
