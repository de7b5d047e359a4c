#include <drivecodec/modbus/answer.hpp>

#include <drivecodec/modbus/functions/read_device_identification.hpp>
#include <drivecodec/modbus/register_view.hpp>

#include "support/verify.hpp"

using namespace drivecodec;
using namespace drivecodec::modbus;

namespace {

constexpr answer<std::uint8_t> outputs(bool available)
{
    if (not available) { return exception_code::server_device_busy; }
    return std::uint8_t{0x6D};
}

TEST(modbus_answer, is_what_was_asked_for)
{
    VERIFY(outputs(true).has_value() and outputs(true) and *outputs(true) == 0x6D);
}

TEST(modbus_answer, or_an_exception)
{
    VERIFY(not outputs(false).has_value() and not outputs(false)
           and outputs(false).error() == exception_code::server_device_busy);
}

TEST(modbus_answer, of_something_that_is_done_takes_one_byte)
{
    VERIFY(sizeof(answer<done>) == 1);
    VERIFY(answer<done>{done{}}.has_value());
    VERIFY(answer<done>{exception_code::illegal_data_address}.error() == exception_code::illegal_data_address);
}

TEST(modbus_answer, gives_access_to_members)
{
    static constexpr std::array<std::uint16_t, 2> words{1, 2};
    VERIFY(answer<register_view>{register_view{words}}->size() == 2);
}

TEST(modbus_answer, may_be_of_something_without_a_default)
{
    using identification = answer<read_device_identification::response>;
    VERIFY(identification{exception_code::illegal_data_value}.error() == exception_code::illegal_data_value);
}

TEST(modbus_answer, of_exception_0_is_a_failure)
{
    VERIFY(answer<done>{exception_code{}}.error() == exception_code::server_device_failure);
}

TEST(modbus_answer, keeps_every_exception_code)
{
    for (unsigned code = 1; code <= 0xFF; ++code) {
        auto const refusal = static_cast<exception_code>(code);
        EXPECT_FALSE(answer<done>{refusal}) << code;
        EXPECT_EQ(answer<done>{refusal}.error(), refusal);
    }
}

}  // namespace
