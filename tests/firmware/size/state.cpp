#include "state.hpp"

#include <drivecodec/cia402/state.hpp>

using namespace drivecodec::cia402;

int state_of(std::uint16_t status)
{
    auto const found = decode_state(status_word::from_raw(status));
    return found ? static_cast<int>(*found) : -1;
}
