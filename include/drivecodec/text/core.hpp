// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/stream_item.hpp>
#include <drivecodec/text/writer.hpp>

// As everywhere in text/: `to_string` gives an enumerator's own name, the word that code and log have in common; empty
// for a value without a name.

namespace drivecodec {

[[nodiscard]] constexpr std::string_view to_string(errc code) noexcept
{
    switch (code) {
    case errc::none: return "none";
    case errc::truncated: return "truncated";
    case errc::trailing_bytes: return "trailing_bytes";
    case errc::bad_start: return "bad_start";
    case errc::bad_checksum: return "bad_checksum";
    case errc::bad_length: return "bad_length";
    case errc::bad_quantity: return "bad_quantity";
    case errc::bad_value: return "bad_value";
    case errc::bad_address: return "bad_address";
    case errc::reserved_address: return "reserved_address";
    case errc::unexpected_function: return "unexpected_function";
    case errc::unsupported_function: return "unsupported_function";
    case errc::unexpected_server: return "unexpected_server";
    case errc::unexpected_reply: return "unexpected_reply";
    case errc::exception_reply: return "exception_reply";
    case errc::no_reply: return "no_reply";
    case errc::no_space: return "no_space";
    case errc::read_only: return "read_only";
    case errc::inexact: return "inexact";
    case errc::out_of_range: return "out_of_range";
    case errc::unreachable: return "unreachable";
    }
    return {};
}

/// What it means, as the end of a sentence: "refused: ...". Empty for a value without a name.
[[nodiscard]] constexpr std::string_view explain(errc code) noexcept
{
    switch (code) {
    case errc::none: return "nothing is wrong";
    case errc::truncated: return "the message is longer than the bytes given";
    case errc::trailing_bytes: return "the message ends before the bytes do";
    case errc::bad_start: return "the message does not begin with its start character";
    case errc::bad_checksum: return "the checksum does not match the bytes it covers";
    case errc::bad_length: return "a length or byte count contradicts the other fields or the bytes that follow";
    case errc::bad_quantity: return "a quantity is outside the limits of its function";
    case errc::bad_value: return "a field holds a value that the protocol does not allow";
    case errc::bad_address: return "an address does not exist, or the range that starts there passes the last one";
    case errc::reserved_address: return "the protocol reserves this address";
    case errc::unexpected_function: return "a well-formed message, but not the one asked for";
    case errc::unsupported_function: return "the function, sub-function or MEI type is not in the set";
    case errc::unexpected_server: return "the reply of another server than the one asked";
    case errc::unexpected_reply: return "the reply does not answer this request";
    case errc::exception_reply: return "the server refused, with an exception or an error number";
    case errc::no_reply: return "to this request there is no reply";
    case errc::no_space: return "the output buffer is too small";
    case errc::read_only: return "the register or parameter cannot be written";
    case errc::inexact: return "the register or parameter has no digits for this value";
    case errc::out_of_range: return "the value is outside the limits of its register, parameter or type";
    case errc::unreachable: return "no command leads to this state from here";
    }
    return {};
}

namespace detail {

/// Was something refused that need not be bytes? Then offset 0 is no place.
[[nodiscard]] constexpr bool refuses_a_value(errc code) noexcept
{
    switch (code) {
    case errc::read_only:
    case errc::inexact:
    case errc::out_of_range:
    case errc::unreachable: return true;
    default: return false;
    }
}

}  // namespace detail

/// What is wrong, and where: `bad_quantity at byte 4`, `truncated, 8 bytes needed`, `exception_reply 2`, `inexact`.
constexpr void write_text(text_writer& out, error fault) noexcept
{
    auto const name = to_string(fault.code());
    if (name.empty()) {
        out.put("error ").decimal(static_cast<std::uint8_t>(fault.code()));
    } else {
        out.put(name);
    }
    if (fault.ok()) { return; }
    if (fault.code() == errc::truncated or fault.code() == errc::no_space) {
        out.put(", ").decimal(fault.offset()).put(" bytes needed");
    } else if (fault.code() == errc::exception_reply) {
        out.put(' ').decimal(fault.offset());
    } else if (fault.offset() != 0 or not detail::refuses_a_value(fault.code())) {
        out.put(" at byte ").decimal(fault.offset());
    }
}

/// `dropped 3 bytes  bad_checksum: 01 02 03`
constexpr void write_text(text_writer& out, dropped_bytes const& run) noexcept
{
    out.put("dropped ").decimal(run.raw.size()).put(run.raw.size() == 1 ? " byte  " : " bytes  ");
    out.put(to_string(run.reason)).put(": ").hex(run.raw);
}

/// `frames=12 unaligned_frames=0 dropped_runs=1 dropped_bytes=3 bad_checksums=1 truncated=0`
constexpr void write_text(text_writer& out, stream_counters const& counted) noexcept
{
    out.put("frames=").decimal(counted.frames);
    out.put(" unaligned_frames=").decimal(counted.unaligned_frames);
    out.put(" dropped_runs=").decimal(counted.dropped_runs);
    out.put(" dropped_bytes=").decimal(counted.dropped_bytes);
    out.put(" bad_checksums=").decimal(counted.bad_checksums);
    out.put(" truncated=").decimal(counted.truncated);
}

/// `write_text` of anything into the caller's characters; ends with "..." if it does not fit.
template <typename Thing>
    requires requires(text_writer& out, Thing const& thing) { write_text(out, thing); }
[[nodiscard]] constexpr std::string_view describe(Thing const& thing, std::span<char> out) noexcept
{
    text_writer text{out};
    write_text(text, thing);
    return text.view_with_ellipsis();
}

}  // namespace drivecodec
