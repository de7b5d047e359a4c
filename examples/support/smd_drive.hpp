// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/link.hpp>
#include <drivecodec/drives/smd/locks.hpp>
#include <drivecodec/drives/smd/map.hpp>
#include <drivecodec/drives/smd/watchdog.hpp>
#include <drivecodec/modbus.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <string_view>

// An smd without its power stage: registers, locks, watchdog, a motor that follows a ramp. Time is what `go_on` says.

namespace support {

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;
namespace smd    = drivecodec::smd;

/// What the manual leaves open, and what is done here:
/// - Exception 01 is for any write while locked, also to a register that there is not, and for C02 while the motor is
///   on. 02 is also for reading what can only be written, and the other way round; 03 also for a wrong quantity and for
///   a word of register 1 without a command; while the drive is busy, everything is 06.
/// - The motor stays as it is when the drive is locked by command, and coasts when C01 takes control from Modbus.
/// - At a standstill the drive is off; inhibited with terminal 28 open, and after a time-out with n22 = 1 until it
///   is told to start or to stop; and in stop after a quick stop.
/// - A start with terminal 28 open or in fault is taken, and lost.
/// - A ramp takes its time from standstill to C11. Only a quick stop ramps down, all other stops coast.
/// - Loading defaults loads all of them, also C01: the drive then has no Modbus.
/// - C09 and c25 are of the next time that the drive gets power.
/// - A fault is reset by terminal 28, mains or an input, whatever caused it.
class smd_drive {
public:
    using seconds = std::chrono::duration<double>;
    template <typename T>
    using answer    = modbus::answer<T>;
    using functions = smd::functions;

    struct settings {
        smd::version       version            = smd::pv507;
        smd::control_mode  control_mode       = smd::control_mode::c40_modbus;
        std::uint16_t      password           = 0;
        smd::link_settings link               = {};
        bool               terminal_28_closed = true;
    };

    explicit smd_drive(settings const& chosen)
        : map_{chosen.version}, locks_{chosen.control_mode, chosen.password},
          is_terminal_28_closed_{chosen.terminal_28_closed}
    {
        load_defaults(load_50_hz);
        set<"C01">(static_cast<int>(chosen.control_mode));
        set<"C09">(chosen.link.address.byte());
        set<"c25">(static_cast<int>(chosen.link.format));
        set<"C94">(chosen.password);
        power_up();
    }

    //=== what happens to it ===//

    /// Mains off and on: parameters, the serial speed and the history of faults stay.
    void power_up()
    {
        reset_fault();
        coast(smd::operational_status::off);
        locks_                    = smd::locks{mode(), get<"C94">()};
        watchdog_                 = smd::watchdog{static_cast<smd::serial_timeout_action>(get<"n22">()), get<"n23">()};
        commanded_direction_      = smd::direction::forward;
        reference_                = smd::speed_reference::local;
        address_                  = static_cast<std::uint8_t>(get<"C09">());
        format_                   = static_cast<smd::serial_format>(get<"c25">());
        constexpr auto auto_start = static_cast<std::uint16_t>(smd::start_condition::auto_start_if_high);
        is_started_               = is_terminal_28_closed_ and terminals_control() and get<"c42">() == auto_start;
    }

    /// Trips. Another fault while it has one is not seen.
    void trip(smd::fault code)
    {
        if (fault_ != smd::fault::no_fault or code == smd::fault::no_fault) { return; }
        fault_      = code;
        since_trip_ = seconds{0};
        coast(smd::operational_status::off);
    }

    void set_terminal_28(bool closed)
    {
        auto const is_edge     = closed and not is_terminal_28_closed_;
        is_terminal_28_closed_ = closed;
        if (not closed) { coast(smd::operational_status::off); }
        if (not is_edge) { return; }
        reset_fault();
        if (terminals_control()) { start(); }
    }
    void toggle_terminal_28() { set_terminal_28(not is_terminal_28_closed_); }

    /// E1 to E3, by 0 to 2. They act by CE1 to CE3: fixed setpoints, DC braking, direction, quick stop, trip set and
    /// reset, acceleration 2.
    void toggle_input(std::size_t which)
    {
        auto& is_high = inputs_.at(which);
        is_high       = not is_high;
        using enum smd::digital_input_function;
        if (is_high and function_of(which) == trip_set) { trip(smd::fault::external_fault); }
        if (is_high and function_of(which) == trip_reset) { reset_fault(); }
    }

