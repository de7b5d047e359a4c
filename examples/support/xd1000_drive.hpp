// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402.hpp>
#include <drivecodec/modbus.hpp>
#include <drivecodec/xd1000.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <utility>

// An xD1000 without its power stage: registers, state machine, a motor that follows a ramp. Time is what `go_on` says.

namespace support {

namespace cia402 = drivecodec::cia402;
namespace modbus = drivecodec::modbus;
namespace xd1000 = drivecodec::xd1000;

class xd1000_drive {
public:
    using seconds = std::chrono::duration<double>;
    template <typename T>
    using answer    = modbus::answer<T>;
    using functions = xd1000::functions;

    struct settings {
        /// 1500 rpm at 50 Hz.
        unsigned pole_pairs = 2;
        /// Parameter 611 is 00: a time-out of the communication is no fault.
        bool ignores_time_out = false;
    };

    explicit xd1000_drive(settings chosen) : settings_{chosen}
    {
        for (std::size_t i = 0; i < xd1000::table.size(); ++i) {
            values_[i] = static_cast<std::uint16_t>(xd1000::table[i].factory_setting.number);
        }
        // What the manual has no factory setting for, but shows in its examples.
        set(xd1000::switching_frequency, 40);
        set(xd1000::maximum_output_frequency, 600);
        set(xd1000::high_speed, 500);
        set(xd1000::acc, 3);
        machine_.initialised();
        refresh();
    }

    //=== what happens to it ===//

    void fault() { machine_.fault(); }

    /// The STOP key: the drive is locked until the next Enable operation.
    void press_stop()
    {
        is_stopped_by_key_ = true;
        machine_.receive(cia402::apply(cia402::command::disable_voltage, {}));
    }

    /// The key on the keypad: in local mode CMD is not obeyed.
    void toggle_local() { is_local_ = not is_local_; }

    /// A valid request has arrived.
    void hear() { silence_ = seconds{0}; }

    /// Time goes by.
    void go_on(seconds elapsed)
    {
        silence_ += elapsed;
        auto const limit = seconds{get(xd1000::time_out) / 10.0};
        if (silence_ > limit and is_supervised_ and not settings_.ignores_time_out) {
            is_supervised_ = false;
            machine_.fault();
        }
        reaction_ = machine_.state() == cia402::state::fault_reaction_active ? reaction_ + elapsed : seconds{0};
        if (reaction_ > seconds{0.1}) { machine_.fault_handled(); }
        turn(elapsed);
        refresh();
    }

    [[nodiscard]] cia402::state state() const noexcept { return machine_.state(); }
    [[nodiscard]] double        speed() const noexcept { return speed_; }

    //=== what it answers ===//

    answer<modbus::register_view> operator()(xd1000::read_holding_registers::request const& asked)
    {
        return read(asked.range.first(), asked.range.count());
    }
    answer<modbus::done> operator()(xd1000::write_single_register::request const& asked)
    {
        return write(asked.address, std::array{asked.value});
    }
    answer<modbus::done> operator()(xd1000::write_multiple_registers::request const& asked)
    {
        return write(asked.block.first(), asked.block.values());
    }
    answer<modbus::register_view> operator()(xd1000::read_write_multiple_registers::request const& asked)
    {
        auto const readable =
            drivecodec::drives::check_range(xd1000::table, asked.read_range.first(), asked.read_range.count());
        if (not readable.ok()) { return modbus::exception_code::illegal_data_address; }  // writes nothing, either
        auto const wrote = write(asked.write_block.first(), asked.write_block.values());
        if (not wrote) { return wrote.error(); }
        return read(asked.read_range.first(), asked.read_range.count());
    }
    answer<modbus::read_device_identification::response>
    operator()(modbus::read_device_identification::request const& asked)
    {
        objects_ = xd1000::identification{.vendor_name          = bytes_of("Lauritz Knudsen Electrical & Automation"),
                                          .product_code         = bytes_of("xD1000H037N4"),
                                          .major_minor_revision = bytes_of("0201")}
                       .objects();
        return modbus::read_device_identification::answer(asked, xd1000::conformity, objects_);
    }

private:
    //=== registers ===//

    /// The texts of this file are literals, so they outlive every reply.
    [[nodiscard]] static drivecodec::bytes bytes_of(std::string_view text)
    {
        return {reinterpret_cast<std::uint8_t const*>(text.data()), text.size()};  // NOLINT: characters as they are
    }

    [[nodiscard]] std::uint16_t& at(std::uint16_t address)
    {
        return values_[static_cast<std::size_t>(xd1000::find(address) - xd1000::table.data())];
    }
    template <typename Register>
    [[nodiscard]] std::uint16_t get(Register which)
    {
        return at(which.address());
    }
    template <typename Register>
    void set(Register which, int value)
    {
        at(which.address()) = static_cast<std::uint16_t>(value);
    }

    answer<modbus::register_view> read(std::uint16_t first, std::uint16_t count)
    {
        if (not drivecodec::drives::check_range(xd1000::table, first, count).ok()) {
            return modbus::exception_code::illegal_data_address;
        }
        refresh();
        return modbus::register_view{std::span{&at(first), count}};  // adjacent there as they are here
    }

