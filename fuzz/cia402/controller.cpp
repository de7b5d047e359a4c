// A controller and a drive over a line that loses, repeats and invents words, with events and goals at any time: the
// reset bit is an edge and only by leave, other bits are kept, and on a quiet line the controller reaches or reports.
//
// Input: what the drive and the user offer (1 byte), the other bits (2), then steps of two bytes: what happens, and to
// what.
#include "fuzz_common.hpp"
#include "input.hpp"

#include <drivecodec/cia402.hpp>

using namespace drivecodec::cia402;

namespace {

class line {
public:
    explicit line(fuzz_input& input) : line{input.u8(), input.u16()} {}

    void step(unsigned what, unsigned argument)
    {
        switch (what % 16) {
        case 0: drive_.initialised(); break;
        case 1: drive_.fault(); break;
        case 2: drive_.fault_handled(); break;
        case 3: drive_.quick_stop_finished(); break;
        case 4: drive_.voltage_lost(); break;
        case 5: drive_.voltage_restored(); break;
        case 6:
            control_.set_goal(static_cast<state>(argument % state_count));
            check_goal();
            break;
        case 7:
            control_.reset_fault();
            may_reset_ = true;
            break;
        case 8: drive_.receive(control_word::from_raw(static_cast<std::uint16_t>(argument))); break;  // someone else
        case 9: hear(status_word::from_raw(static_cast<std::uint16_t>(argument * 0x0101U))); break;
        case 10: hear(last_); break;  // once more
        default:                      // an exchange, of which either half may be lost
            if ((argument & 1U) == 0) { hear(last_ = drive_.status()); }
            if ((argument & 2U) == 0) { drive_.receive(control_.word()); }
        }
    }

    /// The drive goes on by itself, and nothing is lost any more.
    void calm_down()
    {
        auto says = progress::waiting;
        for (int i = 0; i < 100; ++i) {
            drive_.voltage_restored();
            drive_.initialised();
            drive_.fault_handled();
            drive_.quick_stop_finished();
            says = hear(drive_.status());
            drive_.receive(control_.word());
        }
        FUZZ_ASSERT(says != progress::waiting);
        FUZZ_ASSERT(says != progress::reached or drive_.state() == control_.goal());
        FUZZ_ASSERT(says != progress::faulted or drive_.state() == state::fault);
        FUZZ_ASSERT(says == progress::faulted or says == progress::unreachable or says == progress::reached);
    }

private:
    line(unsigned offers, std::uint16_t others)
        : drive_{{.stays_in_quick_stop = (offers & 3U) != 0, .resumes_from_quick_stop = (offers & 2U) != 0}},
          control_{{.way = {.resumes_from_quick_stop       = (offers & 2U) != 0,
                            .straight_to_operation_enabled = (offers & 4U) != 0}}},
          others_{static_cast<std::uint16_t>(others & ~command_bits)}
    {
        control_.set_other_bits(control_word::from_raw(others));
    }

    progress hear(status_word heard)
    {
        auto const before = control_.word();
        auto const says   = control_.update(heard);
        auto const word   = control_.word();
        FUZZ_ASSERT((word.raw & ~command_bits) == others_);
        check_goal();
        if (word.test(control_word::fault_reset)) {
            FUZZ_ASSERT(not before.test(control_word::fault_reset));
            FUZZ_ASSERT(may_reset_);
            FUZZ_ASSERT((word.raw & command_bits) == 0x0080);
            may_reset_ = false;
        }
        return says;
    }

    /// The motor gets power only where that is the goal; of a goal that is none, it is kept where it is.
    void check_goal() const
    {
        FUZZ_ASSERT(not control_.word().test(control_word::enable_operation) or not is_goal(control_.goal())
                    or control_.goal() == state::operation_enabled);
    }

    machine       drive_;
    controller    control_;
    std::uint16_t others_;
    status_word   last_{};
    bool          may_reset_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input input{data, size};
    line       both{input};
    while (not input.empty()) {
        auto const what = input.u8();
        both.step(what, input.u8());
    }
    both.calm_down();
    return 0;
}
