// EXPECT: deleted
#include <drivecodec/fc/process.hpp>

#include <array>

using namespace drivecodec::fc;

constexpr std::array<std::uint8_t, 4> wire{};

unsigned first_word()
{
#ifdef OK
    auto const process = process_status::read(wire);
    for (auto const word : process.pcd()) { return word; }
#else
    for (auto const word : process_status::read(wire).pcd()) { return word; }
#endif
    return 0;
}
