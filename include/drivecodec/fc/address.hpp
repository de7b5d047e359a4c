// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

namespace drivecodec::fc {

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
void address_must_be_between_1_and_31_in_the_short_format();
void address_must_be_between_1_and_126_in_the_long_format();
void address_0_is_no_slave_a_broadcast_is_written_as_such();
}  // namespace compile_error

/// The manual's "address format 1-31" and "address format 1-126".
enum class address_format : std::uint8_t { short_1_to_31, long_1_to_126 };

/// ADR: which slave a telegram is for or from; a slave sends it back unchanged. VLT 6000 manual, "VLT frequency
/// converter address (ADR)".
///
///                  bit 7   bit 6      bit 5        bits 4 to 0
///     1 to 31      0       not used   1 broadcast  address, if no broadcast
///     1 to 126     1       address; 0 broadcast
///
/// 0 in the first format and 127 in the second are no address: refused, unless one says `from_byte`. Bit 6 of the first
/// format is never set here; what comes with it keeps it.
class address {
public:
    static constexpr std::uint8_t last_short = 31;
    static constexpr std::uint8_t last_long  = 126;

    [[nodiscard]] static consteval address short_format(long long number)
    {
        if (number == 0) { compile_error::address_0_is_no_slave_a_broadcast_is_written_as_such(); }
        if (number < 1 or number > last_short) {
            compile_error::address_must_be_between_1_and_31_in_the_short_format();
        }
        return address{static_cast<std::uint8_t>(number)};
    }

    [[nodiscard]] static consteval address long_format(long long number)
    {
        if (number == 0) { compile_error::address_0_is_no_slave_a_broadcast_is_written_as_such(); }
        if (number < 1 or number > last_long) { compile_error::address_must_be_between_1_and_126_in_the_long_format(); }
        return address{static_cast<std::uint8_t>(long_bit | static_cast<unsigned>(number))};
    }

    /// Of a number known only at run time. Errors: `reserved_address` at 0 for what the format does not have, and for 0.
    [[nodiscard]] static constexpr result<address> make(address_format format, std::uint8_t number) noexcept
    {
        auto const is_long = format == address_format::long_1_to_126;
        if (number == 0 or number > (is_long ? last_long : last_short)) { return error{errc::reserved_address, 0}; }
        return address{static_cast<std::uint8_t>(is_long ? long_bit | number : number)};
    }

    /// Of any byte, as it is on the wire.
    [[nodiscard]] static constexpr address from_byte(std::uint8_t adr) noexcept { return address{adr}; }

    [[nodiscard]] constexpr std::uint8_t byte() const noexcept { return byte_; }

    [[nodiscard]] constexpr address_format format() const noexcept
    {
        return is_long() ? address_format::long_1_to_126 : address_format::short_1_to_31;
    }

    /// To all slaves; none of them answers.
    [[nodiscard]] constexpr bool is_broadcast() const noexcept
    {
        return byte_ == long_bit or (byte_ & (long_bit | broadcast_bit)) == broadcast_bit;
    }

    /// Neither a slave nor a broadcast: 00h, 40h and FFh.
    [[nodiscard]] constexpr bool is_reserved() const noexcept
    {
        return (byte_ & ~unused_bit) == 0 or byte_ == (long_bit | (last_long + 1U));
    }

    /// The slave's number, as parameter 501 has it; 0 of a broadcast.
    [[nodiscard]] constexpr std::uint8_t number() const noexcept
    {
        if (is_broadcast()) { return 0; }
        return static_cast<std::uint8_t>(byte_ & (is_long() ? 0x7FU : 0x1FU));
    }

    /// By the byte: two formats of one number differ.
    friend constexpr bool operator==(address, address) noexcept = default;

private:
    static constexpr unsigned long_bit      = 0x80;
    static constexpr unsigned unused_bit    = 0x40;  // in the short format
    static constexpr unsigned broadcast_bit = 0x20;

    constexpr explicit address(std::uint8_t byte) noexcept : byte_{byte} {}

    [[nodiscard]] constexpr bool is_long() const noexcept { return (byte_ & long_bit) != 0; }

    std::uint8_t byte_;
};

inline constexpr address short_broadcast = address::from_byte(0x20);
inline constexpr address long_broadcast  = address::from_byte(0x80);

}  // namespace drivecodec::fc
