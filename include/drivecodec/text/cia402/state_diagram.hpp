// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/text/cia402/names.hpp>
#include <drivecodec/text/writer.hpp>

namespace drivecodec::cia402 {

/// The state machine as a Mermaid state diagram, an arrow for each row of `transitions`: its number and its cause.
///
/// A fault comes from six states; a seventh box, `any`, stands for them.
constexpr void write_state_diagram(text_writer& out) noexcept
{
    out.put("stateDiagram-v2\n");
    for (auto const& row : transitions) {
        auto from = std::string_view{row.from.empty() ? "[*]" : "any"};
        for (auto const& coding : state_codings) {
            if (row.from == state_set{coding.state}) { from = to_string(coding.state); }
        }
        out.put("    ").put(from).put(" --> ").put(to_string(row.to)).put(" : ").decimal(row.number).put(' ');
        out.put(to_string(row.cause));
        if (row.condition == quick_stop_condition::leaves) { out.put(" (605Ah 1 to 4)"); }
        if (row.condition == quick_stop_condition::stays) { out.put(" (605Ah 5 to 8)"); }
        out.put('\n');
    }
}

}  // namespace drivecodec::cia402
