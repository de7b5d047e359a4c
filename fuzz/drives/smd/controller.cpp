// A controller over a line that loses, repeats and invents answers, with goals at any time: it starts only for a goal to
// run, and only after unlocking, reference, speed and direction; stop goes out at once; when the line falls silent, or
// answers the same for ever, it ends.
//
// Input: patience (1 byte), then steps of two bytes: what happens, and to what.
#include "fuzz_common.hpp"
#include "input.hpp"

#include <drivecodec/drives/smd/controller.hpp>

using namespace drivecodec;
using namespace drivecodec::smd;

namespace {

class line {
public:
    explicit line(unsigned patience) : patience_{patience}, master_{{.patience = static_cast<std::uint16_t>(patience)}}
    {}

    void step(unsigned what, unsigned argument)
    {
        switch (what % 16) {
        case 0: stop_or_lock(false); break;
        case 1: stop_or_lock(true); break;
        case 2: run(argument); break;
        case 3: master_.pass(argument * 10'000); break;
        case 4: (void)master_.answered(status(argument)); break;  // asked for or not
        case 5: (void)master_.refused(exception{static_cast<std::uint8_t>(argument)}); break;
        case 6: echo({1, static_cast<std::uint16_t>(argument)}); break;
        case 7: (void)master_.lost(); break;
        default:
            ask();
            if (what % 4 != 0) { answer(argument); }
        }
        check();
    }

    /// What goes on for ever ends. 9 steps, each with `patience` and itself, and one to begin with.
    void go_on(unsigned argument, bool is_lost)
    {
        auto const most = 9 * (patience_ + 1) + 2;
        for (unsigned i = 0; i < most; ++i) {
            ask();
            if (is_lost) {
                (void)master_.lost();
            } else {
                answer(argument);
            }
            check();
        }
        FUZZ_ASSERT(master_.progress() != progress::waiting);
    }

private:
    [[nodiscard]] static status_block status(unsigned argument)
    {
        status_block made{};
        made.operational_status = operational_status{static_cast<std::uint8_t>(argument % 16)};
        made.control_mode = (argument & 0x10U) != 0 ? control_mode::c40_terminal_modbus : control_mode::c40_modbus;
        made.fault        = (argument & 0x20U) != 0 ? fault::external_fault : fault::no_fault;
        made.commanded_direction = (argument & 0x40U) != 0 ? direction::reverse : direction::forward;
        made.speed_reference     = (argument & 0x80U) != 0 ? speed_reference::local : speed_reference::serial;
        return made;
    }

    void stop_or_lock(bool locks)
    {
        if (locks) {
            master_.lock();
        } else {
            master_.stop();
        }
        may_start_ = false;
        FUZZ_ASSERT(master_.due_in() == 0);
        ask();
        FUZZ_ASSERT(asked_.what == step::stop);
    }

    void run(unsigned argument)
    {
        quantity<unit::hertz> const speed{static_cast<std::int32_t>(argument) * 10, -1};
        auto const                  way = (argument & 1U) != 0 ? direction::reverse : direction::forward;
        FUZZ_ASSERT(master_.run(way, speed).ok() == (argument <= 240));
        if (argument <= 240) { may_start_ = true; }
    }

    void ask()
    {
        auto const due = master_.due_in();
        if (due != controller::never) { master_.pass(due); }
        auto const asked = master_.next();
        FUZZ_ASSERT((asked.what == step::none) == (due == controller::never));
        if (asked.what == step::none) { return; }
        FUZZ_ASSERT(master_.next().what == step::none);
        asked_ = asked;
        if (asked.is_write() and asked.write.address == 1) {
            FUZZ_ASSERT(decode_command(asked.write.value).has_value());
        }
        if (asked.what == step::start) { FUZZ_ASSERT(may_start_ and done_ == 15U); }
    }

    void answer(unsigned argument)
    {
        auto const is_pending = master_.due_in() == controller::never and asked_.what != step::none;
        if (not is_pending) { return; }
        if (not asked_.is_write()) {
            (void)master_.answered(status(argument));
            return;
        }
        if ((argument & 0x80U) != 0) {
            if ((argument & 7U) == 1) { done_ = 0; }
            (void)master_.refused(exception{static_cast<std::uint8_t>(argument & 7U)});
            return;
        }
        echo(asked_.write);
        echo(asked_.write);  // doubled
    }

    void echo(modbus::write_single_register::request write)
    {
        if (asked_.is_write() and write.address == asked_.write.address and write.value == asked_.write.value) {
            switch (asked_.what) {
            case step::unlock: done_ |= 1U; break;
            case step::set_reference: done_ |= 2U; break;
            case step::set_speed: done_ |= 4U; break;
            case step::set_direction: done_ |= 8U; break;
            default: break;
            }
        }
        (void)master_.answered(write);
    }

    void check() const
    {
        FUZZ_ASSERT((master_.why() != refusal::none) == (master_.progress() == progress::refused));
        FUZZ_ASSERT(master_.progress() <= progress::faulted);
    }

    unsigned   patience_;
    controller master_;
    exchange   asked_{};
    unsigned   done_      = 0;  // what the drive has been told since its last lock
    bool       may_start_ = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input input{data, size};
    line       both{input.u8()};
    unsigned   argument = 0;
    while (not input.empty()) {
        auto const what = input.u8();
        argument        = input.u8();
        both.step(what, argument);
    }
    both.go_on(argument, false);
    both.go_on(argument, true);
    return 0;
}
