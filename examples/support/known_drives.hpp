// SPDX-License-Identifier: MIT
#pragma once

#include "arguments.hpp"
#include "fc_decoder.hpp"
#include "modbus_decoder.hpp"
#include "smd_traffic.hpp"
#include "vlt6000_traffic.hpp"
#include "xd1000_traffic.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

// The drives that a command line can name, and who explains their frames.

namespace support {

/// What explains the frames of one drive, and may remember what it heard. Empty where a drive has nothing to explain.
struct drive_explainer {
    modbus_explainer modbus{};
    fc_explainer     fc{};
};

struct known_drive {
    std::string_view name;
    std::string_view with_article;
    bool             has_modbus;
    bool             has_fc;
    drive_explainer (*make_explainer)();  ///< For one drive.
};

inline constexpr std::array<known_drive, 3> known_drives{{
    {.name         = "xd1000",
     .with_article = "an xd1000",
     .has_modbus   = true,
     .has_fc       = false,
     .make_explainer =
         [] {
             return drive_explainer{
                 .modbus = [traffic = xd1000_traffic{}](auto&&... frame) mutable { return traffic.explain(frame...); }};
         }},
    {.name           = "vlt6000",
     .with_article   = "a vlt6000",
     .has_modbus     = false,
     .has_fc         = true,
     .make_explainer = [] { return drive_explainer{.fc = explain_vlt6000}; }},
    {.name         = "smd",
     .with_article = "an smd",
     .has_modbus   = true,
     .has_fc       = false,
     .make_explainer =
         [] {
             return drive_explainer{
                 .modbus = [traffic = smd_traffic{}](auto&&... frame) mutable { return traffic.explain(frame...); }};
         }},
}};

/// Throws a usage_error that tells which there are.
[[nodiscard]] inline known_drive const& to_drive(std::string_view word)
{
    auto const* const found = std::ranges::find(known_drives, word, &known_drive::name);
    if (found != known_drives.end()) { return *found; }
    std::string names;
    for (auto const& drive : known_drives) { names.append(names.empty() ? "" : ", ").append(drive.name); }
    throw usage_error{"'" + std::string{word} + "' is no drive that is known here: " + names};
}

}  // namespace support
