// SPDX-License-Identifier: MIT
#pragma once

#include "decoder.hpp"

#include <drivecodec/fc/framing.hpp>

#include <functional>
#include <memory>

namespace support {

/// What a telegram means to a drive. Empty: nothing known.
using fc_explainer = std::function<std::string(drivecodec::fc::frame const&)>;

struct fc_options {
    drivecodec::fc::expecting expect         = drivecodec::fc::expecting::either;
    style                     how            = style::text;
    std::size_t               process_words  = 2;   ///< Of `fc::data_layout`, at run time: 2 to 16
    unsigned                  parameter_bits = 11;  ///< and 11 or 12.
    fc_explainer              explain        = {};
};

/// The FC protocol. A telegram to or from a reserved address does not tell of it.
[[nodiscard]] std::unique_ptr<protocol_decoder> make_fc_decoder(fc_options const& chosen, sink out);

}  // namespace support
