// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

namespace drivecodec::modbus {

// Declared, never defined, not constexpr: calling one is how a consteval constructor says no. The name, with its
// numbers, is the text the compiler prints.
namespace compile_error {
template <int Min, int Max>
void register_count_must_be_between();
template <int Min, int Max>
void coil_count_must_be_between();
void range_must_end_at_or_before_address_65535();
}  // namespace compile_error

/// What is addressed: how many bytes so many take on the wire and the other way round, and what the compiler says of a
/// wrong count.
struct registers {
    [[nodiscard]] static constexpr std::size_t wire_size(std::size_t count) noexcept { return 2 * count; }
    [[nodiscard]] static constexpr std::size_t max_count(std::size_t wire_bytes) noexcept { return wire_bytes / 2; }

    template <int Min, int Max>
    static constexpr void refuse_count()
    {
        compile_error::register_count_must_be_between<Min, Max>();
    }
};
/// Coils or discrete inputs: eight a byte.
struct coils {
    [[nodiscard]] static constexpr std::size_t wire_size(std::size_t count) noexcept { return (count + 7) / 8; }
    [[nodiscard]] static constexpr std::size_t max_count(std::size_t wire_bytes) noexcept { return wire_bytes * 8; }

    template <int Min, int Max>
    static constexpr void refuse_count()
    {
        compile_error::coil_count_must_be_between<Min, Max>();
    }
};

/// Addresses on the wire are counted from 0 ("40001" is address 0) and end at this one.
inline constexpr std::uint16_t last_address = 0xFFFF;

/// Is this a run of 1 to `max` addresses, none beyond 65535? One function for all ranges, for the sake of firmware.
///
/// Errors: `bad_quantity`, `bad_address`; the offset is 0 for the address and 2 for the count, as on the wire.
[[nodiscard]] constexpr error check_range(std::uint16_t first, std::uint16_t count, std::uint16_t max) noexcept
{
    if (count < 1 or count > max) { return {errc::bad_quantity, 2}; }
    return first + count > last_address + 1 ? error{errc::bad_address, 0} : error{};
}

/// A run of consecutive addresses: 1 to `Max` of them, none beyond 65535.
///
/// Every object satisfies that, so whatever takes one need not check it. Constants are checked by the compiler,
/// `register_range<125>{0x006B, 3}`; values known only at run time by `make`. A device that allows less than the
/// specification has its own `Max`.
template <typename Addressed, std::uint16_t Max>
class address_range {
public:
    using addressed = Addressed;

    static constexpr std::uint16_t max_count = Max;

    consteval address_range(int first, int count)
        : first_{static_cast<std::uint16_t>(first)}, count_{static_cast<std::uint16_t>(count)}
    {
        if (count < 1 or count > Max) { Addressed::template refuse_count<1, Max>(); }
        if (first < 0 or first + count > last_address + 1) {
            compile_error::range_must_end_at_or_before_address_65535();
        }
    }

    /// Errors: those of `check_range`.
    [[nodiscard]] static constexpr result<address_range> make(std::uint16_t first, std::uint16_t count) noexcept
    {
        if (auto const fault = check(first, count); not fault.ok()) { return fault; }
        return from_checked(first, count);
    }

    [[nodiscard]] static constexpr error check(std::uint16_t first, std::uint16_t count) noexcept
    {
        return check_range(first, count, Max);
    }

    /// Precondition: check(first, count).ok().
    [[nodiscard]] static constexpr address_range from_checked(std::uint16_t first, std::uint16_t count) noexcept
    {
        return address_range{first, count, checked{}};
    }

    [[nodiscard]] constexpr std::uint16_t first() const noexcept { return first_; }
    [[nodiscard]] constexpr std::uint16_t count() const noexcept { return count_; }

    friend constexpr bool operator==(address_range, address_range) noexcept = default;

private:
    struct checked {};
    constexpr address_range(std::uint16_t first, std::uint16_t count, checked) noexcept : first_{first}, count_{count}
    {}

    std::uint16_t first_;
    std::uint16_t count_;
};

template <std::uint16_t Max>
using register_range = address_range<registers, Max>;
template <std::uint16_t Max>
using coil_range = address_range<coils, Max>;

}  // namespace drivecodec::modbus
