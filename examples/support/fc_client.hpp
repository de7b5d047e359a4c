// SPDX-License-Identifier: MIT
#pragma once

#include "support/fc_line.hpp"
#include "support/line_client.hpp"

#include <array>
#include <cstdint>
#include <optional>

// The FC master's side of a line: ask, wait, ask again.

namespace support {

class fc_client : public line_client<fc_line> {
public:
    using line_client::line_client;

    /// Asks the slave until it answers: its response, or why there is none. Nothing if all tries timed out.
    ///
    /// As of `client::ask`. A text inside the response is valid until the next call.
    template <fc::request Request>
    [[nodiscard]] std::optional<fc::reply<Request>> ask(fc::address slave, Request const& asked)
    {
        using drivecodec::errc;
        auto const telegram = fc::encode(slave, asked, request_);
        if (not telegram) { return fc::reply<Request>{fc::reply_error{telegram.error()}}; }
        return exchange(*telegram, [&](drivecodec::bytes heard) -> std::optional<fc::reply<Request>> {
            auto const answer = fc::check(slave, asked, heard);
            auto const code   = answer ? errc::none : answer.error().code();
            if (code != errc::none and code != errc::exception_reply) { return std::nullopt; }  // of something else
            return answer;
        });
    }

private:
    std::array<std::uint8_t, fc::max_telegram_size> request_{};
};

}  // namespace support
