#pragma once

// STX, a length that fits and a BCC hide everything behind them from a fuzzer, so the mutators of fuzzers whose input
// ends with an FC telegram repair them, in seven of eight. Their own arithmetic, so that the library is not its own
// judge.

#include <cstddef>
#include <cstdint>
#include <span>

/// The exclusive or of all bytes: 0 where the last one is the BCC of those before.
[[nodiscard]] inline std::uint8_t reference_bcc(std::span<std::uint8_t const> data) noexcept
{
    unsigned folded = 0;
    for (unsigned const byte : data) { folded ^= byte; }
    return static_cast<std::uint8_t>(folded);
}

/// Makes the last byte the BCC of those before. Precondition: not telegram.empty().
inline void repair_bcc(std::span<std::uint8_t> telegram) noexcept
{
    telegram.back() = reference_bcc(telegram.first(telegram.size() - 1));
}

[[nodiscard]] inline bool has_reference_bcc(std::span<std::uint8_t const> telegram) noexcept
{
    return not telegram.empty() and reference_bcc(telegram) == 0;
}

#ifdef FUZZ_ENGINE

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed);

/// The telegram behind `head` bytes: often STX and LGE, sometimes cut or filled up with zeros to process data or a
/// parameter, often ADR unless `adr` is 0, nearly always BCC.
inline std::size_t repair_telegram(std::uint8_t* data, std::size_t head, std::size_t size, std::size_t max_size,
                                   unsigned seed, std::uint8_t adr = 0)
{
    if (size < head + 4 or seed % 8 == 0) { return size; }
    auto const fit = seed / 8 % 4;  // 0: of 8 bytes, 1: of 16
    if (fit < 2 and max_size >= head + 16) {
        for (auto i = size; i < head + 16; ++i) { data[i] = 0; }
        size = head + (fit == 0 ? 8 : 16);
    }
    std::span const telegram{data + head, size - head};
    if (seed / 32 % 4 != 0) {
        telegram[0] = 0x02;
        telegram[1] = static_cast<std::uint8_t>(telegram.size() - 2);
    }
    if (adr != 0 and seed / 128 % 4 != 0) { telegram[2] = adr; }
    repair_bcc(telegram);
    return size;
}

#endif
