// SPDX-License-Identifier: MIT
#pragma once

#include "support/vlt6000_machine.hpp"

#include <drivecodec/fc.hpp>
#include <drivecodec/vlt6000.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>

// A VLT 6000 HVAC as a slave: what it answers to telegrams.
//
// Where the manual leaves a choice, this drive answers an AK without a meaning with error 5, wrong data type, and AK F
// with an IND that neither reads nor writes with error 3.

namespace support {

/// A handler for `fc::serve`.
class vlt6000_drive : public vlt6000_machine {
public:
    using answer = fc::parameter_answer;

    using vlt6000_machine::vlt6000_machine;

    fc::process_status operator()(fc::process_command const& given)
    {
        obey(given);
        return {status(), output()};
    }

    answer operator()(fc::parameter_request const& asked)
    {
        using enum fc::parameter_error;
        auto const* row = vlt6000::find(asked.number());
        if (row == nullptr) { return parameter_does_not_exist; }
        auto const is_read = asked.command() == fc::ak_command::read_value;
        if (row->kind == vlt6000::kind::text or (not is_read and not fc::width_of(asked.command()))) {
            return data_type_does_not_match;
        }
        auto const index = asked.array_index();
        if (row->is_array ? index == 0 or index > errors_kept : index != 0) {
            return row->is_array ? sub_index_does_not_exist : not_an_array;
        }
        if (row->is_array and is_read) { return answer::value(errors_.at(index - 1U)); }
        auto const is_setting = vlt6000_settings::find(asked.number()) != nullptr;
        if (is_read) { return is_setting ? memory_.read(asked.number()) : read_out(asked.number()); }
        if (not is_setting) { return no_write_access; }
        auto const said = memory_.write(asked, is_running());
        turn(seconds{0});
        return said;
    }

    fc::text_answer operator()(fc::text_request const& asked)
    {
        using enum fc::parameter_error;
        auto const* row = vlt6000::find(asked.number());
        if (row == nullptr) { return parameter_does_not_exist; }
        if (row->kind != vlt6000::kind::text) { return data_type_does_not_match; }
        auto const is_line = row->access == vlt6000::access::write_only;
        if (asked.access() == fc::text_access::write) {
            if (not is_line) { return no_write_access; }
            if (not row->check_text(asked.characters.size()).ok()) { return value_exceeds_limits; }
            lines_.at(row->number - 533U).assign(asked.characters.begin(), asked.characters.end());
        } else if (asked.access() != fc::text_access::read) {
            return sub_index_does_not_exist;
        }
        return bytes_of(is_line ? std::string_view{lines_.at(row->number - 533U)} : name_plate.at(row->number - 621U));
    }

private:
    /// 621 to 631; what stands on a real one is on its own.
    static constexpr std::array<std::string_view, 11> name_plate{
        "VLT 6006 HVAC", "7.6 kVA",   "178B0000", "2.00",      "LCP 1.0", "DB 1.0",
        "PWR 1.0",       "NO OPTION", "-",        "NO OPTION", "-"};

    [[nodiscard]] static drivecodec::bytes bytes_of(std::string_view text)
    {
        return {reinterpret_cast<std::uint8_t const*>(text.data()), text.size()};  // NOLINT: characters as they are
    }

    /// PCD2: 0 to 100 % are 201 to 202.
    [[nodiscard]] fc::output_frequency output() const
    {
        auto const share  = (std::abs(frequency_) - lowest()) / (highest() - lowest());
        auto const most   = double{fc::output_frequency::last};
        auto const number = std::clamp(std::round(share * fc::output_frequency::hundred_percent), 0.0, most);
        return fc::output_frequency::from_raw(
            static_cast<std::uint16_t>(static_cast<std::int32_t>(std::copysign(number, frequency_))));
    }

    [[nodiscard]] vlt6000::extended_status_word extended_status() const
    {
        using e             = vlt6000::extended_status_word;
        auto const given    = present_orders();
        auto const status   = this->status();
        auto       extended = e::of(e::drive_ready_23, e::drive_ready_25);
        set(extended, e::reversing_and_start, given.anti_clockwise and given.started);
        set(extended, e::ramp_operation, frequency_ != wanted_frequency());
        set(extended, e::reversing, frequency_ < 0);
        set(extended, e::speed_equals_reference, status.test(status_word::speed_equals_reference));
        set(extended, e::running, is_running());
        set(extended, e::remote_controlled_reference, not is_local_);
        set(extended, e::off_mode, is_local_);
        set(extended, e::freeze_output, given.frozen);
        set(extended, e::jogging, given.jogging and is_running());
        set(extended, e::stand_by, status.test(status_word::stand_by));
        set(extended, e::stop, not is_running());
        set(extended, e::dc_stop, given.braking);
        set(extended, e::relay_123_active, relay_1());
        set(extended, e::control_ready, status.test(status_word::control_ready));
        set(extended, e::start_prevented, given.started and is_output_off());
        return extended;
    }

    /// Of the bus alone: 0 to 4000h in 535 are 413 to 414.
    [[nodiscard]] double feedback() const
    {
        double const lowest  = memory_.get(413);
        double const highest = memory_.get(414);
        return lowest + (highest - lowest) * memory_.get(535) / 0x4000;
    }

    [[nodiscard]] static answer word_of(double value)
    {
        return answer::value(static_cast<std::int16_t>(std::lround(std::clamp(value, -32768.0, 32767.0))));
    }
    [[nodiscard]] static answer double_word_of(double value)
    {
        return answer::value(static_cast<std::int32_t>(std::lround(std::clamp(value, -2147483648.0, 2147483647.0))));
    }

    /// What a drive measures. Widths and conversion indexes, in the comments, are this simulator's choice, but for the
    /// double words of 529, 531 and 532. Nothing is connected to the analogue and pulse inputs, 522 to 526.
    [[nodiscard]] answer read_out(std::uint16_t number) const
    {
        auto const share = std::abs(frequency_) / memory_.get(104);  // of the motor's nominal frequency
        auto const kw    = memory_.get(102) / 1000.0 * share * share * share;
        switch (number) {
        case 509: return word_of(resulting_reference() * 10);                                            // %, -1
        case 510: return double_word_of(reference_frequency() * 1000);                                   // Hz, -3
        case 511: return double_word_of(feedback());                                                     // -3
        case 512: return word_of(frequency_ * 10);                                                       // Hz, -1
        case 513: return double_word_of(memory_.get(5) * std::abs(frequency_) / highest());              // -2
        case 514: return word_of(memory_.get(105) * (frequency_ == 0 ? 0 : 0.3 + 0.7 * share * share));  // A, -2
        case 515: return word_of(kw * 100);                                                              // kW, -2
        case 516: return word_of(kw * 134);                                                              // hp, -2
        case 517: return word_of(memory_.get(103) * std::min(share, 1.0));                               // V, 0
        case 518: return word_of(560);                                                                   // V, 0
        case 519:
        case 520: return word_of(50 * share);  // %, 0
        case 521: return answer::value(terminals_.raw);
        case 527: return answer::value(status().raw);
        case 528: return word_of(35);  // degrees Celsius, 0
        case 529: return answer::value(alarms_.raw);
        case 530: return answer::value(command_.raw);
        case 531: return answer::value(all_warnings().raw);
        case 532: return answer::value(extended_status().raw);
        default: return word_of(0);
        }
    }
};

}  // namespace support
