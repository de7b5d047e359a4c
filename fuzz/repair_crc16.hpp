#pragma once

// A checksum hides everything behind it from a fuzzer. A fuzzer whose input is one RTU frame includes this header:
// seven mutated inputs in eight then end in the right CRC. Its own arithmetic, so that the library is not its own judge.

#include <cstddef>
#include <cstdint>

#ifdef FUZZ_ENGINE

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size, unsigned seed)
{
    auto const mutated = LLVMFuzzerMutate(data, size, max_size);
    if (mutated < 4 or seed % 8 == 0) { return mutated; }

    unsigned crc = 0xFFFF;
    for (std::size_t i = 0; i < mutated - 2; ++i) {
        crc ^= data[i];
        for (int bit = 0; bit < 8; ++bit) { crc = (crc & 1U) != 0 ? (crc >> 1) ^ 0xA001U : crc >> 1; }
    }
    data[mutated - 2] = static_cast<std::uint8_t>(crc);
    data[mutated - 1] = static_cast<std::uint8_t>(crc >> 8);
    return mutated;
}

#endif
