#pragma once

#include "fuzz_common.hpp"
#include "modbus/rules.hpp"

#include <drivecodec/modbus/functions.hpp>

// What must hold between check, decode, encode and length of one message type, whatever the bytes.

namespace oracle {

namespace modbus = drivecodec::modbus;
using drivecodec::bytes;
using drivecodec::errc;
using drivecodec::error;

/// A fault names a byte of the input, or a size.
inline void check_fault(error fault, bytes wire)
{
    FUZZ_ASSERT(not fault.ok());
    switch (fault.code()) {
    case errc::truncated: FUZZ_ASSERT(fault.offset() > wire.size() and fault.offset() <= 256); break;
    case errc::bad_length:
    case errc::bad_quantity:
    case errc::bad_value:
    case errc::bad_address:
    case errc::bad_checksum:
    case errc::unexpected_function:
    case errc::unsupported_function:
    case errc::trailing_bytes: FUZZ_ASSERT(fault.offset() < wire.size()); break;
    default: FUZZ_ASSERT(fault.ok());  // an error that no check gives
    }
}

/// Exactly the wire form's size; one byte less is refused and touches nothing.
template <typename Message>
exact_buffer encode_exactly(Message const& message)
{
    auto const size = message.wire_size();
    FUZZ_ASSERT(size > 0 and size <= 256);

    exact_buffer const short_buffer{size - 1};
    for (auto& byte : short_buffer.get()) { byte = 0xA5; }
    auto const refused = drivecodec::encode(message, short_buffer.get());
    FUZZ_ASSERT(not refused and refused.error() == error{errc::no_space, size});
    for (auto const byte : short_buffer.get()) { FUZZ_ASSERT(byte == 0xA5); }

    exact_buffer buffer{size};
    auto const   written = drivecodec::encode(message, buffer.get());
    FUZZ_ASSERT(written and written->size() == size and written->data() == buffer.get().data());
    return buffer;
}

/// The truncations of any bytes: the least length only grows, and no fault but `truncated` is mended by more bytes.
template <typename Message>
void check_prefixes(bytes pdu)
{
    std::size_t needed   = 0;
    bool        is_final = false;  // refused, and not for want of bytes
    for (std::size_t size = 0; size <= pdu.size(); ++size) {
        auto const prefix = pdu.first(size);
        auto const fault  = Message::check(prefix);
        if (fault.ok()) {
            FUZZ_ASSERT(size >= needed);
            FUZZ_ASSERT(not is_final);
            continue;
        }
        check_fault(fault, prefix);
        if (fault.code() == errc::truncated) {
            FUZZ_ASSERT(not is_final);
            FUZZ_ASSERT(fault.offset() >= needed);
            needed = fault.offset();
        } else if (not rules::ends_with_silence(prefix)) {  // there an odd byte is an error, and the next one mends it
            is_final = true;
        }
    }
}

/// What the first bytes say of the length, of any bytes: it only becomes more exact.
template <typename Length>
void check_lengths(bytes pdu, Length length)
{
    auto const whole = length(pdu);
    for (std::size_t size = 0; size < pdu.size(); ++size) {
        auto const predicted = length(pdu.first(size));
        if (predicted.is_open()) {
            FUZZ_ASSERT(predicted.size() > size);
            FUZZ_ASSERT(not whole.is_exact() or predicted.size() <= whole.size());
            FUZZ_ASSERT(not whole.is_open() or predicted.size() <= whole.size());
        } else {
            FUZZ_ASSERT(predicted == whole);
        }
    }
    FUZZ_ASSERT(not whole.is_open() or whole.size() > pdu.size());
}

/// A PDU of this message's function. `is_valid` is what the rules say.
template <typename Message>
void check_message(bytes pdu, bool is_valid, bool is_request)
{
    auto const fault   = Message::check(pdu);
    auto const decoded = drivecodec::decode<Message>(pdu);
    FUZZ_ASSERT(fault.ok() == is_valid);
    FUZZ_ASSERT(decoded.has_value() == is_valid);

    check_prefixes<Message>(pdu);
    if (not is_valid) {
        FUZZ_ASSERT(decoded.error() == fault);
        return;
    }

    FUZZ_ASSERT(decoded->wire_size() == pdu.size());
    auto const encoded = encode_exactly(*decoded);
    for (std::size_t i = 0; i < pdu.size(); ++i) {
        FUZZ_ASSERT(encoded.get()[i] == rules::normal_byte(pdu, i, is_request));
    }
    auto const again = drivecodec::decode<Message>(bytes{encoded.get()});
    FUZZ_ASSERT(again and *again == *decoded);

    auto const length = Message::length(pdu);
    FUZZ_ASSERT(rules::ends_with_silence(pdu) ? length.is_until_silence() : length.is_exact() and length.size() == pdu.size());
    check_lengths(pdu, [](bytes front) { return Message::length(front); });

    if (rules::ends_with_silence(pdu)) { return; }
    for (std::size_t size = 0; size < pdu.size(); ++size) {
        auto const cut = Message::check(pdu.first(size));
        FUZZ_ASSERT(cut.code() == errc::truncated and cut.offset() <= pdu.size());
    }
    exact_buffer const longer{pdu.size() + 1};
    drivecodec::copy_bytes(pdu, longer.get());
    for (std::uint8_t const last : {std::uint8_t{0}, std::uint8_t{0xFF}, pdu[0]}) {
        longer.get()[pdu.size()] = last;
        FUZZ_ASSERT((Message::check(longer.get()) == error{errc::trailing_bytes, pdu.size()}));
    }
}

/// Calls `visit` with a null pointer to each function.
template <typename Visit, typename... Functions>
void for_each_function(modbus::function_set<Functions...> const*, Visit visit)
{
    (visit(static_cast<Functions const*>(nullptr)), ...);
}
template <typename Visit>
void for_each_function(Visit visit)
{
    for_each_function(static_cast<modbus::public_functions const*>(nullptr), visit);
}

/// Does the PDU begin as one of `Function`, by code and MEI type?
template <typename Function>
[[nodiscard]] bool is_of(bytes pdu)
{
    if (pdu.empty() or pdu[0] != modbus::to_byte(Function::code)) { return false; }
    if constexpr (requires { Function::mei; }) {
        return pdu.size() >= 2 and pdu[1] == static_cast<std::uint8_t>(Function::mei);
    }
    return true;
}

}  // namespace oracle
