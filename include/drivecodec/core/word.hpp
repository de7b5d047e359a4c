// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <type_traits>

namespace drivecodec {

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
void flag_is_outside_the_word();
}  // namespace compile_error

/// One named bit of `Word`. Carries its word's type, so a status flag cannot test a control word.
template <typename Word>
struct flag {
    std::uint8_t bit;

    consteval explicit flag(int position) : bit{static_cast<std::uint8_t>(position)}
    {
        if (position < 0 or position > 31) { compile_error::flag_is_outside_the_word(); }
    }
};

/// `Width` adjacent bits of `Word`, lowest at `First`, read as `Value`.
template <typename Word, typename Value, unsigned First, unsigned Width>
struct field {
    static_assert(Width > 0 and First + Width <= 32, "field does not fit in a word");
};

/// A control, status or event word: one unsigned integer with names for its bits.
///
/// `Self` derives from it and lists its flags and fields as static members. The object *is* the integer: same
/// size, passed in a register, usable as a template argument; `raw` is public, so `switch (word.raw)` works and
/// unknown bits survive a decode/encode round trip.
template <typename Self, std::unsigned_integral Raw>
struct word {
    using raw_type = Raw;

    Raw raw{};

    /// A word with exactly these flags set.
    template <std::same_as<flag<Self>>... Flags>
    [[nodiscard]] static constexpr Self of(Flags... flags) noexcept
    {
        return from_raw(static_cast<Raw>((0U | ... | mask(flags))));
    }

    [[nodiscard]] static constexpr Self from_raw(Raw raw) noexcept
    {
        Self self{};
        self.raw = raw;
        return self;
    }

    //=== flags ===//
    [[nodiscard]] constexpr bool test(flag<Self> f) const noexcept { return (raw & mask(f)) != 0; }
    [[nodiscard]] constexpr Self with(flag<Self> f) const noexcept { return from_raw(static_cast<Raw>(raw | mask(f))); }
    [[nodiscard]] constexpr Self without(flag<Self> f) const noexcept
    {
        return from_raw(static_cast<Raw>(raw & ~mask(f)));
    }

    //=== fields ===//
    template <typename Value, unsigned First, unsigned Width>
    [[nodiscard]] constexpr Value get(field<Self, Value, First, Width>) const noexcept
    {
        static_assert(First + Width <= 8 * sizeof(Raw), "the field is outside the word");
        return static_cast<Value>((raw >> First) & low_bits<Width>);
    }
    /// Bits of `contents` above the field's width are ignored.
    template <typename Value, unsigned First, unsigned Width>
    [[nodiscard]] constexpr Self with(field<Self, Value, First, Width>,
                                      std::type_identity_t<Value> contents) const noexcept
    {
        static_assert(First + Width <= 8 * sizeof(Raw), "the field is outside the word");
        auto const bits = static_cast<Raw>((static_cast<Raw>(contents) & low_bits<Width>) << First);
        return from_raw(static_cast<Raw>((raw & ~(low_bits<Width> << First)) | bits));
    }

    friend constexpr bool operator==(word, word) noexcept = default;

private:
    template <unsigned Width>
    static constexpr Raw low_bits = static_cast<Raw>((std::uint64_t{1} << Width) - 1);

    static constexpr Raw mask(flag<Self> f) noexcept { return static_cast<Raw>(Raw{1} << f.bit); }
};

}  // namespace drivecodec
