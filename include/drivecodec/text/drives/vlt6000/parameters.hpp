// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/drives/vlt6000/parameters.hpp>
#include <drivecodec/text/drives/code.hpp>
#include <drivecodec/text/drives/vlt6000/choices.hpp>
#include <drivecodec/text/drives/vlt6000/digital_inputs.hpp>
#include <drivecodec/text/drives/vlt6000/parameter_row.hpp>
#include <drivecodec/text/drives/vlt6000/words.hpp>

namespace drivecodec::vlt6000 {

/// A parameter and what PWE brings of it, as a log sees them.
struct parameter_value {
    std::uint16_t number;
    std::uint32_t pwe;
};

/// `202 output_frequency_high_limit`, `103`: the number, and the name if the manual has one.
constexpr void write_title(text_writer& out, std::uint16_t number) noexcept
{
    out.decimal(number);
    if (auto const* row = find(number); row != nullptr and not row->name.empty()) { out.put(' ').put(row->name); }
}

namespace detail {

/// The value of one parameter that has a type of its own; returns whether it is that.
template <int Number>
[[nodiscard]] constexpr bool write_typed_value(text_writer& out, parameter_value given) noexcept
{
    using value_type = typename decltype(parameter<Number>)::value_type;
    if (given.number != Number) { return false; }
    if constexpr (std::is_enum_v<value_type>) {
        if (given.pwe > 0xFFFF) {
            out.decimal(given.pwe);
        } else {
            drives::write_code(out, static_cast<value_type>(given.pwe));
        }
        return true;
    } else {
        if (given.pwe > std::numeric_limits<typename value_type::raw_type>::max()) { return false; }
        write_text(out, value_type::from_raw(static_cast<typename value_type::raw_type>(given.pwe)));
        return true;
    }
}

template <int... Numbers>
[[nodiscard]] constexpr bool write_one_of(text_writer& out, parameter_value given) noexcept
{
    return (write_typed_value<Numbers>(out, given) or ...);
}

}  // namespace detail

/// `202 output_frequency_high_limit 100.0 Hz`, `505 start logic_or`, `527 status_word STW 0F03 serial_control ...`. Of a
/// number whose scale the manual does not state, what was transferred: `207 ramp_down_time 100`.
constexpr void write_text(text_writer& out, parameter_value given) noexcept
{
    write_title(out, given.number);
    out.put(' ');
    if (detail::write_one_of<1, 7, 415, 500, 502, 503, 504, 505, 506, 507, 508, 521, 527, 529, 530, 531, 532, 556>(
            out, given)) {
        return;
    }
    if (auto const* row = find(given.number)) {
        write_value(out, *row, given.pwe);
    } else {
        out.decimal(given.pwe);
    }
}

}  // namespace drivecodec::vlt6000
