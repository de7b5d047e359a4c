// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/cia402/state.hpp>
#include <drivecodec/drives/direction.hpp>

namespace drivecodec::xd1000 {

using drives::direction;

/// ETA, register 3201: what the drive says of itself. xD1000 manual, "Status word description".
///
/// The statusword of CiA 402 with the drive's own bits. Names say what a 1 means. Whether the motor has power does not
/// follow from the state: in Operation enabled it has none at zero reference and at halt.
struct status_word : word<status_word, std::uint16_t> {
    static constexpr flag<status_word> ready_to_switch_on{0};
    static constexpr flag<status_word> switched_on{1};
    static constexpr flag<status_word> operation_enabled{2};
    static constexpr flag<status_word> fault{3};
    static constexpr flag<status_word> voltage_enabled{4};  ///< Always 1, says the manual; its table of states does not.
    static constexpr flag<status_word> no_quick_stop{5};
    static constexpr flag<status_word> switch_on_disabled{6};
    static constexpr flag<status_word> remote{9};              ///< CMD is obeyed; 0: local mode.
    static constexpr flag<status_word> reference_reached{10};  ///< Steady state.
    static constexpr flag<status_word> reference_exceeded{11};  ///< The reference is below LSP or above HSP.
    static constexpr flag<status_word> stopped_by_stop_key{14};
    static constexpr field<status_word, xd1000::direction, 15, 1> direction{};  ///< Forward also at standstill.

    constexpr status_word() noexcept = default;
    /// Bit for bit.
    constexpr explicit status_word(cia402::status_word standard) noexcept { raw = standard.raw; }

    [[nodiscard]] constexpr cia402::status_word standard() const noexcept
    {
        return cia402::status_word::from_raw(raw);
    }

    [[nodiscard]] constexpr bool is_local() const noexcept { return not test(remote); }
};

/// The state that ETA reports, by the standard's masks 4F and 6F.
///
/// Never by comparing with the values that the manual prints as "ETA masked by 16#006F": they have bit 4 set, which that
/// mask clears. Errors: `bad_value` at 0 for a word that is no state.
[[nodiscard]] constexpr result<cia402::state> decode_state(status_word status) noexcept
{
    return cia402::decode_state(status.standard());
}

}  // namespace drivecodec::xd1000
