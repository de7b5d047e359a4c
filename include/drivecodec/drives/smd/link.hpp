// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>
#include <drivecodec/modbus/rtu/timing.hpp>

// The serial line. smd manual, sections 2.3, 4.3 and 4.4.

namespace drivecodec::smd {

namespace compile_error {
// Declared, never defined, not constexpr: calling it is how a consteval function says no. Its name is the text.
void the_smd_has_an_address_between_1_and_247_and_takes_no_broadcast();
}  // namespace compile_error

/// The only one.
inline constexpr std::uint32_t baud_rate = 9600;

/// Parameter C09: a Modbus address, but not that of a broadcast, which the drive does not support.
///
/// `rtu::encode(rtu::broadcast, ...)` of a write to this drive compiles all the same, for the request is that of any
/// Modbus device: other drives on the line may take it. This one does not, and nobody answers.
class network_address {
public:
    consteval network_address(int address) : server_{modbus::rtu::server_address::reserved(byte_of(address))}
    {
        if (byte_of(address) != address or not make(byte_of(address))) {
            compile_error::the_smd_has_an_address_between_1_and_247_and_takes_no_broadcast();
        }
    }

    /// Of a byte known only at run time. Errors: `reserved_address` at 0, also for 0.
    [[nodiscard]] static constexpr result<network_address> make(std::uint8_t byte) noexcept
    {
        auto const server = modbus::rtu::server_address::make(byte);
        if (not server) { return server.error(); }
        if (server->is_broadcast()) { return error{errc::reserved_address, 0}; }
        return network_address{*server};
    }

    [[nodiscard]] constexpr std::uint8_t byte() const noexcept { return server_.byte(); }
    constexpr operator modbus::rtu::server_address() const noexcept { return server_; }

    friend constexpr bool operator==(network_address, network_address) noexcept = default;

private:
    constexpr explicit network_address(modbus::rtu::server_address server) noexcept : server_{server} {}

    [[nodiscard]] static constexpr std::uint8_t byte_of(int number) noexcept
    {
        return static_cast<std::uint8_t>(number);
    }

    modbus::rtu::server_address server_;
};

/// As drives leave the factory; the manual advises to avoid it, as most other devices do too.
inline constexpr network_address factory_address{1};

//=== c25: two meanings ===//

/// Errors: `bad_value` at 0 for an unknown code.
[[nodiscard]] constexpr result<modbus::rtu::character_format> to_rtu(serial_format code) noexcept
{
    switch (code) {
    case serial_format::format_8n2: return modbus::rtu::format_8n2;
    case serial_format::format_8n1: return modbus::rtu::format_8n1;
    case serial_format::format_8e1: return modbus::rtu::format_8e1;
    case serial_format::format_8o1: return modbus::rtu::format_8o1;
    }
    return error{errc::bad_value, 0};
}

/// What the same code means while C01 is not one of Modbus: the rate of LECOM. Errors: `bad_value` at 0 for an unknown
/// code.
[[nodiscard]] constexpr result<std::uint32_t> lecom_bits_per_second(serial_format code) noexcept
{
    auto const number = static_cast<unsigned>(code);
    if (number > 3) { return error{errc::bad_value, 0}; }
    return baud_rate >> number;
}

/// Does all of the manual say that this version has this format? Section 2.3 has 8N1 of PV507 only; section 6.2 of
/// both.
[[nodiscard]] constexpr bool is_undisputed(serial_format code, version which) noexcept
{
    return code != serial_format::format_8n1 or which == pv507;
}

/// How a drive is set up; without arguments, as it leaves the factory.
struct link_settings {
    network_address address = factory_address;            ///< C09
    serial_format   format  = serial_format::format_8n2;  ///< c25

    /// The silences of the line. Errors: `bad_value` at 0 for an unknown code.
    [[nodiscard]] constexpr result<modbus::rtu::timing> timing() const noexcept
    {
        auto const shape = to_rtu(format);
        if (not shape) { return shape.error(); }
        return modbus::rtu::timing::make(baud_rate, *shape);
    }

    friend constexpr bool operator==(link_settings const&, link_settings const&) noexcept = default;
};

//=== n23: how often to talk to the drive ===//

/// n23 as a drive leaves the factory: "may be too restrictive", for not even one poll of the status fits into its half.
inline constexpr quantity<unit::second> factory_fault_time{50, -3};

/// What one read of the drive status takes on the line, in microseconds: request, response and a silence after each,
/// and not the time in which the drive thinks.
[[nodiscard]] constexpr std::uint32_t status_poll_time(modbus::rtu::timing line) noexcept
{
    using response        = read_holding_registers::basic_response<modbus::register_array<status_block::word_count>>;
    constexpr auto around = modbus::rtu::layout::adu::around;
    constexpr auto characters = around + read_holding_registers::request::wire_size() + around + response::wire_size();
    return line.frame_time(characters) + 2 * line.inter_frame();
}

/// The manual's advice: talk to the drive at less than half of n23. In microseconds. Errors, at 0, for what n23 does
/// not take: `inexact`, `out_of_range`.
[[nodiscard]] constexpr result<std::uint32_t> advised_interval(quantity<unit::second> fault_time) noexcept
{
    auto const milliseconds = n23<pv507>.raw(fault_time);
    if (not milliseconds) { return milliseconds.error(); }
    return std::uint32_t{*milliseconds} * 500;
}

/// The least n23 with which one exchange after the other of this length, in microseconds, follows the advice: that of
/// `status_poll_time`, and the time in which the drive thinks. Errors: `out_of_range` at 0 if n23 takes none.
[[nodiscard]] constexpr result<quantity<unit::second>> advised_fault_time(std::uint32_t exchange) noexcept
{
    constexpr auto limits = n23<pv507>.row.limits;
    if (exchange >= static_cast<std::uint32_t>(limits.max) * 500) { return error{errc::out_of_range, 0}; }
    auto const milliseconds = static_cast<std::int32_t>(exchange / 500 + 1);
    return quantity<unit::second>{milliseconds < limits.min ? limits.min : milliseconds, -3};
}

}  // namespace drivecodec::smd
