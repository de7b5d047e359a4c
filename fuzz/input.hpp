#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

/// Takes an input apart into values; zeros when it has run out. Clang's FuzzedDataProvider.h is not on g++'s path.
class fuzz_input {
public:
    constexpr fuzz_input(std::uint8_t const* data, std::size_t size) noexcept : rest_{data, size} {}
    constexpr explicit fuzz_input(std::span<std::uint8_t const> data) noexcept : rest_{data} {}

    [[nodiscard]] constexpr bool empty() const noexcept { return rest_.empty(); }

    [[nodiscard]] constexpr std::uint8_t u8() noexcept
    {
        if (rest_.empty()) { return 0; }
        auto const byte = rest_.front();
        rest_           = rest_.subspan(1);
        return byte;
    }

    [[nodiscard]] constexpr std::uint16_t u16() noexcept
    {
        auto const high = u8();
        return static_cast<std::uint16_t>((high << 8) | u8());
    }

    /// 0 to `limit` - 1. Precondition: limit > 0.
    [[nodiscard]] constexpr std::size_t below(std::size_t limit) noexcept { return u16() % limit; }

    /// At most `count` bytes.
    [[nodiscard]] constexpr std::span<std::uint8_t const> take(std::size_t count) noexcept
    {
        auto const taken = rest_.first(count < rest_.size() ? count : rest_.size());
        rest_            = rest_.subspan(taken.size());
        return taken;
    }

    [[nodiscard]] constexpr std::span<std::uint8_t const> rest() const noexcept { return rest_; }

private:
    std::span<std::uint8_t const> rest_;
};
