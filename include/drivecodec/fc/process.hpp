// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/core/codec.hpp>
#include <drivecodec/fc/data_layout.hpp>
#include <drivecodec/fc/main_value.hpp>

#include <array>
#include <concepts>
#include <utility>

// The process block, which every telegram has: PCD1 PCD2. VLT 6000 manual, "Process word".

namespace drivecodec::fc {

/// Bit 10 of a control word: 0 has the slave ignore it. VLT 6000 manual, "Control word as per FC protocol".
inline constexpr std::uint16_t data_valid_bit = 0x0400;

namespace detail {

/// The words of PCD, as both directions have them.
template <typename Layout>
class process_block {
public:
    [[nodiscard]] static constexpr std::size_t wire_size() noexcept { return Layout::process_size; }

    /// PCD1 has index 0. Precondition: index < Layout::process_words.
    [[nodiscard]] constexpr std::uint16_t pcd(std::size_t index) const noexcept { return words_[index]; }
    [[nodiscard]] constexpr std::span<std::uint16_t const, Layout::process_words> pcd() const& noexcept
    {
        return words_;
    }
    /// Refused: the words would outlive a temporary. Name the block first.
    void pcd() const&& = delete;

    constexpr void write(mutable_bytes out) const noexcept { store(out, each_word{}); }

    [[nodiscard]] static constexpr error check(bytes data) noexcept
    {
        if (data.size() < wire_size()) { return {errc::truncated, wire_size()}; }
        if (data.size() > wire_size()) { return {errc::trailing_bytes, wire_size()}; }
        return {};
    }

protected:
    constexpr process_block() noexcept = default;

    template <typename... More>
    constexpr process_block(std::uint16_t first, std::uint16_t second, More... more) noexcept
        : words_{first, second, static_cast<std::uint16_t>(more)...}
    {}

    constexpr explicit process_block(bytes data) noexcept : process_block{data, each_word{}} {}

    // Not an operator, which would compare the two directions.
    [[nodiscard]] constexpr bool has_words_of(process_block const& other) const noexcept
    {
        return words_ == other.words_;
    }

private:
    // Not loops, for the sake of firmware: at places known to the compiler, words stay in registers.
    using each_word = std::make_index_sequence<Layout::process_words>;

    template <std::size_t... Index>
    constexpr process_block(bytes data, std::index_sequence<Index...>) noexcept
        : words_{be16_at<2 * Index>::load(data)...}
    {}

    template <std::size_t... Index>
    constexpr void store(mutable_bytes out, std::index_sequence<Index...>) const noexcept
    {
        (be16_at<2 * Index>::store(out, words_[Index]), ...);
    }

    std::array<std::uint16_t, Layout::process_words> words_{};
};

template <typename T>
concept pcd_word = std::same_as<T, std::uint16_t> or std::same_as<T, std::int16_t>;  // nothing is cut off

/// As many words as the layout has beyond the two that all have.
template <typename Layout, typename... More>
concept further_words = 2 + sizeof...(More) == Layout::process_words and (pcd_word<More> and ...);

}  // namespace detail

/// A status word of a drive, or any other word of 16 bits: an object that has them as `raw`.
template <typename T>
concept drive_word = requires(T const& given) {
    { given.raw } -> std::same_as<std::uint16_t const&>;
};
/// A control word of a drive: one that has a flag `data_valid`.
template <typename T>
concept drive_control_word = drive_word<T> and requires { T::data_valid; };

namespace compile_error {
// Declared, never defined, not constexpr: calling it is how a consteval function says no. Its name is the text.
void a_control_word_must_be_between_0_and_FFFF();
}  // namespace compile_error

/// The bits of a control word: a constant, a `std::uint16_t`, or the control word of a drive. No other word is one.
struct control_word_value {
    std::uint16_t raw;

