// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/functions.hpp>

namespace drivecodec::smd {

/// What C99 holds: eight characters, "SMD 1.51". smd manual, section 6.2.
struct software_version {
    std::array<char, 2 * std::size_t{software_version_words}> characters{};

    /// Errors: `bad_quantity` at 0 if they are not four words. The first character of two is the high byte, as of all
    /// registers; the manual has no example.
    [[nodiscard]] static constexpr result<software_version> make(modbus::register_view words) noexcept
    {
        if (words.size() != software_version_words) { return error{errc::bad_quantity, 0}; }
        software_version made{};
        for (std::size_t i = 0; i < words.size(); ++i) {
            made.characters[2 * i]     = static_cast<char>(words[i] >> 8);
            made.characters[2 * i + 1] = static_cast<char>(words[i] & 0xFF);
        }
        return made;
    }

    /// The words that hold it.
    [[nodiscard]] constexpr modbus::register_array<software_version_words> words() const noexcept
    {
        modbus::register_array<software_version_words> made{};
        for (std::size_t i = 0; i < software_version_words; ++i) {
            made.words[i] = static_cast<std::uint16_t>(static_cast<unsigned char>(characters[2 * i]) << 8
                                                       | static_cast<unsigned char>(characters[2 * i + 1]));
        }
        return made;
    }

    [[nodiscard]] constexpr std::string_view view() const noexcept { return {characters.data(), characters.size()}; }

    friend constexpr bool operator==(software_version const&, software_version const&) noexcept = default;
};

/// C99, where a version has it.
template <version Version>
struct software_version_parameter {
    static constexpr drives::register_row row = *drives::find(table<Version>, software_version_address<Version>);

    using value_type = software_version;

    [[nodiscard]] static constexpr std::uint16_t address() noexcept { return software_version_address<Version>; }

    /// All four words.
    [[nodiscard]] static consteval read_holding_registers::request read()
    {
        return {.range = {address(), software_version_words}};
    }

    /// Errors: those of `software_version::make`.
    [[nodiscard]] static constexpr result<software_version> value(modbus::register_view words) noexcept
    {
        return software_version::make(words);
    }
};

}  // namespace drivecodec::smd
