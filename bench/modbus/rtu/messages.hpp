#pragma once

#include <drivecodec/modbus/rtu/client.hpp>
#include <drivecodec/modbus/rtu/framing.hpp>

#include <array>

/// What is measured, by the clock and in instructions.
namespace messages {

using drivecodec::bytes;
using drivecodec::mutable_bytes;
namespace modbus = drivecodec::modbus;
namespace rtu    = drivecodec::modbus::rtu;

constexpr auto words_125 = [] {
    std::array<std::uint16_t, 125> words{};
    for (std::size_t i = 0; i < words.size(); ++i) { words[i] = static_cast<std::uint16_t>(0x1234 + 0x2F1D * i); }
    return words;
}();
inline constexpr auto words_123 = [] {
    std::array<std::uint16_t, 123> words{};
    for (std::size_t i = 0; i < words.size(); ++i) { words[i] = words_125[i]; }
    return words;
}();

constexpr auto asked = modbus::read_holding_registers::request{{0x006B, 125}};

inline constexpr auto request_03  = rtu::encode(7, modbus::read_holding_registers::request{{0x006B, 3}});
using response_of_125 = modbus::read_holding_registers::basic_response<modbus::register_array<125>>;
inline constexpr auto response_03 = rtu::encode(7, response_of_125{{modbus::register_array<125>{words_125}}});
constexpr std::size_t request_16_size = rtu::layout::adu::around + 6 + 2 * words_123.size();

/// A request of eight bytes: all rules and the CRC, then its fields. 0 if it is refused.
inline std::uint32_t decode_request_03(bytes wire)
{
    auto const frame = rtu::decode<modbus::read_holding_registers::request>(wire);
    if (not frame) { return 0; }
    auto const& range = frame->message.range;
    return static_cast<std::uint32_t>(frame->address.byte() + (range.first() << 8) + (range.count() << 24));
}

/// A response of 125 registers: all rules, the CRC, whether it answers the request, then all values into host words.
inline std::size_t decode_response_03(bytes wire, std::array<std::uint16_t, 125>& to)
{
    auto const response = rtu::check(7, asked, wire);
    return response ? response->values.copy_to(to).size() : 0;
}

/// A request that writes 123 registers, from host words. The size of the frame; 0 if it is refused.
inline std::size_t encode_request_16(std::span<std::uint16_t const> words, mutable_bytes out)
{
    auto const request = modbus::write_multiple_registers::request::make(0x0100, words);
    if (not request) { return 0; }
    auto const frame = rtu::encode(7, *request, out);
    return frame ? frame->size() : 0;
}

}  // namespace messages
