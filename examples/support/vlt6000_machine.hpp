// SPDX-License-Identifier: MIT
#pragma once

#include "support/vlt6000_settings.hpp"

#include <drivecodec/fc.hpp>
#include <drivecodec/vlt6000.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

// A VLT 6000 HVAC without its power stage and its bus: terminals, words, a motor that follows a ramp. Time is what
// `go_on` says.
//
// Where the manual leaves a choice, this drive
// - adds the preset reference, a percentage that is 0 from the factory, to the reference of the bus;
// - has its output at 0 Hz at once when it coasts, brakes or trips: there is no load that turns on;
// - carries out a bus time-out's freeze, jog and maximum only if it was running: it never starts by itself;
// - ends a time-out's reaction with the next telegram, also one without valid data; but a stop and trip, once begun,
//   ends as a trip;
// - shows "within frequency range" at standstill, and "speed equals reference" only while it runs;
// - has as an error code, for parameter 615, the number of the alarm's bit plus one.

namespace support {

class vlt6000_machine {
public:
    using seconds        = std::chrono::duration<double>;
    using alarm_word     = vlt6000::alarm_word;
    using control_word   = vlt6000::control_word;
    using digital_inputs = vlt6000::digital_inputs;
    using status_word    = vlt6000::status_word;
    using warning_word   = vlt6000::warning_word;

    static constexpr std::size_t errors_kept = 10;

    struct settings {
        std::uint8_t   address   = 1;
        std::int32_t   baud_code = static_cast<std::int32_t>(vlt6000::baud_rate::baud_9600);
        std::string    eeprom;  ///< A file; empty: forgotten when the program ends.
        digital_inputs closed = digital_inputs::of(digital_inputs::terminal_27);
        /// DC braking inverse is at terminal 19, where else reversing is.
        bool terminal_19_brakes = false;
    };

    explicit vlt6000_machine(settings const& chosen)
        : memory_{chosen.eeprom}, terminals_{chosen.closed}, terminal_19_brakes_{chosen.terminal_19_brakes}
    {
        memory_.set(501, chosen.address);
        memory_.set(502, chosen.baud_code);
    }

    //=== what happens to it ===//

    /// Time goes by.
    void go_on(seconds elapsed)
    {
        silence_ += elapsed;
        auto const limit = seconds{static_cast<double>(memory_.get(555))};
        if (is_supervised_ and not is_timed_out_ and speaks_fc() and silence_ > limit) { time_out(); }
        turn(elapsed);
    }

    void trip(alarm_word alarms)
    {
        if (alarms.raw == 0) { return; }
        alarms_ = alarm_word::from_raw(alarms_.raw | alarms.raw);
        std::rotate(errors_.begin(), errors_.end() - 1, errors_.end());
        errors_.front() = 1;
        while ((alarms.raw >> (errors_.front() - 1U) & 1U) == 0) { ++errors_.front(); }
        turn(seconds{0});
    }

    void warn(warning_word warnings) { warnings_ = warnings; }
    void toggle(drivecodec::flag<digital_inputs> input)
    {
        terminals_ = terminals_.test(input) ? terminals_.without(input) : terminals_.with(input);
        turn(seconds{0});
    }
    /// The OFF/STOP key, and the Auto key: while it is off, the drive obeys no control word.
    void toggle_local() { is_local_ = not is_local_; }

    /// Mains off and on: RAM and all words are lost, and so is what locked a trip.
    void power_cycle()
    {
        memory_.power_on();
        alarms_        = {};
        warnings_      = {};
        command_       = at_power_on;
        reference_     = {};
        lines_         = {};
        frequency_     = 0;
        is_supervised_ = is_timed_out_ = is_carrying_on_ = is_stopping_to_trip_ = false;
        turn(seconds{0});
    }

    /// A telegram for it has come.
    void obey(fc::process_command const& given)
    {
        silence_        = seconds{0};
        is_supervised_  = true;
        is_timed_out_   = false;
        is_carrying_on_ = false;
        auto const word = control_word::from_raw(given.control_word());
        if (word.test(control_word::data_valid)) {
            auto const is_edge = word.test(control_word::reset) and not command_.test(control_word::reset);
            if (is_edge and not is_local_ and not alarms_.test(alarm_word::trip_locked)) { alarms_ = {}; }
            command_   = word;
            reference_ = given.reference();
        }
        turn(seconds{0});
    }

    //=== what one can see of it ===//

    /// False after parameter 500 was set to another protocol: then it answers nothing.
    [[nodiscard]] bool speaks_fc() const { return memory_.get(500) == 0; }

    /// In Hz; negative in reverse.
    [[nodiscard]] double frequency() const { return frequency_; }

