#pragma once

#include "support/verify.hpp"

#include <drivecodec/modbus/message.hpp>

#include <iomanip>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// What holds for every message, whatever its function: written for a message type whose type is erased, so that it
/// is compiled once and not once a type.
namespace properties {

using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;
using drivecodec::message_length;

using byte_vector = std::vector<std::uint8_t>;

/// A buffer of just this size: one byte beyond it is seen by the address sanitizer.
[[nodiscard]] inline byte_vector copy_of(bytes from) { return {from.begin(), from.end()}; }

[[nodiscard]] inline std::string to_hex(bytes from)
{
    std::ostringstream text;
    for (auto const byte : from) {
        text << std::setw(2) << std::setfill('0') << std::hex << std::uppercase << int{byte} << ' ';
    }
    return text.str();
}

struct message_type {
    std::uint8_t code;
    error (*check)(bytes) noexcept;
    message_length (*length)(bytes) noexcept;
    byte_vector (*recode)(bytes);  ///< Decodes, and encodes what was decoded. Precondition: check(pdu).ok().
};

template <typename T>
[[nodiscard]] byte_vector recode(bytes pdu)
{
    auto const decoded = drivecodec::decode<T>(pdu);
    if (not decoded) { return {}; }
    byte_vector out(decoded->wire_size());
    auto const  written = drivecodec::encode(*decoded, out);
    return written and written->size() == out.size() ? out : byte_vector{};
}

template <drivecodec::modbus::readable_message T>
[[nodiscard]] constexpr message_type type_of() noexcept
{
    return {static_cast<std::uint8_t>(T::function::code), T::check, T::length, recode<T>};
}

/// What encoding writes for a PDU that was decoded: the same, but for the unused bits of a request's last coils.
[[nodiscard]] inline byte_vector normalised(bytes pdu)
{
    auto wire = copy_of(pdu);
    if (wire.size() > 6 and wire[0] == 0x0F) {
        if (auto const used = wire[4] % 8; used != 0) {
            wire.back() = static_cast<std::uint8_t>(wire.back() & ((1U << used) - 1));
        }
    }
    return wire;
}

/// Whatever the bytes are: they are refused for a reason that fits them, or they are what encoding writes.
[[nodiscard]] inline testing::AssertionResult consistent(message_type const& type, bytes given)
{
    auto const exact  = copy_of(given);
    auto const pdu    = bytes{exact};
    auto const fault  = type.check(pdu);
    auto const length = type.length(pdu);
    auto const no     = [&](char const* what) {
        return testing::AssertionFailure() << what << ": error " << int(fault.code()) << " at " << fault.offset() << ", length "
                                           << length.size() << " of " << pdu.size() << ": " << to_hex(pdu);
    };

    if (length.is_impossible()) { return no("impossible"); }
    if (length.is_open() and length.size() <= pdu.size()) { return no("an open length that is already there"); }

    switch (fault.code()) {
    case errc::none:
        if (length.is_open()) { return no("valid, but of no known length"); }
        if (length.is_exact() and length.size() != pdu.size()) { return no("valid, but of another length"); }
        if (pdu.size() > drivecodec::modbus::max_pdu_size) { return no("valid, but too long"); }
        if (type.recode(pdu) != normalised(pdu)) { return no("encodes to other bytes"); }
        break;
    case errc::truncated:
        if (fault.offset() <= pdu.size()) { return no("truncated, but there"); }
        if (length.is_exact() and length.size() < fault.offset()) { return no("truncated beyond its length"); }
        break;
    case errc::trailing_bytes:
        if (fault.offset() >= pdu.size()) { return no("no byte trails"); }
        break;
    default:
        if (fault.offset() >= pdu.size()) { return no("wrong at a byte that is not there"); }
        break;
    }
    if (length.is_exact() and length.size() == pdu.size()
        and (fault.code() == errc::truncated or fault.code() == errc::trailing_bytes)) {
        return no("of just its length, but refused for it");
    }
    return testing::AssertionSuccess();
}

/// Once a prefix settles the length, more bytes do not change it.
[[nodiscard]] inline testing::AssertionResult length_settles(message_type const& type, bytes given)
{
    auto known = message_length::at_least(0);
    for (std::size_t size = 0; size <= given.size(); ++size) {
        auto const exact  = copy_of(given.first(size));
        auto const length = type.length(exact);
        if (not known.is_open() and length != known) {
            return testing::AssertionFailure() << "byte " << size << " changes the length: " << to_hex(given);
        }
        if (length.is_open() and length.size() < known.size()) {
            return testing::AssertionFailure() << "byte " << size << " makes the least length less: " << to_hex(given);
        }
        known = length;
    }
    return testing::AssertionSuccess();
}

/// Encodes `value` into a buffer of its size, refuses one byte less, and decodes it again: the same value.
template <typename T>
[[nodiscard]] testing::AssertionResult round_trips(T const& value)
{
    auto const  size = value.wire_size();
    byte_vector small(size - 1, 0xEE);
    if (auto const refused = drivecodec::encode(value, small);
        refused or refused.error() != error{errc::no_space, size} or small != byte_vector(size - 1, 0xEE)) {
        return testing::AssertionFailure() << "one byte less is not refused";
    }
    byte_vector wire(size + 1, 0xEE);
    auto const  written = drivecodec::encode(value, wire);
    if (not written or written->data() != wire.data() or written->size() != size or wire.back() != 0xEE) {
        return testing::AssertionFailure() << "does not write its size";
    }
    wire.pop_back();
    wire.shrink_to_fit();
    if (T::length(wire) != message_length::exactly(size) and not T::length(wire).is_until_silence()) {
        return testing::AssertionFailure() << "does not know its length: " << to_hex(wire);
    }
    auto const again = drivecodec::decode<T>(wire);
    if (not again) {
        return testing::AssertionFailure() << "is refused: " << int(again.error().code()) << " at " << again.error().offset()
                                           << ": " << to_hex(wire);
    }
    if (not(*again == value)) { return testing::AssertionFailure() << "becomes another value: " << to_hex(wire); }
    return testing::AssertionSuccess();
}

/// The wire form of any value, in a vector of just its size.
template <typename T>
[[nodiscard]] byte_vector wire_of(T const& value)
{
    byte_vector out(value.wire_size());
    EXPECT_TRUE(drivecodec::encode(value, out));
    return out;
}

}  // namespace properties
