#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <span>

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

/// Elements on the heap, exactly so many: a sanitizer sees what is read or written beyond them.
template <typename T>
class exact_array {
public:
    explicit exact_array(std::size_t size) : elements_{std::make_unique<T[]>(size)}, size_{size} {}

    [[nodiscard]] std::span<T> get() const noexcept { return {elements_.get(), size_}; }

private:
    std::unique_ptr<T[]> elements_;
    std::size_t          size_;
};

using exact_buffer = exact_array<std::uint8_t>;