    consteval control_word_value(int bits) : raw{static_cast<std::uint16_t>(bits)}
    {
        if (bits < 0 or bits > 0xFFFF) { compile_error::a_control_word_must_be_between_0_and_FFFF(); }
    }
    template <std::same_as<std::uint16_t> T>
    constexpr control_word_value(T bits) noexcept : raw{bits}
    {}
    template <drive_control_word Word>
    constexpr control_word_value(Word const& word) noexcept : raw{word.raw}
    {}
};

/// Says that the process data of a telegram is to be ignored: PCD is 0, and so is "data valid".
struct data_not_valid_t {};
inline constexpr data_not_valid_t data_not_valid{};

/// PCD of a master: control word and reference, further words if the layout has them.
///
/// Made by `data_valid` or from `data_not_valid`: one of them has to be said, since a control word without bit 10 is
/// ignored, and one with it starts and stops a motor.
template <typename Layout>
class basic_process_command : public detail::process_block<Layout> {
    using base = detail::process_block<Layout>;

public:
    constexpr basic_process_command(data_not_valid_t) noexcept {}

    template <typename... More>
        requires detail::further_words<Layout, More...>
    [[nodiscard]] static constexpr basic_process_command valid(control_word_value control_word, fc::reference wanted,
                                                               More... more) noexcept
    {
        return {checked{}, static_cast<std::uint16_t>(control_word.raw | data_valid_bit), wanted.raw(), more...};
    }

    /// Bit 10: the slave obeys it.
    [[nodiscard]] constexpr bool is_data_valid() const noexcept { return (control_word() & data_valid_bit) != 0; }
    [[nodiscard]] constexpr std::uint16_t control_word() const noexcept { return this->pcd(0); }
    [[nodiscard]] constexpr fc::reference reference() const noexcept { return fc::reference::from_raw(this->pcd(1)); }

    [[nodiscard]] static constexpr basic_process_command read(bytes data) noexcept
    {
        return basic_process_command{data};
    }

    friend constexpr bool operator==(basic_process_command const& a, basic_process_command const& b) noexcept
    {
        return a.has_words_of(b);
    }

private:
    struct checked {};
    constexpr explicit basic_process_command(bytes data) noexcept : base{data} {}
    template <typename... Words>
    constexpr basic_process_command(checked, Words... words) noexcept : base{words...}
    {}
};
using process_command = basic_process_command<vlt_layout>;

/// Process data that the slave obeys: bit 10 is set, whatever the word says. Words beyond the second are the layout's,
/// each a `std::uint16_t` or `std::int16_t`.
template <typename Layout = vlt_layout, typename... More>
    requires detail::further_words<Layout, More...>
[[nodiscard]] constexpr basic_process_command<Layout> data_valid(control_word_value control_word, reference wanted,
                                                                 More... more) noexcept
{
    return basic_process_command<Layout>::valid(control_word, wanted, more...);
}

/// PCD of a slave: status word and output frequency, further words if the layout has them.
template <typename Layout>
class basic_process_status : public detail::process_block<Layout> {
    using base = detail::process_block<Layout>;

public:
    constexpr basic_process_status() noexcept = default;

    template <typename... More>
        requires detail::further_words<Layout, More...>
    constexpr basic_process_status(std::uint16_t status_word, fc::output_frequency frequency, More... more) noexcept
        : base{status_word, frequency.raw(), more...}
    {}
    template <drive_word Word, typename... More>
        requires detail::further_words<Layout, More...> and (not drive_control_word<Word>)
    constexpr basic_process_status(Word const& status_word, fc::output_frequency frequency, More... more) noexcept
        : basic_process_status{status_word.raw, frequency, more...}
    {}

    [[nodiscard]] constexpr std::uint16_t        status_word() const noexcept { return this->pcd(0); }
    [[nodiscard]] constexpr fc::output_frequency output_frequency() const noexcept
    {
        return fc::output_frequency::from_raw(this->pcd(1));
    }

    // Inlined also where size matters: what a called function returns in memory keeps a whole response there.
    [[nodiscard, gnu::always_inline]] static constexpr basic_process_status read(bytes data) noexcept
    {
        return basic_process_status{data};
    }

    friend constexpr bool operator==(basic_process_status const& a, basic_process_status const& b) noexcept
    {
        return a.has_words_of(b);
    }

private:
    constexpr explicit basic_process_status(bytes data) noexcept : base{data} {}
};
using process_status = basic_process_status<vlt_layout>;

}  // namespace drivecodec::fc
