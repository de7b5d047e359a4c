// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/crc16/slices.hpp>

#include <type_traits>

// A block is a polynomial of degree 127 in a vector register, as the line brings it: bit 0 of the first byte is the
// coefficient of x^127. `times` gives low half * low factor + high half * high factor.
#if defined(__PCLMUL__)

#include <wmmintrin.h>

namespace drivecodec::modbus::crc16 {

struct x86_block {
    __m128i bits;

    [[nodiscard]] static x86_block load(std::uint8_t const* from) noexcept
    {
        return {_mm_loadu_si128(static_cast<__m128i const*>(static_cast<void const*>(from)))};
    }
    void store(std::uint8_t* to) const noexcept
    {
        _mm_storeu_si128(static_cast<__m128i*>(static_cast<void*>(to)), bits);
    }
    [[nodiscard]] static x86_block make(std::uint64_t low, std::uint64_t high) noexcept
    {
        return {_mm_set_epi64x(static_cast<long long>(high), static_cast<long long>(low))};
    }
    [[nodiscard]] x86_block plus(x86_block other) const noexcept { return {_mm_xor_si128(bits, other.bits)}; }
    [[nodiscard]] x86_block times(x86_block factors) const noexcept
    {
        return {_mm_xor_si128(_mm_clmulepi64_si128(bits, factors.bits, 0x00),
                              _mm_clmulepi64_si128(bits, factors.bits, 0x11))};
    }
};

using native_block = x86_block;

}  // namespace drivecodec::modbus::crc16

#elif defined(__aarch64__) && defined(__ARM_FEATURE_AES) && !defined(__AARCH64EB__)

#include <arm_neon.h>

namespace drivecodec::modbus::crc16 {

struct arm_block {
    uint64x2_t bits;

    [[nodiscard]] static arm_block load(std::uint8_t const* from) noexcept
    {
        return {vreinterpretq_u64_u8(vld1q_u8(from))};
    }
    void                           store(std::uint8_t* to) const noexcept { vst1q_u8(to, vreinterpretq_u8_u64(bits)); }
    [[nodiscard]] static arm_block make(std::uint64_t low, std::uint64_t high) noexcept
    {
        return {vcombine_u64(vcreate_u64(low), vcreate_u64(high))};
    }
    [[nodiscard]] arm_block plus(arm_block other) const noexcept { return {veorq_u64(bits, other.bits)}; }
    [[nodiscard]] arm_block times(arm_block factors) const noexcept
    {
        auto const ours   = vreinterpretq_p64_u64(bits);
        auto const theirs = vreinterpretq_p64_u64(factors.bits);
        auto const low    = vmull_p64(vgetq_lane_p64(ours, 0), vgetq_lane_p64(theirs, 0));
        auto const high   = vmull_high_p64(ours, theirs);
        return {veorq_u64(vreinterpretq_u64_p128(low), vreinterpretq_u64_p128(high))};
    }
};

using native_block = arm_block;

}  // namespace drivecodec::modbus::crc16

#else

namespace drivecodec::modbus::crc16 {

struct no_block {};

using native_block = no_block;

}  // namespace drivecodec::modbus::crc16

#endif

namespace drivecodec::modbus::crc16 {

/// Sixteen bytes at a time with a carry-less multiply, four of them at once, where the compiler's target has one: x86
/// with PCLMUL, 64-bit ARM with AES. Elsewhere, in constant evaluation and for the last bytes it is `slices`
/// (V. Gopal et al.: "Fast CRC Computation for Generic Polynomials Using PCLMULQDQ Instruction", 2009).
///
/// What the target has is part of the type, so that units compiled for different targets do not mix.
template <typename Block>
struct basic_carryless {
    /// Does the target have a carry-less multiply?
    static constexpr bool is_native = not std::is_empty_v<Block>;

    [[nodiscard]] static constexpr std::uint16_t update(std::uint16_t crc, bytes data) noexcept
    {
        if constexpr (is_native) {
            if (not std::is_constant_evaluated() and data.size() >= 16) { return fold(crc, data); }
        }
        return slices::update(crc, data);
    }

private:
    /// What moves a half over `count` bytes: x^(8 * count) modulo the polynomial, divided by x, since the 127 bits of a
    /// product of halves lie in the 128 bits of a block as if it had been multiplied by x.
    [[nodiscard]] static consteval std::uint64_t over(std::size_t count)
    {
        constexpr std::uint16_t x_to_the_7th = 0x0100;
        return std::uint64_t{after_zeros(x_to_the_7th, count - 1)} << 48;
    }

    /// Precondition: data.size() >= 16.
    [[nodiscard]] static std::uint16_t fold(std::uint16_t crc, bytes data) noexcept
    {
        // The low half came first and has eight bytes further to go.
        auto const over_16 = Block::make(over(16 + 8), over(16));

        auto const* from  = data.data();
        auto        left  = data.size() - 16;
        auto        block = Block::load(from).plus(Block::make(crc, 0));
        from += 16;
        if (left >= 48) {
            auto const over_64 = Block::make(over(64 + 8), over(64));

            auto second = Block::load(from);
            auto third  = Block::load(from + 16);
            auto fourth = Block::load(from + 32);
            from += 48;
            left -= 48;
            for (; left >= 64; left -= 64) {
                block  = block.times(over_64).plus(Block::load(from));
                second = second.times(over_64).plus(Block::load(from + 16));
                third  = third.times(over_64).plus(Block::load(from + 32));
                fourth = fourth.times(over_64).plus(Block::load(from + 48));
                from += 64;
            }
            block = block.times(over_16).plus(second);
            block = block.times(over_16).plus(third);
            block = block.times(over_16).plus(fourth);
        }
        for (; left >= 16; left -= 16) {
            block = block.times(over_16).plus(Block::load(from));
            from += 16;
        }
        std::array<std::uint8_t, 16> folded{};
        block.store(folded.data());
        return slices::update(slices::update(0, folded), {from, left});
    }
};

using carryless = basic_carryless<native_block>;

}  // namespace drivecodec::modbus::crc16
