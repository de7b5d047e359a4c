// What a user wants and a drive says, and what the drive must be told.
#include "controller.hpp"

namespace {

struct exchange {
    std::uint8_t  goal;
    bool          reset;
    std::uint16_t status;
    std::uint16_t control;
};

constexpr exchange day[] = {
    {4, false, 0x0250, 0x0106}, {4, false, 0x0231, 0x0107}, {4, false, 0x023F, 0x0107},  // up, and a fault
    {4, false, 0x0238, 0x0100}, {4, true, 0x0238, 0x0100},  {4, false, 0x0238, 0x0180},  // reset on an edge
    {4, false, 0x0250, 0x0106}, {4, false, 0x0231, 0x0107}, {4, false, 0x0233, 0x010F},  // up again
    {1, false, 0x0202, 0x0100}, {4, false, 0x0233, 0x010F}, {4, false, 0x0237, 0x010F},  // down after all; up after all
    {5, false, 0x0237, 0x0102}, {5, false, 0x0217, 0x0102}, {1, false, 0x0217, 0x0100},  // quick stop, and out of it
    {5, false, 0x0250, 0x0100}, {2, false, 0x0250, 0x0106}, {2, false, 0x0231, 0x0106},  // out of reach; ready
    {end, false, 0, 0},
};

exchange const* now      = day;
bool            was_told = true;

}  // namespace

std::uint8_t wanted_goal()
{
    return now->goal;
}

bool wants_reset()
{
    return now->reset;
}

std::uint16_t read_status()
{
    return now->status;
}

void write_control(std::uint16_t word)
{
    was_told = was_told and word == now->control;
    ++now;
}

int main()
{
    if (not run(0x0100) or now->goal != end) { return 1; }
    return was_told ? 0 : 2;
}