    void               set_analog_input(double hertz) { analog_ = std::clamp(hertz, 0.0, 240.0); }
    void               set_busy(bool busy) { is_busy_ = busy; }
    [[nodiscard]] bool is_busy() const noexcept { return is_busy_; }

    /// Time goes by.
    void go_on(seconds elapsed)
    {
        auto const microseconds = static_cast<std::uint32_t>(std::clamp(elapsed.count(), 0.0, 4000.0) * 1e6);
        react(watchdog_.pass(microseconds, locks_));
        since_trip_ += elapsed;
        auto const resets_itself = get<"c70">() == static_cast<int>(smd::trip_reset::auto_reset);
        if (resets_itself and since_trip_ > tenths(get<"c71">())) { reset_fault(); }
        turn(elapsed);
    }

    //=== what is seen of it ===//

    [[nodiscard]] smd::version    version() const noexcept { return map_.version(); }
    [[nodiscard]] smd::lock_state lock_state() const noexcept { return locks_.state(); }
    [[nodiscard]] double          speed() const noexcept { return std::abs(speed_); }  ///< Hz.

    [[nodiscard]] bool speaks_modbus() const { return smd::program_source_of(mode()) == smd::program_source::modbus; }
    /// Of the line that it is at since it got power.
    [[nodiscard]] std::uint8_t       address() const noexcept { return address_; }
    [[nodiscard]] smd::serial_format format() const noexcept { return format_; }

    [[nodiscard]] smd::status_block status() const
    {
        auto const tenths_of = [](double hertz) {
            return drivecodec::quantity<drivecodec::unit::hertz>{static_cast<std::int32_t>(std::lround(hertz * 10)),
                                                                 -1};
        };
        return {.command_speed       = tenths_of(command_speed()),
                .actual_speed        = tenths_of(speed()),
                .load                = {load(), 0},
                .operational_status  = operational_status(),
                .actual_direction    = speed_ < 0 ? smd::direction::reverse : smd::direction::forward,
                .control_mode        = mode(),
                .speed_source        = speed_source(),
                .speed_reference     = reference_,
                .fault               = fault_,
                .commanded_direction = direction()};
    }

    //=== what it answers ===//

    /// To a frame on the line, as the drive with this address: the reply, or nothing. Broadcasts are nothing to it, and
    /// without C01 of 8 to 11 it has no Modbus.
    [[nodiscard]] drivecodec::bytes answer_frame(rtu::frame const& found, drivecodec::mutable_bytes room)
    {
        auto const own = rtu::server_address::make(address_);
        if (not own or own->is_broadcast() or found.address() != address_ or not speaks_modbus()) { return {}; }
        if (found.aligned and found.direction == modbus::direction::request) { watchdog_.heard(); }
        return rtu::serve(*own, found, room, *this);
    }

    answer<modbus::register_view> operator()(smd::read_holding_registers::request const& asked)
    {
        return read(asked.range.first(), asked.range.count());
    }
    answer<modbus::register_view> operator()(smd::read_input_registers::request const& asked)
    {
        return read(asked.range.first(), asked.range.count());
    }
    answer<modbus::done> operator()(smd::write_single_register::request const& asked)
    {
        return write(asked.address, asked.value);
    }
    answer<modbus::done> operator()(smd::write_multiple_registers::request const& asked)
    {
        return write(asked.block.first(), asked.block.values()[0]);
    }

private:
    //=== parameters ===//

    static constexpr int load_50_hz = 1;
    static constexpr int load_60_hz = 2;

    template <smd::parameter_code Code>
    [[nodiscard]] std::uint16_t address_in_map() const
    {
        static constexpr std::array<std::uint16_t, 2> addresses{smd::address_of(Code.view(), smd::pv400),
                                                                smd::address_of(Code.view(), smd::pv507)};
        return addresses.at(version() == smd::pv400 ? 0 : 1);
    }
    /// Of a parameter that the version lacks: 0.
    template <smd::parameter_code Code>
    [[nodiscard]] std::uint16_t get() const
    {
        return values_.at(address_in_map<Code>());
    }
    template <smd::parameter_code Code>
    void set(int value)
    {
        values_.at(address_in_map<Code>()) = static_cast<std::uint16_t>(value);
    }

    [[nodiscard]] static seconds tenths(std::uint16_t raw) { return seconds{raw / 10.0}; }
    template <smd::parameter_code Code>
    [[nodiscard]] double hertz() const
    {
        return get<Code>() / 10.0;
    }

    [[nodiscard]] smd::control_mode mode() const { return static_cast<smd::control_mode>(get<"C01">()); }
    [[nodiscard]] bool              terminals_control() const
    {
        return smd::control_source_of(mode()) == smd::control_source::terminal;
    }