    [[nodiscard]] bool relay_1() const { return is_relay_on(control_word::relay_1, 323); }
    [[nodiscard]] bool relay_2() const { return is_relay_on(control_word::relay_2, 326); }
    /// 0 and 1: what 533 and 534 were set to.
    [[nodiscard]] std::string const& line(std::size_t which) const { return lines_.at(which); }

    [[nodiscard]] status_word status() const
    {
        using s               = status_word;
        using w               = warning_word;
        auto const is_tripped = alarms_.raw != 0;
        auto const warnings   = all_warnings();
        auto const voltage    = w::of(w::undervoltage, w::overvoltage, w::voltage_warning_low, w::voltage_warning_high);
        auto const temperature = w::of(w::motor_thermistor, w::motor_overtemperature, w::inverter_overtemperature);

        auto status = s::of(s::drive_ready);
        set(status, is_tripped ? s::tripped : s::control_ready);
        set(status, s::stand_by, not is_output_off() and not is_local_ and not is_running());
        set(status, s::warning, warnings.raw != 0);
        set(status, s::speed_equals_reference, is_running() and frequency_ == wanted_frequency());
        set(status, s::serial_control, not is_local_);
        auto const magnitude = std::abs(frequency_);
        set(status, s::within_frequency_range, frequency_ == 0 or (magnitude > lowest() and magnitude < highest()));
        set(status, s::running, is_running());
        set(status, s::voltage_warning, (warnings.raw & voltage.raw) != 0);
        set(status, s::current_limit, warnings.test(w::current_limit));
        set(status, s::thermal_warning, (warnings.raw & temperature.raw) != 0);
        return status;
    }

protected:
    static constexpr std::int32_t follows_control_word = 26;  // in 323 and 326

    /// Before the first telegram, nothing on the bus hinders the terminals.
    static constexpr control_word at_power_on = vlt6000::neutral.without(control_word::data_valid);

    template <typename Word>
    static void set(Word& word, drivecodec::flag<Word> flag, bool is_set = true)
    {
        if (is_set) { word = word.with(flag); }
    }

    //=== terminals and control word together ===//

    struct orders {
        bool coasting;
        bool braking;
        bool started;
        bool anti_clockwise;
        bool quick_stop;
        bool frozen;
        bool jogging;
    };

    [[nodiscard]] vlt6000::gating gating(std::uint16_t number) const
    {
        return static_cast<vlt6000::gating>(memory_.get(number));
    }

    /// Terminals: 18 start, 19 reversing or DC brake, 27 coasting.
    [[nodiscard]] orders present_orders() const
    {
        using c            = control_word;
        using t            = digital_inputs;
        auto const word    = is_local_ ? at_power_on : command_;
        auto const sources = [&](bool terminal, drivecodec::flag<c> bit) {
            return vlt6000::sources<bool>{.terminal = terminal, .bus = word.test(bit)};
        };
        auto const at_19 = terminals_.test(t::terminal_19);
        return {
            .coasting = is_coasting(gating(503), sources(terminals_.test(t::terminal_27), c::no_coasting_stop)),
            .braking  = is_dc_braking(gating(504), sources(at_19 or not terminal_19_brakes_, c::no_dc_brake)),
            .started  = not is_local_ and is_started(gating(505), sources(terminals_.test(t::terminal_18), c::start)),
            .anti_clockwise = is_anti_clockwise(gating(506), sources(at_19 and not terminal_19_brakes_, c::reversing)),
            .quick_stop     = not word.test(c::no_quick_stop),
            .frozen         = not word.test(c::no_freeze_output),
            .jogging        = word.test(c::jog),
        };
    }

    /// 16 and 17 are lsb and msb of the preset reference, 32 and 33 of the setup.
    [[nodiscard]] unsigned chosen_at(drivecodec::flag<digital_inputs> lsb, drivecodec::flag<digital_inputs> msb) const
    {
        return (terminals_.test(lsb) ? 1U : 0U) | (terminals_.test(msb) ? 2U : 0U);
    }

    [[nodiscard]] vlt6000::setup wanted_setup() const
    {
        if (memory_.get(4) == 0) {  // not multi-setup: 002 says which
            return static_cast<vlt6000::setup>(std::max(memory_.get(2) - 1, 0));
        }
        auto const terminal =
            static_cast<vlt6000::setup>(chosen_at(digital_inputs::terminal_32, digital_inputs::terminal_33));
        return active_setup(gating(507), {.terminal = terminal, .bus = command_.get(control_word::setup)});
    }

    /// In percent.
    [[nodiscard]] double preset_reference() const
    {
        auto const terminal =
            static_cast<vlt6000::preset_reference>(chosen_at(digital_inputs::terminal_16, digital_inputs::terminal_17));
        auto const active = active_preset_reference(
            gating(508), {.terminal = terminal, .bus = command_.get(control_word::preset_reference)});
        return memory_.get(static_cast<std::uint16_t>(210 + number(active))) / 100.0;
    }

    //=== frequencies, in Hz ===//

