// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/word.hpp>

namespace drivecodec::vlt6000 {

/// PCD1 from slave to master, and parameter 527: what the drive says of itself. VLT 6000 manual, "Status word as per FC
/// protocol". Names say what a 1 means.
struct status_word : word<status_word, std::uint16_t> {
    static constexpr flag<status_word> control_ready{0};  ///< 0: tripped. 1: ready for operation.
    /// 0: not said. 1: ready for operation. The manual adds "but terminal 27 is 0 and/or a coasting command has been
    /// received", yet its example of a running drive has a 1: so this bit does not tell that the drive coasts.
    static constexpr flag<status_word> drive_ready{1};
    /// 0: not said; also of a drive that runs. 1: a start command will start the motor.
    static constexpr flag<status_word> stand_by{2};
    static constexpr flag<status_word> tripped{3};  ///< 0: no trip. 1: tripped, operation needs a reset.
    static constexpr flag<status_word> not_used_4{4};
    static constexpr flag<status_word> not_used_5{5};
    static constexpr flag<status_word> not_used_6{6};
    static constexpr flag<status_word> warning{7};  ///< 0: no warning. 1: a warning has occurred.
    /// 0: the speed differs from the reference, as on a ramp. 1: it equals the reference. Of the 0 the manual says "the
    /// motor is running"; whether it is, only `running` tells.
    static constexpr flag<status_word> speed_equals_reference{8};
    /// 0: local operation, OFF/STOP or Hand: control words have no effect. 1: serial communication controls the drive.
    static constexpr flag<status_word> serial_control{9};
    /// 0: the output frequency has reached the limit of parameter 201 or 202. 1: it is within them.
    ///
    /// The manual's table says "Out of frequency range", and means the 0.
    static constexpr flag<status_word> within_frequency_range{10};
    /// 0: the motor is not running. 1: there is a start signal, or the output frequency is above 0 Hz.
    static constexpr flag<status_word> running{11};
    static constexpr flag<status_word> no_function_12{12};
    static constexpr flag<status_word> voltage_warning{13};  ///< 0: none. 1: the DC voltage is too low or too high.
    /// 0: the current is below parameter 215. 1: it is above, and the drive trips after the time of parameter 412.
    static constexpr flag<status_word> current_limit{14};
    /// 0: none. 1: the motor, the drive or a thermistor at an analogue input is beyond its temperature limit.
    static constexpr flag<status_word> thermal_warning{15};

    /// Is the drive in OFF/STOP or Hand, so that it obeys no control word?
    [[nodiscard]] constexpr bool is_local() const noexcept { return not test(serial_control); }
};

}  // namespace drivecodec::vlt6000