    void load_defaults(int which)
    {
        auto const first = smd::address_of("C01", version());
        for (auto address = first; address < values_.size(); ++address) {
            auto const* const row = map_.find(address);
            if (row != nullptr and row->is_writable()) {
                values_.at(address) = static_cast<std::uint16_t>(row->factory_setting.number);
            }
        }
        if (which == load_60_hz) {
            set<"C11">(600);
            set<"C15">(600);
        }
        adopt_settings();
    }

    /// Locks and watchdog have some of the parameters.
    void adopt_settings()
    {
        locks_.set_control_mode(mode());
        locks_.set_password(get<"C94">());
        watchdog_.set_action(static_cast<smd::serial_timeout_action>(get<"n22">()));
        watchdog_.set_fault_time(get<"n23">());
    }

    //=== reading ===//

    answer<modbus::register_view> read(std::uint16_t first, std::uint16_t count)
    {
        using enum modbus::exception_code;
        if (is_busy_) { return server_device_busy; }
        auto const possible = map_.make_read(first, count);
        if (not possible) {
            return possible.error().code() == drivecodec::errc::bad_address ? illegal_data_address : illegal_data_value;
        }
        refresh();
        if (count == smd::software_version_words) { return modbus::register_view{software_version_.words}; }
        return modbus::register_view{std::span{values_}.subspan(first, count)};
    }

    /// What is measured.
    void refresh()
    {
        auto const now = status();
        auto const at  = [&](std::uint16_t address) -> std::uint16_t& { return values_.at(address); };
        if (auto const words = now.make_words()) { std::ranges::copy(words->words, &at(smd::status_block::address)); }
        auto const command = at(smd::command_speed.address());
        auto const actual  = at(smd::actual_speed.address());
        auto const percent = static_cast<int>(load());
        auto const volts   = static_cast<int>(std::lround(std::min(speed() / hertz<"C15">(), 1.0) * 100));

        at(smd::drive_family.address())     = static_cast<std::uint16_t>(smd::family::smd);
        at(smd::motor_volts.address())      = static_cast<std::uint16_t>(volts);
        at(smd::register_version.address()) = static_cast<std::uint16_t>(version());
        set<"C46">(command);
        set<"C50">(actual);
        set<"C52">(volts);
        set<"C53">(100);
        set<"C54">(percent);
        set<"C56">(percent);
        set<"c61">(static_cast<int>(fault_));
        set<"c62">(static_cast<int>(last_faults_[0]));
        set<"c63">(static_cast<int>(last_faults_[1]));
        if (version() == smd::pv507) { set<"c38">(get<"c81">()); }
        at(address_in_map<"C99">()) = software_version_.words.front();
    }

    /// Its words are no registers of their own: those have the numbers that follow.
    [[nodiscard]] static modbus::register_array<smd::software_version_words> software_version_of(smd::version which)
    {
        constexpr std::string_view in_pv400 = "SMD 1.51";
        constexpr std::string_view in_pv507 = "SMD 2.01";
        smd::software_version      text;
        std::ranges::copy(which == smd::pv400 ? in_pv400 : in_pv507, text.characters.begin());
        return text.words();
    }

    //=== writing ===//

    answer<modbus::done> write(std::uint16_t address, std::uint16_t value)
    {
        using enum modbus::exception_code;
        if (is_busy_) { return server_device_busy; }
        auto const is_unlock = address == smd::unlock_commands.address() or address == smd::unlock_parameters.address();
        if (not is_unlock and not locks_.may_write(address, value)) { return illegal_function; }
        if (auto const refused = check(address, value); refused != modbus::exception_code{}) { return refused; }
        if (not locks_.write(address, value)) { return illegal_function; }
        if (address == smd::drive_control.address()) {
            obey(*smd::executed_command(value));
        } else if (not is_unlock) {
            store(address, value);
        }
        return modbus::done{};
    }

    /// 0: it may be written.
    [[nodiscard]] modbus::exception_code check(std::uint16_t address, std::uint16_t value) const
    {
        using enum modbus::exception_code;
        if (address == smd::drive_control.address()) {
            auto const command = smd::executed_command(value);
            if (command) { return {}; }
            return command.error().why == smd::command_fault::several ? server_device_failure : illegal_data_value;
        }
        auto const fault = map_.check_write(address, value);
        if (fault.code() == drivecodec::errc::out_of_range) { return illegal_data_value; }
        if (not fault.ok()) { return illegal_data_address; }
        auto const is_between = [&](std::uint16_t least, std::uint16_t greatest) {
            return value >= least and value <= greatest;
        };
        auto const is_serial_speed = address == smd::serial_speed_command.address();
        auto const is_pi_setpoint  = version() == smd::pv507 and address == address_in_map<"c81">();
        if (is_serial_speed and not is_between(get<"C10">(), get<"C11">())) { return illegal_data_value; }
        if (is_pi_setpoint and not is_between(get<"c86">(), get<"c87">())) { return illegal_data_value; }
        if (address == address_in_map<"C02">()) { return check_load(value); }
        return {};
    }

