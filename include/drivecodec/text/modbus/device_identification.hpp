// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/functions/read_device_identification.hpp>

#include <string_view>

// Empty for numbers that the specification does not name.

namespace drivecodec::modbus {

[[nodiscard]] constexpr std::string_view to_string(mei_type type) noexcept
{
    switch (type) {
    case mei_type::canopen_general_reference: return "canopen_general_reference";
    case mei_type::read_device_identification: return "read_device_identification";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(read_device_id_code code) noexcept
{
    switch (code) {
    case read_device_id_code::basic: return "basic";
    case read_device_id_code::regular: return "regular";
    case read_device_id_code::extended: return "extended";
    case read_device_id_code::specific: return "specific";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(device_conformity conformity) noexcept
{
    switch (conformity) {
    case device_conformity::basic_stream: return "basic_stream";
    case device_conformity::regular_stream: return "regular_stream";
    case device_conformity::extended_stream: return "extended_stream";
    case device_conformity::basic_and_specific: return "basic_and_specific";
    case device_conformity::regular_and_specific: return "regular_and_specific";
    case device_conformity::extended_and_specific: return "extended_and_specific";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(device_object_id id) noexcept
{
    switch (id) {
    case device_object_id::vendor_name: return "vendor_name";
    case device_object_id::product_code: return "product_code";
    case device_object_id::major_minor_revision: return "major_minor_revision";
    case device_object_id::vendor_url: return "vendor_url";
    case device_object_id::product_name: return "product_name";
    case device_object_id::model_name: return "model_name";
    case device_object_id::user_application_name: return "user_application_name";
    }
    return {};
}

}  // namespace drivecodec::modbus
