#include <drivecodec/drives/smd/family.hpp>

#include "support/verify.hpp"

namespace {

using drivecodec::smd::family;

// smd manual, table 2 and note 2: decimal and hexadecimal.
static_assert(family{64} == family::qc and family{0x40} == family::qc);
static_assert(family{65} == family::mc and family{0x41} == family::mc);
static_assert(family{66} == family::sc and family{0x42} == family::sc);
static_assert(family{68} == family::mch and family{0x44} == family::mch);
static_assert(family{69} == family::smd and family{0x45} == family::smd);
static_assert(family{70} == family::tc and family{0x46} == family::tc);
static_assert(family{71} == family::tmd and family{0x47} == family::tmd);
static_assert(family{72} == family::smv and family{0x48} == family::smv);

TEST(smd_manual, replies_to_a_read_of_register_19_with_0045)
{
    VERIFY(family{0x0045} == family::smd);
}

TEST(smd_manual, leaves_family_67_blank_and_names_DL_in_a_note_only)
{
    // 67, and what may come later, stay numbers; a DL cannot be told from a QC.
    VERIFY(static_cast<int>(family{67}) == 67);
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        ASSERT_EQ(static_cast<unsigned>(family{static_cast<std::uint16_t>(raw)}), raw);
    }
}

}  // namespace