    /// There are no OEM defaults, and the memory module needs no translation.
    [[nodiscard]] modbus::exception_code check_load(std::uint16_t which) const
    {
        using enum smd::operational_status;
        auto const present = operational_status();
        if (present != off and present != inhibit) { return modbus::exception_code::illegal_function; }
        constexpr auto oem = static_cast<std::uint16_t>(smd::load_defaults::load_oem_defaults);
        return which == oem ? modbus::exception_code::illegal_data_value : modbus::exception_code{};
    }

    void store(std::uint16_t address, std::uint16_t value)
    {
        if (address == address_in_map<"C02">()) {
            if (value == load_50_hz or value == load_60_hz) { load_defaults(value); }
            return;  // it always reads 0: loading is complete
        }
        auto const was_controlled = smd::modbus_controls(mode());
        values_.at(address)       = value;
        adopt_settings();
        if (was_controlled and not smd::modbus_controls(mode())) { coast(smd::operational_status::off); }
    }

    void obey(smd::command given)
    {
        switch (given) {
        case smd::command::update_buffers:
        case smd::command::lock: return;
        case smd::command::stop: return coast(smd::operational_status::off);
        case smd::command::start: return start();
        case smd::command::set_reverse: commanded_direction_ = smd::direction::reverse; return;
        case smd::command::set_forward: commanded_direction_ = smd::direction::forward; return;
        case smd::command::serial_speed_reference: reference_ = smd::speed_reference::serial; return;
        case smd::command::local_speed_reference: reference_ = smd::speed_reference::local; return;
        }
    }

    //=== the drive ===//

    void start()
    {
        if (not is_terminal_28_closed_ or fault_ != smd::fault::no_fault) { return; }
        is_started_      = true;
        is_ramping_down_ = false;
    }

    void coast(smd::operational_status then)
    {
        is_started_      = false;
        is_ramping_down_ = false;
        at_standstill_   = then;
        speed_           = 0;
    }

    void react(smd::time_out_reaction reaction)
    {
        switch (reaction) {
        case smd::time_out_reaction::none:
        case smd::time_out_reaction::lock: return;
        case smd::time_out_reaction::lock_and_inhibit: return coast(smd::operational_status::inhibit);
        case smd::time_out_reaction::lock_and_stop:
            is_started_      = false;
            is_ramping_down_ = true;
            at_standstill_   = smd::operational_status::stop;
            return;
        case smd::time_out_reaction::lock_and_trip: return trip(smd::fault::communication_fault);
        }
    }

    void reset_fault()
    {
        if (fault_ == smd::fault::no_fault) { return; }
        last_faults_ = {fault_, last_faults_[0]};
        fault_       = smd::fault::no_fault;
    }

    [[nodiscard]] smd::digital_input_function function_of(std::size_t input) const
    {
        std::array const configured{get<"CE1">(), get<"CE2">(), get<"CE3">()};
        return static_cast<smd::digital_input_function>(configured.at(input));
    }
    [[nodiscard]] bool has_input(smd::digital_input_function wanted) const
    {
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            if (inputs_.at(i) and function_of(i) == wanted) { return true; }
        }
        return false;
    }

    /// Of the inputs only while the terminals control the drive.
    [[nodiscard]] smd::direction direction() const
    {
        if (not terminals_control()) { return commanded_direction_; }
        return has_input(smd::digital_input_function::direction_of_rotation) ? smd::direction::reverse
                                                                             : smd::direction::forward;
    }

    [[nodiscard]] smd::speed_source speed_source() const
    {
        using enum smd::digital_input_function;
        if (reference_ == smd::speed_reference::serial) { return smd::speed_source::serial; }
        auto const has_1 = has_input(activate_fixed_setpoint_1);
        auto const has_2 = has_input(activate_fixed_setpoint_2);
        if (has_1 and has_2) { return smd::speed_source::preset_3; }
        if (has_1) { return smd::speed_source::preset_1; }
        if (has_2) { return smd::speed_source::preset_2; }
        return smd::setpoint_source_of(mode()) == smd::setpoint_source::c40 ? smd::speed_source::preset_c40
                                                                            : smd::speed_source::analog;
    }

