// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/framing.hpp>
#include <drivecodec/text/fc/telegram.hpp>

namespace drivecodec::fc {

/// What `write_text` writes of a frame is never longer. The longest is a text of which no character can be printed.
inline constexpr std::size_t max_description_size = 1'100;

namespace detail {

/// What can be said of a PKE whose direction is not known, and so not the meaning of its AK.
template <typename Layout>
constexpr void write_ambiguous(text_writer& out, bytes data) noexcept
{
    auto const given = basic_parameter_request<Layout>::read(data);
    out.put("AK ").decimal(static_cast<std::uint8_t>(given.command()));
    write_number(out, given.number(), given.array_index());
    write_pwe(out, given.pwe);
    out.put(", ");
    write_text(out, given.process);
}

}  // namespace detail

/// A telegram that a reader found:
///
///     request to slave 1: read_value 202, PCD 047F 2000
///     response from slave 1: word 202 = 1000, PCD 0F03 2000
///     to or from slave 1: AK 1 202, PWE 000003E8, PCD 0F03 2000
///     to or from slave 1: text 621 "VLT 6000", PCD 0F03 2000
///     request to slave 1: 6 bytes of data: 01 02 03 04 05 06
///
/// The last is of a length that the layout does not have. What was found amid dropped bytes says so. A run of dropped
/// bytes is described by <drivecodec/text/core.hpp>.
template <typename Layout = vlt_layout>
constexpr void write_text(text_writer& out, frame const& found) noexcept
{
    auto const data       = found.data();
    auto const is_request = found.direction == direction::request;
    detail::write_head(out, found.direction, found.address());
    switch (found.kind<Layout>()) {
    case data_kind::process: write_text(out, basic_process_command<Layout>::read(data)); break;
    case data_kind::parameter:
        if (is_request) {
            write_text(out, basic_parameter_request<Layout>::read(data));
        } else if (found.direction == direction::response) {
            write_text(out, basic_parameter_response<Layout>::read(data));
        } else {
            detail::write_ambiguous<Layout>(out, data);
        }
        break;
    case data_kind::text:
        if (is_request) {
            write_text(out, basic_text_request<Layout>::read(data));
        } else {
            write_text(out, basic_text_response<Layout>::read(data));
        }
        break;
    case data_kind::unknown:
        out.decimal(data.size()).put(data.size() == 1 ? " byte of data" : " bytes of data");
        out.put(data.empty() ? "" : ": ").hex(data);
        break;
    }
    if (not found.aligned) { out.put("  (found amid dropped bytes)"); }
}

/// The same into `out`, of any layout; ends with "..." if it does not fit.
template <typename Layout = vlt_layout>
[[nodiscard]] constexpr std::string_view describe(frame const& found, std::span<char> out) noexcept
{
    text_writer text{out};
    write_text<Layout>(text, found);
    return text.view_with_ellipsis();
}

}  // namespace drivecodec::fc
