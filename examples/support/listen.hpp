// SPDX-License-Identifier: MIT
#pragma once

#include "ear.hpp"
#include "line_options.hpp"

#include <functional>

// A live line that nothing is written to.

namespace support {

/// From now on SIGINT and SIGTERM end what reads, and nothing else.
void stop_on_signals();

[[nodiscard]] bool is_stopped();

/// Now, by a clock that does not run backwards and began with the time of day: microseconds since 1970.
[[nodiscard]] timestamp time_now();

/// Listens to the device, or pseudo-terminal, until `is_stopped()` or it is gone. `each_turn` is called after all that
/// was heard, and at least five times a second. Throws a usage_error if the device cannot be opened.
void listen(line_options const& line, std::uint32_t usual_baud, ear& to, std::function<void()> const& each_turn);

}  // namespace support
