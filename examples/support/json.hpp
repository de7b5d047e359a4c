// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>

#include <concepts>
#include <string>
#include <string_view>

namespace support {

/// A text as JSON, with its quotes. What is not printable ASCII becomes \u00NN, one a byte.
[[nodiscard]] inline std::string json_text(std::string_view text)
{
    std::string out{'"'};
    for (auto const c : text) {
        if (c < ' ' or c > '~') {
            constexpr std::string_view digits = "0123456789abcdef";
            auto const                 byte   = static_cast<unsigned char>(c);
            out.append("\\u00").append({digits[byte >> 4], digits[byte & 0xF]});
        } else {
            if (c == '"' or c == '\\') { out += '\\'; }
            out += c;
        }
    }
    return out += '"';
}

/// A JSON array, of values that are JSON already.
class json_array {
public:
    void add(std::string_view value) { text_.append(text_.empty() ? "" : ",").append(value); }

    [[nodiscard]] std::string text() const { return '[' + text_ + ']'; }

private:
    std::string text_;
};

/// A JSON object on one line.
class json_object {
public:
    /// `value` is JSON already.
    void add_json(std::string_view name, std::string_view value)
    {
        text_.append(text_.empty() ? "" : ",").append(json_text(name)).append(":").append(value);
    }
    void add(std::string_view name, std::string_view text) { add_json(name, json_text(text)); }
    void add(std::string_view name, char const* text) { add_json(name, json_text(text)); }
    void add(std::string_view name, bool value) { add_json(name, value ? "true" : "false"); }
    void add(std::string_view name, std::integral auto number) { add_json(name, std::to_string(number)); }
    void add_null(std::string_view name) { add_json(name, "null"); }

    [[nodiscard]] std::string text() const { return '{' + text_ + '}'; }

private:
    std::string text_;
};

}  // namespace support