    /// All or nothing. What cannot be written is an illegal address, a value beyond the limits an illegal value; what
    /// the motor would have to stand still for is 04.
    template <typename Values>
    answer<modbus::done> write(std::uint16_t first, Values const& values)
    {
        using drivecodec::errc;
        auto const fault = drivecodec::drives::check_write(xd1000::table, first, values);
        if (fault.code() == errc::out_of_range) { return modbus::exception_code::illegal_data_value; }
        if (not fault.ok()) { return modbus::exception_code::illegal_data_address; }
        for (std::size_t i = 0; i < values.size(); ++i) {
            auto const* row = xd1000::find(static_cast<std::uint16_t>(first + i));
            if (row->access == drivecodec::drives::access::read_write_at_standstill and speed_ != 0) {
                return modbus::exception_code::server_device_failure;
            }
        }
        is_supervised_ = true;
        for (std::size_t i = 0; i < values.size(); ++i) { store(static_cast<std::uint16_t>(first + i), values[i]); }
        return modbus::done{};
    }

    void store(std::uint16_t address, std::uint16_t value)
    {
        at(address) = value;
        if (address == xd1000::cmd.address()) { obey(xd1000::command_word::from_raw(value)); }
        // An output of the scanner goes on to the register that it is assigned to.
        auto const word = static_cast<unsigned>(address - xd1000::nc1.address());
        if (word >= xd1000::scanner_words) { return; }
        auto const  destination = at(static_cast<std::uint16_t>(xd1000::nca1.address() + word));
        auto const* row         = destination == 0 ? nullptr : xd1000::find(destination);
        auto const  is_output   = destination >= xd1000::nc1.address() and destination <= xd1000::nc4.address();
        if (row != nullptr and row->check_write(value).ok() and not is_output) { store(destination, value); }
    }

    /// What is measured, and what the scanner copies.
    void refresh()
    {
        set(xd1000::eta, status().raw);
        set(xd1000::rfrd, static_cast<int>(std::lround(speed_)));
        for (unsigned word = 0; word < xd1000::scanner_words; ++word) {
            auto const source = at(static_cast<std::uint16_t>(xd1000::nma1.address() + word));
            auto const exists = source != 0 and xd1000::find(source) != nullptr;
            at(static_cast<std::uint16_t>(xd1000::nm1.address() + word)) = exists ? at(source) : std::uint16_t{0};
        }
    }

    //=== the drive ===//

    void obey(xd1000::command_word word)
    {
        if (is_local_) { return; }
        machine_.receive(word.standard());
        if (machine_.state() == cia402::state::operation_enabled) { is_stopped_by_key_ = false; }
    }

    [[nodiscard]] xd1000::command_word command() { return xd1000::command_word::from_raw(get(xd1000::cmd)); }

    /// In revolutions per minute, for tenths of a hertz.
    [[nodiscard]] double to_speed(double tenths_of_hertz) const { return tenths_of_hertz * 6 / settings_.pole_pairs; }

    /// The speed that is asked for, within low and high speed.
    [[nodiscard]] double reference()
    {
        auto const asked   = static_cast<double>(static_cast<std::int16_t>(get(xd1000::lfrd)));
        auto const highest = to_speed(get(xd1000::high_speed));
        auto const limited = std::clamp(std::abs(asked), std::min(to_speed(get(xd1000::low_speed)), highest), highest);
        auto const reverse =
            (asked < 0) != (command().get(xd1000::command_word::direction) == xd1000::direction::reverse);
        return reverse ? -limited : limited;
    }

    void turn(seconds elapsed)
    {
        constexpr double nominal_tenths_of_hertz = 500;
        auto const       ramp                    = seconds{static_cast<double>(get(xd1000::acc))};
        auto const       target                  = [&]() -> std::pair<double, seconds> {
            switch (machine_.state()) {
            case cia402::state::operation_enabled:
                return {command().test(xd1000::command_word::halt) ? 0 : reference(), ramp};
            case cia402::state::quick_stop_active: return {0, ramp / 4};
            default: return {0, seconds{2}};  // without power: it runs out
            }
        }();
        auto const reach = target.second.count() > 0 ? to_speed(nominal_tenths_of_hertz) * (elapsed / target.second)
                                                     : std::abs(target.first - speed_);
        speed_           = std::clamp(target.first, speed_ - reach, speed_ + reach);
        if (speed_ == 0) { machine_.quick_stop_finished(); }
    }

    [[nodiscard]] xd1000::status_word status()
    {
        auto       status    = xd1000::status_word{machine_.status()};
        auto const asked     = std::abs(static_cast<double>(static_cast<std::int16_t>(get(xd1000::lfrd))));
        auto const is_beyond = asked > to_speed(get(xd1000::high_speed)) or asked < to_speed(get(xd1000::low_speed));
        auto const is_on     = machine_.state() == cia402::state::operation_enabled;
        auto const is_halted = command().test(xd1000::command_word::halt);
        if (not is_local_) { status = status.with(xd1000::status_word::remote); }
        if (is_on and not is_halted and speed_ == reference()) {
            status = status.with(xd1000::status_word::reference_reached);
        }
        if (is_beyond) { status = status.with(xd1000::status_word::reference_exceeded); }
        if (is_stopped_by_key_) { status = status.with(xd1000::status_word::stopped_by_stop_key); }
        return status.with(xd1000::status_word::direction,
                           speed_ < 0 ? xd1000::direction::reverse : xd1000::direction::forward);
    }

    settings                                        settings_;
    cia402::machine                                 machine_;
    std::array<std::uint16_t, xd1000::table.size()> values_{};  // in the order of the table
    std::array<modbus::device_object, 3>            objects_{};
    double                                          speed_ = 0;  // revolutions per minute
    seconds                                         silence_{0};
    seconds                                         reaction_{0};
    bool                                            is_supervised_     = false;  // after the first write
    bool                                            is_stopped_by_key_ = false;
    bool                                            is_local_          = false;
};

}  // namespace support
