#include <drivecodec/fc/data_type.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::fc;

// VLT 6000 manual, "Data types supported by the VLT frequency converter".
static_assert(data_type{3} == data_type::integer_16 and data_type{4} == data_type::integer_32);
static_assert(data_type{5} == data_type::unsigned_8 and data_type{6} == data_type::unsigned_16);
static_assert(data_type{7} == data_type::unsigned_32 and data_type{9} == data_type::text_string);

TEST(data_type, numbers_have_width_and_sign)
{
    VERIFY(width_of(data_type{3}) == width::word and is_signed(data_type{3}));
    VERIFY(width_of(data_type{4}) == width::double_word and is_signed(data_type{4}));
    VERIFY(width_of(data_type{5}) == width::word and not is_signed(data_type{5}));
    VERIFY(width_of(data_type{6}) == width::word and not is_signed(data_type{6}));
    VERIFY(width_of(data_type{7}) == width::double_word and not is_signed(data_type{7}));
}

TEST(data_type, all_others_are_no_numbers)
{
    for (int number = 0; number <= 255; ++number) {
        EXPECT_EQ(is_number(static_cast<data_type>(number)), number >= 3 and number <= 7) << number;
    }
}

}  // namespace
