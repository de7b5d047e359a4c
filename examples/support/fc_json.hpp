// SPDX-License-Identifier: MIT
#pragma once

#include "hex.hpp"
#include "json.hpp"

#include <drivecodec/text/fc.hpp>

#include <algorithm>
#include <string>

namespace support {

namespace detail {

/// AK and what has it; `Data` has a direction, `frame_direction` says whether it is known.
template <typename Data>
void add_ak(json_object& out, Data const& data, drivecodec::fc::direction frame_direction)
{
    namespace fc           = drivecodec::fc;
    auto const add_ak_name = [&](auto ak) {
        auto const is_known = frame_direction != fc::direction::unknown or ak == decltype(ak)::text;
        if (auto const name = to_string(ak); is_known and not name.empty()) { out.add("ak_name", name); }
    };
    out.add("ak", data.pke.raw >> 12);
    if constexpr (Data::is_request) {
        add_ak_name(data.pke.get(fc::pke::command));
    } else {
        add_ak_name(data.pke.get(fc::pke::reply));
    }
    out.add("parameter", data.number());
    out.add("index", data.ind.get(fc::ind::array_index));
}

template <typename Data>
void add_parameter(json_object& out, Data const& data, drivecodec::fc::direction frame_direction)
{
    namespace fc = drivecodec::fc;
    add_ak(out, data, frame_direction);
    if constexpr (not Data::is_request) {
        if (data.reply() == fc::ak_reply::cannot_be_executed) {
            auto const refusal = data.refusal();
            out.add("error", static_cast<std::uint16_t>(refusal));
            if (auto const name = to_string(refusal); not name.empty()) { out.add("error_name", name); }
            return;
        }
    }
    out.add("value", data.pwe);
}

template <typename Data>
void add_text(json_object& out, Data const& data, drivecodec::fc::direction frame_direction)
{
    add_ak(out, data, frame_direction);
    out.add("access", static_cast<std::uint8_t>(data.access()));
    if (auto const name = to_string(data.access()); not name.empty()) { out.add("access_name", name); }
    // The zeros of a read request stand where a value would be.
    auto const is_no_text = std::ranges::all_of(data.characters, [](auto byte) { return byte == 0; });
    out.add("text", is_no_text ? std::string{} : std::string(data.characters.begin(), data.characters.end()));
}

}  // namespace detail

/// A telegram as a JSON object; numbers are as on the wire, and what has a name besides has it in a key of its own, with
/// `_name` behind it.
///
/// What a telegram does not have is left out: process data have no `ak` and what belongs to it, texts no `value` but a
/// `text`, refusals an `error` instead; `value` is PWE, also where AK tells of none. Where the direction is unknown an AK
/// has no name. What has a length that the layout does not have is only `raw`.
template <typename Layout>
[[nodiscard]] std::string to_json(drivecodec::fc::frame const& found)
{
    namespace fc       = drivecodec::fc;
    auto const data    = found.data();
    auto const kind    = found.kind<Layout>();
    auto const request = found.direction == fc::direction::request;

    json_object out;
    out.add("protocol", "fc");
    out.add("direction", to_string(found.direction));
    out.add("address", found.address().number());
    out.add("broadcast", found.address().is_broadcast());
    out.add("kind", to_string(kind));
    if (kind == fc::data_kind::parameter) {
        if (request) {
            detail::add_parameter(out, fc::basic_parameter_request<Layout>::read(data), found.direction);
        } else {
            detail::add_parameter(out, fc::basic_parameter_response<Layout>::read(data), found.direction);
        }
    } else if (kind == fc::data_kind::text) {
        if (request) {
            detail::add_text(out, fc::basic_text_request<Layout>::read(data), found.direction);
        } else {
            detail::add_text(out, fc::basic_text_response<Layout>::read(data), found.direction);
        }
    }
    if (kind != fc::data_kind::unknown) {
        json_array words;
        auto const process = fc::basic_process_status<Layout>::read(data.last(Layout::process_size));
        for (auto const word : process.pcd()) {
            words.add(std::to_string(word));
        }
        out.add_json("pcd", words.text());
    }
    out.add("aligned", found.aligned);
    out.add("raw", to_hex(found.raw));
    return out.text();
}

}  // namespace support
