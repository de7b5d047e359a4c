// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/exception.hpp>

namespace drivecodec::smd {

/// What the exception codes of Modbus mean to this drive, which uses some for other things than Modbus does. smd manual,
/// section 2.3, E.
enum class exception : std::uint8_t {
    command_rejected  = 1,  ///< "Illegal function", and every write to what is locked.
    no_such_register  = 2,
    data_out_of_range = 3,
    wrong_data_format = 4,  ///< Also several bits in register 1, without that of stop.
    slave_device_busy = 6,
};

[[nodiscard]] constexpr exception to_exception(modbus::exception_code code) noexcept
{
    return static_cast<exception>(code);
}

}  // namespace drivecodec::smd
