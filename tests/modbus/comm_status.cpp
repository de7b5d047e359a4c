#include <drivecodec/modbus/comm_status.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::modbus::comm_status;

TEST(comm_status, is_one_of_two_words)
{
    for (unsigned word = 0; word <= 0xFFFF; ++word) {
        EXPECT_EQ(comm_status::is_valid(static_cast<std::uint16_t>(word)), word == 0x0000 or word == 0xFFFF) << word;
    }
}

TEST(comm_status, is_what_the_specification_says)
{
    VERIFY(comm_status::to_wire(true) == 0xFFFF);
    VERIFY(comm_status::to_wire(false) == 0x0000);
}

}  // namespace
