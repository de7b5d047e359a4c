// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/error.hpp>

namespace drivecodec::fc {

/// Why a command cannot be executed: the number in PWE of the reply 0111. VLT 6000 manual, "Error message"; those
/// marked FC are of newer guides. Any other may come.
enum class parameter_error : std::uint16_t {
    parameter_does_not_exist     = 0,
    no_write_access              = 1,
    value_exceeds_limits         = 2,
    sub_index_does_not_exist     = 3,
    not_an_array                 = 4,
    data_type_does_not_match     = 5,
    only_reset                   = 6,   ///< FC: the value can only be set back.
    not_changeable               = 7,   ///< FC
    no_description               = 9,   ///< FC
    no_parameter_write_access    = 11,  ///< FC
    no_text                      = 15,  ///< FC
    not_possible_in_present_mode = 17,  ///< For example while the motor runs.
    other_error                  = 18,  ///< FC
    no_bus_access                = 130,
    factory_setup_selected       = 131,
    no_lcp_access                = 132,  ///< FC
    unknown_viewer               = 252,  ///< FC
    request_not_supported        = 253,  ///< FC
    unknown_attribute            = 254,  ///< FC
    no_error                     = 255,  ///< FC
};

/// Why there is no answer to a request: what is wrong with the bytes and where, as in `error`; or, if `code()` is
/// `exception_reply`, the number with which the slave replied that the command cannot be executed.
class reply_error : public error {
public:
    constexpr reply_error(error fault) noexcept : error{fault} {}
    constexpr reply_error(parameter_error refusal) noexcept
        : error{errc::exception_reply, static_cast<std::size_t>(refusal)}
    {}

    /// Precondition: code() == errc::exception_reply.
    [[nodiscard]] constexpr parameter_error number() const noexcept { return static_cast<parameter_error>(offset()); }
};

}  // namespace drivecodec::fc
