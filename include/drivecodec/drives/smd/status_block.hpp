// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/status_words.hpp>
#include <drivecodec/modbus/register_view.hpp>

namespace drivecodec::smd {

/// All that the drive says of itself, in one read of six registers from 24 on. smd manual, section 5.4.
///
/// Speeds have no sign; directions are apart. Every six words are a status: numbers without a name stay as they are.
struct status_block {
    static constexpr std::uint16_t address    = 24;
    static constexpr std::size_t   word_count = 6;

    quantity<unit::hertz>   command_speed{0, -1};  ///< Register 24: 0 to 240.0 Hz in steps of 0.1 Hz.
    quantity<unit::hertz>   actual_speed{0, -1};   ///< Register 25, as 24.
    quantity<unit::percent> load{0, 0};            ///< Of full load, 0 to 255 %.
    smd::operational_status operational_status{};
    direction               actual_direction{};
    smd::control_mode       control_mode{};
    smd::speed_source       speed_source{};
    smd::speed_reference    speed_reference{};
    smd::fault              fault{};
    direction               commanded_direction{};

    /// Errors: `bad_quantity` at 0 if these are not six words.
    [[nodiscard]] static constexpr result<status_block> decode(modbus::register_view words) noexcept
    {
        if (words.size() != word_count) { return error{errc::bad_quantity, 0}; }
        std::array<std::uint16_t, word_count> const raw{words[0], words[1], words[2], words[3], words[4], words[5]};
        return from_words(raw);
    }

    [[nodiscard]] static constexpr status_block from_words(std::array<std::uint16_t, word_count> const& raw) noexcept
    {
        auto const word_3 = load_and_status::from_raw(raw[2]);
        auto const word_4 = direction_and_mode::from_raw(raw[3]);
        auto const word_5 = source_and_reference::from_raw(raw[4]);
        auto const word_6 = fault_and_direction::from_raw(raw[5]);
        return {.command_speed       = {raw[0], -1},
                .actual_speed        = {raw[1], -1},
                .load                = word_3.load(),
                .operational_status  = word_3.get(load_and_status::operational_status),
                .actual_direction    = word_4.get(direction_and_mode::actual_direction),
                .control_mode        = word_4.get(direction_and_mode::control_mode),
                .speed_source        = word_5.get(source_and_reference::speed_source),
                .speed_reference     = word_5.get(source_and_reference::speed_reference),
                .fault               = word_6.get(fault_and_direction::fault),
                .commanded_direction = word_6.get(fault_and_direction::commanded_direction)};
    }

    /// The drive's side: the six words. Errors, at the word: `out_of_range` for what its register or byte cannot hold,
    /// `inexact` for more digits than it has.
    [[nodiscard]] constexpr result<modbus::register_array<word_count>> make_words() const noexcept
    {
        auto const command = command_speed.scaled_to(-1);
        auto const actual  = actual_speed.scaled_to(-1);
        auto const percent = load.scaled_to(0);
        if (not command) { return command.error(); }
        if (not actual) { return actual.error().moved_by(1); }
        if (not percent) { return percent.error().moved_by(2); }
        if (not is_within(*command, 0xFFFF)) { return error{errc::out_of_range, 0}; }
        if (not is_within(*actual, 0xFFFF)) { return error{errc::out_of_range, 1}; }
        if (not is_within(*percent, 0xFF)) { return error{errc::out_of_range, 2}; }
        if (not is_within(static_cast<std::int32_t>(control_mode), 0xFF)) { return error{errc::out_of_range, 3}; }
        if (not is_within(static_cast<std::int32_t>(fault), 0xFF)) { return error{errc::out_of_range, 5}; }

        auto const word_3 = load_and_status{}
                                .with(load_and_status::load_byte, static_cast<std::uint8_t>(*percent))
                                .with(load_and_status::operational_status, operational_status);
        auto const word_4 = direction_and_mode{}
                                .with(direction_and_mode::actual_direction, actual_direction)
                                .with(direction_and_mode::control_mode, control_mode);
        auto const word_5 = source_and_reference{}
                                .with(source_and_reference::speed_source, speed_source)
                                .with(source_and_reference::speed_reference, speed_reference);
        auto const word_6 = fault_and_direction{}
                                .with(fault_and_direction::fault, fault)
                                .with(fault_and_direction::commanded_direction, commanded_direction);
        return modbus::register_array<word_count>{{static_cast<std::uint16_t>(*command),
                                                   static_cast<std::uint16_t>(*actual), word_3.raw, word_4.raw,
                                                   word_5.raw, word_6.raw}};
    }

    friend constexpr bool operator==(status_block const&, status_block const&) noexcept = default;

private:
    [[nodiscard]] static constexpr bool is_within(std::int32_t number, std::int32_t last) noexcept
    {
        return number >= 0 and number <= last;
    }
};

}  // namespace drivecodec::smd
