// SPDX-License-Identifier: MIT
#pragma once

#include "json.hpp"
#include "stream_json.hpp"

#include <drivecodec/core/stream_item.hpp>
#include <drivecodec/text/core.hpp>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>

// What was found on a line, in a form that does not know of which protocol it is.

namespace support {

enum class traffic : std::uint8_t {
    request,     ///< Also a broadcast, which has the address 0.
    reply,       ///< That it was done.
    refusal,     ///< A reply that it was not: an exception of Modbus, "cannot be executed" of FC.
    unclear,     ///< A frame of which nothing tells whether it is a request.
    unanswered,  ///< No bytes: the request before got no reply.
    dropped,     ///< Bytes that belong to no frame.
};

/// What ended the waiting for a reply.
enum class silence_until : std::uint8_t { next_frame, time_out, end };

/// One thing on the line. All of them in order have every byte of it once.
struct traffic_item {
    traffic                     kind;
    std::string_view            protocol{};       ///< Of a frame: `Modbus`, `FC`.
    std::optional<std::uint8_t> address{};        ///< Of the slave. Of dropped bytes: who is to reply, if anybody.
    std::optional<std::uint8_t> seems_from{};     ///< Whom dropped bytes would be to or from, as far as they can tell.
    bool                        expects_reply{};  ///< A request that has one address, and is to be answered.
    bool                        is_answer{};      ///< A reply or refusal to the request before it.
    bool                        is_bad_check{};   ///< Of dropped bytes: they began like a frame, with a wrong checksum.
    silence_until               until{};          ///< Of what was not answered.
    std::size_t                 size{};           ///< In bytes.
    std::string                 text{};           ///< As the `style` says; of what was not answered, nothing.
    std::string                 meaning{};        ///< To the drive, if that is known.

    [[nodiscard]] bool is_reply() const { return kind == traffic::reply or kind == traffic::refusal; }
};

/// Where what was found goes.
using sink = std::function<void(traffic_item const&)>;

/// How frames are written.
enum class style : std::uint8_t {
    text,     ///< With their address and direction.
    content,  ///< What is behind those.
    json,
};

/// A thing as a line of JSON, or of text.
template <typename Thing>
[[nodiscard]] std::string line_of(Thing const& thing, bool json)
{
    if (json) { return to_json(thing); }
    std::array<char, 1024> buffer;
    return std::string{drivecodec::describe(thing, buffer)};
}

/// Text and meaning of an item: a line below it, or in JSON one more member.
[[nodiscard]] inline std::string with_meaning(traffic_item const& item, bool json)
{
    if (item.meaning.empty()) { return item.text; }
    if (not json) { return item.text + "\n    " + item.meaning; }
    return item.text.substr(0, item.text.size() - 1) + ",\"meaning\":" + json_text(item.meaning) + '}';
}

/// Writes frames and dropped bytes, a line each, and a line of meaning if there is any.
[[nodiscard]] inline sink lines_to(std::ostream& out, bool json)
{
    return [&out, json](traffic_item const& item) {
        if (item.kind != traffic::unanswered) { out << with_meaning(item, json) << '\n'; }
    };
}

}  // namespace support
