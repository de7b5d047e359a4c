// SPDX-License-Identifier: MIT
#pragma once

#include <poll.h>
#include <unistd.h>

#include <optional>
#include <string>
#include <utility>

namespace support {

/// What is typed on the standard input, line by line, without waiting for it.
class keyboard {
public:
    /// The next whole line, without its newline; nothing if there is none yet.
    [[nodiscard]] std::optional<std::string> next()
    {
        pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
        char   key = 0;
        while (is_open_ and poll(&input, 1, 0) > 0) {
            is_open_ = read(STDIN_FILENO, &key, 1) == 1;
            if (not is_open_) { break; }
            if (key == '\n') { return std::exchange(line_, {}); }
            line_ += key;
        }
        return std::nullopt;
    }

private:
    std::string line_;
    bool        is_open_ = true;
};

}  // namespace support
