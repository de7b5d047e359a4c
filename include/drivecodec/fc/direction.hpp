// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace drivecodec::fc {

/// Which way a telegram goes. Nothing in it says so, and AK 1 and 2 mean one thing in a request and another in a
/// response: who hears a line from its middle has to find out.
enum class direction : std::uint8_t {
    unknown,
    request,   ///< Master to slave: the manual's control telegram.
    response,  ///< Slave to master: the manual's reply telegram.
};

}  // namespace drivecodec::fc
