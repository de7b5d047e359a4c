// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/framing.hpp>
#include <drivecodec/fc/text.hpp>
#include <drivecodec/text/fc.hpp>
#include <drivecodec/text/vlt6000.hpp>

#include <array>
#include <string>

// What the telegrams of a VLT 6000 HVAC mean.

namespace support {

/// Names the parameter of a telegram, and explains its value, its control or status word, and its frequency. Of a
/// telegram whose direction is unknown there is only the parameter to name.
[[nodiscard]] inline std::string explain_vlt6000(drivecodec::fc::frame const& found)
{
    namespace fc      = drivecodec::fc;
    namespace vlt6000 = drivecodec::vlt6000;

    std::array<char, 4096>  room;
    drivecodec::text_writer text{room};

    auto const separator = [&] { return text.needed() == 0 ? "" : "; "; };

    // The parameter, unless AK says that there is none, and its value if it brings one.
    auto const explain = [&](auto const& data, auto ak) {
        if (static_cast<unsigned>(ak) == 0) { return; }
        if (fc::width_of(ak)) {
            write_text(text, vlt6000::parameter_value{data.number(), data.pwe});
        } else {
            vlt6000::write_title(text, data.number());
        }
    };
    auto const data = found.data();
    auto const kind = found.kind();
    if (kind == fc::data_kind::unknown) { return {}; }
    if (kind == fc::data_kind::text) { vlt6000::write_title(text, fc::text_response::read(data).number()); }
    if (kind == fc::data_kind::parameter) {
        auto const asked = fc::parameter_request::read(data);
        auto const given = fc::parameter_response::read(data);
        switch (found.direction) {
        case fc::direction::request: explain(asked, asked.command()); break;
        case fc::direction::response: explain(given, given.reply()); break;
        case fc::direction::unknown: vlt6000::write_title(text, asked.number()); break;
        }
    }

    auto const pcd = data.last(fc::vlt_layout::process_size);
    if (found.direction == fc::direction::response) {
        auto const status = fc::process_status::read(pcd);
        text.put(separator());
        write_text(text, vlt6000::status_word::from_raw(status.status_word()));
        text.put(", output frequency ");
        write_text(text, status.output_frequency());
    }
    if (found.direction == fc::direction::request) {
        auto const command = fc::process_command::read(pcd);
        text.put(separator());
        if (command.is_data_valid()) {
            write_text(text, vlt6000::control_word::from_raw(command.control_word()));
            text.put(", reference ");
            write_text(text, command.reference());
        } else {
            text.put("process data ignored");
        }
    }
    return std::string{text.view_with_ellipsis()};
}

}  // namespace support
