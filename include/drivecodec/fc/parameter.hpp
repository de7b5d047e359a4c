// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/data_type.hpp>
#include <drivecodec/fc/parameter_error.hpp>
#include <drivecodec/fc/pke.hpp>
#include <drivecodec/fc/process.hpp>

#include <limits>

// The parameter block: PKE IND PWEhigh PWElow, then the process block. VLT 6000 manual, "Parameter bytes".

namespace drivecodec::fc {

namespace layout::parameter {
inline constexpr be16_at<0>  pke{};
inline constexpr be16_at<2>  ind{};
inline constexpr be16_at<4>  pwe_high{};
inline constexpr be16_at<6>  pwe_low{};
inline constexpr std::size_t process = pwe_low.end;
}  // namespace layout::parameter

/// How many words of PWE a command writes, or a reply brings. Errors: `bad_value` at 0 for one that has no value.
[[nodiscard]] constexpr result<width> width_of(ak_command command) noexcept
{
    switch (command) {
    case ak_command::write_word:
    case ak_command::write_word_to_eeprom: return width::word;
    case ak_command::write_double_word:
    case ak_command::write_double_word_to_eeprom: return width::double_word;
    default: return error{errc::bad_value, 0};
    }
}
[[nodiscard]] constexpr result<width> width_of(ak_reply reply) noexcept
{
    switch (reply) {
    case ak_reply::word: return width::word;
    case ak_reply::double_word: return width::double_word;
    default: return error{errc::bad_value, 0};
    }
}

/// A number that PWE can hold: 16 bits and less are a word.
template <typename T>
concept parameter_integer = std::integral<T> and not std::same_as<T, bool> and sizeof(T) <= 4;

/// The data of a parameter telegram, with the process block of its direction. Every AK but that of texts, also those
/// without a meaning.
template <typename Layout, typename Process>
struct basic_parameter_data {
    using layout_type = Layout;

    fc::pke       pke;
    fc::ind       ind;
    std::uint32_t pwe;  ///< A word lies in the lower half; the upper is then 0.
    Process       process;

    static constexpr bool is_request = std::is_same_v<Process, basic_process_command<Layout>>;

    /// What is asked.
    [[nodiscard]] constexpr ak_command command() const noexcept
        requires is_request
    {
        return pke.get(fc::pke::command);
    }
    /// What is answered.
    [[nodiscard]] constexpr ak_reply reply() const noexcept
        requires(not is_request)
    {
        return pke.get(fc::pke::reply);
    }

    /// Why not. Precondition: reply() == ak_reply::cannot_be_executed.
    [[nodiscard]] constexpr parameter_error refusal() const noexcept
        requires(not is_request)
    {
        return parameter_error{static_cast<std::uint16_t>(pwe)};
    }

    /// The parameter number (PNU).
    [[nodiscard]] constexpr std::uint16_t number() const noexcept { return pke.number<Layout>(); }
    [[nodiscard]] constexpr std::uint8_t  array_index() const noexcept { return ind.get(fc::ind::array_index); }

    /// PWE as a `T`. Errors, at 0: `bad_value` where AK tells of no value, or of another width than that of `T`, or PWE
    /// is no word although AK says so; `out_of_range` for a number that `T` does not hold.
    template <parameter_integer T>
    [[nodiscard]] constexpr result<T> value() const noexcept
    {
        auto const given = width_of(ak());
        if (not given or (*given == width::word) != (sizeof(T) <= 2)) { return error{errc::bad_value, 0}; }
        if constexpr (sizeof(T) == 4) {
            return static_cast<T>(pwe);
        } else {
            using sixteen   = std::conditional_t<std::is_signed_v<T>, std::int16_t, std::uint16_t>;
            auto const word = static_cast<sixteen>(pwe);
            // Above a negative word some have 0, others its sign.
            if (pwe >> 16 != 0 and pwe != static_cast<std::uint32_t>(word)) { return error{errc::bad_value, 0}; }
            if (word < std::numeric_limits<T>::min() or word > std::numeric_limits<T>::max()) {
                return error{errc::out_of_range, 0};
            }
            return static_cast<T>(word);
        }
    }

    /// PWE as a number of a type known only at run time. Errors, at 0: as above; `bad_value` for what is no number.
    [[nodiscard]] constexpr result<std::int64_t> value(data_type type) const noexcept
    {
        switch (type) {
        case data_type::integer_16: return widened(value<std::int16_t>());
        case data_type::integer_32: return widened(value<std::int32_t>());
        case data_type::unsigned_8: return widened(value<std::uint8_t>());
        case data_type::unsigned_16: return widened(value<std::uint16_t>());
        case data_type::unsigned_32: return widened(value<std::uint32_t>());
        default: return error{errc::bad_value, 0};
        }
    }

    //=== wire ===//

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept { return Layout::parameter_size; }

    /// Errors: `unexpected_function` at 0 for a text.
    [[nodiscard]] static constexpr error check(bytes data) noexcept
    {
        if (data.size() < wire_size()) { return {errc::truncated, wire_size()}; }
        if (data.size() > wire_size()) { return {errc::trailing_bytes, wire_size()}; }
        if (fc::pke::from_raw(layout::parameter::pke.load(data)).get(fc::pke::command) == ak_command::text) {
            return {errc::unexpected_function, layout::parameter::pke.begin};
        }
        return {};
    }

    [[nodiscard]] static constexpr basic_parameter_data read(bytes data) noexcept
    {
        namespace at = layout::parameter;
        return {fc::pke::from_raw(at::pke.load(data)), fc::ind::from_raw(at::ind.load(data)),
                std::uint32_t{at::pwe_high.load(data)} << 16 | at::pwe_low.load(data),
                Process::read(data.subspan(at::process))};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        namespace at = layout::parameter;
        at::pke.store(out, pke.raw);
        at::ind.store(out, ind.raw);
        at::pwe_high.store(out, static_cast<std::uint16_t>(pwe >> 16));
        at::pwe_low.store(out, static_cast<std::uint16_t>(pwe));
        process.write(out.subspan(at::process));
    }

    friend constexpr bool operator==(basic_parameter_data const&, basic_parameter_data const&) noexcept = default;

private:
    [[nodiscard]] constexpr auto ak() const noexcept
    {
        if constexpr (is_request) {
            return command();
        } else {
            return reply();
        }
    }

    template <typename T>
    [[nodiscard]] static constexpr result<std::int64_t> widened(result<T> narrow) noexcept
    {
        if (not narrow) { return narrow.error(); }
        return std::int64_t{*narrow};
    }
};

template <typename Layout>
using basic_parameter_request = basic_parameter_data<Layout, basic_process_command<Layout>>;
template <typename Layout>
using basic_parameter_response = basic_parameter_data<Layout, basic_process_status<Layout>>;

using parameter_request  = basic_parameter_request<vlt_layout>;
using parameter_response = basic_parameter_response<vlt_layout>;

}  // namespace drivecodec::fc
