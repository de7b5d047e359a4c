// Any bytes as the drive's status: six words are one, whatever they hold, and come back as they were. Any status as a
// drive would send it: what its words cannot hold is refused, all else comes back.
//
// Input: how many bytes of the rest are the reply (1), the reply, then the fields of a status.
#include "fuzz_common.hpp"
#include "input.hpp"

#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/smd/status_block.hpp>

using namespace drivecodec;

namespace {

void describe_in(std::size_t room, smd::status_block const& status)
{
    exact_array<char> text{room};
    auto const        line = describe(status, text.get());
    FUZZ_ASSERT(line.size() <= room);
    for (auto const character : line) { FUZZ_ASSERT(character >= ' ' and character <= '~'); }
}

void receive(bytes reply)
{
    exact_buffer wire{reply.size()};
    copy_bytes(reply, wire.get());
    auto const status = smd::status_block::decode(modbus::register_view::of_wire(bytes{wire.get()}));
    FUZZ_ASSERT(status.has_value() == (reply.size() == 12 or reply.size() == 13));  // an odd last byte is no register
    if (not status) {
        FUZZ_ASSERT(status.error() == error{errc::bad_quantity, 0});
        return;
    }

    // smd manual, table 10: D1H is the first byte, D6L the last.
    auto const at = [&](std::size_t byte) { return unsigned{reply[byte]}; };
    FUZZ_ASSERT(status->command_speed.number == static_cast<int>(256 * at(0) + at(1)));
    FUZZ_ASSERT(status->actual_speed.number == static_cast<int>(256 * at(2) + at(3)));
    FUZZ_ASSERT(status->command_speed.exponent == -1 and status->actual_speed.exponent == -1);
    FUZZ_ASSERT(status->load == quantity<unit::percent>{static_cast<int>(at(4)), 0});
    FUZZ_ASSERT(static_cast<unsigned>(status->operational_status) == at(5));
    FUZZ_ASSERT(static_cast<unsigned>(status->actual_direction) == at(6));
    FUZZ_ASSERT(static_cast<unsigned>(status->control_mode) == at(7));
    FUZZ_ASSERT(static_cast<unsigned>(status->speed_source) == at(8));
    FUZZ_ASSERT(static_cast<unsigned>(status->speed_reference) == at(9));
    FUZZ_ASSERT(static_cast<unsigned>(status->fault) == at(10));
    FUZZ_ASSERT(static_cast<unsigned>(status->commanded_direction) == at(11));

    auto const words = status->make_words();
    FUZZ_ASSERT(words.has_value());
    exact_buffer back{words->wire_size()};
    words->write(back.get());
    FUZZ_ASSERT(same_bytes(back.get(), reply.first(12)));

    describe_in(300, *status);
    describe_in(at(0), *status);
}

/// 32 bits and an exponent.
decimal read_decimal(fuzz_input& input)
{
    auto const high = std::uint32_t{input.u16()};
    return {static_cast<std::int32_t>(high << 16 | input.u16()), static_cast<std::int8_t>(input.u8())};
}

void send(fuzz_input& input)
{
    smd::status_block status{};
    status.command_speed       = quantity<unit::hertz>::of(read_decimal(input));
    status.actual_speed        = quantity<unit::hertz>::of(read_decimal(input));
    status.load                = quantity<unit::percent>::of(read_decimal(input));
    status.operational_status  = smd::operational_status{input.u8()};
    status.actual_direction    = drives::direction{input.u8()};
    status.control_mode        = smd::control_mode{input.u16()};
    status.speed_source        = smd::speed_source{input.u8()};
    status.speed_reference     = smd::speed_reference{input.u8()};
    status.fault               = smd::fault{input.u16()};
    status.commanded_direction = drives::direction{input.u8()};

    auto const fits = [](decimal value, int exponent, std::int32_t last) {
        auto const steps = value.scaled_to(exponent);
        return steps and *steps >= 0 and *steps <= last;
    };
    auto const is_allowed = fits(status.command_speed.value(), -1, 0xFFFF)
                            and fits(status.actual_speed.value(), -1, 0xFFFF) and fits(status.load.value(), 0, 0xFF)
                            and static_cast<unsigned>(status.control_mode) <= 0xFF
                            and static_cast<unsigned>(status.fault) <= 0xFF;
    auto const words = status.make_words();
    FUZZ_ASSERT(words.has_value() == is_allowed);
    if (words) {
        FUZZ_ASSERT(smd::status_block::from_words(words->words) == status);
    } else {
        FUZZ_ASSERT(words.error().offset() < smd::status_block::word_count);
    }
    describe_in(500, status);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input input{data, size};
    auto const length = input.u8();
    receive(input.take(length));
    send(input);
    return 0;
}
