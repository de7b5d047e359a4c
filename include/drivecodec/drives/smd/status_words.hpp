// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/quantity.hpp>
#include <drivecodec/core/word.hpp>
#include <drivecodec/drives/direction.hpp>
#include <drivecodec/drives/smd/control_mode.hpp>
#include <drivecodec/drives/smd/fault.hpp>
#include <drivecodec/drives/smd/operational_status.hpp>
#include <drivecodec/drives/smd/speed_source.hpp>

// Registers 26 to 29: two bytes in a word, which mean two things. smd manual, table 6 and sections 5.4.2 to 5.4.8.

namespace drivecodec::smd {

using drives::direction;

/// Register 26: load, operational status.
struct load_and_status : word<load_and_status, std::uint16_t> {
    static constexpr field<load_and_status, std::uint8_t, 8, 8>            load_byte{};
    static constexpr field<load_and_status, smd::operational_status, 0, 8> operational_status{};

    /// Of full load; 0 to 255 %.
    [[nodiscard]] constexpr quantity<unit::percent> load() const noexcept { return {get(load_byte), 0}; }
};

/// Register 27: actual rotational direction, control mode.
struct direction_and_mode : word<direction_and_mode, std::uint16_t> {
    static constexpr field<direction_and_mode, smd::direction, 8, 8>    actual_direction{};
    static constexpr field<direction_and_mode, smd::control_mode, 0, 8> control_mode{};
};

/// Register 28: speed command source, speed reference status.
struct source_and_reference : word<source_and_reference, std::uint16_t> {
    static constexpr field<source_and_reference, smd::speed_source, 8, 8>    speed_source{};
    static constexpr field<source_and_reference, smd::speed_reference, 0, 8> speed_reference{};
};

/// Register 29: present fault, commanded rotational direction.
struct fault_and_direction : word<fault_and_direction, std::uint16_t> {
    static constexpr field<fault_and_direction, smd::fault, 8, 8>     fault{};
    static constexpr field<fault_and_direction, smd::direction, 0, 8> commanded_direction{};
};

}  // namespace drivecodec::smd
