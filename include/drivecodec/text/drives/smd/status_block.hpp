// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/status_block.hpp>
#include <drivecodec/text/drives/code.hpp>
#include <drivecodec/text/drives/smd/fault.hpp>
#include <drivecodec/text/drives/smd/names.hpp>
#include <drivecodec/text/quantity.hpp>

namespace drivecodec::smd {

/// `100 %, run`
constexpr void write_text(text_writer& out, load_and_status word) noexcept
{
    write_text(out, word.load());
    drives::write_code(out.put(", "), word.get(load_and_status::operational_status));
}

/// `forward, c40_modbus`
constexpr void write_text(text_writer& out, direction_and_mode word) noexcept
{
    drives::write_code(out, word.get(direction_and_mode::actual_direction));
    drives::write_code(out.put(", "), word.get(direction_and_mode::control_mode));
}

/// `speed_source serial, speed_reference serial`
constexpr void write_text(text_writer& out, source_and_reference word) noexcept
{
    drives::write_code(out.put("speed_source "), word.get(source_and_reference::speed_source));
    drives::write_code(out.put(", speed_reference "), word.get(source_and_reference::speed_reference));
}

/// `no_fault, forward`
constexpr void write_text(text_writer& out, fault_and_direction word) noexcept
{
    write_text(out, word.get(fault_and_direction::fault));
    drives::write_code(out.put(", "), word.get(fault_and_direction::commanded_direction));
}

/// What it does, then what it was told, then by whom:
/// `run 41.2 Hz forward, command 50.0 Hz reverse, load 64 %, no_fault, speed_source serial, speed_reference serial,
/// control_mode c40_modbus`, in one line. Codes without a name are numbers.
constexpr void write_text(text_writer& out, status_block const& status) noexcept
{
    drives::write_code(out, status.operational_status);
    write_text(out.put(' '), status.actual_speed);
    drives::write_code(out.put(' '), status.actual_direction);
    write_text(out.put(", command "), status.command_speed);
    drives::write_code(out.put(' '), status.commanded_direction);
    write_text(out.put(", load "), status.load);
    write_text(out.put(", "), status.fault);
    drives::write_code(out.put(", speed_source "), status.speed_source);
    drives::write_code(out.put(", speed_reference "), status.speed_reference);
    drives::write_code(out.put(", control_mode "), status.control_mode);
}

}  // namespace drivecodec::smd
