// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/framing.hpp>
#include <drivecodec/fc/parameter.hpp>
#include <drivecodec/fc/text.hpp>

// The slave's side of the line.

namespace drivecodec::fc {

/// What a handler says to a parameter command: a value, or why not.
class parameter_answer {
public:
    /// Cannot be executed.
    constexpr parameter_answer(parameter_error refusal) noexcept
        : pwe_{static_cast<std::uint16_t>(refusal)}, reply_{ak_reply::cannot_be_executed}
    {}

    /// The value, as wide as its type: 16 bits and less are a word.
    template <parameter_integer T>
    [[nodiscard]] static constexpr parameter_answer value(T number) noexcept
    {
        if constexpr (sizeof(T) == 4) {
            return {ak_reply::double_word, static_cast<std::uint32_t>(number)};
        } else {
            return {ak_reply::word, static_cast<std::uint32_t>(number) & 0xFFFFU};
        }
    }

    /// Any other reply.
    constexpr parameter_answer(ak_reply reply, std::uint32_t pwe) noexcept : pwe_{pwe}, reply_{reply} {}

    [[nodiscard]] constexpr ak_reply      reply() const noexcept { return reply_; }
    [[nodiscard]] constexpr std::uint32_t pwe() const noexcept { return pwe_; }

    friend constexpr bool operator==(parameter_answer, parameter_answer) noexcept = default;

private:
    std::uint32_t pwe_;
    ak_reply      reply_;
};

/// What a handler says to a text command: the text as it now is, which lives until `serve` returns; or why not.
using text_answer = result<bytes, parameter_error>;

namespace detail {

/// PKE and IND of the request come back, AK apart.
constexpr void write_reply(bytes asked, mutable_bytes data, parameter_answer said) noexcept
{
    namespace at = layout::parameter;
    at::pke.store(data, pke::from_raw(at::pke.load(asked)).with(pke::reply, said.reply()).raw);
    at::ind.store(data, at::ind.load(asked));
    at::pwe_high.store(data, static_cast<std::uint16_t>(said.pwe() >> 16));
    at::pwe_low.store(data, static_cast<std::uint16_t>(said.pwe()));
}

/// Writes the parameter block of the response into `data`; returns its size.
template <typename Layout, typename Handler>
[[nodiscard]] constexpr std::size_t answer_parameter(bytes asked, mutable_bytes data, Handler& handler) noexcept
{
    using request = basic_parameter_request<Layout>;
    parameter_answer said{parameter_error::parameter_does_not_exist};
    auto const       given = request::read(asked);
    if (given.command() == ak_command::no_command) {
        said = {ak_reply::no_reply, 0};
    } else if constexpr (requires { handler(given); }) {
        static_assert(std::is_convertible_v<decltype(handler(given)), parameter_answer>,
                      "a handler answers a parameter_request with a parameter_answer or a parameter_error");
        said = handler(given);
    }
    write_reply(asked, data, said);
    return layout::parameter::process;
}

/// The same of a text; one that does not fit is an error.
template <typename Layout, typename Handler>
[[nodiscard]] constexpr std::size_t answer_text(bytes asked, mutable_bytes data, Handler& handler) noexcept
{
    using request = basic_text_request<Layout>;
    parameter_answer said{parameter_error::parameter_does_not_exist};
    if constexpr (requires(request const& given) { handler(given); }) {
        static_assert(std::is_convertible_v<decltype(handler(std::declval<request const&>())), text_answer>,
                      "a handler answers a text_request with a text_answer, bytes or a parameter_error");
        text_answer const text = handler(request::read(asked));
        auto const        room = data.size() - Layout::around_text;
        if (text and text->size() <= room) {
            copy_bytes(asked.first(layout::text::characters), data);
            copy_bytes(*text, data.subspan(layout::text::characters));
            return layout::text::characters + text->size();
        }
        said = text ? parameter_error::other_error : text.error();
    }
    write_reply(asked, data, said);
    return layout::parameter::process;
}

}  // namespace detail

/// Answers the telegram `wire` as the slave `own`: the telegram to send, at the front of `reply`; empty if there is none.
///
/// Silent for telegrams to other slaves, damaged ones, those with a length that the layout does not have, and
/// broadcasts, which are carried out. ADR comes back as it came, in whichever of its formats it names the slave.
///
/// The handler's overloads say what is served:
///   process_status   (process_command const&)     always, after what the telegram has of a parameter
///   parameter_answer (parameter_request const&)   every command but AK 0, also those without a meaning
///   text_answer      (text_request const&)        AK F; `access()` says whether it is read or written
/// Without the last two, every parameter "does not exist". `process_command::is_data_valid()` tells the handler whether
/// to obey: a drive ignores a control word without it, and still says its status.
///
/// Preconditions: `wire` and `reply` do not overlap; `wire` is nothing that the slave itself sent. A response looks
/// like a request to the slave it is from: who hears its own transmissions takes them out before.
///
/// 256 bytes are always enough for `reply`. With fewer than a parameter telegram has, what is asked is carried out and
/// nothing is said.
template <typename Layout = vlt_layout, typename Handler>
[[nodiscard]] constexpr bytes serve(address own, bytes wire, mutable_bytes reply, Handler&& handler) noexcept
{
    namespace at = layout::telegram;
    if (not check_telegram(wire, Layout::process_size, max_data_size).ok()) { return {}; }
    auto const received = frame{.raw = wire, .direction = direction::request, .aligned = true};
    auto const to       = received.address();
    auto const kind     = received.template kind<Layout>();
    if ((not to.is_broadcast() and to.number() != own.number()) or kind == data_kind::unknown) { return {}; }

    std::array<std::uint8_t, at::around + Layout::parameter_size> nobody;  // hears what is written here

    auto const is_silent = to.is_broadcast() or reply.size() < nobody.size();
    auto const out       = is_silent ? mutable_bytes{nobody} : first_at_most(reply, max_telegram_size);
    auto const asked     = data_of(wire);
    auto const data      = out.subspan(at::data, out.size() - at::around);

    std::size_t size = 0;
    if (kind == data_kind::parameter) { size = detail::answer_parameter<Layout>(asked, data, handler); }
    if (kind == data_kind::text) { size = detail::answer_text<Layout>(asked, data, handler); }
    using command                             = basic_process_command<Layout>;
    basic_process_status<Layout> const status = handler(command::read(asked.last(Layout::process_size)));
    if (is_silent) { return {}; }
    status.write(data.subspan(size, Layout::process_size));

    auto const whole = out.first(at::around + size + Layout::process_size);
    seal(whole, to);
    return whole;
}

/// The same for a telegram from a `reader`. A slave acts on aligned requests only: what was found amid dropped bytes may
/// be part of another telegram's data.
template <typename Layout = vlt_layout, typename Handler>
[[nodiscard]] constexpr bytes serve(address own, frame const& received, mutable_bytes reply, Handler&& handler) noexcept
{
    if (not received.aligned or received.direction != direction::request) { return {}; }
    return serve<Layout>(own, received.raw, reply, handler);
}

}  // namespace drivecodec::fc
