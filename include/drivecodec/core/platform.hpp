// SPDX-License-Identifier: MIT
#pragma once

namespace drivecodec {

/// Is this built for a machine with an operating system and memory to spare, or for firmware? Defaults that trade
/// size for speed read it here; where a default does not suit, its user names another one as a template argument.
#if defined(__linux__) || defined(__APPLE__) || defined(_WIN32) || defined(__FreeBSD__) || defined(__unix__)
inline constexpr bool is_host = true;
#else
inline constexpr bool is_host = false;
#endif

}  // namespace drivecodec
