#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

// FC telegrams as the manual describes them, written without the library.

namespace fc_model {

using byte_list = std::vector<std::uint8_t>;

[[nodiscard]] inline std::uint8_t bcc(std::span<std::uint8_t const> covered)
{
    unsigned sum = 0;
    for (auto const byte : covered) { sum ^= byte; }
    return static_cast<std::uint8_t>(sum);
}

/// STX LGE ADR data BCC.
[[nodiscard]] inline byte_list telegram_of(int adr, auto const& data)
{
    byte_list made{0x02, static_cast<std::uint8_t>(data.size() + 2), static_cast<std::uint8_t>(adr)};
    made.insert(made.end(), data.begin(), data.end());
    made.push_back(bcc(made));
    return made;
}

/// The data of a telegram made by `telegram_of`.
[[nodiscard]] inline byte_list data_of(std::span<std::uint8_t const> telegram)
{
    auto const data = telegram.subspan(3, telegram.size() - 4);
    return {data.begin(), data.end()};
}

/// The telegram with this byte instead, and a right BCC.
[[nodiscard]] inline byte_list with_byte(std::span<std::uint8_t const> telegram, std::size_t at, unsigned byte)
{
    byte_list made{telegram.begin(), telegram.end()};
    made[at]    = static_cast<std::uint8_t>(byte);
    made.back() = bcc(std::span{made}.first(made.size() - 1));
    return made;
}

}  // namespace fc_model
