// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/word.hpp>

namespace drivecodec::vlt6000 {

/// Parameter 532: what the drive is doing, in more detail than the status word. VLT 6000 manual, "Warning words 1+2 and
/// Alarm word".
///
/// The manual describes parameter 532 with the text of the warning word; its table has states.
struct extended_status_word : word<extended_status_word, std::uint32_t> {
    static constexpr flag<extended_status_word> overvoltage_control_active{0};
    static constexpr flag<extended_status_word> start_delay{1};
    static constexpr flag<extended_status_word> sleep_boost_active{2};
    static constexpr flag<extended_status_word> sleep_mode_active{3};
    static constexpr flag<extended_status_word> automatic_motor_adaptation_completed{4};
    static constexpr flag<extended_status_word> automatic_motor_adaptation_running{5};
    static constexpr flag<extended_status_word> reversing_and_start{6};
    static constexpr flag<extended_status_word> ramp_operation{7};
    static constexpr flag<extended_status_word> reversing{8};
    static constexpr flag<extended_status_word> speed_equals_reference{9};
    static constexpr flag<extended_status_word> running{10};
    /// 0: local reference. 1: remote controlled reference.
    static constexpr flag<extended_status_word> remote_controlled_reference{11};
    static constexpr flag<extended_status_word> off_mode{12};
    static constexpr flag<extended_status_word> hand_mode{13};  ///< 0: auto mode. 1: hand mode.
    static constexpr flag<extended_status_word> start_blocked{14};
    static constexpr flag<extended_status_word> start_blocked_signal_missing{15};
    static constexpr flag<extended_status_word> freeze_output{16};
    static constexpr flag<extended_status_word> freeze_output_blocked{17};
    static constexpr flag<extended_status_word> jogging{18};
    static constexpr flag<extended_status_word> jog_blocked{19};
    static constexpr flag<extended_status_word> stand_by{20};
    static constexpr flag<extended_status_word> stop{21};
    static constexpr flag<extended_status_word> dc_stop{22};
    /// The manual says "Drive ready" of bit 23 and of bit 25, and nothing of a difference.
    static constexpr flag<extended_status_word> drive_ready_23{23};
    static constexpr flag<extended_status_word> relay_123_active{24};
    static constexpr flag<extended_status_word> drive_ready_25{25};
    static constexpr flag<extended_status_word> control_ready{26};
    static constexpr flag<extended_status_word> start_prevented{27};
    static constexpr flag<extended_status_word> profibus_off3_active{28};
    static constexpr flag<extended_status_word> profibus_off2_active{29};
    static constexpr flag<extended_status_word> profibus_off1_active{30};
    static constexpr flag<extended_status_word> reserved_31{31};
};

}  // namespace drivecodec::vlt6000
