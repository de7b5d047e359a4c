// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/result.hpp>

namespace drivecodec::modbus::rtu {

namespace compile_error {
// Declared, never defined, not constexpr: calling one is how a consteval function says no. Its name is the text.
void server_address_must_be_between_1_and_247();
void address_0_is_the_broadcast_write_rtu_broadcast();
}  // namespace compile_error

/// Which server a frame is for or from: 1 to 247. MODBUS over Serial Line V1.02, 2.2.
///
/// 0 is the broadcast, as a constant `rtu::broadcast`. 248 to 255 are reserved: refused, unless one says so.
class server_address {
public:
    static constexpr std::uint8_t first = 1;
    static constexpr std::uint8_t last  = 247;

    consteval server_address(int address) : byte_{static_cast<std::uint8_t>(address)}
    {
        if (address == 0) { compile_error::address_0_is_the_broadcast_write_rtu_broadcast(); }
        if (address < first or address > last) { compile_error::server_address_must_be_between_1_and_247(); }
    }

    /// Of a byte known only at run time; 0 is the broadcast. Errors: `reserved_address` at 0.
    [[nodiscard]] static constexpr result<server_address> make(std::uint8_t byte) noexcept
    {
        if (byte > last) { return error{errc::reserved_address, 0}; }
        return reserved(byte);
    }

    /// Any byte, also those from 248 to 255, for devices that use them against the specification.
    [[nodiscard]] static constexpr server_address reserved(std::uint8_t byte) noexcept
    {
        return server_address{byte, any{}};
    }

    [[nodiscard]] constexpr std::uint8_t byte() const noexcept { return byte_; }
    [[nodiscard]] constexpr bool         is_broadcast() const noexcept { return byte_ == 0; }
    [[nodiscard]] constexpr bool         is_reserved() const noexcept { return byte_ > last; }

    friend constexpr bool operator==(server_address, server_address) noexcept = default;

private:
    struct any {};
    constexpr server_address(std::uint8_t byte, any) noexcept : byte_{byte} {}

    std::uint8_t byte_;
};

/// All servers: a type of its own, so that a constant broadcast of something but a write does not compile.
struct broadcast_address {
    constexpr operator server_address() const noexcept { return server_address::reserved(0); }
};
inline constexpr broadcast_address broadcast{};

}  // namespace drivecodec::modbus::rtu
