// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/stream_item.hpp>

#include <string>

// What every stream reader gives beside frames, as JSON objects.

namespace support {

[[nodiscard]] std::string to_json(drivecodec::dropped_bytes const& run);
[[nodiscard]] std::string to_json(drivecodec::stream_counters const& counted);

}  // namespace support
