// SPDX-License-Identifier: MIT
#include "stream_json.hpp"

#include "hex.hpp"
#include "json.hpp"

#include <drivecodec/text/core.hpp>

namespace support {

std::string to_json(drivecodec::dropped_bytes const& run)
{
    json_object out;
    out.add("dropped", to_hex(run.raw));
    out.add("reason", to_string(run.reason));
    return out.text();
}

std::string to_json(drivecodec::stream_counters const& counted)
{
    json_object counters;
    counters.add("frames", counted.frames);
    counters.add("unaligned_frames", counted.unaligned_frames);
    counters.add("dropped_runs", counted.dropped_runs);
    counters.add("dropped_bytes", counted.dropped_bytes);
    counters.add("bad_checksums", counted.bad_checksums);
    counters.add("truncated", counted.truncated);
    json_object out;
    out.add_json("counters", counters.text());
    return out.text();
}

}  // namespace support
