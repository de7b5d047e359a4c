// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/parameter.hpp>
#include <drivecodec/fc/telegram.hpp>
#include <drivecodec/fc/text.hpp>

// The master's side of the line: is this the response to that request?

namespace drivecodec::fc {

/// Will a slave answer? None answers a broadcast.
[[nodiscard]] constexpr bool expects_reply(address to) noexcept
{
    return not to.is_broadcast();
}

namespace detail {

//=== which response a request has ===//

template <typename Layout>
basic_process_status<Layout> response_of(basic_process_command<Layout> const&);
template <typename Layout>
basic_parameter_response<Layout> response_of(basic_parameter_request<Layout> const&);
template <typename Layout, typename Text>
basic_text_response<Layout> response_of(basic_text_data<Layout, basic_process_command<Layout>, Text> const&);

//=== does the telegram `wire`, which is a valid one with data of the right size, answer? ===//

/// Which replies answer each of the 16 commands: bit n is AK n. A word written is answered as a word; what is read may
/// have either width. Nobody knows what answers a command without a meaning; a text does not.
inline constexpr std::array<std::uint16_t, 16> answering = [] {
    constexpr auto bit = [](ak_reply reply) { return static_cast<std::uint16_t>(1U << static_cast<unsigned>(reply)); };
    std::array<std::uint16_t, 16> replies{};
    for (unsigned command = 0; command < replies.size(); ++command) {
        replies[command] = static_cast<std::uint16_t>(~bit(ak_reply::text));
        switch (ak_command{static_cast<std::uint8_t>(command)}) {
        case ak_command::no_command: replies[command] = bit(ak_reply::no_reply); break;
        case ak_command::read_value: replies[command] = bit(ak_reply::word) | bit(ak_reply::double_word); break;
        case ak_command::write_word:
        case ak_command::write_word_to_eeprom: replies[command] = bit(ak_reply::word); break;
        case ak_command::write_double_word:
        case ak_command::write_double_word_to_eeprom: replies[command] = bit(ak_reply::double_word); break;
        case ak_command::read_description: replies[command] = bit(ak_reply::description); break;
        case ak_command::text: replies[command] = bit(ak_reply::text); break;
        }
    }
    return replies;
}();

[[nodiscard]] constexpr bool answers(ak_reply reply, ak_command command) noexcept
{
    return (answering[static_cast<std::size_t>(command)] >> static_cast<unsigned>(reply) & 1U) != 0;
}

inline constexpr error other_parameter{errc::unexpected_reply, layout::telegram::data + layout::parameter::pke.begin};
inline constexpr error other_element{errc::unexpected_reply, layout::telegram::data + layout::parameter::ind.begin};

/// One function for all requests with a PKE, for the sake of firmware.
template <typename Layout>
[[nodiscard]] constexpr error match_pke(pke asked, bytes wire) noexcept
{
    namespace at           = layout::parameter;
    auto const number_bits = basic_parameter_number<Layout>::last;
    auto const data        = data_of(wire);
    auto const given       = pke::from_raw(at::pke.load(data));
    auto const command     = asked.get(pke::command);
    auto const reply       = given.get(pke::reply);
    if (command != ak_command::no_command and ((given.raw ^ asked.raw) & number_bits) != 0) { return other_parameter; }
    if (reply == ak_reply::cannot_be_executed and data.size() == Layout::parameter_size) {  // else there is no PWE
        return reply_error{parameter_error{at::pwe_low.load(data)}};
    }
    return answers(reply, command) ? error{} : other_parameter;
}

template <typename Layout>
[[nodiscard]] constexpr error match(basic_process_command<Layout> const&, bytes) noexcept
{
    return {};
}

template <typename Layout>
[[nodiscard]] constexpr error match(basic_parameter_request<Layout> const& asked, bytes wire) noexcept
{
    auto const fault = match_pke<Layout>(asked.pke, wire);
    if (not fault.ok()) { return fault; }
    // The manual does not say that IND is repeated; but the value of another element answers another request.
    auto const index = ind::from_raw(layout::parameter::ind.load(data_of(wire))).get(ind::array_index);
    return index == 0 or index == asked.array_index() ? error{} : other_element;
}

template <typename Layout, typename Text>
[[nodiscard]] constexpr error match(basic_text_data<Layout, basic_process_command<Layout>, Text> const& asked,
                                    bytes                                                               wire) noexcept
{
    return match_pke<Layout>(asked.pke, wire);
}

/// What is wrong with the telegram of a response, up to its data.
[[nodiscard]] constexpr error check_response(address from, bytes wire, std::size_t least, std::size_t most) noexcept
{
    auto const fault = check_telegram(wire, least, most);
    if (not fault.ok()) { return fault; }
    auto const adr = layout::telegram::adr;
    return adr.load(wire) == from.byte() ? error{} : error{errc::unexpected_server, adr.begin};
}

}  // namespace detail

/// A request: `process_command`, `parameter_request`, or a text request.
template <typename T>
concept request = writable<T> and requires(T const& asked) { detail::response_of(asked); };

/// The response to a request, or why there is none.
template <request Request>
using reply = result<decltype(detail::response_of(std::declval<Request const&>())), reply_error>;

/// The response in the telegram `wire`, if it is the answer of the slave `to` to `asked`; a stale or foreign one is not.
///
/// Precondition: `wire` is not the request itself, come back as an echo. A request to read looks like a reply of 0, a
/// control word like a status word: who hears its own transmissions takes them out before.
///
/// Errors, with offsets in `wire`: `no_reply` to a broadcast; those of `check_telegram`; `unexpected_server` at 2 for
/// another ADR: a slave sends it back unchanged; `unexpected_reply` for another parameter, element or kind of reply;
/// `exception_reply` with the slave's error number. A text points into `wire`.
template <request Request>
[[nodiscard]] constexpr reply<Request> check(address to, Request const& asked, bytes wire) noexcept
{
    using response = typename reply<Request>::value_type;
    if (not expects_reply(to)) { return reply_error{error{errc::no_reply, 0}}; }
    auto fault = detail::check_response(to, wire, min_data_size<response>(), max_data_size_of<response>());
    if (not fault.ok()) { return reply_error{fault}; }
    fault = detail::match(asked, wire);
    if (not fault.ok()) { return reply_error{fault}; }
    return response::read(data_of(wire));
}

/// Refused: a text that borrows its bytes would outlive them. Name the buffer first.
template <request Request, owning_temporary Temporary>
    requires(not fixed_size<typename reply<Request>::value_type>)
reply<Request> check(address, Request const&, Temporary&&) = delete;

}  // namespace drivecodec::fc
