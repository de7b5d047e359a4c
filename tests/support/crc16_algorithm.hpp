#pragma once

#include "support/modbus_vectors.hpp"
#include "support/verify.hpp"

#include <drivecodec/modbus/crc16.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// What every algorithm must do: INSTANTIATE_TYPED_TEST_SUITE_P(name, crc16_algorithm, type).
template <typename Algorithm>
class crc16_algorithm : public testing::Test {};

TYPED_TEST_SUITE_P(crc16_algorithm);

namespace crc16_reference {

using drivecodec::bytes;

/// The specification's own procedure (MODBUS over Serial Line V1.02, 6.2.2), step by step.
inline std::uint16_t update(std::uint16_t crc, std::uint8_t byte)
{
    crc = static_cast<std::uint16_t>(crc ^ byte);
    for (int shift = 0; shift < 8; ++shift) {
        bool const shifted_out = crc % 2 == 1;
        crc                    = crc / 2;
        if (shifted_out) { crc = static_cast<std::uint16_t>(crc ^ 0xA001); }
    }
    return crc;
}

inline constexpr std::size_t max_length = 300;
inline constexpr std::size_t alignments = 16;

struct alignas(alignments) aligned_bytes {
    std::array<std::uint8_t, max_length + alignments> byte;
};

inline aligned_bytes pseudo_random_bytes()
{
    aligned_bytes made{};
    std::uint32_t state = 1;
    for (auto& byte : made.byte) {
        state = state * 1103515245 + 12345;
        byte  = static_cast<std::uint8_t>(state >> 16);
    }
    return made;
}

}  // namespace crc16_reference

TYPED_TEST_P(crc16_algorithm, gives_the_check_value_of_the_catalogue)
{
    namespace crc16 = drivecodec::modbus::crc16;
    VERIFY(crc16::compute<TypeParam>(vectors::crc_check_input) == vectors::crc_check);
    EXPECT_EQ(crc16::compute<TypeParam>(opaque(vectors::crc_check_input)), vectors::crc_check);
}

TYPED_TEST_P(crc16_algorithm, of_nothing_changes_nothing)
{
    VERIFY(TypeParam::update(0x1234, {}) == 0x1234);
}

TYPED_TEST_P(crc16_algorithm, of_a_printed_frame_leaves_the_residue)
{
    namespace crc16 = drivecodec::modbus::crc16;
    VERIFY(crc16::compute<TypeParam>(vectors::xd1000_read_request) == crc16::residue);
    VERIFY(crc16::compute<TypeParam>(vectors::xd1000_read_response) == crc16::residue);
    VERIFY(crc16::compute<TypeParam>(vectors::xd1000_write_request) == crc16::residue);
    VERIFY(crc16::compute<TypeParam>(vectors::introduction_read_request) == crc16::residue);
}

TYPED_TEST_P(crc16_algorithm, is_the_specification_s_for_every_length_and_alignment)
{
    namespace crc16   = drivecodec::modbus::crc16;
    auto const random = opaque(crc16_reference::pseudo_random_bytes());
    for (std::size_t alignment = 0; alignment < crc16_reference::alignments; ++alignment) {
        auto expected = crc16::initial;
        for (std::size_t length = 0; length <= crc16_reference::max_length; ++length) {
            auto const message = std::span{random.byte}.subspan(alignment, length);
            ASSERT_EQ(crc16::compute<TypeParam>(message), expected) << length << " bytes at " << alignment;
            if (length < crc16_reference::max_length) {
                expected = crc16_reference::update(expected, random.byte[alignment + length]);
            }
        }
    }
}

TYPED_TEST_P(crc16_algorithm, continues_at_every_split)
{
    namespace crc16   = drivecodec::modbus::crc16;
    auto const random = opaque(crc16_reference::pseudo_random_bytes());
    for (std::size_t length = 0; length <= crc16_reference::max_length; ++length) {
        auto const message = std::span{random.byte}.first(length);
        auto const whole   = crc16::compute<TypeParam>(message);
        for (std::size_t split = 0; split <= length; ++split) {
            auto const begun = crc16::compute<TypeParam>(message.first(split));
            ASSERT_EQ(TypeParam::update(begun, message.subspan(split)), whole) << split << " of " << length;
        }
    }
}

TYPED_TEST_P(crc16_algorithm, continues_from_every_value)
{
    for (std::uint32_t crc = 0; crc <= 0xFFFF; ++crc) {
        auto const from = static_cast<std::uint16_t>(crc);
        for (auto const& message : std::array<std::array<std::uint8_t, 1>, 4>{{{0x00}, {0x01}, {0x80}, {0xFF}}}) {
            ASSERT_EQ(TypeParam::update(from, message), crc16_reference::update(from, message[0])) << crc;
        }
    }
}

TYPED_TEST_P(crc16_algorithm, of_a_message_with_its_crc_is_the_residue)
{
    namespace crc16 = drivecodec::modbus::crc16;
    auto random     = crc16_reference::pseudo_random_bytes();
    for (std::size_t length = 0; length <= crc16_reference::max_length; ++length) {
        auto       wire       = random;
        auto const crc        = crc16::compute<TypeParam>(std::span{wire.byte}.first(length));
        wire.byte[length]     = static_cast<std::uint8_t>(crc);
        wire.byte[length + 1] = static_cast<std::uint8_t>(crc >> 8);
        ASSERT_EQ(crc16::compute<TypeParam>(std::span{wire.byte}.first(length + 2)), crc16::residue) << length;
    }
}

REGISTER_TYPED_TEST_SUITE_P(crc16_algorithm, gives_the_check_value_of_the_catalogue, of_nothing_changes_nothing,
                            of_a_printed_frame_leaves_the_residue,
                            is_the_specification_s_for_every_length_and_alignment, continues_at_every_split,
                            continues_from_every_value, of_a_message_with_its_crc_is_the_residue);
