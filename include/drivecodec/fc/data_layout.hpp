// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace drivecodec::fc {

/// What the bytes between ADR and BCC are.
enum class data_kind : std::uint8_t {
    process,    ///< PCD1 PCD2
    parameter,  ///< PKE IND PWEhigh PWElow PCD1 PCD2
    text,       ///< PKE IND characters PCD1 PCD2
    unknown,    ///< A length that the layout does not have: it needs another layout.
};

/// How long the blocks of a telegram's data are. Both sides of a line have to be set up alike: no field tells.
///
/// VLT 6000: two process words, parameter numbers of 11 bits, of which bit 11 is none. Newer FC guides have
/// numbers of 12 bits, and drives with more process words.
template <std::size_t ProcessWords = 2, unsigned ParameterNumberBits = 11>
struct data_layout {
    static_assert(ProcessWords >= 2 and ProcessWords <= 16, "PCD has 2 to 16 words");
    static_assert(ParameterNumberBits == 11 or ParameterNumberBits == 12, "parameter numbers have 11 or 12 bits");

    static constexpr std::size_t process_words         = ProcessWords;
    static constexpr unsigned    parameter_number_bits = ParameterNumberBits;

    static constexpr std::size_t process_size   = 2 * ProcessWords;
    static constexpr std::size_t parameter_size = 8 + process_size;
    static constexpr std::size_t around_text    = 4 + process_size;  ///< The bytes of a text's data that are no text.
};

/// VLT 6000, and what the newer drives make of it by default.
using vlt_layout = data_layout<2, 11>;
/// Newer FC guides: parameter numbers of 12 bits.
using fc_layout = data_layout<2, 12>;

}  // namespace drivecodec::fc
