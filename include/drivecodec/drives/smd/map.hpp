// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/smd/functions.hpp>

namespace drivecodec::smd {

namespace detail {

/// The three characters of a code as one number, to be searched by; 0 if it is none.
[[nodiscard]] constexpr std::uint32_t code_key(std::string_view code) noexcept
{
    if (code.size() != 3) { return 0; }
    auto const letter = [&](std::size_t at) {
        return static_cast<std::uint32_t>(static_cast<unsigned char>(code[at]));
    };
    return letter(0) << 16 | letter(1) << 8 | letter(2);
}

/// Where the row of a code is in `table<Version>`.
struct code_place {
    std::uint32_t key;
    std::uint16_t index;
};

template <version Version>
inline constexpr std::size_t code_count = [] {
    std::size_t count = 0;
    for (auto const& row : table<Version>) { count += row.code.empty() ? 0U : 1U; }
    return count;
}();

/// In ascending order of the codes, which is not that of the addresses.
template <version Version>
inline constexpr std::array<code_place, code_count<Version>> code_places = [] {
    std::array<code_place, code_count<Version>> places{};
    std::size_t                                 count = 0;
    for (std::size_t index = 0; index < table<Version>.size(); ++index) {
        auto const key = code_key(table<Version>[index].code);
        if (key == 0) { continue; }
        auto at = count++;
        for (; at > 0 and places[at - 1].key > key; --at) { places[at] = places[at - 1]; }
        places[at] = {key, static_cast<std::uint16_t>(index)};
    }
    return places;
}();

static_assert(strictly_ascending(code_places<pv400>, &code_place::key));
static_assert(strictly_ascending(code_places<pv507>, &code_place::key));

template <version Version>
[[nodiscard]] constexpr drives::register_row const* find(std::uint16_t address) noexcept
{
    return drives::find(table<Version>, address);
}
template <version Version>
[[nodiscard]] constexpr drives::register_row const* find(std::string_view word) noexcept
{
    if (auto const key = code_key(word); key != 0) {
        auto const* place = find_row(code_places<Version>, &code_place::key, key);
        return place != nullptr ? &table<Version>[place->index] : nullptr;
    }
    return drives::find(table<Version>, word);
}

}  // namespace detail

/// The registers of a drive whose version is known only at run time.
class map {
public:
    constexpr map(smd::version which) noexcept : version_{which} {}

    /// Of what the drive has in register 50. Errors: `bad_value` at 0 for a version that the manual does not have:
    /// there is no map then, and nothing must be written to that drive.
    [[nodiscard]] static constexpr result<map> make(std::uint16_t register_50) noexcept
    {
        auto const which = make_version(register_50);
        if (not which) { return which.error(); }
        return map{*which};
    }

    [[nodiscard]] constexpr smd::version version() const noexcept { return version_; }

    /// The register with this address, or nullptr.
    [[nodiscard]] constexpr drives::register_row const* find(std::uint16_t address) const noexcept
    {
        return version_ == pv400 ? detail::find<pv400>(address) : detail::find<pv507>(address);
    }
    /// The register with this code ("C12"; C01 is not c01) or name ("acceleration_time"), or nullptr.
    [[nodiscard]] constexpr drives::register_row const* find(std::string_view word) const noexcept
    {
        return version_ == pv400 ? detail::find<pv400>(word) : detail::find<pv507>(word);
    }

    //=== requests. Errors are of the register, at 0: `bad_address` if the version lacks it ===//

    /// All that can be read there at once may be asked for, or one register. Errors: `bad_quantity` for any other
    /// count; `bad_address` also for a register that can only be written.
    [[nodiscard]] constexpr result<read_holding_registers::request> make_read(std::uint16_t address,
                                                                              std::uint16_t count = 1) const noexcept
    {
        auto const* row = find(address);
        if (row == nullptr or not row->is_readable()) { return error{errc::bad_address, 0}; }
        auto const is_text = row->type == drives::raw_type::text;
        if (count == software_version_words and not is_text) { return error{errc::bad_quantity, 0}; }
        auto const range = read_range::make(address, count);
        if (not range) { return error{errc::bad_quantity, 0}; }
        return read_holding_registers::request{.range = *range};
    }

    /// May these 16 bits be written there? Errors: `read_only`, `out_of_range`.
    [[nodiscard]] constexpr error check_write(std::uint16_t address, std::uint16_t raw) const noexcept
    {
        auto const* row = find(address);
        return row != nullptr ? row->check_write(raw) : error{errc::bad_address, 0};
    }

    /// Errors: those of `check_write`.
    [[nodiscard]] constexpr result<write_single_register::request> make_write(std::uint16_t address,
                                                                              std::uint16_t raw) const noexcept
    {
        if (auto const fault = check_write(address, raw); not fault.ok()) { return fault; }
        return write_single_register::request{.address = address, .value = raw};
    }

    /// A physical value, in the unit of the register: 5.0 of "C12" are five seconds. Errors: those of `check_write`;
    /// `inexact` for more digits than the register has.
    [[nodiscard]] constexpr result<write_single_register::request> make_write(std::string_view word,
                                                                              decimal          value) const noexcept
    {
        auto const* row = find(word);
        if (row == nullptr) { return error{errc::bad_address, 0}; }
        if (not row->is_writable()) { return error{errc::read_only, 0}; }
        auto const raw = row->make_raw(value);
        if (not raw) { return raw.error(); }
        return write_single_register::request{.address = row->address, .value = *raw};
    }

    friend constexpr bool operator==(map, map) noexcept = default;

private:
    smd::version version_;
};

}  // namespace drivecodec::smd
