// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/modbus/message.hpp>
#include <drivecodec/modbus/register_view.hpp>

namespace drivecodec::modbus {

/// Sub-functions of Diagnostics. Any other number is a value without a name.
/// MODBUS Application Protocol V1.1b3, 6.8.1.
enum class diagnostic : std::uint16_t {
    return_query_data                      = 0,
    restart_communications_option          = 1,
    return_diagnostic_register             = 2,
    change_ascii_input_delimiter           = 3,
    force_listen_only_mode                 = 4,
    clear_counters_and_diagnostic_register = 10,
    return_bus_message_count               = 11,
    return_bus_communication_error_count   = 12,
    return_bus_exception_error_count       = 13,
    return_server_message_count            = 14,
    return_server_no_response_count        = 15,
    return_server_nak_count                = 16,
    return_server_busy_count               = 17,
    return_bus_character_overrun_count     = 18,
    clear_overrun_counter_and_flag         = 20,
};

namespace compile_error {
void this_diagnostic_does_not_allow_this_data();  // not constexpr: its name is the error text
}  // namespace compile_error

namespace layout::diagnostics {  // | function | sub-function hi lo | data hi lo | ...
inline constexpr be16_at<1>  sub_function{};
inline constexpr std::size_t data = sub_function.end;
}  // namespace layout::diagnostics

/// Diagnostics (08), MODBUS Application Protocol V1.1b3, 6.8.
struct diagnostics {
    static constexpr auto        code = function_code::diagnostics;
    static constexpr char const* name = "diagnostics";

    static constexpr std::size_t   max_words = (max_pdu_size - layout::diagnostics::data) / 2;
    static constexpr std::uint16_t clear_log = 0xFF00;  ///< Data of the restart: also clear the event log.

    //=== what the sub-functions allow ===//

    /// Exactly one word of data, as all named ones but Return Query Data have.
    [[nodiscard]] static constexpr bool has_one_word(diagnostic sub) noexcept
    {
        auto const number = static_cast<std::uint16_t>(sub);
        return (number >= 1 and number <= 4) or (number >= 10 and number <= 18) or number == 20;
    }

    /// The response repeats the data of the request.
    [[nodiscard]] static constexpr bool echoes_data(diagnostic sub) noexcept
    {
        using enum diagnostic;
        return sub == return_query_data or sub == restart_communications_option or sub == change_ascii_input_delimiter
               or sub == clear_counters_and_diagnostic_register or sub == clear_overrun_counter_and_flag;
    }

    /// No server answers Force Listen Only Mode.
    [[nodiscard]] static constexpr bool expects_reply(diagnostic sub) noexcept
    {
        return sub != diagnostic::force_listen_only_mode;
    }
    [[nodiscard]] static constexpr bool expects_reply(bytes pdu) noexcept
    {
        namespace at = layout::diagnostics;
        return pdu.size() < at::data or expects_reply(static_cast<diagnostic>(at::sub_function.load(pdu)));
    }

    /// May this data accompany the sub-function in this direction?
    template <direction Direction, typename Values>
    [[nodiscard]] static constexpr bool allows(diagnostic sub, Values const& data) noexcept
    {
        if (not has_one_word(sub)) { return data.size() <= max_words; }
        if (data.size() != 1) { return false; }
        auto const word = data[0];
        if (sub == diagnostic::restart_communications_option) { return word == 0 or word == clear_log; }
        if (sub == diagnostic::change_ascii_input_delimiter) { return (word & 0xFF) == 0; }
        auto const is_a_counter = Direction == direction::response and not echoes_data(sub);
        return is_a_counter or word == 0;
    }

    template <direction Direction, typename Values>
    class message;
    template <typename Values>
    using basic_request = message<direction::request, Values>;
    template <typename Values>
    using basic_response = message<direction::response, Values>;
    using request        = basic_request<register_view>;
    using response       = basic_response<register_view>;

    /// A constant request, checked by the compiler: `of(diagnostic::return_bus_message_count)`.
    [[nodiscard]] static consteval basic_request<register_array<1>> of(diagnostic sub, std::uint16_t word = 0);
    template <std::size_t N>
    [[nodiscard]] static consteval basic_request<register_array<N>> of(diagnostic sub, std::uint16_t const (&words)[N]);
};

template <direction Direction, typename Values>
class diagnostics::message {
public:
    using function = diagnostics;

    consteval message(diagnostic sub, Values data)
        requires fixed_size<Values>
        : data_{data}, sub_function_{sub}
    {
        if (not allows<Direction>(sub, data)) { compile_error::this_diagnostic_does_not_allow_this_data(); }
    }

