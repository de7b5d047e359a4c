// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/message.hpp>

namespace drivecodec::modbus {

/// A PDU of which only the size is known: what a gateway passes from one line to another. 1 to 253 bytes, borrowed.
class raw_pdu {
public:
    static constexpr bool is_pdu = true;

    /// Errors: those of `check`.
    [[nodiscard]] static constexpr result<raw_pdu> make(bytes pdu) noexcept
    {
        if (auto const fault = check(pdu); not fault.ok()) { return fault; }
        return read(pdu);
    }

    /// Refused: it would outlive the bytes. Name the buffer first.
    template <owning_temporary Temporary>
    static result<raw_pdu> make(Temporary&&) = delete;

    [[nodiscard]] constexpr bytes         wire() const noexcept { return wire_; }
    [[nodiscard]] constexpr function_code function() const noexcept
    {
        return static_cast<function_code>(layout::function.load(wire_));
    }

    [[nodiscard]] constexpr std::size_t wire_size() const noexcept { return wire_.size(); }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        if (pdu.empty()) { return {errc::truncated, 1}; }
        return pdu.size() > max_pdu_size ? error{errc::trailing_bytes, max_pdu_size} : error{};
    }

    [[nodiscard]] static constexpr raw_pdu read(bytes pdu) noexcept { return raw_pdu{pdu}; }

    constexpr void write(mutable_bytes out) const noexcept { copy_bytes(wire_, out); }

    friend constexpr bool operator==(raw_pdu const& a, raw_pdu const& b) noexcept
    {
        return same_bytes(a.wire_, b.wire_);
    }

private:
    constexpr explicit raw_pdu(bytes pdu) noexcept : wire_{pdu} {}

    bytes wire_;
};

}  // namespace drivecodec::modbus
