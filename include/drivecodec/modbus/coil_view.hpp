// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/bytes.hpp>
#include <drivecodec/core/index_iterator.hpp>
#include <drivecodec/modbus/address_range.hpp>

#include <array>

namespace drivecodec::modbus {

/// States of coils or discrete inputs, borrowed: packed as on the wire (eight a byte, the first
/// in the lowest bit), or as host bools that are to be sent.
///
/// Unused bits of the last byte are ignored when read and 0 when written. A response does not say how many coils
/// it holds, only how many bytes: then `size()` is a multiple of eight, and the request knows how many count.
class coil_view {
public:
    using addressed = coils;

    constexpr coil_view() noexcept = default;

    /// Host bools: an array, a span.
    template <borrowable_by<bool, coil_view> States>
    constexpr coil_view(States const& states) noexcept : coil_view{std::span<bool const>{states}, host{}}
    {}

    /// The first `count` coils of `wire`. Precondition: coils::wire_size(count) <= wire.size().
    [[nodiscard]] static constexpr coil_view of_wire(bytes wire, std::size_t count) noexcept
    {
        return {wire.data(), count};
    }
    /// All coils of `wire`, eight a byte.
    [[nodiscard]] static constexpr coil_view of_wire(bytes wire) noexcept { return of_wire(wire, 8 * wire.size()); }

    [[nodiscard]] constexpr std::size_t size() const noexcept { return size_; }
    [[nodiscard]] constexpr bool        empty() const noexcept { return size_ == 0; }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept { return coils::wire_size(size_); }

    /// Precondition: index < size().
    [[nodiscard]] constexpr bool operator[](std::size_t index) const noexcept
    {
        return host_ ? states_[index] : (wire_[index / 8] >> (index % 8) & 1) != 0;
    }

    [[nodiscard]] constexpr index_iterator<coil_view, bool> begin() const noexcept { return {*this, 0}; }
    [[nodiscard]] constexpr index_iterator<coil_view, bool> end() const noexcept { return {*this, size_}; }

    /// The first `count` of them. Precondition: count <= size().
    [[nodiscard]] constexpr coil_view first(std::size_t count) const noexcept
    {
        auto part  = *this;
        part.size_ = static_cast<std::uint16_t>(count);
        return part;
    }

    /// Precondition: out.size() == wire_size().
    constexpr void write(mutable_bytes out) const noexcept
    {
        for (std::size_t byte = 0; byte < out.size(); ++byte) { out.data()[byte] = packed(byte); }
    }

    friend constexpr bool operator==(coil_view const& a, coil_view const& b) noexcept
    {
        if (a.size_ != b.size_) { return false; }
        for (std::size_t i = 0; i < a.size_; ++i) {
            if (a[i] != b[i]) { return false; }
        }
        return true;
    }

private:
    [[nodiscard]] constexpr std::uint8_t packed(std::size_t byte) const noexcept
    {
        unsigned   bits = 0;
        auto const left = size_ - 8 * byte;
        if (not host_) {
            bits = left < 8 ? wire_[byte] & ((1U << left) - 1U) : wire_[byte];
        } else {
            for (std::size_t bit = 0; bit < 8 and bit < left; ++bit) {
                bits |= static_cast<unsigned>(states_[8 * byte + bit]) << bit;
            }
        }
        return static_cast<std::uint8_t>(bits);
    }

    struct host {};
    constexpr coil_view(std::span<bool const> states, host) noexcept
        : states_{states.data()}, size_{saturate_16(states.size())}, host_{true}
    {}
    constexpr coil_view(std::uint8_t const* wire, std::size_t count) noexcept
        : wire_{wire}, size_{static_cast<std::uint16_t>(count)}
    {}

    union {
        std::uint8_t const* wire_ = nullptr;
        bool const*         states_;
    };
    std::uint16_t size_ = 0;
    bool          host_ = false;  // states_ is active, not wire_
};

/// `N` states, owned: a message of them has a size that the compiler knows.
template <std::size_t N>
struct coil_array {
    using addressed = coils;

    std::array<bool, N> states;

    [[nodiscard]] static constexpr std::size_t size() noexcept { return N; }
    [[nodiscard]] static constexpr std::size_t wire_size() noexcept { return coils::wire_size(N); }
    [[nodiscard]] constexpr bool               operator[](std::size_t index) const noexcept { return states[index]; }
    [[nodiscard]] constexpr auto               begin() const noexcept { return states.begin(); }
    [[nodiscard]] constexpr auto               end() const noexcept { return states.end(); }

    constexpr void write(mutable_bytes out) const noexcept { coil_view{states}.write(out); }

    friend constexpr bool operator==(coil_array const&, coil_array const&) noexcept = default;
};

}  // namespace drivecodec::modbus
