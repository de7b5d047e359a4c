#include <drivecodec/modbus/crc16.hpp>

#include "support/modbus_vectors.hpp"
#include "support/verify.hpp"

#include <drivecodec/modbus/crc16/byte_table.hpp>
#include <drivecodec/modbus/crc16/carryless.hpp>
#include <drivecodec/modbus/crc16/nibble.hpp>

namespace {

using drivecodec::bytes;
namespace crc16 = drivecodec::modbus::crc16;

//=== the default ===//

static_assert(std::is_same_v<crc16::by_default, crc16::slices> == drivecodec::is_host);
static_assert(std::is_same_v<crc16::by_default, crc16::bitwise> == not drivecodec::is_host);

TEST(crc16, computes_by_default)
{
    VERIFY(crc16::compute(vectors::crc_check_input) == vectors::crc_check);
    VERIFY(crc16::compute({}) == crc16::initial);
    VERIFY(crc16::compute(bytes{vectors::introduction_read_request}.first(6)) == 0x8776);  // 76 87 on the wire
}

TEST(crc16, finds_every_wrong_bit)
{
    for (std::size_t bit = 0; bit < 8 * vectors::xd1000_read_response.size(); ++bit) {
        auto wire     = vectors::xd1000_read_response;
        wire[bit / 8] = static_cast<std::uint8_t>(wire[bit / 8] ^ (1U << (bit % 8)));
        EXPECT_NE(crc16::compute(wire), crc16::residue) << "bit " << bit;
    }
}

//=== the choice ===//

static_assert(crc16::algorithm<crc16::bitwise>);
static_assert(crc16::algorithm<crc16::nibble>);
static_assert(crc16::algorithm<crc16::byte_table>);
static_assert(crc16::algorithm<crc16::slices>);
static_assert(crc16::algorithm<crc16::carryless>);

struct peripheral {
    static std::uint16_t update(std::uint16_t crc, bytes data) noexcept
    {
        ++calls;
        return crc16::bitwise::update(crc, data);
    }
    static inline int calls = 0;
};
static_assert(crc16::algorithm<peripheral>);

struct may_throw {
    static std::uint16_t update(std::uint16_t crc, bytes data);
};
struct of_32_bits {
    static std::uint32_t update(std::uint32_t crc, bytes data) noexcept;
};
static_assert(not crc16::algorithm<may_throw>);
static_assert(not crc16::algorithm<of_32_bits>);
static_assert(not crc16::algorithm<int>);

TEST(crc16, takes_a_user_s_algorithm)
{
    EXPECT_EQ(crc16::compute<peripheral>(vectors::crc_check_input), vectors::crc_check);
    EXPECT_EQ(peripheral::calls, 1);
}

}  // namespace