    /// In Hz, between C10 and C11.
    [[nodiscard]] double command_speed() const
    {
        auto const wanted = [this] {
            switch (speed_source()) {
            case smd::speed_source::preset_c40: return hertz<"c40">();
            case smd::speed_source::preset_1: return hertz<"C37">();
            case smd::speed_source::preset_2: return hertz<"C38">();
            case smd::speed_source::preset_3: return hertz<"C39">();
            case smd::speed_source::serial: return values_.at(smd::serial_speed_command.address()) / 10.0;
            default: return analog_;
            }
        }();
        return std::clamp(wanted, std::min(hertz<"C10">(), hertz<"C11">()), hertz<"C11">());
    }

    [[nodiscard]] bool is_powered() const { return is_started_ or is_ramping_down_; }
    [[nodiscard]] bool is_braking() const
    {
        return is_powered() and has_input(smd::digital_input_function::dc_braking);
    }
    [[nodiscard]] bool is_stopping_quickly() const
    {
        return is_ramping_down_ or has_input(smd::digital_input_function::quick_stop);
    }

    /// Where the ramp leads, in Hz; negative is reverse.
    [[nodiscard]] double target() const
    {
        if (is_stopping_quickly()) { return 0; }
        return direction() == smd::direction::reverse ? -command_speed() : command_speed();
    }

    void turn(seconds elapsed)
    {
        if (not is_powered()) { return; }
        if (is_braking()) {
            speed_ = 0;
            return;
        }
        auto const is_second   = has_input(smd::digital_input_function::accel_decel_2) and version() == smd::pv507;
        auto const accelerates = speed_ * target() >= 0 and std::abs(target()) > speed();
        auto const up          = is_second ? get<"c01">() : get<"C12">();
        auto const down        = is_second ? get<"c03">() : get<"C13">();
        auto const ramp        = tenths(accelerates ? up : down);
        auto const reach       = ramp.count() > 0 ? hertz<"C11">() * (elapsed / ramp) : std::abs(target()) + speed();
        speed_                 = std::clamp(target(), speed_ - reach, speed_ + reach);
        if (is_ramping_down_ and speed_ == 0) { coast(at_standstill_); }
    }

    [[nodiscard]] smd::operational_status operational_status() const
    {
        using enum smd::operational_status;
        if (fault_ != smd::fault::no_fault) { return fault; }
        if (not is_terminal_28_closed_) { return inhibit; }
        if (not is_powered()) { return at_standstill_; }
        if (is_braking()) { return dc_brake; }
        auto const wanted = target();
        if (speed_ == wanted) {
            if (wanted != 0) { return run; }
            return is_stopping_quickly() ? stop : run_at_0_hz;
        }
        return speed_ * wanted >= 0 and std::abs(wanted) > speed() ? accel : decel;
    }

    /// Something between 10 % without speed and 60 % at C11, and more while it accelerates; of full load.
    [[nodiscard]] std::int32_t load() const
    {
        if (not is_powered()) { return 0; }
        auto const of_speed = static_cast<std::int32_t>(std::lround(10 + 50 * std::min(speed() / hertz<"C11">(), 1.0)));
        return of_speed + (operational_status() == smd::operational_status::accel ? 20 : 0);
    }

    smd::map                                            map_;
    modbus::register_array<smd::software_version_words> software_version_ = software_version_of(map_.version());
    smd::locks                                          locks_;
    smd::watchdog                                       watchdog_;
    std::array<std::uint16_t, 256>                      values_{};  // by address
    std::array<smd::fault, 2>                           last_faults_{};
    std::array<bool, 3>                                 inputs_{};
    smd::fault                                          fault_ = smd::fault::no_fault;
    seconds                                             since_trip_{0};
    double                                              speed_               = 0;  // Hz, negative in reverse
    double                                              analog_              = 0;  // Hz
    smd::operational_status                             at_standstill_       = smd::operational_status::off;
    smd::direction                                      commanded_direction_ = smd::direction::forward;
    smd::speed_reference                                reference_           = smd::speed_reference::local;
    std::uint8_t                                        address_             = 0;
    smd::serial_format                                  format_              = smd::serial_format::format_8n2;
    bool                                                is_terminal_28_closed_;
    bool                                                is_started_      = false;
    bool                                                is_ramping_down_ = false;  // after a time-out
    bool                                                is_busy_         = false;
};

}  // namespace support
