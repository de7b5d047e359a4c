// SPDX-License-Identifier: MIT
#pragma once

#include "bus_drives.hpp"
#include "bus_statistics.hpp"

#include <drivecodec/core/stream_item.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// Traffic and statistics of a line in columns.

namespace support {

struct bus_look {
    bool        has_colours = false;
    bool        is_absolute = false;  ///< Times of day, not since the begin.
    std::size_t width       = 120;    ///< Of a line, where possible.
};

/// `text` in lines of at most `width` characters, cut at blanks where there are any. One line at least.
[[nodiscard]] std::vector<std::string> wrap(std::string_view text, std::size_t width);

/// `12.346` for 12345678 microseconds, or with `is_absolute` `13:05:59.346`; the second where they are no time of day,
/// before September 2001, is `12.346` as well.
[[nodiscard]] std::string time_text(timestamp since_begin, timestamp absolute, bool is_absolute);

/// `+12.3 ms`, `+12.3 s` from ten seconds on.
[[nodiscard]] std::string response_text(std::uint64_t microseconds);

/// What is written of a line.
class bus_view {
public:
    bus_view(bus_look look, bus_drives const& drives) : look_{look}, drives_{drives} {}

    /// One item, with the newline at its end:
    ///
    ///           0.000     5 smd      ->              03 read_holding_registers  first=24 count=1
    ///           0.012     5 smd      <-    +12.3 ms  03 read_holding_registers  byte_count=2 registers=[412]
    ///
    /// The columns of times are there from the first time on that is known, `when`, and that of names if there are any.
    [[nodiscard]] std::string line(traffic_item const& item, bus_event const& event,
                                   std::optional<timestamp> when) const;

    /// A row for each address, one for bytes that are nobody's, and the sum.
    [[nodiscard]] std::string table(bus_statistics const& statistics) const;

    /// `14 frames of Modbus in 8.2 s, 3 dropped bytes`
    [[nodiscard]] std::string headline(drivecodec::stream_counters const& counted, std::string_view protocol) const;

    /// How long it took from the first time to the last.
    void pass(std::optional<timestamp> now);

private:
    [[nodiscard]] std::string painted(std::string_view text, std::string_view colour) const;

    bus_look                 look_;
    bus_drives const&        drives_;
    std::optional<timestamp> begin_;
    timestamp                last_ = 0;
};

}  // namespace support
