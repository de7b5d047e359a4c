#pragma once

// The rules of MODBUS Application Protocol V1.1b3 once more, written from its tables and without the library, so that the
// library is not its own judge: which PDUs are valid, and which response answers which request.

#include <cstddef>
#include <cstdint>
#include <span>

namespace rules {

using pdu_bytes = std::span<std::uint8_t const>;

inline constexpr std::size_t max_pdu_size = 253;

[[nodiscard]] inline unsigned u16(pdu_bytes pdu, std::size_t at) noexcept { return pdu[at] * 256U + pdu[at + 1]; }

/// | first | count | at `at`. Precondition: pdu.size() >= at + 4.
[[nodiscard]] inline bool is_range(pdu_bytes pdu, std::size_t at, unsigned max) noexcept
{
    auto const first = u16(pdu, at);
    auto const count = u16(pdu, at + 2);
    return count >= 1 and count <= max and first + count <= 65536;
}

/// | function | byte count | and so many bytes.
[[nodiscard]] inline bool has_byte_count(pdu_bytes pdu, unsigned least, unsigned most) noexcept
{
    return pdu.size() >= 2 and pdu[1] >= least and pdu[1] <= most and pdu.size() == 2U + pdu[1];
}

//=== 08 ===//

[[nodiscard]] inline bool diagnostic_has_one_word(unsigned sub) noexcept
{
    return (sub >= 1 and sub <= 4) or (sub >= 10 and sub <= 18) or sub == 20;
}

[[nodiscard]] inline bool diagnostic_echoes(unsigned sub) noexcept
{
    return sub == 0 or sub == 1 or sub == 3 or sub == 10 or sub == 20;
}

[[nodiscard]] inline bool is_diagnostic(pdu_bytes pdu, bool is_request) noexcept
{
    if (pdu.size() < 3 or pdu.size() > max_pdu_size or pdu.size() % 2 != 1) { return false; }
    auto const sub = u16(pdu, 1);
    if (not diagnostic_has_one_word(sub)) { return true; }
    if (pdu.size() != 5) { return false; }
    auto const word = u16(pdu, 3);
    if (sub == 1) { return word == 0 or word == 0xFF00; }
    if (sub == 3) { return word % 256 == 0; }
    return word == 0 or (not is_request and not diagnostic_echoes(sub));
}

//=== 20 and 21 ===//

[[nodiscard]] inline bool is_file_range(pdu_bytes record) noexcept
{
    auto const number = u16(record, 3);
    auto const length = u16(record, 5);
    return record[0] == 6 and u16(record, 1) != 0 and number <= 9999 and length >= 1 and length <= 124
           and number + length <= 10000;
}

[[nodiscard]] inline bool is_read_file_request(pdu_bytes pdu) noexcept
{
    if (not has_byte_count(pdu, 7, 245) or pdu[1] % 7 != 0) { return false; }
    unsigned answer = 2;
    for (std::size_t at = 2; at < pdu.size(); at += 7) {
        if (not is_file_range(pdu.subspan(at, 7))) { return false; }
        answer += 2 + 2 * u16(pdu, at + 5);
    }
    return answer <= max_pdu_size;
}

[[nodiscard]] inline bool is_read_file_response(pdu_bytes pdu) noexcept
{
    if (not has_byte_count(pdu, 4, 251) or pdu[1] % 2 != 0) { return false; }
    for (std::size_t at = 2; at < pdu.size(); at += std::size_t{1} + pdu[at]) {
        if (pdu[at] < 3 or pdu[at] % 2 == 0 or at + 1 + pdu[at] > pdu.size() or pdu[at + 1] != 6) { return false; }
    }
    return true;
}

[[nodiscard]] inline bool is_write_file(pdu_bytes pdu) noexcept
{
    if (not has_byte_count(pdu, 9, 251)) { return false; }
    for (std::size_t at = 2; at < pdu.size();) {
        if (pdu.size() - at < 9 or not is_file_range(pdu.subspan(at, 7))) { return false; }
        auto const size = 7 + std::size_t{2} * u16(pdu, at + 5);
        if (size > pdu.size() - at) { return false; }
        at += size;
    }
    return true;
}

//=== 43/14 ===//

[[nodiscard]] inline bool is_identification_response(pdu_bytes pdu) noexcept
{
    if (pdu.size() < 7 or pdu.size() > max_pdu_size or pdu[2] < 1 or pdu[2] > 4) { return false; }
    if (pdu[4] != 0x00 and pdu[4] != 0xFF) { return false; }
    std::size_t at = 7;
    for (unsigned object = 0; object < pdu[6]; ++object) {
        if (pdu.size() - at < 2 or pdu.size() - at - 2 < pdu[at + 1]) { return false; }
        at += std::size_t{2} + pdu[at + 1];
    }
    return at == pdu.size();
}

//=== all ===//

[[nodiscard]] inline bool is_block(pdu_bytes pdu, std::size_t at, unsigned max, bool is_bits) noexcept
{
    if (pdu.size() < at + 5 or not is_range(pdu, at, max)) { return false; }
    auto const count = u16(pdu, at + 2);
    auto const size  = is_bits ? (count + 7) / 8 : 2 * count;
    return pdu[at + 4] == size and pdu.size() == at + 5 + size;
}

[[nodiscard]] inline bool is_request(pdu_bytes pdu) noexcept
{
    if (pdu.empty()) { return false; }
    switch (pdu[0]) {
    case 0x01:
    case 0x02: return pdu.size() == 5 and is_range(pdu, 1, 2000);
    case 0x03:
    case 0x04: return pdu.size() == 5 and is_range(pdu, 1, 125);
    case 0x05: return pdu.size() == 5 and (u16(pdu, 3) == 0xFF00 or u16(pdu, 3) == 0x0000);
    case 0x06: return pdu.size() == 5;
    case 0x07:
    case 0x0B:
    case 0x0C:
    case 0x11: return pdu.size() == 1;
    case 0x08: return is_diagnostic(pdu, true);
    case 0x0F: return is_block(pdu, 1, 1968, true);
    case 0x10: return is_block(pdu, 1, 123, false);
    case 0x14: return is_read_file_request(pdu);
    case 0x15: return is_write_file(pdu);
    case 0x16: return pdu.size() == 7;
    case 0x17: return pdu.size() >= 10 and is_range(pdu, 1, 125) and is_block(pdu, 5, 121, false);
    case 0x18: return pdu.size() == 3;
    case 0x2B:
        if (pdu.size() < 2) { return false; }
        if (pdu[1] == 0x0D) { return pdu.size() <= max_pdu_size; }
        return pdu[1] == 0x0E and pdu.size() == 4 and pdu[2] >= 1 and pdu[2] <= 4;
    default: return false;
    }
}

[[nodiscard]] inline bool is_exception(pdu_bytes pdu) noexcept
{
    if (pdu.empty() or pdu[0] < 0x80) { return false; }
    return pdu.size() == 2 or (pdu.size() == 3 and pdu[0] == 0xAB);
}

/// Of a function, or an exception.
[[nodiscard]] inline bool is_response(pdu_bytes pdu) noexcept
{
    if (pdu.empty()) { return false; }
    if (pdu[0] >= 0x80) { return is_exception(pdu); }
    switch (pdu[0]) {
    case 0x01:
    case 0x02: return has_byte_count(pdu, 1, 250);
    case 0x03:
    case 0x04:
    case 0x17: return has_byte_count(pdu, 2, 250) and pdu[1] % 2 == 0;
    case 0x05:
    case 0x06:
    case 0x15:
    case 0x16: return is_request(pdu);
    case 0x07: return pdu.size() == 2;
    case 0x08: return is_diagnostic(pdu, false);
    case 0x0B: return pdu.size() == 5 and (u16(pdu, 1) == 0 or u16(pdu, 1) == 0xFFFF);
    case 0x0C: return has_byte_count(pdu, 6, 6 + 64) and (u16(pdu, 2) == 0 or u16(pdu, 2) == 0xFFFF);
    case 0x0F: return pdu.size() == 5 and is_range(pdu, 1, 1968);
    case 0x10: return pdu.size() == 5 and is_range(pdu, 1, 123);
    case 0x11: return has_byte_count(pdu, 1, 251);
    case 0x14: return is_read_file_response(pdu);
    case 0x18:
        return pdu.size() >= 5 and u16(pdu, 3) <= 31 and u16(pdu, 1) == 2 + 2 * u16(pdu, 3)
               and pdu.size() == 3 + u16(pdu, 1);
    case 0x2B:
        if (pdu.size() < 2) { return false; }
        return pdu[1] == 0x0D ? pdu.size() <= max_pdu_size : pdu[1] == 0x0E and is_identification_response(pdu);
    default: return false;
    }
}

/// No field tells the length: Return Query Data, unknown sub-functions, and CANopen.
[[nodiscard]] inline bool ends_with_silence(pdu_bytes pdu) noexcept
{
    if (pdu.size() >= 3 and pdu[0] == 0x08) { return not diagnostic_has_one_word(u16(pdu, 1)); }
    return pdu.size() >= 2 and pdu[0] == 0x2B and pdu[1] == 0x0D;
}

[[nodiscard]] inline bool is_write(pdu_bytes request) noexcept
{
    switch (request[0]) {
    case 0x05:
    case 0x06:
    case 0x0F:
    case 0x10:
    case 0x15:
    case 0x16: return true;
    default: return false;
    }
}

/// Precondition: is_request(request).
[[nodiscard]] inline bool expects_reply(pdu_bytes request) noexcept
{
    return not(request[0] == 0x08 and u16(request, 1) == 4);
}

[[nodiscard]] inline bool starts_alike(pdu_bytes a, pdu_bytes b, std::size_t size) noexcept
{
    if (a.size() < size or b.size() < size) { return false; }
    for (std::size_t i = 0; i < size; ++i) {
        if (a[i] != b[i]) { return false; }
    }
    return true;
}

[[nodiscard]] inline bool is_same(pdu_bytes a, pdu_bytes b) noexcept
{
    return a.size() == b.size() and starts_alike(a, b, a.size());
}

/// Does this response answer that request? An exception does not. Precondition: is_request(request), is_response(response).
[[nodiscard]] inline bool answers(pdu_bytes request, pdu_bytes response) noexcept
{
    if (request[0] != response[0]) { return false; }
    switch (request[0]) {
    case 0x01:
    case 0x02: return response[1] == (u16(request, 3) + 7) / 8;
    case 0x03:
    case 0x04:
    case 0x17: return response[1] == 2 * u16(request, 3);
    case 0x05:
    case 0x06:
    case 0x15:
    case 0x16: return is_same(request, response);
    case 0x08:
        return starts_alike(request, response, 3)
               and (not diagnostic_echoes(u16(request, 1)) or is_same(request, response));
    case 0x0F:
    case 0x10: return starts_alike(request, response, 5);
    case 0x14: {
        std::size_t given = 2;
        for (std::size_t asked = 2; asked < request.size(); asked += 7) {
            if (given >= response.size() or response[given] != 1 + 2 * u16(request, asked + 5)) { return false; }
            given += std::size_t{1} + response[given];
        }
        return given == response.size();
    }
    case 0x2B:
        if (request[1] != response[1]) { return false; }
        if (request[1] == 0x0D) { return true; }
        return request[2] == response[2] and (request[2] != 4 or (response[6] == 1 and response[7] == request[3]));
    default: return true;
    }
}

/// The byte of a valid PDU, with what need not survive decoding cleared: unused bits of coils to write.
[[nodiscard]] inline std::uint8_t normal_byte(pdu_bytes pdu, std::size_t at, bool is_request) noexcept
{
    if (is_request and pdu[0] == 0x0F and at + 1 == pdu.size() and u16(pdu, 3) % 8 != 0) {
        return static_cast<std::uint8_t>(pdu[at] & ((1U << (u16(pdu, 3) % 8)) - 1));
    }
    return pdu[at];
}

}  // namespace rules
