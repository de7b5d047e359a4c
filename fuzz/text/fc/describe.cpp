// Any data of a telegram as words, in any layout, direction and room, and what they mean to a VLT 6000.
//
// Input: direction, layout and alignment, the room (2 bytes), ADR, the data.
#include "fuzz_common.hpp"
#include "input.hpp"
#include "text/description.hpp"

#include <drivecodec/text/fc.hpp>
#include <drivecodec/text/vlt6000.hpp>

#include <algorithm>
#include <vector>

namespace {

namespace fc      = drivecodec::fc;
namespace vlt6000 = drivecodec::vlt6000;

constexpr std::size_t most_of_a_word = 1200;

template <typename Layout>
void check_frame(fc::frame const& heard, std::size_t room)
{
    check_description(fc::max_description_size, room,
                      [&](std::span<char> out) { return fc::describe<Layout>(heard, out); });
}

template <typename Thing>
void check_thing(Thing const& thing, std::size_t room)
{
    check_description(most_of_a_word, room, [&](std::span<char> out) { return drivecodec::describe(thing, out); });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    fuzz_input input{data, size};
    auto const flags = input.u8();
    auto const room  = input.u16();
    auto const adr   = input.u8();
    auto const rest  = input.rest().first(std::min(input.rest().size(), fc::max_data_size));

    std::vector<std::uint8_t> telegram{fc::stx, static_cast<std::uint8_t>(rest.size() + 2), adr};
    telegram.insert(telegram.end(), rest.begin(), rest.end());
    telegram.push_back(fc::bcc::of(telegram));

    fc::frame const heard{
        .raw = telegram, .direction = static_cast<fc::direction>(flags % 3), .aligned = flags / 4 % 2 != 0};
    if (flags / 8 % 2 == 0) {
        check_frame<fc::vlt_layout>(heard, room);
    } else {
        check_frame<fc::data_layout<4, 12>>(heard, room);
    }

    if (heard.kind() != fc::data_kind::parameter) { return 0; }
    auto const given = fc::parameter_response::read(heard.data());
    check_thing(vlt6000::parameter_value{given.number(), given.pwe}, room);
    check_thing(vlt6000::control_word::from_raw(given.process.status_word()), room);
    check_thing(vlt6000::status_word::from_raw(given.process.status_word()), room);
    check_thing(given.process.output_frequency(), room);
    return 0;
}
