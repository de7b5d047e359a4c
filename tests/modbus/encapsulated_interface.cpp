#include <drivecodec/modbus/encapsulated_interface.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

constexpr auto type = mei_type::read_device_identification;

TEST(mei_type, has_the_number_of_the_specification)
{
    VERIFY(static_cast<int>(mei_type::canopen_general_reference) == 13);
    VERIFY(static_cast<int>(mei_type::read_device_identification) == 14);
}

TEST(mei_head, is_looked_at_before_the_length)
{
    VERIFY(check_mei_head({}, type, 4, 7) == error{errc::truncated, 7});
    VERIFY(check_mei_head("2A"_hex, type, 4, 7) == error{errc::unexpected_function, 0});
    VERIFY(check_mei_head("2A 0E"_hex, type, 4, 7) == error{errc::unexpected_function, 0});
    VERIFY(check_mei_head("2B"_hex, type, 4, 7) == error{errc::truncated, 7});
    VERIFY(check_mei_head("2B 0D"_hex, type, 4, 7) == error{errc::unexpected_function, 1});
    VERIFY(check_mei_head("2B 0D 01 02 03"_hex, type, 4, 7) == error{errc::unexpected_function, 1});
    VERIFY(check_mei_head("2B 0E 01"_hex, type, 4, 7) == error{errc::truncated, 7});
    VERIFY(check_mei_head("2B 0E 01 00"_hex, type, 4, 7).ok());
}

TEST(mei_head, is_written)
{
    constexpr auto written = [] {
        std::array<std::uint8_t, 3> out{0xEE, 0xEE, 0xEE};
        write_mei_head(out, mei_type::canopen_general_reference);
        return out;
    };
    VERIFY(written() == "2B 0D EE"_hex);
}

}  // namespace
