// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/registers.hpp>

// Who may write what. smd manual, sections 4.5, 4.6, 5.2, 5.7 and 5.8. Reading is always allowed.

namespace drivecodec::smd {

enum class lock_state : std::uint8_t {
    locked,      ///< Nothing but what unlocks.
    control,     ///< Also registers 1 and 40.
    parameters,  ///< Also every register but 1; of register 1, the lock.
    both,
};

/// The drive's side: what is unlocked, for simulators, and for whoever wants to know what a write will do.
///
/// What the manual leaves open, and what is done here:
/// - Unlocking never takes away: 0 to register 48 leaves parameters writable that were.
/// - A wrong password changes nothing, and is refused as a write to a locked drive is.
/// - What register 48 unlocked, control and parameters, ends when C01 is set to another value than 10 or 11. What register
///   49 unlocked goes on then, and may be unlocked at any C01.
/// - Writing the lock to a drive that is locked is refused, as every other write is.
/// - Register 40 needs no more than control, by sections 4.5, 4.8 and 7.2; section 5.6 has "only after enabling parameter
///   writes".
class locks {
public:
    /// Of a drive that has just got power. C01, and C94: 0 from the factory, where 0 then unlocks everything.
    constexpr locks(control_mode mode, std::uint16_t password) noexcept : mode_{mode}, password_{password} {}

    [[nodiscard]] constexpr lock_state state() const noexcept
    {
        auto const has_parameters = parameters_by_48_ or parameters_by_49_;
        if (control_) { return has_parameters ? lock_state::both : lock_state::control; }
        return has_parameters ? lock_state::parameters : lock_state::locked;
    }

    /// Does the lock let this write pass? If not, the drive answers exception 01. Whether the register is there, is
    /// writable at all and takes the value is another question: that of `map`, and for register 1 of `executed_command`.
    [[nodiscard]] constexpr bool may_write(std::uint16_t address, std::uint16_t value) const noexcept
    {
        auto const present = state();
        switch (address) {
        case drive_control.address():
            return control_ or (present == lock_state::parameters and value == control_word(command::lock));
        case serial_speed_command.address(): return present != lock_state::locked;
        case unlock_commands.address(): return modbus_controls(mode_) and (value == 0 or value == password_);
        case unlock_parameters.address(): return value == password_;
        default: return present == lock_state::parameters or present == lock_state::both;
        }
    }

    /// The drive has received this write. As `may_write`; what passes also locks and unlocks. C01 and C94, whose
    /// registers depend on the version, are for the caller to set.
    constexpr bool write(std::uint16_t address, std::uint16_t value) noexcept
    {
        if (not may_write(address, value)) { return false; }
        switch (address) {
        case drive_control.address():
            if (value == control_word(command::lock)) { lock(); }
            break;
        case unlock_commands.address():
            control_ = true;
            if (value == password_) { parameters_by_48_ = true; }
            break;
        case unlock_parameters.address(): parameters_by_49_ = true; break;
        default: break;
        }
        return true;
    }

    /// C01 has been set, over the bus or at the drive.
    constexpr void set_control_mode(control_mode mode) noexcept
    {
        mode_ = mode;
        if (not modbus_controls(mode)) { control_ = parameters_by_48_ = false; }
    }
    /// C94 has been set. Asked for at the next unlocking only.
    constexpr void set_password(std::uint16_t password) noexcept { password_ = password; }

    /// Nothing is unlocked any more: power down, a serial time-out. Whether the drive goes on: `reaction_to_time_out`.
    constexpr void lock() noexcept { control_ = parameters_by_48_ = parameters_by_49_ = false; }

    friend constexpr bool operator==(locks const&, locks const&) noexcept = default;

private:
    control_mode  mode_;
    std::uint16_t password_;
    bool          control_          = false;
    bool          parameters_by_48_ = false;
    bool          parameters_by_49_ = false;
};

}  // namespace drivecodec::smd
