// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/bounded.hpp>
#include <drivecodec/modbus/file_record_range.hpp>
#include <drivecodec/modbus/register_view.hpp>

namespace drivecodec::modbus {

namespace layout::file_values {  // | length | reference type | values ...
inline constexpr u8_at<0>    length{};  // of all that follows it, in bytes: odd, at least 3
inline constexpr u8_at<1>    reference_type{};
inline constexpr std::size_t values = reference_type.end;
}  // namespace layout::file_values

/// The registers of one range of a file: one sub-response of Read File Record (20).
struct file_values {
    using bounded_values = bounded<register_view, 1, file_record_range::max_length>;

    bounded_values values;

    /// Errors: `bad_quantity` at the length.
    [[nodiscard]] static constexpr result<file_values> make(register_view values_to_send) noexcept
    {
        if (not bounded_values::fits(values_to_send.size())) { return error{errc::bad_quantity, 0}; }
        return file_values{.values = bounded_values::from_checked(values_to_send)};
    }

    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
    {
        return layout::file_values::values + values.wire_size();
    }

    [[nodiscard]] static constexpr message_length length(bytes wire) noexcept
    {
        namespace at = layout::file_values;
        if (wire.empty()) { return message_length::at_least(at::length.end); }
        return message_length::exactly(std::size_t{at::length.end} + at::length.load(wire));
    }

    [[nodiscard]] static constexpr error check(bytes wire) noexcept
    {
        namespace at = layout::file_values;
        if (wire.empty()) { return {errc::truncated, at::values + 2}; }
        std::size_t const size = at::length.load(wire);
        if (size % 2 == 0) { return {errc::bad_length, at::length.begin}; }
        if (not bounded_values::fits(size / 2)) { return {errc::bad_quantity, at::length.begin}; }
        if (auto const fault = check_size(wire, at::length.end + size); not fault.ok()) { return fault; }
        auto const is_known = at::reference_type.load(wire) == file_reference_type;
        return is_known ? error{} : error{errc::bad_value, at::reference_type.begin};
    }

    [[nodiscard]] static constexpr file_values read(bytes wire) noexcept
    {
        auto const values = register_view::of_wire(wire.subspan(layout::file_values::values));
        return {.values = bounded_values::from_checked(values)};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::file_values;
        at::length.store(out, static_cast<std::uint8_t>(wire_size() - at::length.end));
        at::reference_type.store(out, file_reference_type);
        values.write(out.subspan(at::values));
    }

    friend constexpr bool operator==(file_values const&, file_values const&) noexcept = default;
};

}  // namespace drivecodec::modbus