    /// Errors: `bad_value` at the data.
    [[nodiscard]] static constexpr result<message> make(diagnostic sub, Values data_to_send) noexcept
    {
        if (not allows<Direction>(sub, data_to_send)) { return error{errc::bad_value, layout::diagnostics::data}; }
        return message{data_to_send, sub};
    }

    [[nodiscard]] constexpr diagnostic    sub_function() const noexcept { return sub_function_; }
    [[nodiscard]] constexpr Values const& data() const noexcept { return data_; }

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        requires fixed_size<Values>
    {
        return layout::diagnostics::data + Values::wire_size();
    }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
        requires(not fixed_size<Values>)
    {
        return layout::diagnostics::data + data_.wire_size();
    }

    /// Return Query Data and sub-functions without a name have as many words as the line brings before it falls silent.
    [[nodiscard]] static constexpr message_length length(bytes pdu) noexcept
    {
        namespace at = layout::diagnostics;
        if (pdu.size() < at::data) { return message_length::at_least(at::data); }
        auto const sub = static_cast<diagnostic>(at::sub_function.load(pdu));
        return has_one_word(sub) ? message_length::exactly(at::data + 2) : message_length::until_silence();
    }

    [[nodiscard]] static constexpr error check(bytes pdu) noexcept
    {
        namespace at = layout::diagnostics;
        if (auto const fault = check_head(pdu, code, at::data, at::data); not fault.ok()) { return fault; }
        auto const sub  = static_cast<diagnostic>(at::sub_function.load(pdu));
        auto const data = pdu.subspan(at::data);
        if (has_one_word(sub)) {
            if (auto const fault = check_size(pdu, at::data + 2); not fault.ok()) { return fault; }
        } else if (data.size() > 2 * max_words) {
            return {errc::trailing_bytes, at::data + 2 * max_words};
        } else if (data.size() % 2 != 0) {
            return {errc::bad_length, pdu.size() - 1};
        }
        return allows<Direction>(sub, register_view::of_wire(data)) ? error{} : error{errc::bad_value, at::data};
    }

    [[nodiscard]] static constexpr message read(bytes pdu) noexcept
    {
        namespace at = layout::diagnostics;
        return {Values::of_wire(pdu.subspan(at::data)), static_cast<diagnostic>(at::sub_function.load(pdu))};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::diagnostics;
        layout::function.store(out, to_byte(code));
        at::sub_function.store(out, static_cast<std::uint16_t>(sub_function_));
        data_.write(out.subspan(at::data));
    }

    //=== of a request ===//

    [[nodiscard]] constexpr bool expects_reply() const noexcept
        requires(Direction == direction::request)
    {
        return diagnostics::expects_reply(sub_function_);
    }

    /// The response that repeats this request.
    [[nodiscard]] constexpr basic_response<Values> reply() const noexcept
        requires(Direction == direction::request)
    {
        return {data_, sub_function_};
    }

    /// The response with data of its own, as a counter. Errors: `bad_value` at the data.
    [[nodiscard]] constexpr result<response> reply_with(register_view data_to_send) const noexcept
        requires(Direction == direction::request)
    {
        return response::make(sub_function_, data_to_send);
    }

    template <typename Response>
        requires(Direction == direction::request)
    [[nodiscard]] constexpr error matches(Response const& given) const noexcept
    {
        namespace at = layout::diagnostics;
        if (given.sub_function() != sub_function_) { return expect_equal(false, at::sub_function.begin); }
        if (not echoes_data(sub_function_)) { return {}; }
        auto same = given.data().size() == data_.size();
        for (std::size_t i = 0; same and i < data_.size(); ++i) { same = given.data()[i] == data_[i]; }
        return expect_equal(same, at::data);
    }

    friend constexpr bool operator==(message const&, message const&) noexcept = default;

private:
    template <direction, typename>
    friend class message;

    constexpr message(Values data, diagnostic sub) noexcept : data_{data}, sub_function_{sub} {}

    Values     data_;
    diagnostic sub_function_;
};

consteval auto diagnostics::of(diagnostic sub, std::uint16_t word) -> basic_request<register_array<1>>
{
    return {sub, register_array<1>{{word}}};
}

template <std::size_t N>
consteval auto diagnostics::of(diagnostic sub, std::uint16_t const (&words)[N]) -> basic_request<register_array<N>>
{
    return {sub, register_array<N>{std::to_array(words)}};
}

}  // namespace drivecodec::modbus
