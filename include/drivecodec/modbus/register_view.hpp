// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/be16.hpp>
#include <drivecodec/core/index_iterator.hpp>
#include <drivecodec/modbus/address_range.hpp>

#include <array>

namespace drivecodec::modbus {

/// Register values, borrowed: as they lie on the wire (big-endian), or as host words that are to be sent.
///
/// One type for both, so that a message that was decoded and one that is to be encoded are the same type, and
/// values pass from a frame into another one without a copy between.
class register_view {
public:
    using addressed = registers;

    constexpr register_view() noexcept = default;

    /// Host words: an array, a vector, a span.
    template <borrowable_by<std::uint16_t, register_view> Words>
    constexpr register_view(Words const& words) noexcept : register_view{std::span<std::uint16_t const>{words}, host{}}
    {}

    /// The first `count` registers of `wire`. Precondition: 2 * count <= wire.size(), count < 65536.
    [[nodiscard]] static constexpr register_view of_wire(bytes wire, std::size_t count) noexcept
    {
        return {wire.data(), count};
    }
    /// All registers of `wire`, of which a PDU has at most 126; an odd last byte is not part of the view.
    [[nodiscard]] static constexpr register_view of_wire(bytes wire) noexcept { return of_wire(wire, wire.size() / 2); }

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool        empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept { return registers::wire_size(size_); }

    /// Precondition: index < size().
    [[nodiscard]] constexpr std::uint16_t operator[](std::size_t index) const noexcept
    {
        return host_ ? words_[index] : be16_at<0>::load(bytes{wire_ + 2 * index, 2});
    }

    [[nodiscard]] constexpr index_iterator<register_view, std::uint16_t> begin() const noexcept { return {*this, 0}; }
    [[nodiscard]] constexpr index_iterator<register_view, std::uint16_t> end() const noexcept { return {*this, size_}; }

    /// `count` registers from `first` on. Precondition: first + count <= size().
    [[nodiscard]] constexpr register_view subview(std::size_t first, std::size_t count) const noexcept
    {
        auto part = *this;
        if (host_) {
            part.words_ = words_ + first;
        } else {
            part.wire_ = wire_ + 2 * first;
        }
        part.size_ = static_cast<std::uint16_t>(count);
        return part;
    }

    /// All values at once into host words; returns the part of `to` that was filled: as many as both have.
    constexpr std::span<std::uint16_t> copy_to(std::span<std::uint16_t> to) const noexcept
    {
        to = to.first(to.size() < size_ ? to.size() : size_);
        if (is_host and not host_) {
            load_be16(bytes{wire_, 2 * to.size()}, to);
        } else {
            for (std::size_t i = 0; i < to.size(); ++i) { to.data()[i] = (*this)[i]; }
        }
        return to;
    }

    /// Precondition: out.size() == wire_size().
    constexpr void write(mutable_bytes out) const noexcept
    {
        if (is_host and host_) {
            store_be16({words_, size_}, out);
        } else if (is_host) {
            copy_bytes({wire_, out.size()}, out);
        } else {
            for (std::size_t i = 0; i < size_; ++i) { be16_at<0>::store(out.subspan(2 * i), (*this)[i]); }
        }
    }

    friend constexpr bool operator==(register_view const& a, register_view const& b) noexcept
    {
        if (a.size_ != b.size_) { return false; }
        for (std::size_t i = 0; i < a.size_; ++i) {
            if (a[i] != b[i]) { return false; }
        }
        return true;
    }

private:
    struct host {};
    constexpr register_view(std::span<std::uint16_t const> words, host) noexcept
        : words_{words.data()}, size_{saturate_16(words.size())}, host_{true}
    {}
    constexpr register_view(std::uint8_t const* wire, std::size_t count) noexcept
        : wire_{wire}, size_{static_cast<std::uint16_t>(count)}
    {}

    union {
        std::uint8_t const*  wire_ = nullptr;
        std::uint16_t const* words_;
    };
    std::uint16_t size_ = 0;
    bool          host_ = false;  // words_ is active, not wire_
};

/// `N` register values, owned: a message of them has a size that the compiler knows.
template <std::size_t N>
struct register_array {
    using addressed = registers;

    std::array<std::uint16_t, N> words;

    [[nodiscard]] static constexpr std::size_t size() noexcept { return N; }
    [[nodiscard]] static constexpr std::size_t wire_size() noexcept { return registers::wire_size(N); }
    [[nodiscard]] constexpr std::uint16_t      operator[](std::size_t index) const noexcept { return words[index]; }
    [[nodiscard]] constexpr auto               begin() const noexcept { return words.begin(); }
    [[nodiscard]] constexpr auto               end() const noexcept { return words.end(); }

    constexpr void write(mutable_bytes out) const noexcept { store_be16(words, out); }

    friend constexpr bool operator==(register_array const&, register_array const&) noexcept = default;
};

}  // namespace drivecodec::modbus
