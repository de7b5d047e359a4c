// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/file_record_range.hpp>
#include <drivecodec/modbus/register_view.hpp>

namespace drivecodec::modbus {

/// Registers of a file with their values: one sub-request of Write File Record (21).
///
/// As on the wire: a `file_record_range`, then the values. There are as many values as the range has registers.
template <typename Values>
class basic_file_record {
public:
    consteval basic_file_record(int file, int record, Values values)
        requires fixed_size<Values>
        : range_{file, record, static_cast<int>(Values::size())}, values_{values}
    {}

    /// Errors: `bad_address`, `bad_quantity` at the field's offset in the sub-request.
    [[nodiscard]] static constexpr result<basic_file_record> make(std::uint16_t file, std::uint16_t record,
                                                                  Values values) noexcept
    {
        auto const range = file_record_range::make(file, record, static_cast<std::uint16_t>(values.size()));
        if (not range) { return range.error(); }
        return basic_file_record{*range, values};
    }

    [[nodiscard]] constexpr file_record_range range() const noexcept { return range_; }
    [[nodiscard]] constexpr Values const&     values() const noexcept { return values_; }

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        requires fixed_size<Values>
    {
        return head + Values::wire_size();
    }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
        requires(not fixed_size<Values>)
    {
        return head + values_.wire_size();
    }

    [[nodiscard]] static constexpr message_length length(bytes wire) noexcept
    {
        if (wire.size() < head) { return message_length::at_least(head); }
        return message_length::exactly(head + registers::wire_size(layout::file_record_range::length.load(wire)));
    }

    [[nodiscard]] static constexpr error check(bytes wire) noexcept
    {
        if (wire.size() < head) { return {errc::truncated, head + 2}; }
        auto const fault = file_record_range::check_fields(wire);
        return fault.ok() ? check_size(wire, length(wire).size()) : fault;
    }

    [[nodiscard]] static constexpr basic_file_record read(bytes wire) noexcept
    {
        return {file_record_range::read(wire), Values::of_wire(wire.subspan(head))};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        range_.write(out);
        values_.write(out.subspan(head));
    }

    friend constexpr bool operator==(basic_file_record const&, basic_file_record const&) noexcept = default;

private:
    static constexpr std::size_t head = file_record_range::wire_size();

    constexpr basic_file_record(file_record_range range, Values values) noexcept : range_{range}, values_{values} {}

    file_record_range range_;
    Values            values_;
};

using file_record = basic_file_record<register_view>;

}  // namespace drivecodec::modbus
