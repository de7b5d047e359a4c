#pragma once

// The rules of the FC protocol a second time, in the plainest form: what the fuzzers compare the library with.

#include "fc/repair_bcc.hpp"
#include "fuzz_common.hpp"

#include <drivecodec/core/bytes.hpp>
#include <drivecodec/core/error.hpp>

#include <algorithm>
#include <optional>

namespace rules {

using drivecodec::bytes;
using drivecodec::errc;

//=== fields ===//

[[nodiscard]] inline unsigned word_at(bytes wire, std::size_t at)
{
    return wire[at] * 256U + wire[at + 1];
}

/// STX, LGE and ADR before the data, BCC behind them. Precondition: a whole telegram.
[[nodiscard]] inline bytes data_of(bytes telegram)
{
    return telegram.subspan(3, telegram.size() - 4);
}
[[nodiscard]] inline unsigned ak_of(bytes data)
{
    return data[0] / 16U;
}
[[nodiscard]] inline unsigned number_of(bytes data, bool has_12_bits)
{
    return word_at(data, 0) % (has_12_bits ? 4096U : 2048U);
}
[[nodiscard]] inline std::uint32_t pwe_of(bytes data)
{
    return static_cast<std::uint32_t>(word_at(data, 4)) << 16 | word_at(data, 6);
}

[[nodiscard]] inline bool is_broadcast(unsigned adr)
{
    return adr == 0x80 or (adr < 0x80 and (adr & 0x20) != 0);
}
/// 0 and 127, which no slave has, and which are no broadcast.
[[nodiscard]] inline bool is_reserved(unsigned adr)
{
    return adr == 0x00 or adr == 0x40 or adr == 0xFF;
}
[[nodiscard]] inline unsigned slave_of(unsigned adr)
{
    if (is_broadcast(adr)) { return 0; }
    return adr < 0x80 ? adr % 32 : adr - 0x80;
}

[[nodiscard]] inline bool is_same(bytes a, bytes b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

//=== what is wrong ===//

struct fault {
    errc        code   = errc::none;
    std::size_t offset = 0;

    friend bool operator==(fault const&, fault const&) = default;
};

/// With a telegram of `least` to `most` data bytes, whatever they are.
[[nodiscard]] inline fault fault_of(bytes wire, std::size_t least, std::size_t most)
{
    if (wire.empty()) { return {errc::truncated, least + 4}; }
    if (wire[0] != 0x02) { return {errc::bad_start, 0}; }
    if (wire.size() == 1) { return {errc::truncated, least + 4}; }
    auto const whole = wire[1] + std::size_t{2};
    if (whole < least + 4 or whole > most + 4) { return {errc::bad_length, 1}; }
    if (wire.size() < whole) { return {errc::truncated, whole}; }
    if (wire.size() > whole) { return {errc::trailing_bytes, whole}; }
    if (not has_reference_bcc(wire)) { return {errc::bad_checksum, whole - 1}; }
    return is_reserved(wire[2]) ? fault{errc::reserved_address, 2} : fault{};
}

[[nodiscard]] inline bool is_telegram(bytes wire)
{
    return fault_of(wire, 0, 252).code == errc::none;
}

//=== values ===//

/// The number of 8, 16 or 32 bits that `data` bring in PWE, if AK tells of one that wide.
[[nodiscard]] inline std::optional<long long> value_of(bytes data, bool is_request, bool is_signed, int bits)
{
    auto const ak      = ak_of(data);
    auto const is_word = is_request ? ak == 0x2 or ak == 0xE : ak == 0x1;
    auto const is_long = is_request ? ak == 0x3 or ak == 0xD : ak == 0x2;
    if (not(bits == 32 ? is_long : is_word)) { return {}; }
    long long  number  = bits == 32 ? pwe_of(data) : word_at(data, 6);
    auto const turning = bits == 32 ? 0x8000'0000LL : 0x8000LL;
    if (is_signed and number >= turning) { number -= 2 * turning; }
    // A word has nothing above it, or its sign.
    if (bits != 32 and word_at(data, 4) != 0 and not(word_at(data, 4) == 0xFFFF and number < 0)) { return {}; }
    if (bits == 8 and (is_signed ? number < -128 or number > 127 : number > 255)) { return {}; }
    return number;
}

//=== replies ===//

/// May a reply with this AK answer a command with that one?
[[nodiscard]] inline bool answers(unsigned reply, unsigned command)
{
    switch (command) {
    case 0x0: return reply == 0x0;
    case 0x1: return reply == 0x1 or reply == 0x2;
    case 0x2:
    case 0xE: return reply == 0x1;
    case 0x3:
    case 0xD: return reply == 0x2;
    case 0x4: return reply == 0x3;
    case 0xF: return reply == 0xF;
    default: return reply != 0xF;  // a command without a meaning
    }
}

}  // namespace rules
