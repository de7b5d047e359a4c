// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/message_length.hpp>
#include <drivecodec/fc/direction.hpp>
#include <drivecodec/fc/parameter.hpp>
#include <drivecodec/fc/telegram.hpp>

namespace drivecodec::fc {

/// A whole telegram: STX, an LGE that can be, and the right BCC. Its fields have not been checked.
struct frame {
    bytes         raw;  ///< From STX to BCC.
    fc::direction direction;
    bool          aligned;  ///< It began after a silence or directly behind a valid telegram, not amid dropped bytes.

    [[nodiscard]] constexpr fc::address address() const noexcept
    {
        return fc::address::from_byte(layout::telegram::adr.load(raw));
    }
    [[nodiscard]] constexpr bytes data() const noexcept { return data_of(raw); }

    /// What its data are in this layout: their length tells process data and parameters, AK F tells texts, also from a
    /// parameter of the same length.
    template <typename Layout = vlt_layout>
    [[nodiscard]] constexpr data_kind kind() const noexcept
    {
        auto const size = data().size();
        if (size == Layout::process_size) { return data_kind::process; }
        if (size < Layout::around_text) { return data_kind::unknown; }
        if (ak() == static_cast<std::uint8_t>(ak_command::text)) { return data_kind::text; }
        return size == Layout::parameter_size ? data_kind::parameter : data_kind::unknown;
    }

    /// The four bits of AK, as a number: their meaning depends on the direction. Precondition: the data have a PKE.
    [[nodiscard]] constexpr std::uint8_t ak() const noexcept { return static_cast<std::uint8_t>(data().front() >> 4); }
};

/// Which telegrams a reader listens for. Nothing in a telegram tells that it comes from oneself: a slave, or a master
/// that expects responses, takes the echo of its own transmissions out of the stream first, if it hears them.
enum class expecting : std::uint8_t {
    either,    ///< All that is on the line: a monitor, or a slave on a shared line.
    request,   ///< A slave alone with its master.
    response,  ///< A master that does not hear itself.
};

/// How telegrams are told apart in a stream; the `framing` of `fc::reader`.
///
/// A telegram begins with STX, LGE says its length, BCC is right: there is one reading of each byte.
///
/// The direction is that of what is expected; of broadcasts and of what has the own address it is a request. Else AK D
/// and E, and 3 where it is no reply, tell a request, and 7 a response. Else it comes from what was heard before: behind a
/// request comes the response of the same address, or the request to another; behind a response a request, for slaves
/// speak only when asked. Where nothing of this is known yet, it is unknown.
template <typename Layout = vlt_layout>
class framing {
public:
    using frame = fc::frame;

    static constexpr unsigned    max_readings   = 1;
    static constexpr std::size_t min_frame_size = layout::telegram::around + vlt_layout::process_size;  // of any layout
    static constexpr std::size_t max_frame_size = max_telegram_size;

    constexpr framing() noexcept = default;
    constexpr explicit framing(expecting what) noexcept : expecting_{what} {}
    constexpr framing(expecting what, address own_address) noexcept
        : own_number_{own_address.number()}, expecting_{what}
    {}

    [[nodiscard]] constexpr message_length length(bytes front, unsigned) const noexcept
    {
        namespace at = layout::telegram;
        if (at::stx.load(front) != stx) { return message_length::impossible(); }
        if (front.size() < at::lge.end) { return message_length::at_least(at::lge.end); }
        return message_length::exactly(at::lge.load(front) + at::not_in_lge);
    }

    [[nodiscard]] static constexpr bool is_intact(bytes telegram) noexcept { return bcc::of(telegram) == 0; }

    [[nodiscard]] constexpr frame accept(bytes raw, unsigned, bool aligned) noexcept
    {
        auto heard      = frame{.raw = raw, .direction = direction::unknown, .aligned = aligned};
        heard.direction = direction_of(heard);
        last_           = heard.direction;
        last_adr_       = heard.address().byte();
        return heard;
    }

    /// Nobody answered in time, nor will: the next telegram is a request, also where no direction was known before.
    constexpr void request_timed_out() noexcept { last_ = direction::response; }

private:
    [[nodiscard]] constexpr direction direction_of(frame const& heard) const noexcept
    {
        auto const adr = heard.address();
        if (expecting_ == expecting::response) { return direction::response; }
        if (expecting_ == expecting::request or adr.is_broadcast()) { return direction::request; }
        if (own_number_ != 0 and adr.number() == own_number_) { return direction::request; }
        auto const told = heard.template kind<Layout>() == data_kind::parameter ? direction_of(heard.ak()) : unknown;
        if (told != unknown or last_ == unknown) { return told; }
        if (last_ == direction::response or adr.byte() != last_adr_) { return direction::request; }
        return direction::response;
    }

    /// Of an AK that only one side sends.
    [[nodiscard]] static constexpr direction direction_of(std::uint8_t ak) noexcept
    {
        constexpr auto has_descriptions = Layout::parameter_number_bits == 12;  // of which AK 3 is the reply
        switch (ak_command{ak}) {
        case ak_command::write_double_word: return has_descriptions ? unknown : direction::request;
        case ak_command::write_double_word_to_eeprom:
        case ak_command::write_word_to_eeprom: return direction::request;
        default: return ak_reply{ak} == ak_reply::cannot_be_executed ? direction::response : unknown;
        }
    }

    static constexpr auto unknown = direction::unknown;

    std::uint8_t own_number_ = 0;  // 0: none
    expecting    expecting_  = expecting::either;
    direction    last_       = direction::unknown;  // response also where nobody answered
    std::uint8_t last_adr_   = 0;
};

}  // namespace drivecodec::fc
