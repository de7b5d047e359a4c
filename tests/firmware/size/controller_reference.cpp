#include "controller.hpp"

// What the library does in controller.cpp. Called, and not there.
struct controller {
    std::uint32_t state[4];
};
void          make(controller* control);
void          set_other_bits(controller* control, std::uint16_t other_bits);
void          set_goal(controller* control, std::uint8_t goal);
void          reset_fault(controller* control);
std::uint8_t  goal_of(controller const* control);
std::uint8_t  update(controller* control, std::uint16_t status);
std::uint16_t word_of(controller const* control);

bool run(std::uint16_t other_bits)
{
    controller control;
    make(&control);
    set_other_bits(&control, other_bits);
    for (std::uint8_t says = 1;;) {
        auto const goal = wanted_goal();
        if (goal == end) { return says == 0; }
        if (goal != goal_of(&control)) { set_goal(&control, goal); }
        if (wants_reset()) { reset_fault(&control); }
        says = update(&control, read_status());
        write_control(word_of(&control));
    }
}
