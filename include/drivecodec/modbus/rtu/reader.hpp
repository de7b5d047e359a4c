// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/deframer.hpp>
#include <drivecodec/modbus/rtu/framing.hpp>

namespace drivecodec::modbus::rtu {

/// Finds every valid frame in a noisy line; see `deframer` for how to feed it and what comes out.
///
/// `Functions` are those whose lengths it knows, whatever a server serves; a frame of any other function ends with
/// a silence. A silence is t3.5 of `rtu::timing`.
template <typename Functions = public_functions, crc16::algorithm Crc = crc16::by_default,
          std::size_t Capacity = max_adu_size + 64>
class basic_reader : public deframer<framing<Functions, Crc>, Capacity> {
    using base = deframer<framing<Functions, Crc>, Capacity>;

public:
    /// Listens to everything: requests, and responses in the light of the request before.
    constexpr basic_reader() noexcept = default;
    constexpr explicit basic_reader(expecting what) noexcept : base{framing<Functions, Crc>{what}} {}

    /// Of the server with this address, on a line that it may share with others: what has its address is a request.
    constexpr basic_reader(expecting what, server_address own_address) noexcept
        : base{framing<Functions, Crc>{what, own_address}}
    {}

    /// Nobody answered the last request: the next frame is not its response.
    constexpr void request_timed_out() noexcept
    {
        this->scheme().request_timed_out();
        this->reconsider();
    }
};

using reader = basic_reader<>;

}  // namespace drivecodec::modbus::rtu
