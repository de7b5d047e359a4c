// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/exception.hpp>

#include <string_view>

namespace drivecodec::modbus {

/// Empty for a code that the specification does not name.
[[nodiscard]] constexpr std::string_view to_string(exception_code code) noexcept
{
    switch (code) {
    case exception_code::illegal_function: return "illegal_function";
    case exception_code::illegal_data_address: return "illegal_data_address";
    case exception_code::illegal_data_value: return "illegal_data_value";
    case exception_code::server_device_failure: return "server_device_failure";
    case exception_code::acknowledge: return "acknowledge";
    case exception_code::server_device_busy: return "server_device_busy";
    case exception_code::memory_parity_error: return "memory_parity_error";
    case exception_code::gateway_path_unavailable: return "gateway_path_unavailable";
    case exception_code::gateway_target_device_failed_to_respond: return "gateway_target_device_failed_to_respond";
    }
    return {};
}

}  // namespace drivecodec::modbus
