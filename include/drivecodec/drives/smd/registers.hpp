// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/holding_register.hpp>
#include <drivecodec/drives/smd/family.hpp>
#include <drivecodec/drives/smd/functions.hpp>
#include <drivecodec/drives/smd/hardware.hpp>

// The registers up to 50 by name, as table 6 of the manual names them: the same in both versions.
//
//     rtu::encode(5, smd::drive_control.write(smd::command::start))
//     rtu::encode(5, smd::serial_speed_command.write(41.2_Hz))
//     rtu::encode(5, smd::drive_status.read())

namespace drivecodec::smd {

template <std::uint16_t Address, typename Value = drives::number_in<table<pv507>, Address>>
using holding_register = drives::holding_register<table<pv507>, Address, read_holding_registers, Value>;

inline constexpr holding_register<1, command>   drive_control{};
inline constexpr holding_register<19, family>   drive_family{};
inline constexpr holding_register<21>           drive_size{};  ///< Always 0.
inline constexpr holding_register<22, hardware> drive_hardware{};

inline constexpr holding_register<24>                       command_speed{};
inline constexpr holding_register<25>                       actual_speed{};
inline constexpr holding_register<26, load_and_status>      load_and_operational_status{};
inline constexpr holding_register<27, direction_and_mode>   actual_direction_and_control_mode{};
inline constexpr holding_register<28, source_and_reference> speed_source_and_speed_reference{};
inline constexpr holding_register<29, fault_and_direction>  present_fault_and_commanded_direction{};

inline constexpr holding_register<30> motor_volts{};  ///< Percent of the nominal voltage of the drive.

/// In tenths of a hertz, without a sign: registers and commands of direction are apart. The manual also calls it keypad
/// speed. A constant is checked against 0 to 240.0 Hz, see `make_serial_speed`. The drive powers up with the speed that
/// was written last; how often it can be written, the manual does not say.
inline constexpr holding_register<40> serial_speed_command{};

inline constexpr holding_register<48>                unlock_commands{};
inline constexpr holding_register<49>                unlock_parameters{};
inline constexpr holding_register<50, std::uint16_t> register_version{};  ///< For `make_version`.

/// Registers 24 to 29 at once.
struct drive_status_registers {
    using value_type = status_block;

    [[nodiscard]] static constexpr std::uint16_t address() noexcept { return status_block::address; }

    [[nodiscard]] static consteval read_holding_registers::request read()
    {
        return {.range = {status_block::address, status_block::word_count}};
    }

    /// Errors: those of `status_block::decode`.
    [[nodiscard]] static constexpr result<status_block> value(modbus::register_view words) noexcept
    {
        return status_block::decode(words);
    }
};
inline constexpr drive_status_registers drive_status{};

/// A speed between what C10 and C11 are set to, as register 40 takes it. Errors, at 0: `inexact`, `out_of_range`.
[[nodiscard]] constexpr result<write_single_register::request>
make_serial_speed(quantity<unit::hertz> wanted, quantity<unit::hertz> minimum, quantity<unit::hertz> maximum) noexcept
{
    if (wanted < minimum or wanted > maximum) { return error{errc::out_of_range, 0}; }
    return serial_speed_command.make_write(wanted);
}

}  // namespace drivecodec::smd
