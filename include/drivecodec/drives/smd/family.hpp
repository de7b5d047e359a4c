// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::smd {

/// Register 19, the same in all drives of the make: of which family a drive is. smd manual, table 2 and note 2. 67 has
/// no name there; other numbers may be of later families.
enum class family : std::uint16_t {
    qc  = 64,  ///< Also DL, by note 2.
    mc  = 65,
    sc  = 66,
    mch = 68,
    smd = 69,  ///< This drive.
    tc  = 70,
    tmd = 71,
    smv = 72,
};

}  // namespace drivecodec::smd
