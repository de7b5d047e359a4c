#pragma once

#include "fuzz_common.hpp"
#include "input.hpp"

#include <drivecodec/fc/slave.hpp>

#include <array>

namespace fuzz_fc {

namespace fc = drivecodec::fc;

/// A slave's handler. It answers every parameter with what the input tells: a word, a double word, a refusal or any
/// reply; every text with so many characters, or a refusal.
template <typename Layout>
class drive {
public:
    using process_command   = fc::basic_process_command<Layout>;
    using process_status    = fc::basic_process_status<Layout>;
    using parameter_request = fc::basic_parameter_request<Layout>;
    using text_request      = fc::basic_text_request<Layout>;

    /// Six bytes.
    explicit drive(fuzz_input& input) : manner_{input.u8()}, ak_{static_cast<std::uint8_t>(input.u8() % 16)}
    {
        high_ = input.u16();
        low_  = input.u16();
        for (std::size_t i = 0; i < text_.size(); ++i) { text_[i] = static_cast<std::uint8_t>(i); }
    }

    process_status operator()(process_command const&)
    {
        ++process_calls;
        return status();
    }
    fc::parameter_answer operator()(parameter_request const&)
    {
        FUZZ_ASSERT(process_calls == 0);  // the process data come last
        ++parameter_calls;
        switch (manner_ % 4) {
        case 0: return fc::parameter_answer::value(low_);
        case 1: return fc::parameter_answer::value(pwe());
        case 2: return fc::parameter_error{low_};
        default: return {fc::ak_reply{ak_}, pwe()};
        }
    }
    fc::text_answer operator()(text_request const&)
    {
        FUZZ_ASSERT(process_calls == 0);
        ++text_calls;
        if (refuses_text()) { return fc::parameter_error{low_}; }
        return text();
    }

    //=== what that is on the wire ===//

    [[nodiscard]] process_status status() const
    {
        std::array<std::uint8_t, Layout::process_size> words{};
        for (std::size_t i = 0; i < words.size(); ++i) { words[i] = static_cast<std::uint8_t>(0x0F + i); }
        return process_status::read(words);
    }
    [[nodiscard]] unsigned ak() const
    {
        constexpr std::array<std::uint8_t, 3> replies{0x1, 0x2, 0x7};
        return manner_ % 4 == 3 ? ak_ : replies[manner_ % 4];
    }
    [[nodiscard]] std::uint32_t pwe_sent() const { return manner_ % 2 == 0 ? low_ : pwe(); }
    [[nodiscard]] bool          refuses_text() const { return manner_ / 4 % 4 == 0; }
    [[nodiscard]] std::uint16_t refusal() const { return low_; }
    /// Often few characters, sometimes more than a telegram has.
    [[nodiscard]] drivecodec::bytes text() const
    {
        return drivecodec::bytes{text_}.first(manner_ / 16 % 2 == 0 ? high_ % 21U : high_ % 300U);
    }

    unsigned process_calls   = 0;
    unsigned parameter_calls = 0;
    unsigned text_calls      = 0;

private:
    [[nodiscard]] std::uint32_t pwe() const { return std::uint32_t{high_} << 16 | low_; }

    std::uint8_t                  manner_;
    std::uint8_t                  ak_;
    std::uint16_t                 high_ = 0;
    std::uint16_t                 low_  = 0;
    std::array<std::uint8_t, 300> text_{};
};

/// A drive that has no parameters.
template <typename Layout>
struct drive_without_parameters {
    fc::basic_process_status<Layout> operator()(fc::basic_process_command<Layout> const&) const { return status; }

    fc::basic_process_status<Layout> status;
};

}  // namespace fuzz_fc
