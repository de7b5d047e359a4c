// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>

#include <concepts>
#include <string_view>
#include <type_traits>

namespace drivecodec {

/// Writes text into the caller's characters. What does not fit is left out, and counted: nothing is written outside,
/// and no call fails. Without a buffer it only measures. There is no terminating zero.
class text_writer {
public:
    constexpr text_writer() noexcept = default;
    constexpr explicit text_writer(std::span<char> out) noexcept : out_{out} {}

    //=== what was written ===//

    /// The text, as far as it fits.
    [[nodiscard]] constexpr std::string_view view() const noexcept
    {
        return {out_.data(), is_complete() ? needed_ : out_.size()};
    }
    /// How many characters the whole text has.
    [[nodiscard]] constexpr std::size_t needed() const noexcept { return needed_; }
    [[nodiscard]] constexpr bool        is_complete() const noexcept { return needed_ <= out_.size(); }

    /// As `view`; where text was left out, its last characters become "...", so that a reader sees it.
    [[nodiscard]] constexpr std::string_view view_with_ellipsis() noexcept
    {
        if (not is_complete()) {
            auto const dots = out_.size() < 3 ? out_.size() : 3;
            for (auto& last : out_.last(dots)) { last = '.'; }
        }
        return view();
    }

    //=== text ===//

    constexpr text_writer& put(char character) noexcept
    {
        if (needed_ < out_.size()) { out_.data()[needed_] = character; }
        ++needed_;
        return *this;
    }

    constexpr text_writer& put(std::string_view text) noexcept
    {
        for (auto const character : text) { put(character); }
        return *this;
    }

    // No ///: the backslashes are not commands of the documentation.
    //
    // Bytes that should be ASCII, between quotes: `"`, `\` and what cannot be printed become \", \\ and \xNN.
    constexpr text_writer& quoted(bytes characters) noexcept
    {
        put('"');
        for (auto const byte : characters) {
            if (byte < ' ' or byte > '~') {
                put("\\x").hex(byte);
            } else {
                if (byte == '"' or byte == '\\') { put('\\'); }
                put(static_cast<char>(byte));
            }
        }
        return put('"');
    }

    //=== numbers ===//

    template <std::integral Number>
    constexpr text_writer& decimal(Number number) noexcept
    {
        if constexpr (std::is_signed_v<Number>) {
            if (number < 0) { return put('-').decimal_digits(0 - static_cast<std::uint64_t>(number)); }
        }
        return decimal_digits(static_cast<std::uint64_t>(number));
    }

    /// All digits that the type has, without a prefix: 2 for a byte.
    template <std::unsigned_integral Number>
    constexpr text_writer& hex(Number number) noexcept
    {
        for (auto shift = 8 * static_cast<int>(sizeof number); shift > 0;) {
            shift -= 4;
            put("0123456789ABCDEF"[(number >> shift) & 0xF]);
        }
        return *this;
    }

    /// Two digits a byte.
    constexpr text_writer& hex(bytes wire, std::string_view separator = " ") noexcept
    {
        auto between = std::string_view{};
        for (auto const byte : wire) {
            put(between).hex(byte);
            between = separator;
        }
        return *this;
    }

private:
    constexpr text_writer& decimal_digits(std::uint64_t number) noexcept
    {
        char        digits[20] = {};
        std::size_t count      = 0;
        do {
            digits[count++] = static_cast<char>('0' + number % 10);
            number /= 10;
        } while (number != 0);
        while (count > 0) { put(digits[--count]); }
        return *this;
    }

    std::span<char> out_{};
    std::size_t     needed_ = 0;
};

}  // namespace drivecodec
