// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/codec.hpp>
#include <drivecodec/modbus/address_range.hpp>

namespace drivecodec::modbus {

/// `Values` (a view or an array of registers or coils) of which there are `Min` to `Max`.
///
/// Every object satisfies that. An array is checked by the compiler, a view by `make`.
template <typename Values, std::uint16_t Min, std::uint16_t Max>
class bounded : public Values {
public:
    using values_type = Values;

    static constexpr std::uint16_t min_count = Min;
    static constexpr std::uint16_t max_count = Max;

    consteval bounded(Values values)
        requires fixed_size<Values>
        : Values{values}
    {
        if (Values::size() < Min or Values::size() > Max) { Values::addressed::template refuse_count<Min, Max>(); }
    }

    /// Errors: `bad_quantity` at 0.
    [[nodiscard]] static constexpr result<bounded> make(Values values) noexcept
    {
        if (not fits(values.size())) { return error{errc::bad_quantity, 0}; }
        return from_checked(values);
    }

    [[nodiscard]] static constexpr bool fits(std::size_t count) noexcept { return count >= Min and count <= Max; }

    /// Precondition: fits(values.size()).
    [[nodiscard]] static constexpr bounded from_checked(Values const& values) noexcept
    {
        return bounded{values, checked{}};
    }

    /// The same without the promise.
    [[nodiscard]] constexpr Values const& values() const noexcept { return *this; }

    friend constexpr bool operator==(bounded const& a, bounded const& b) noexcept { return a.values() == b.values(); }

private:
    struct checked {};
    constexpr bounded(Values const& values, checked) noexcept : Values{values} {}
};

/// Values for a run of consecutive addresses from `first` on: 1 to `Max` of them, none beyond 65535.
///
/// Every object satisfies that. With an array of values it is checked by the compiler, with a view by `make`.
template <typename Values, std::uint16_t Max>
class address_block {
public:
    static constexpr std::uint16_t max_count = Max;

    using range_type = address_range<typename Values::addressed, Max>;

    consteval address_block(int first, Values values)
        requires fixed_size<Values>
        : first_{range_type{first, static_cast<int>(Values::size())}.first()}, values_{values}
    {}

    /// Errors: `bad_quantity` at 2, `bad_address` at 0, as on the wire.
    [[nodiscard]] static constexpr result<address_block> make(std::uint16_t first, Values values) noexcept
    {
        if (values.size() > Max) { return error{errc::bad_quantity, 2}; }
        auto const fault = range_type::check(first, static_cast<std::uint16_t>(values.size()));
        if (not fault.ok()) { return fault; }
        return from_checked(first, values);
    }

    /// Precondition: range_type::check(first, values.size()).ok().
    [[nodiscard]] static constexpr address_block from_checked(std::uint16_t first, Values const& values) noexcept
    {
        return address_block{first, values, checked{}};
    }

    /// The same with `count` values in `wire`.
    [[nodiscard]] static constexpr address_block of_wire(std::uint16_t first, bytes wire, std::uint16_t count) noexcept
    {
        return {first, wire, count};
    }

    [[nodiscard]] constexpr std::uint16_t first() const noexcept { return first_; }
    [[nodiscard]] constexpr std::uint16_t count() const noexcept { return static_cast<std::uint16_t>(values_.size()); }
    [[nodiscard]] constexpr Values const& values() const noexcept { return values_; }
    [[nodiscard]] constexpr range_type    range() const noexcept { return range_type::from_checked(first(), count()); }

    friend constexpr bool operator==(address_block const&, address_block const&) noexcept = default;

private:
    struct checked {};
    constexpr address_block(std::uint16_t first, Values const& values, checked) noexcept
        : first_{first}, values_{values}
    {}

    constexpr address_block(std::uint16_t first, bytes wire, std::uint16_t count) noexcept
        : first_{first}, values_{Values::of_wire(wire, count)}
    {}

    std::uint16_t first_;
    Values        values_;
};

}  // namespace drivecodec::modbus
