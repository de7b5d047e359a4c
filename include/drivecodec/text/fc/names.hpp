// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/framing.hpp>
#include <drivecodec/fc/parameter_requests.hpp>

#include <string_view>

// An enumerator's own name; empty for a value without one. Those of errors are in parameter_error.hpp.

namespace drivecodec::fc {

[[nodiscard]] constexpr std::string_view to_string(ak_command command) noexcept
{
    switch (command) {
    case ak_command::no_command: return "no_command";
    case ak_command::read_value: return "read_value";
    case ak_command::write_word: return "write_word";
    case ak_command::write_double_word: return "write_double_word";
    case ak_command::read_description: return "read_description";
    case ak_command::write_double_word_to_eeprom: return "write_double_word_to_eeprom";
    case ak_command::write_word_to_eeprom: return "write_word_to_eeprom";
    case ak_command::text: return "text";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(ak_reply reply) noexcept
{
    switch (reply) {
    case ak_reply::no_reply: return "no_reply";
    case ak_reply::word: return "word";
    case ak_reply::double_word: return "double_word";
    case ak_reply::description: return "description";
    case ak_reply::cannot_be_executed: return "cannot_be_executed";
    case ak_reply::text: return "text";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(text_access access) noexcept
{
    switch (access) {
    case text_access::none: return "none";
    case text_access::read: return "read";
    case text_access::write: return "write";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(storage where) noexcept
{
    switch (where) {
    case storage::ram: return "ram";
    case storage::ram_and_eeprom: return "ram_and_eeprom";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(data_type type) noexcept
{
    switch (type) {
    case data_type::integer_16: return "integer_16";
    case data_type::integer_32: return "integer_32";
    case data_type::unsigned_8: return "unsigned_8";
    case data_type::unsigned_16: return "unsigned_16";
    case data_type::unsigned_32: return "unsigned_32";
    case data_type::text_string: return "text_string";
    case data_type::byte_string: return "byte_string";
    case data_type::time_difference: return "time_difference";
    case data_type::reserved: return "reserved";
    case data_type::bit_sequence: return "bit_sequence";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(width of) noexcept
{
    switch (of) {
    case width::word: return "word";
    case width::double_word: return "double_word";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(data_kind kind) noexcept
{
    switch (kind) {
    case data_kind::process: return "process";
    case data_kind::parameter: return "parameter";
    case data_kind::text: return "text";
    case data_kind::unknown: return "unknown";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(direction which) noexcept
{
    switch (which) {
    case direction::unknown: return "unknown";
    case direction::request: return "request";
    case direction::response: return "response";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(expecting what) noexcept
{
    switch (what) {
    case expecting::either: return "either";
    case expecting::request: return "request";
    case expecting::response: return "response";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(address_format format) noexcept
{
    switch (format) {
    case address_format::short_1_to_31: return "short_1_to_31";
    case address_format::long_1_to_126: return "long_1_to_126";
    }
    return {};
}

[[nodiscard]] constexpr std::string_view to_string(main_value kind) noexcept
{
    switch (kind) {
    case main_value::reference: return "reference";
    case main_value::output_frequency: return "output_frequency";
    }
    return {};
}

}  // namespace drivecodec::fc
