// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/register_group.hpp>
#include <drivecodec/drives/xd1000/command_word.hpp>
#include <drivecodec/drives/xd1000/functions.hpp>
#include <drivecodec/drives/xd1000/status_word.hpp>
#include <drivecodec/drives/xd1000/table.hpp>

// The registers by name, as the manual names them:
//
//     rtu::encode(2, xd1000::cmd.write(cia402::command::enable_operation))
//     rtu::encode(2, xd1000::high_speed.write(50.0_Hz))
//     xd1000::eta.value(0x0237)

namespace drivecodec::xd1000 {

template <std::uint16_t Address, typename Value = drives::number_in<table, Address>>
using holding_register = drives::holding_register<table, Address, read_holding_registers, Value>;

inline constexpr holding_register<3102> switching_frequency{};
inline constexpr holding_register<3103> maximum_output_frequency{};
inline constexpr holding_register<3104> high_speed{};
inline constexpr holding_register<3105> low_speed{};

inline constexpr holding_register<3201, status_word>   eta{};
inline constexpr holding_register<3206, std::uint16_t> eti{};  ///< Extended status word: the manual has no bits.

inline constexpr holding_register<6001>                           modbus_address{};
inline constexpr holding_register<6003, xd1000::baud_rate>        baud_rate_setting{};
inline constexpr holding_register<6004, xd1000::character_format> character_format_setting{};
inline constexpr holding_register<6005>                           time_out{};

inline constexpr holding_register<8501, command_word>  cmd{};
inline constexpr holding_register<8504, std::uint16_t> cmi{};   ///< Extended control word: the manual has no bits.
inline constexpr holding_register<8602>                lfrd{};  ///< Speed reference.
inline constexpr holding_register<8604>                rfrd{};  ///< Speed feedback.
inline constexpr holding_register<9001>                acc{};   ///< `acc.with_exponent<-1>` if yours counts tenths.

inline constexpr holding_register<12701, std::uint16_t> nma1{};
inline constexpr holding_register<12702, std::uint16_t> nma2{};
inline constexpr holding_register<12703, std::uint16_t> nma3{};
inline constexpr holding_register<12704, std::uint16_t> nma4{};
inline constexpr holding_register<12721, std::uint16_t> nca1{};
inline constexpr holding_register<12722, std::uint16_t> nca2{};
inline constexpr holding_register<12723, std::uint16_t> nca3{};
inline constexpr holding_register<12724, std::uint16_t> nca4{};
inline constexpr holding_register<12741, std::uint16_t> nm1{};
inline constexpr holding_register<12742, std::uint16_t> nm2{};
inline constexpr holding_register<12743, std::uint16_t> nm3{};
inline constexpr holding_register<12744, std::uint16_t> nm4{};
inline constexpr holding_register<12761, std::uint16_t> nc1{};
inline constexpr holding_register<12762, std::uint16_t> nc2{};
inline constexpr holding_register<12763, std::uint16_t> nc3{};
inline constexpr holding_register<12764, std::uint16_t> nc4{};

/// Adjacent registers as one request: `registers<high_speed, low_speed>{}.read()`. A gap, more than 63 to read or 61 to
/// write, or one that cannot be written, does not compile.
template <auto... Registers>
using registers = drives::register_group<read_holding_registers, write_multiple_registers, Registers...>;

/// A read known only at run time. Errors, in registers: `bad_quantity` beyond 63, `bad_address` at the first gap.
[[nodiscard]] constexpr result<read_holding_registers::request> make_read(std::uint16_t first,
                                                                          std::uint16_t count) noexcept
{
    auto const range = modbus::register_range<63>::make(first, count);
    if (not range) { return range.error(); }
    if (auto const fault = drives::check_range(table, first, count); not fault.ok()) { return fault; }
    return read_holding_registers::request{.range = *range};
}

/// A write known only at run time. Errors, in registers: `bad_quantity` beyond 61, `bad_address` at the first gap,
/// `read_only`, `out_of_range`.
[[nodiscard]] constexpr result<write_multiple_registers::request> make_write(std::uint16_t         first,
                                                                             modbus::register_view values) noexcept
{
    auto const asked = write_multiple_registers::request::make(first, values);
    if (not asked) { return asked.error(); }
    if (auto const fault = drives::check_write(table, first, values); not fault.ok()) { return fault; }
    return asked;
}

}  // namespace drivecodec::xd1000
