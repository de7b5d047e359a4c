#include <drivecodec/modbus/rtu/address.hpp>

#include "support/verify.hpp"

namespace {

namespace rtu = drivecodec::modbus::rtu;
using drivecodec::errc;
using drivecodec::error;
using rtu::server_address;

TEST(rtu_server_address, is_1_to_247_as_a_constant)
{
    static constexpr server_address first = 1;
    static constexpr server_address last  = 247;
    VERIFY(first.byte() == 1 and not first.is_broadcast() and not first.is_reserved());
    VERIFY(last.byte() == 247 and not last.is_broadcast() and not last.is_reserved());
}

TEST(rtu_server_address, is_made_of_a_byte_that_is_not_reserved)
{
    for (int byte = 0; byte <= 0xFF; ++byte) {
        auto const made = server_address::make(static_cast<std::uint8_t>(byte));
        ASSERT_EQ(made.has_value(), byte <= 247) << byte;
        if (made) {
            ASSERT_EQ(made->byte(), byte);
            ASSERT_EQ(made->is_broadcast(), byte == 0);
            ASSERT_FALSE(made->is_reserved());
        } else {
            ASSERT_EQ(made.error(), error(errc::reserved_address, 0));
        }
    }
    VERIFY(server_address::make(17)->byte() == 17);
    VERIFY(server_address::make(248).error() == error{errc::reserved_address, 0});
}

TEST(rtu_server_address, is_any_byte_for_who_says_so)
{
    for (int byte = 0; byte <= 0xFF; ++byte) {
        auto const address = server_address::reserved(static_cast<std::uint8_t>(byte));
        ASSERT_EQ(address.byte(), byte);
        ASSERT_EQ(address.is_broadcast(), byte == 0);
        ASSERT_EQ(address.is_reserved(), byte > 247);
    }
}

TEST(rtu_server_address, is_compared_by_its_byte)
{
    static constexpr server_address seventeen = 17;
    VERIFY(seventeen == *server_address::make(17));
    VERIFY(seventeen != *server_address::make(18));
}

TEST(rtu_server_address, is_the_broadcast_by_name)
{
    static constexpr server_address all = rtu::broadcast;
    VERIFY(all.is_broadcast());
    VERIFY(all == *server_address::make(0));
    static_assert(sizeof(server_address) == 1);
}

}  // namespace
