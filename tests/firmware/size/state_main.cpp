#include "state.hpp"

namespace {

struct example {
    std::uint16_t status;
    std::int8_t   state;
};

/// The words that manuals print, with and without what does not matter; and two that are no state.
constexpr example examples[] = {{0x0000, 0}, {0x0250, 1}, {0x0231, 2}, {0x0233, 3}, {0x06B7, 4},  {0x0217, 5},
                                {0x023F, 6}, {0x001F, 6}, {0x0238, 7}, {0x0018, 7}, {0x0002, -1}, {0xFFFF, -1}};

}  // namespace

int main()
{
    for (auto const& each : examples) {
        if (state_of(each.status) != each.state) { return 1; }
    }
    return 0;
}
