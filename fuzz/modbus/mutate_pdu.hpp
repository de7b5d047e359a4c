#pragma once

// Byte counts and quantities that contradict the size hide what is behind them, as a checksum does. Fuzzers whose input
// ends with a PDU or an RTU frame make them agree in half of what they mutate.

#include "repair_crc16.hpp"

#include <drivecodec/modbus/functions.hpp>

#ifdef FUZZ_ENGINE

namespace mutate {

enum class pdu_kind : std::uint8_t { request, response };

/// Makes the quantity that of the byte count, in requests 15, 16, 23 and in response 24; lets request 20 ask for as much as
/// a response carries, or a register more.
inline void repair_quantity(std::span<std::uint8_t> pdu, pdu_kind kind)
{
    auto const store = [&](std::size_t at, unsigned count) {
        pdu[at]     = static_cast<std::uint8_t>(count >> 8);
        pdu[at + 1] = static_cast<std::uint8_t>(count);
    };
    if (kind == pdu_kind::request) {
        if (pdu.size() >= 6 and pdu[0] == 0x0F) { store(3, 8U * pdu[5] - (pdu[5] > 0 ? pdu[2] % 8U : 0U)); }
        if (pdu.size() >= 6 and pdu[0] == 0x10) { store(3, pdu[5] / 2U); }
        if (pdu.size() >= 10 and pdu[0] == 0x17) { store(7, pdu[9] / 2U); }
        if (pdu.size() >= 9 and pdu[0] == 0x14 and (pdu.size() - 2) % 7 == 0 and pdu.back() % 2 != 0) {
            unsigned others = 0;  // what all but the last one ask for; the last one, for as much as a response has left
            for (std::size_t at = 2; at + 7 < pdu.size(); at += 7) { others += 2 + 2 * (pdu[at + 5] * 256U + pdu[at + 6]); }
            if (others < 248) { store(pdu.size() - 2, (249 - others) / 2 + pdu.back() / 2 % 2U); }
        }
    } else if (pdu.size() >= 5 and pdu[0] == 0x18) {
        store(3, (pdu[1] * 256U + pdu[2]) / 2U - 1U);
    }
}

/// Cuts the PDU, or fills it up with zeros, to the size that its header announces; gives that size.
inline std::size_t fit_size(std::uint8_t* pdu, std::size_t size, std::size_t max_size, pdu_kind kind)
{
    drivecodec::bytes const front{pdu, size};
    auto const length = kind == pdu_kind::request ? drivecodec::modbus::public_functions::request_length(front)
                                                  : drivecodec::modbus::public_functions::response_length(front);
    if (not length.is_exact() or length.size() > max_size) { return size; }
    for (auto i = size; i < length.size(); ++i) { pdu[i] = 0; }
    return length.size();
}

inline std::size_t repair_pdu(std::uint8_t* pdu, std::size_t size, std::size_t max_size, pdu_kind kind)
{
    if (size == 0) { return size; }
    repair_quantity({pdu, size}, kind);
    return fit_size(pdu, size, max_size, kind);
}

/// The frame behind `head` bytes: often its PDU, nearly always its CRC.
inline std::size_t repair_frame(std::uint8_t* data, std::size_t head, std::size_t size, std::size_t max_size, unsigned seed,
                                pdu_kind kind)
{
    if (size < head + 4 or seed % 8 == 0) { return size; }
    if (seed / 8 % 2 == 0) {
        size = head + 3 + repair_pdu(data + head + 1, size - head - 3, max_size - head - 3, kind);
    }
    repair_crc16(std::span{data, size}.subspan(head));
    return size;
}

}  // namespace mutate

#endif
