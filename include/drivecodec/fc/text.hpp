// SPDX-License-Identifier: MIT
#pragma once

#include <drivecodec/fc/pke.hpp>
#include <drivecodec/fc/process.hpp>
#include <drivecodec/fc/telegram.hpp>

// The text block: PKE IND ch1 .. chn, then the process block. VLT 6000 manual, "Parameter value (PWE)".

namespace drivecodec::fc {

namespace layout::text {
inline constexpr be16_at<0>  pke{};
inline constexpr be16_at<2>  ind{};
inline constexpr std::size_t characters = ind.end;
}  // namespace layout::text

/// The most characters that a telegram holds beside PKE, IND and PCD.
template <typename Layout = vlt_layout>
inline constexpr std::size_t max_text_size = max_data_size - Layout::around_text;

/// The data of a text telegram, with the process block of its direction. `Text` is `bytes`, which it borrows, or an
/// array: then the whole telegram has a size that the compiler knows.
///
/// Characters are the drive's, bytes without a terminating zero; what it pads with is not cut off.
template <typename Layout, typename Process, typename Text = bytes>
struct basic_text_data {
    using layout_type = Layout;

    fc::pke pke;
    fc::ind ind;
    Text    characters;
    Process process;

    static constexpr bool is_request   = std::is_same_v<Process, basic_process_command<Layout>>;
    static constexpr bool has_own_text = not std::is_same_v<Text, bytes>;

    /// The parameter number (PNU).
    [[nodiscard]] constexpr std::uint16_t   number() const noexcept { return pke.number<Layout>(); }
    [[nodiscard]] constexpr fc::text_access access() const noexcept { return ind.get(fc::ind::text_access); }

    //=== wire ===//

    [[nodiscard]] static constexpr std::size_t wire_size() noexcept
        requires has_own_text
    {
        return Layout::around_text + std::tuple_size_v<Text>;
    }
    [[nodiscard]] constexpr std::size_t wire_size() const noexcept
        requires(not has_own_text)
    {
        return Layout::around_text + characters.size();
    }

    /// Errors: `unexpected_function` at 0 for what is no text.
    [[nodiscard]] static constexpr error check(bytes data) noexcept
        requires(not has_own_text)
    {
        if (data.size() < Layout::around_text) { return {errc::truncated, Layout::around_text}; }
        if (fc::pke::from_raw(layout::text::pke.load(data)).get(fc::pke::command) != ak_command::text) {
            return {errc::unexpected_function, layout::text::pke.begin};
        }
        return {};
    }

    [[nodiscard]] static constexpr basic_text_data read(bytes data) noexcept
        requires(not has_own_text)
    {
        auto const size = data.size() - Layout::around_text;
        return {fc::pke::from_raw(layout::text::pke.load(data)), fc::ind::from_raw(layout::text::ind.load(data)),
                data.subspan(layout::text::characters, size),
                Process::read(data.subspan(layout::text::characters + size))};
    }

    constexpr void write(mutable_bytes out) const noexcept
    {
        layout::text::pke.store(out, pke.raw);
        layout::text::ind.store(out, ind.raw);
        copy_bytes(characters, out.subspan(layout::text::characters));
        process.write(out.last(Layout::process_size));
    }

    friend constexpr bool operator==(basic_text_data const& a, basic_text_data const& b) noexcept
    {
        return a.pke == b.pke and a.ind == b.ind and same_bytes(a.characters, b.characters) and a.process == b.process;
    }
};

template <typename Layout>
using basic_text_request = basic_text_data<Layout, basic_process_command<Layout>>;
template <typename Layout>
using basic_text_response = basic_text_data<Layout, basic_process_status<Layout>>;

using text_request  = basic_text_request<vlt_layout>;
using text_response = basic_text_response<vlt_layout>;

/// A text request of `Size` characters of its own.
template <typename Layout, std::size_t Size>
using basic_fixed_text_request = basic_text_data<Layout, basic_process_command<Layout>, std::array<std::uint8_t, Size>>;

}  // namespace drivecodec::fc
