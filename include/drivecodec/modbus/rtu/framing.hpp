// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/functions.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

namespace drivecodec::modbus::rtu {

/// A whole valid frame: its CRC is right, its length is that of its function. Its fields have not been checked.
struct frame {
    bytes             raw;        ///< From the server address to the CRC.
    modbus::direction direction;  ///< What it was read as.
    bool              aligned;  ///< It began after a silence or directly behind a valid frame, not amid dropped bytes.

    [[nodiscard]] constexpr std::uint8_t  address() const noexcept { return layout::adu::address.load(raw); }
    [[nodiscard]] constexpr bytes         pdu() const noexcept { return pdu_of(raw); }
    [[nodiscard]] constexpr function_code function() const noexcept
    {
        return static_cast<function_code>(pdu().front() & ~exception_bit);
    }
    [[nodiscard]] constexpr bool is_exception() const noexcept { return exception_response::is_exception(pdu()); }
};

/// Which frames a reader listens for.
enum class expecting : std::uint8_t {
    either,    ///< All that is on the line: a monitor, or a server on a shared line.
    request,   ///< A server alone with its client.
    response,  ///< A client that does not hear its own requests.
};

/// How RTU frames are told apart in a stream; the `framing` of `rtu::reader`.
///
/// The readings of the bytes at the front, in order: a response first if the last frame was a request of that address
/// and function, else a request first. What is addressed to `own_address` is a request only. A refusal of function 43
/// has two lengths: with and without the MEI type.
template <typename Functions = public_functions, crc16::algorithm Crc = crc16::by_default>
class framing {
public:
    using frame = rtu::frame;

    static constexpr unsigned    max_readings   = 4;
    static constexpr std::size_t min_frame_size = min_adu_size;
    static constexpr std::size_t max_frame_size = max_adu_size;

    constexpr framing() noexcept = default;
    constexpr explicit framing(expecting what) noexcept : expecting_{what} {}
    constexpr framing(expecting what, server_address own_address) noexcept
        : own_address_{own_address.byte()}, expecting_{what}
    {}

    [[nodiscard]] constexpr message_length length(bytes front, unsigned reading) const noexcept
    {
        constexpr auto header = layout::adu::pdu + modbus::layout::function.end;
        if (front.size() < header) { return message_length::at_least(header); }

        auto const is_second = reading >= 2;
        if (reading % 2 == 0) { return length_of(front, is_second); }
        // The other length of a refusal. Half of all readings of noise end here, inlined.
        if (front[layout::adu::pdu] != exception_response::mei_function) { return message_length::impossible(); }
        if (is_second and reads_one_way(front)) { return message_length::impossible(); }
        if (direction_of(front, is_second) == direction::request) { return message_length::impossible(); }
        return message_length::exactly(exception_response::mei_size + layout::adu::around);
    }

    [[nodiscard]] static constexpr bool is_intact(bytes adu) noexcept { return has_valid_crc<Crc>(adu); }

    [[nodiscard]] constexpr frame accept(bytes raw, unsigned reading, bool aligned) noexcept
    {
        auto const accepted = frame{.raw = raw, .direction = direction_of(raw, reading >= 2), .aligned = aligned};
        asked_              = accepted.direction == direction::request and accepted.address() != 0
                 and Functions::expects_reply(accepted.pdu());
        asked_address_  = accepted.address();
        asked_function_ = accepted.function();
        return accepted;
    }

    /// Nobody answered the last request.
    constexpr void request_timed_out() noexcept { asked_ = false; }

private:
    /// Precondition: front.size() >= 2.
    [[nodiscard]] constexpr message_length length_of(bytes front, bool is_second) const noexcept
    {
        if (is_second and reads_one_way(front)) { return message_length::impossible(); }
        auto const pdu    = front.subspan(layout::adu::pdu);
        auto const length = direction_of(front, is_second) == direction::request ? Functions::request_length(pdu)
                                                                                 : Functions::response_length(pdu);
        return length.plus(length.is_open() ? layout::adu::pdu : layout::adu::around);
    }

    [[nodiscard]] constexpr direction direction_of(bytes front, bool is_second) const noexcept
    {
        return is_second ? other(first_direction(front)) : first_direction(front);
    }

    [[nodiscard]] static constexpr direction other(direction d) noexcept
    {
        return d == direction::request ? direction::response : direction::request;
    }

    [[nodiscard]] constexpr bool is_own(bytes front) const noexcept
    {
        return own_address_ != 0 and layout::adu::address.load(front) == own_address_;
    }

    [[nodiscard]] constexpr bool reads_one_way(bytes front) const noexcept
    {
        return expecting_ != expecting::either or is_own(front);
    }

    /// Precondition: front.size() >= 2.
    [[nodiscard]] constexpr direction first_direction(bytes front) const noexcept
    {
        if (is_own(front) or expecting_ == expecting::request) { return direction::request; }
        if (expecting_ == expecting::response) { return direction::response; }
        auto const function = front[layout::adu::pdu] & ~exception_bit;
        auto const is_answer =
            asked_ and layout::adu::address.load(front) == asked_address_ and function == to_byte(asked_function_);
        return is_answer ? direction::response : direction::request;
    }

    std::uint8_t  own_address_ = 0;  // 0: none
    expecting     expecting_   = expecting::either;
    bool          asked_       = false;  // the last frame was a request that gets a reply:
    std::uint8_t  asked_address_{};
    function_code asked_function_{};
};

}  // namespace drivecodec::modbus::rtu
