// SPDX-License-Identifier: MIT
#pragma once

#include "decoder.hpp"

#include <drivecodec/fc/framing.hpp>

#include <memory>

namespace support {

struct fc_options {
    drivecodec::fc::expecting expect         = drivecodec::fc::expecting::either;
    bool                      json           = false;
    std::size_t               process_words  = 2;      ///< Of `fc::data_layout`, at run time: 2 to 16
    unsigned                  parameter_bits = 11;     ///< and 11 or 12.
    bool                      vlt6000        = false;  ///< Explains the parameters and words of this drive.
};

/// The FC protocol. A telegram to or from a reserved address does not tell of it.
[[nodiscard]] std::unique_ptr<protocol_decoder> make_fc_decoder(fc_options const& chosen, std::ostream& out);

}  // namespace support
