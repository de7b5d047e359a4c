// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/crc16.hpp>
#include <drivecodec/modbus/message.hpp>
#include <drivecodec/modbus/rtu/address.hpp>

// The RTU frame: | server address | PDU ... | CRC lo hi |. MODBUS over Serial Line V1.02, 2.5.1.

namespace drivecodec::modbus::rtu {

namespace layout::adu {
inline constexpr u8_at<0>    address{};
inline constexpr std::size_t pdu      = address.end;
inline constexpr std::size_t crc_size = 2;
inline constexpr std::size_t around   = pdu + crc_size;  // the bytes that are not the PDU's
}  // namespace layout::adu

inline constexpr std::size_t min_adu_size = layout::adu::around + 1;
inline constexpr std::size_t max_adu_size = layout::adu::around + max_pdu_size;

/// The PDU in a whole frame. Precondition: adu.size() >= min_adu_size.
[[nodiscard]] constexpr bytes pdu_of(bytes adu) noexcept
{
    return adu.subspan(layout::adu::pdu, adu.size() - layout::adu::around);
}

/// The PDU in what may be a frame; nothing if it is too short to have one.
[[nodiscard]] constexpr bytes pdu_or_nothing(bytes adu) noexcept
{
    return adu.size() < min_adu_size ? bytes{} : pdu_of(adu);
}

/// Does the frame end with the CRC of what is before it? Precondition: adu.size() >= 2.
template <crc16::algorithm Crc = crc16::by_default>
[[nodiscard]] constexpr bool has_valid_crc(bytes adu) noexcept
{
    return crc16::compute<Crc>(adu) == crc16::residue;
}

/// Puts the CRC into the last two bytes. Precondition: adu.size() >= 2.
template <crc16::algorithm Crc = crc16::by_default>
constexpr void write_crc(mutable_bytes adu) noexcept
{
    auto const covered = adu.size() - layout::adu::crc_size;
    auto const crc     = crc16::compute<Crc>(adu.first(covered));
    u8_at<0>::store(adu.subspan(covered), static_cast<std::uint8_t>(crc));
    u8_at<1>::store(adu.subspan(covered), static_cast<std::uint8_t>(crc >> 8));
}

/// What is wrong with a frame, of which `pdu_fault` tells what is wrong with its PDU: what a longer frame would mend,
/// then what the line has damaged, then another address than `address`, then what the other side has sent wrongly.
/// Of a frame without a PDU that is an empty one's: `truncated`.
template <crc16::algorithm Crc>
[[nodiscard]] constexpr error check_adu(bytes adu, std::uint8_t address, error pdu_fault) noexcept
{
    if (pdu_fault.code() == errc::truncated) { return pdu_fault.moved_by(layout::adu::around); }
    if (adu.size() > max_adu_size) { return {errc::trailing_bytes, max_adu_size}; }
    if (not has_valid_crc<Crc>(adu)) { return {errc::bad_checksum, adu.size() - layout::adu::crc_size}; }
    if (layout::adu::address.load(adu) != address) { return {errc::unexpected_server, layout::adu::address.begin}; }
    return pdu_fault.moved_by(layout::adu::pdu);
}

/// A message to or from a server, as a frame: a request, a response, an exception, or a `raw_pdu`.
///
/// `check` tells apart what a longer frame would mend (`truncated`), what the line has damaged (`bad_checksum`), and
/// what the other side has sent wrongly (the errors of the message).
template <framable Message, crc16::algorithm Crc = crc16::by_default>
struct adu {
    server_address address;
    Message        message;

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        requires fixed_size<Message>
    {
        return layout::adu::around + Message::wire_size();
    }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
        requires(not fixed_size<Message>)
    {
        return layout::adu::around + message.wire_size();
    }

    [[nodiscard]] static constexpr error check(bytes wire) noexcept
    {
        // The address may be any, so it is compared with itself.
        auto const address = wire.empty() ? std::uint8_t{0} : layout::adu::address.load(wire);
        return check_adu<Crc>(wire, address, Message::check(pdu_or_nothing(wire)));
    }

    [[nodiscard]] static constexpr adu read(bytes wire) noexcept
    {
        return {server_address::reserved(layout::adu::address.load(wire)), Message::read(pdu_of(wire))};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        layout::adu::address.store(out, address.byte());
        message.write(out.subspan(layout::adu::pdu, out.size() - layout::adu::around));
        write_crc<Crc>(out);
    }

    friend constexpr bool operator==(adu const&, adu const&) noexcept = default;
};

//=== the gates ===//

/// The frame of a message whose size the compiler knows. Cannot fail; a constant one is built by the compiler.
template <crc16::algorithm Crc = crc16::by_default, framable Message>
    requires fixed_size<Message>
[[nodiscard]] constexpr auto encode(server_address address, Message const& message) noexcept
{
    static_assert(Message::wire_size() <= max_pdu_size, "no PDU is longer than 253 bytes");
    return drivecodec::encode(adu<Message, Crc>{address, message});
}

/// Writes the frame to the front of `out`; returns the part written.
///
/// Errors, and then `out` is untouched: `no_space`; `bad_length` for a user's message that is longer than a PDU.
template <crc16::algorithm Crc = crc16::by_default, framable Message>
[[nodiscard]] constexpr result<mutable_bytes> encode(server_address address, Message const& message,
                                                     mutable_bytes out) noexcept
{
    if (message.wire_size() > max_pdu_size) { return error{errc::bad_length, layout::adu::pdu}; }
    return drivecodec::encode(adu<Message, Crc>{address, message}, out);
}

/// To all servers, none of which answers: only what writes.
template <crc16::algorithm Crc = crc16::by_default, message Message>
    requires fixed_size<Message>
[[nodiscard]] constexpr auto encode(broadcast_address address, Message const& message) noexcept
{
    static_assert(is_write<typename Message::function>(), "only a write can be broadcast: nobody answers a broadcast");
    return encode<Crc>(server_address{address}, message);
}
template <crc16::algorithm Crc = crc16::by_default, message Message>
[[nodiscard]] constexpr result<mutable_bytes> encode(broadcast_address address, Message const& message,
                                                     mutable_bytes out) noexcept
{
    static_assert(is_write<typename Message::function>(), "only a write can be broadcast: nobody answers a broadcast");
    return encode<Crc>(server_address{address}, message, out);
}

/// The message that the frame `wire` holds, and its address. Views inside it point into `wire`.
///
/// Errors: those of `adu::check`.
template <codec Message, crc16::algorithm Crc = crc16::by_default>
[[nodiscard]] constexpr result<adu<Message, Crc>> decode(bytes wire) noexcept
{
    return drivecodec::decode<adu<Message, Crc>>(wire);
}

/// Refused: a message that borrows its bytes would outlive them. Name the buffer first.
template <codec Message, crc16::algorithm Crc = crc16::by_default, owning_temporary Temporary>
    requires(framable<Message> and not fixed_size<Message>)
result<adu<Message, Crc>> decode(Temporary&&) = delete;

}  // namespace drivecodec::modbus::rtu