    [[nodiscard]] double lowest() const { return memory_.get(201) / 10.0; }
    [[nodiscard]] double highest() const { return memory_.get(202) / 10.0; }

    /// In percent, of which 100 are the most.
    [[nodiscard]] double resulting_reference() const
    {
        return std::clamp(reference_.number() * 100.0 / fc::reference::hundred_percent + preset_reference(), -100.0,
                          100.0);
    }

    /// What a start command leads to.
    [[nodiscard]] double reference_frequency() const
    {
        auto const percent   = resulting_reference();
        auto const lower     = memory_.get(204) / 1000.0;
        auto const span      = memory_.get(205) / 1000.0 - lower;
        auto const magnitude = std::clamp(lower + span * std::abs(percent) / 100, lowest(), highest());
        return (percent < 0) != present_orders().anti_clockwise ? -magnitude : magnitude;
    }

    [[nodiscard]] bool is_output_off() const
    {
        auto const given = present_orders();
        return alarms_.raw != 0 or given.coasting or given.braking;
    }

    /// Where the ramp leads.
    [[nodiscard]] double wanted_frequency() const
    {
        using enum vlt6000::bus_time_interval_function;
        auto const given = present_orders();
        auto const jog   = std::clamp(memory_.get(209) / 10.0, 0.0, highest());
        if (is_output_off() or is_stopping_to_trip_) { return 0; }
        if (is_timed_out_ and not is_local_) {
            auto const reaction = time_out_reaction();
            if (reaction == stop) { return 0; }
            if (is_carrying_on_ and reaction == freeze_output) { return frequency_; }
            if (is_carrying_on_ and reaction == jogging) { return std::copysign(jog, frequency_); }
            if (is_carrying_on_ and reaction == max_output_frequency) { return std::copysign(highest(), frequency_); }
        }
        if (given.frozen) { return frequency_; }
        if (given.quick_stop) { return 0; }
        if (given.jogging) { return given.anti_clockwise ? -jog : jog; }
        return given.started ? reference_frequency() : 0;
    }

    [[nodiscard]] bool is_running() const
    {
        auto const given = present_orders();
        return frequency_ != 0 or (not is_output_off() and (given.started or given.jogging));
    }

    /// 206 and 207 are the times from 0 Hz to the motor's nominal frequency, 104, and back.
    void turn(seconds elapsed)
    {
        memory_.select(wanted_setup());
        auto const wanted = wanted_frequency();
        auto const is_up  = std::abs(wanted) > std::abs(frequency_) and wanted * frequency_ >= 0;
        auto const ramp   = seconds{static_cast<double>(memory_.get(is_up ? 206 : 207))};
        auto const reach  = memory_.get(104) * (elapsed / ramp);
        frequency_        = is_output_off() ? 0 : std::clamp(wanted, frequency_ - reach, frequency_ + reach);
        if (is_stopping_to_trip_ and frequency_ == 0) {
            is_stopping_to_trip_ = false;
            trip(alarm_word::of(alarm_word::serial_communication_timeout));
        }
    }

    //=== bus time-out ===//

    [[nodiscard]] vlt6000::bus_time_interval_function time_out_reaction() const
    {
        return static_cast<vlt6000::bus_time_interval_function>(memory_.get(556));
    }

    void time_out()
    {
        is_timed_out_   = true;
        is_carrying_on_ = is_running();
        is_stopping_to_trip_ =
            not is_local_ and time_out_reaction() == vlt6000::bus_time_interval_function::stop_and_trip;
    }

    /// Relays drop by a time-out whatever 556 is.
    [[nodiscard]] bool is_relay_on(drivecodec::flag<control_word> bit, std::uint16_t number) const
    {
        return command_.test(bit) and memory_.get(number) == follows_control_word and not is_timed_out_;
    }

    [[nodiscard]] warning_word all_warnings() const
    {
        auto warnings = warnings_;
        set(warnings, warning_word::serial_communication_timeout,
            is_timed_out_ and time_out_reaction() != vlt6000::bus_time_interval_function::off);
        return warnings;
    }

    vlt6000_settings                      memory_;
    digital_inputs                        terminals_;
    bool                                  terminal_19_brakes_;
    control_word                          command_ = at_power_on;  // the last that was valid
    fc::reference                         reference_{};
    alarm_word                            alarms_{};
    warning_word                          warnings_{};
    std::array<std::uint8_t, errors_kept> errors_{};  // the latest first; 0: none
    std::array<std::string, 2>            lines_{};
    double                                frequency_ = 0;
    seconds                               silence_{0};
    bool                                  is_supervised_       = false;  // after the first telegram
    bool                                  is_timed_out_        = false;
    bool                                  is_carrying_on_      = false;  // timed out while it ran
    bool                                  is_stopping_to_trip_ = false;
    bool                                  is_local_            = false;
};

}  // namespace support
