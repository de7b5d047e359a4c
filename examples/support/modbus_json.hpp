// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/rtu/framing.hpp>

#include <string>

namespace support {

/// A frame as a JSON object, all fields of its function at the top level under their names in the specification.
///
/// Lists are arrays; numbers are as on the wire. What has a name besides its number has it in a key of its own: the
/// field's with `_name` behind it, and `name` for the `id` of a device object. With the PDU of the `request` heard
/// before, a response has as many coils as that asked for.
[[nodiscard]] std::string to_json(drivecodec::modbus::rtu::frame const& found, drivecodec::bytes request = {});

}  // namespace support
