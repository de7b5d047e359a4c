// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/word.hpp>

namespace drivecodec::smd {

/// Register 22: what is on the drive's memory module, the EPM. smd manual, table 9.
struct hardware : word<hardware, std::uint16_t> {
    static constexpr flag<hardware> reserved_0{0};
    static constexpr flag<hardware> reserved_1{1};
    static constexpr flag<hardware> oem_defaults_present{2};  ///< 0: there are none.
    /// 0: the EPM has the parameter version of the software, or is not compatible at all, of which a fault tells. 1: its
    /// data are valid and used, but of another parameter version: none can be edited until they are translated.
    ///
    /// The faults of the 0 are `control_fault` and `incompatibility_fault`; the third that the manual names, "GF (data
    /// fault)", is in none of its tables. It translates "with P48", a parameter of another family: here C02 = 4 does.
    static constexpr flag<hardware> user_data_compatible_only{3};
};

}  // namespace drivecodec::smd
