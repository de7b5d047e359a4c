#include <drivecodec/text/core.hpp>
#include <drivecodec/text/drives/smd/words.hpp>

#include "support/verify.hpp"

#include <array>
#include <cstdio>
#include <string>

namespace {

using namespace drivecodec::smd;
using drivecodec::describe;

template <typename Thing>
std::string text_of(Thing const& thing)
{
    std::array<char, 100> room{};
    return std::string{describe(thing, room)};
}

std::string command_text(unsigned raw)
{
    return text_of(decode_command(static_cast<std::uint16_t>(raw)));
}

TEST(text_smd_words, name_a_command_or_what_is_wrong_with_it)
{
    EXPECT_EQ(command_text(0x0001), "0001 update_buffers");
    EXPECT_EQ(command_text(0x0008), "0008 start");
    EXPECT_EQ(command_text(0x0200), "0200 local_speed_reference");
    EXPECT_EQ(command_text(0x0000), "0000 no_command");
    EXPECT_EQ(command_text(0x0010), "0010 unused_bit");
    EXPECT_EQ(command_text(0x000C), "000C several_with_stop");
    EXPECT_EQ(command_text(0x0048), "0048 several");
}

TEST(text_smd_words, begin_with_their_number)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        std::array<char, 5> digits{};
        std::snprintf(digits.data(), digits.size(), "%04X", raw);
        ASSERT_EQ(command_text(raw).substr(0, 4), digits.data());
        ASSERT_EQ(text_of(hardware::from_raw(static_cast<std::uint16_t>(raw))).substr(0, 4), digits.data());
    }
}

TEST(text_smd_words, name_what_is_on_the_memory_module)
{
    EXPECT_EQ(text_of(hardware{}), "0000");
    EXPECT_EQ(text_of(hardware::from_raw(0x0004)), "0004 oem_defaults_present");
    EXPECT_EQ(text_of(hardware::from_raw(0x000C)), "000C oem_defaults_present user_data_compatible_only");
    EXPECT_EQ(text_of(hardware::from_raw(0x8019)), "8019 user_data_compatible_only +8011");
}

TEST(text_smd_words, write_a_register_s_numbers_as_the_manual_does)
{
    EXPECT_EQ(text_of(*register_number::make_from_reference(40025)), "#24 (Modbus Register #25)");
    EXPECT_EQ(text_of(*register_number::make_from_smd(0)), "#0 (Modbus Register #1)");
}

}  // namespace
