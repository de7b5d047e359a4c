// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/parameter.hpp>
#include <drivecodec/fc/telegram.hpp>
#include <drivecodec/fc/text.hpp>
#include <drivecodec/text/fc/address.hpp>
#include <drivecodec/text/fc/names.hpp>
#include <drivecodec/text/fc/parameter_error.hpp>

// Telegrams as one readable line each.

namespace drivecodec::fc {

namespace detail {

template <typename Layout>
constexpr void write_pcd(text_writer& out, process_block<Layout> const& process) noexcept
{
    out.put("PCD");
    for (auto const word : process.pcd()) { out.put(' ').hex(word); }
}

/// ` 202`, ` 615[1]`
constexpr void write_number(text_writer& out, std::uint16_t number, std::uint8_t array_index) noexcept
{
    out.put(' ').decimal(number);
    if (array_index != 0) { out.put('[').decimal(array_index).put(']'); }
}

/// `, PWE 0000000A`
constexpr void write_pwe(text_writer& out, std::uint32_t pwe) noexcept
{
    out.put(", PWE ").hex(pwe);
}

/// ` = 1000`. A word without a sign, for nothing tells; but -1 where the upper half says that it has one.
template <typename Parameter>
constexpr void write_value(text_writer& out, Parameter const& data, width of) noexcept
{
    if (of == width::double_word) {
        out.put(" = ").decimal(data.pwe);
    } else if (auto const word = data.template value<std::uint16_t>()) {
        out.put(" = ").decimal(*word);
    } else if (auto const negative = data.template value<std::int16_t>()) {
        out.put(" = ").decimal(*negative);
    } else {
        write_pwe(out, data.pwe);
    }
}

/// Without PCD.
template <typename Parameter>
constexpr void write_parameter(text_writer& out, Parameter const& data) noexcept
{
    auto const ak = [&] {
        if constexpr (Parameter::is_request) {
            return data.command();
        } else {
            return data.reply();
        }
    }();
    auto const ak_number = static_cast<std::uint8_t>(ak);
    if (auto const name = to_string(ak); not name.empty()) {
        out.put(name);
    } else {
        out.put("AK ").decimal(ak_number);
    }
    if (ak_number != 0 or data.number() != 0) { write_number(out, data.number(), data.array_index()); }
    if constexpr (not Parameter::is_request) {
        if (ak == ak_reply::cannot_be_executed) {
            out.put(": ");
            write_text(out, data.refusal());
            if (data.pwe > 0xFFFF) { write_pwe(out, data.pwe); }
            return;
        }
    }
    if (auto const width = width_of(ak)) {
        write_value(out, data, *width);
    } else if (data.pwe != 0) {
        write_pwe(out, data.pwe);
    }
}

/// What a request to read a text has where one would be.
inline constexpr std::array<std::uint8_t, 4> no_characters{};

/// `request to slave 1: `
constexpr void write_head(text_writer& out, direction which, address of) noexcept
{
    if (which == direction::request and of.is_broadcast()) {
        out.put("broadcast: ");
        return;
    }
    switch (which) {
    case direction::request: out.put("request to "); break;
    case direction::response: out.put("response from "); break;
    case direction::unknown: out.put("to or from "); break;
    }
    write_text(out, of);
    out.put(": ");
}

}  // namespace detail

/// `PCD 047F 2000`
template <typename Layout>
constexpr void write_text(text_writer& out, basic_process_command<Layout> const& process) noexcept
{
    detail::write_pcd(out, process);
}
template <typename Layout>
constexpr void write_text(text_writer& out, basic_process_status<Layout> const& process) noexcept
{
    detail::write_pcd(out, process);
}

/// `read_value 615[1], PCD 047F 2000`, `word 202 = 1000, PCD 0F03 2000`,
/// `cannot_be_executed 202: value_exceeds_limits (2), PCD 0F03 2000`. An AK without a name is `AK 5`. PWE where AK tells
/// of no value is written if it is not 0, the number beside AK 0 likewise.
template <typename Layout, typename Process>
constexpr void write_text(text_writer& out, basic_parameter_data<Layout, Process> const& data) noexcept
{
    detail::write_parameter(out, data);
    out.put(", ");
    write_text(out, data.process);
}

/// `text 621 read, PCD 0000 0000`, `text 533 write "HELLO", PCD 0000 0000`, `text 621 "VLT 6000", PCD 0F03 2000`
template <typename Layout, typename Process, typename Text>
constexpr void write_text(text_writer& out, basic_text_data<Layout, Process, Text> const& data) noexcept
{
    out.put("text");
    detail::write_number(out, data.number(), data.ind.get(fc::ind::array_index));
    auto is_shown = true;
    if constexpr (basic_text_data<Layout, Process, Text>::is_request) {
        is_shown = data.access() != text_access::read or not same_bytes(data.characters, detail::no_characters);
        if (auto const name = to_string(data.access()); not name.empty()) {
            out.put(' ').put(name);
        } else {
            out.put(" access ").hex(static_cast<std::uint8_t>(data.access()));
        }
    }
    if (is_shown) { out.put(' ').quoted(data.characters); }
    out.put(", ");
    write_text(out, data.process);
}

/// `request to slave 1: read_value 202, PCD 047F 2000`, `response from slave 1: PCD 0F03 2000`, `broadcast: PCD 047C 0000`
template <writable Data>
constexpr void write_text(text_writer& out, telegram<Data> const& given) noexcept
{
    constexpr auto is_request = [] {
        if constexpr (requires { Data::is_request; }) {
            return Data::is_request;
        } else {
            return requires(Data const& data) { data.is_data_valid(); };  // process data
        }
    }();
    detail::write_head(out, is_request ? direction::request : direction::response, given.address);
    write_text(out, given.data);
}

}  // namespace drivecodec::fc
