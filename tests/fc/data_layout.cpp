#include <drivecodec/fc/data_layout.hpp>

#include "support/verify.hpp"

namespace {

using namespace drivecodec::fc;

// VLT 6000 manual, "Telegram length (LGE)": 4 and 12 data bytes, and 10 + n with ADR and BCC.
TEST(data_layout, of_the_vlt_6000_has_the_lengths_of_the_manual)
{
    VERIFY(vlt_layout::process_size == 4 and vlt_layout::process_size + 1 + 1 == 6);
    VERIFY(vlt_layout::parameter_size == 12 and vlt_layout::parameter_size + 1 + 1 == 14);
    VERIFY(vlt_layout::around_text == 8 and vlt_layout::around_text + 1 + 1 == 10);
    VERIFY(vlt_layout::parameter_number_bits == 11);
}

TEST(data_layout, of_newer_guides_has_12_bits_and_the_same_lengths)
{
    VERIFY(fc_layout::parameter_number_bits == 12);
    VERIFY(fc_layout::process_size == vlt_layout::process_size);
    VERIFY(fc_layout::parameter_size == vlt_layout::parameter_size);
}

TEST(data_layout, grows_by_two_bytes_with_every_process_word)
{
    VERIFY(data_layout<4>::process_size == 8);
    VERIFY(data_layout<4>::parameter_size == 16 and data_layout<4>::around_text == 12);
    VERIFY(data_layout<16>::process_size == 32);
    VERIFY(data_layout<16>::parameter_size == 40 and data_layout<16>::around_text == 36);
    VERIFY(data_layout<>::process_words == 2);
}

}  // namespace
