// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/word.hpp>

namespace drivecodec::vlt6000 {

/// Parameter 521: which of the 8 inputs have a signal. VLT 6000 manual, "Digital input, parameter 521".
///
/// Terminal 16 is the bit to the extreme left, of eight: bit 7. How many bits are transferred, the manual does not say;
/// those above the eight survive.
struct digital_inputs : word<digital_inputs, std::uint16_t> {
    static constexpr flag<digital_inputs> terminal_16{7};
    static constexpr flag<digital_inputs> terminal_17{6};
    static constexpr flag<digital_inputs> terminal_18{5};
    static constexpr flag<digital_inputs> terminal_19{4};
    static constexpr flag<digital_inputs> terminal_27{3};
    static constexpr flag<digital_inputs> terminal_29{2};
    static constexpr flag<digital_inputs> terminal_32{1};
    static constexpr flag<digital_inputs> terminal_33{0};
};

}  // namespace drivecodec::vlt6000
