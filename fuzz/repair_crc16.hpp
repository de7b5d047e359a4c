#pragma once

// A checksum hides everything behind it from a fuzzer, so the mutators of fuzzers whose input holds RTU frames repair it,
// in seven of eight. Its own arithmetic, so that the library is not its own judge.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

[[nodiscard]] inline std::uint16_t reference_crc16(std::span<std::uint8_t const> data) noexcept
{
    static auto const table = [] {
        std::array<unsigned, 256> made{};
        for (unsigned i = 0; i < 256; ++i) {
            made[i] = i;
            for (int bit = 0; bit < 8; ++bit) { made[i] = (made[i] & 1U) != 0 ? (made[i] >> 1) ^ 0xA001U : made[i] >> 1; }
        }
        return made;
    }();
    unsigned crc = 0xFFFF;
    for (auto const byte : data) { crc = (crc >> 8) ^ table[(crc ^ byte) & 0xFFU]; }
    return static_cast<std::uint16_t>(crc);
}

/// Makes the last two bytes the CRC of those before. Precondition: frame.size() >= 2.
inline void repair_crc16(std::span<std::uint8_t> frame) noexcept
{
    auto const covered = frame.size() - 2;
    auto const crc     = reference_crc16(frame.first(covered));
    frame[covered]     = static_cast<std::uint8_t>(crc);
    frame[covered + 1] = static_cast<std::uint8_t>(crc >> 8);
}

[[nodiscard]] inline bool has_reference_crc16(std::span<std::uint8_t const> frame) noexcept
{
    return frame.size() >= 2 and reference_crc16(frame) == 0;
}

#ifdef FUZZ_ENGINE

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed);

#endif
