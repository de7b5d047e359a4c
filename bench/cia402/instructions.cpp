// The instructions that it takes to decode the state of every statusword there is, the loop included.
#include <drivecodec/cia402/state.hpp>

#include <array>

using namespace drivecodec::cia402;

#define MEASURED extern "C" [[gnu::noinline]]

using counts = std::array<std::uint32_t, state_count + 1>;  // by state; the last one: no state

MEASURED void measured_decode_state_of_65536_words(counts& seen)
{
    for (std::uint32_t raw = 0; raw <= 0xFFFF; ++raw) {
        auto const found = decode_state(status_word::from_raw(static_cast<std::uint16_t>(raw)));
        ++seen[found ? static_cast<std::size_t>(*found) : state_count];
    }
}

int main()
{
    static counts seen{};
    measured_decode_state_of_65536_words(seen);
    return seen[state_count] == 0x10000 / 128 * 104 ? 0 : 1;
}
