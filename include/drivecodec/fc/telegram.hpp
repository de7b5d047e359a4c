// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/codec.hpp>
#include <drivecodec/fc/address.hpp>
#include <drivecodec/fc/bcc.hpp>

// The telegram: | STX | LGE | ADR | data ... | BCC |. VLT 6000 manual, "Telegram build-up under FC protocol".

namespace drivecodec::fc {

namespace layout::telegram {
inline constexpr u8_at<0>    stx{};
inline constexpr u8_at<1>    lge{};
inline constexpr u8_at<2>    adr{};
inline constexpr std::size_t data          = adr.end;
inline constexpr std::size_t bcc_size      = 1;
inline constexpr std::size_t around        = data + bcc_size;  // the bytes that are not data
inline constexpr std::size_t not_in_lge    = lge.end;          // LGE counts from ADR to BCC
inline constexpr std::size_t counted_extra = around - not_in_lge;
}  // namespace layout::telegram

/// The start character.
inline constexpr std::uint8_t stx = 0x02;

inline constexpr std::size_t max_telegram_size = 256;  ///< LGE is at most 254, says the USS specification.
inline constexpr std::size_t max_data_size     = max_telegram_size - layout::telegram::around;

/// The data in a whole telegram. Precondition: telegram.size() >= 4.
[[nodiscard]] constexpr bytes data_of(bytes telegram) noexcept
{
    return {telegram.data() + layout::telegram::data, telegram.size() - layout::telegram::around};
}

/// What is wrong with `wire` as a telegram of `least` to `most` data bytes, whatever they say: in wire order, and the
/// address last, since only a right BCC makes it one.
///
/// Errors: `truncated`; `bad_start` at 0; `bad_length` at 1; `trailing_bytes`; `bad_checksum` at the BCC;
/// `reserved_address` at 2.
[[nodiscard]] constexpr error check_telegram(bytes wire, std::size_t least, std::size_t most) noexcept
{
    namespace at = layout::telegram;
    if (not wire.empty() and at::stx.load(wire) != stx) { return {errc::bad_start, at::stx.begin}; }
    if (wire.size() < at::lge.end) { return {errc::truncated, least + at::around}; }
    std::size_t const lge = at::lge.load(wire);
    if (lge < least + at::counted_extra or lge > most + at::counted_extra) { return {errc::bad_length, at::lge.begin}; }
    auto const size = lge + at::not_in_lge;
    if (wire.size() < size) { return {errc::truncated, size}; }
    if (wire.size() > size) { return {errc::trailing_bytes, size}; }
    if (bcc::of(wire) != 0) { return {errc::bad_checksum, size - at::bcc_size}; }
    if (address::from_byte(at::adr.load(wire)).is_reserved()) { return {errc::reserved_address, at::adr.begin}; }
    return {};
}

/// Puts STX, LGE, ADR and BCC around data that are already there. Precondition: 4 <= out.size() <= 256.
constexpr void seal(mutable_bytes out, address to) noexcept
{
    namespace at    = layout::telegram;
    auto const last = out.size() - at::bcc_size;
    at::stx.store(out, stx);
    at::lge.store(out, static_cast<std::uint8_t>(out.size() - at::not_in_lge));
    at::adr.store(out, to.byte());
    u8_at<0>::store(out.subspan(last), bcc::of(out.first(last)));
}

/// A whole telegram into `out`, which has its size.
template <writable Data>
constexpr void write_telegram(mutable_bytes out, address to, Data const& data) noexcept
{
    data.write(out.subspan(layout::telegram::data, out.size() - layout::telegram::around));
    seal(out, to);
}

/// How many data bytes `Data` may have.
template <codec Data>
[[nodiscard]] constexpr std::size_t min_data_size() noexcept
{
    if constexpr (fixed_size<Data>) {
        return Data::wire_size();
    } else {
        return Data::layout_type::around_text;
    }
}
template <codec Data>
[[nodiscard]] constexpr std::size_t max_data_size_of() noexcept
{
    return fixed_size<Data> ? min_data_size<Data>() : max_data_size;
}

/// Data to or from a slave, as a telegram: process data, a parameter, or a text.
template <writable Data>
struct telegram {
    fc::address address;
    Data        data;

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        requires fixed_size<Data>
    {
        return layout::telegram::around + Data::wire_size();
    }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
        requires(not fixed_size<Data>)
    {
        return layout::telegram::around + data.wire_size();
    }

    /// Errors: those of `check_telegram`, then those of the data.
    [[nodiscard]] static constexpr error check(bytes wire) noexcept
        requires codec<Data>
    {
        auto const fault = check_telegram(wire, min_data_size<Data>(), max_data_size_of<Data>());
        return fault.ok() ? Data::check(data_of(wire)).moved_by(layout::telegram::data) : fault;
    }

    [[nodiscard]] static constexpr telegram read(bytes wire) noexcept
        requires codec<Data>
    {
        return {fc::address::from_byte(layout::telegram::adr.load(wire)), Data::read(data_of(wire))};
    }

    constexpr void write(mutable_bytes out) const noexcept { write_telegram(out, address, data); }

    friend constexpr bool operator==(telegram const&, telegram const&) noexcept = default;
};

//=== the gates ===//

/// The telegram of data whose size the compiler knows. Cannot fail; a constant one is built by the compiler.
template <fixed_size Data>
[[nodiscard]] constexpr auto encode(address to, Data const& data) noexcept
{
    static_assert(Data::wire_size() <= max_data_size, "no telegram has more than 252 data bytes");
    std::array<std::uint8_t, telegram<Data>::wire_size()> out;  // not set to 0: every byte of it is written
    write_telegram(out, to, data);
    return out;
}

/// Writes the telegram to the front of `out`; returns the part written.
///
/// Errors, and then `out` is untouched: `no_space`; `bad_length` at 3 for a text of more than 244 characters, or of
/// fewer in a layout with more process words.
template <writable Data>
[[nodiscard]] constexpr result<mutable_bytes> encode(address to, Data const& data, mutable_bytes out) noexcept
{
    if (data.wire_size() > max_data_size) { return error{errc::bad_length, layout::telegram::data}; }
    return drivecodec::encode(telegram<Data>{to, data}, out);
}

/// The `Data` in the telegram `wire`, and its address. A text points into `wire`.
///
/// Errors: those of `telegram::check`.
template <codec Data>
[[nodiscard]] constexpr result<telegram<Data>> decode(bytes wire) noexcept
{
    return drivecodec::decode<telegram<Data>>(wire);
}

/// Refused: a text that borrows its bytes would outlive them. Name the buffer first.
template <codec Data, owning_temporary Temporary>
    requires(not fixed_size<Data>)
result<telegram<Data>> decode(Temporary&&) = delete;

}  // namespace drivecodec::fc
