// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace drivecodec {

/// Why bytes, or a value, were refused. Every enumerator says what these did, not what the code did.
enum class errc : std::uint8_t {
    none = 0,
    truncated,             ///< The message is longer than the bytes given; `offset` is the least total length it needs.
    trailing_bytes,        ///< The message ends at `offset`, before the bytes do.
    bad_start,             ///< The message does not begin with its start character.
    bad_checksum,          ///< CRC or BCC does not match the bytes it covers.
    bad_length,            ///< A length or byte count contradicts the other fields, or the bytes that follow it.
    bad_quantity,          ///< A quantity is outside the limits of its function.
    bad_value,             ///< A field holds a value that the protocol does not allow.
    bad_address,           ///< An address does not exist, or the range that starts there passes the last one.
    reserved_address,      ///< An address that the protocol reserves: 248 to 255 in Modbus, 0 and 127 in FC.
    unexpected_function,   ///< A well-formed message, but not the one asked for.
    unsupported_function,  ///< A function (or its sub-function, or MEI type) that is not in the set.
    unexpected_server,     ///< A reply of another server, or slave, than the one asked.
    unexpected_reply,      ///< A reply that does not answer this request: the field at `offset` differs.
    exception_reply,       ///< The server refused: `offset` is the exception code, or the error number of FC.
    no_reply,              ///< To this request there is no reply: a broadcast, or a command to be silent.
    no_space,              ///< The output buffer is too small; nothing was written. `offset` is the size needed.
    read_only,             ///< A register or parameter that cannot be written.
    inexact,               ///< A value that its register or parameter has no digits for.
    out_of_range,          ///< A value outside the limits of its register or parameter, or of its type.
    unreachable,           ///< A state that no command leads to from here.
};

/// What went wrong, and at which byte of those the user gave; 0 where a value was refused that is no byte.
///
/// No text: the caller still holds the input, so the offending byte is `input[error.offset()]`. Words are in
/// <drivecodec/text/core.hpp>, which firmware may leave out. As the result of a check, `errc::none` means that
/// nothing is wrong. What the offset is for `truncated`, `no_space` and `exception_reply`, see there.
///
/// One 32-bit number, so that it comes back in a register: on a Cortex-M0 that saves a fifth of a server's code.
class error {
public:
    constexpr error() noexcept = default;

    /// Precondition: where < 65536.
    constexpr error(errc what, std::size_t where) noexcept
        : packed_{static_cast<std::uint32_t>(where) << code_bits | static_cast<std::uint32_t>(what)}
    {}

    [[nodiscard]] constexpr errc code() const noexcept { return static_cast<errc>(packed_ & ((1U << code_bits) - 1U)); }
    [[nodiscard]] constexpr std::uint16_t offset() const noexcept
    {
        return static_cast<std::uint16_t>(packed_ >> code_bits);
    }
    [[nodiscard]] constexpr bool ok() const noexcept { return packed_ == 0; }

    /// The same error, seen from an outer layer in which these bytes begin at `base`. An exception is nowhere.
    [[nodiscard]] constexpr error moved_by(std::size_t base) const noexcept
    {
        auto moved = *this;
        if (not ok() and code() != errc::exception_reply) {
            moved.packed_ += static_cast<std::uint32_t>(base) << code_bits;
        }
        return moved;
    }

    friend constexpr bool operator==(error, error) noexcept = default;

private:
    // As few as hold every errc: most errors are then a number below 256, which Thumb loads with one instruction.
    static constexpr unsigned code_bits = 5;

    std::uint32_t packed_ = 0;
};

}  // namespace drivecodec
