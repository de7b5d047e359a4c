#include "controller.hpp"

#include <drivecodec/cia402/controller.hpp>

using namespace drivecodec::cia402;

bool run(std::uint16_t other_bits)
{
    controller control;
    control.set_other_bits(control_word::from_raw(other_bits));
    for (auto says = progress::waiting;;) {
        auto const goal = wanted_goal();
        if (goal == end) { return says == progress::reached; }
        if (goal != static_cast<std::uint8_t>(control.goal())) { control.set_goal(static_cast<state>(goal)); }
        if (wants_reset()) { control.reset_fault(); }
        says = control.update(status_word::from_raw(read_status()));
        write_control(control.word().raw);
    }
}
