#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

/// What each fuzzer defines: one input, no state from one call to the next.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size);

/// What must hold for every input. Not assert(), which NDEBUG removes.
#define FUZZ_ASSERT(...)                                                                     \
    do {                                                                                     \
        if (not(__VA_ARGS__)) {                                                              \
            std::fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #__VA_ARGS__);   \
            std::abort();                                                                    \
        }                                                                                    \
    } while (false)
