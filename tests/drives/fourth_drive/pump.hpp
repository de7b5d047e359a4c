#pragma once

// A drive that does not exist, added as the README says, "Adding a drive", with public headers only.

#include <drivecodec/core/word.hpp>
#include <drivecodec/drives/register_group.hpp>
#include <drivecodec/modbus/function_set.hpp>
#include <drivecodec/text/drives/code.hpp>
#include <drivecodec/text/drives/register_row.hpp>

namespace pump {

using namespace drivecodec;

// Step 1: what is no number has a type.

enum class mode : std::uint16_t { off, by_hand, by_level };
inline constexpr std::array<std::uint16_t, 3> mode_codes{0, 1, 2};

struct status_word : word<status_word, std::uint16_t> {
    static constexpr flag<status_word> running{0};
    static constexpr flag<status_word> dry{3};
};

// Step 2: the table.

inline constexpr drives::register_table<6> table = [] {
    using enum drives::access;
    using enum drives::raw_type;
    using enum drives::source;
    return drives::register_table<6>{{
        {.address = 100, .name = "status", .code = "STA", .type = bits, .access = read_only, .access_from = manual},
        {.address    = 101,
         .name       = "actual_speed",
         .type       = signed_number,
         .exponent   = -1,
         .unit       = unit::hertz,
         .scale_from = manual,
         .limits     = drives::no_limits_signed,
         .access     = read_only},
        {.address         = 200,
         .name            = "speed_reference",
         .menu            = "2.0",
         .code            = "REF",
         .exponent        = -1,
         .unit            = unit::hertz,
         .scale_from      = manual,
         .limits          = {0, 600, manual},
         .factory_setting = {500, manual},
         .access          = read_write,
         .access_from     = manual},
        {.address = 201,
         .name    = "mode",
         .menu    = "2.1",
         .type    = enumeration,
         .limits  = {0, 2, manual},
         .access  = read_write,
         .choices = mode_codes},
        {.address = 202, .name = "reserve", .menu = "2.2"},
        {.address = 203, .name = "reserve", .menu = "2.3", .access = panel_only},
    }};
}();
static_assert(strictly_ascending(table, &drives::register_row::address));

// Step 3: its functions, with their limits, and the registers by name.

using read_holding_registers   = modbus::basic_read_holding_registers<4>;
using write_single_register    = modbus::write_single_register;
using write_multiple_registers = modbus::basic_write_multiple_registers<2>;
using functions = modbus::function_set<read_holding_registers, write_single_register, write_multiple_registers>;

template <std::uint16_t Address, typename Value = drives::number_in<table, Address>>
using holding_register = drives::holding_register<table, Address, read_holding_registers, Value>;

inline constexpr holding_register<100, status_word> status{};
inline constexpr holding_register<101>              actual_speed{};
inline constexpr holding_register<200>              speed_reference{};
inline constexpr holding_register<201, pump::mode>  operating_mode{};
inline constexpr holding_register<203>              reserve_of_the_panel{};

template <auto... Registers>
using registers = drives::register_group<read_holding_registers, write_multiple_registers, Registers...>;

// Step 4: lookups, for what is known only at run time.

[[nodiscard]] constexpr drives::register_row const* find(std::uint16_t address) noexcept
{
    return drives::find(table, address);
}
[[nodiscard]] constexpr drives::register_row const* find(std::string_view word) noexcept
{
    return drives::find(table, word);
}

// Step 5: words.

[[nodiscard]] constexpr std::string_view to_string(mode code) noexcept
{
    switch (code) {
    case mode::off: return "off";
    case mode::by_hand: return "by_hand";
    case mode::by_level: return "by_level";
    }
    return {};
}

constexpr void write_text(text_writer& out, status_word given) noexcept
{
    out.put(given.test(status_word::running) ? "running" : "stopped");
    if (given.test(status_word::dry)) { out.put(" dry"); }
}

constexpr void write_text(text_writer& out, std::uint16_t address, std::uint16_t raw) noexcept
{
    auto const* row = find(address);
    if (row == nullptr) { return drives::write_unknown_register(out, address, raw); }
    out.put(drives::title(*row)).put(' ');
    if (address == status.address()) { return drives::write_meaning(out, status.value(raw)); }
    if (address == operating_mode.address()) { return drives::write_meaning(out, operating_mode.value(raw)); }
    drives::write_value(out, *row, raw);
}

}  // namespace pump
