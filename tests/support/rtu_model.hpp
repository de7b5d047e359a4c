#pragma once

#include "support/stream_model.hpp"

#include <optional>

// RTU frames as the specifications describe them, written without the library: what its stream reader is compared with.

namespace rtu_model {

using stream_model::byte_list;
using stream_model::bytes;
using stream_model::dice;
using stream_model::line;
using stream_model::reading;
using what = stream_model::reading::what;

inline constexpr int request  = 0;
inline constexpr int response = 1;

//=== CRC ===//

[[nodiscard]] inline std::uint16_t crc(bytes message)
{
    static auto const table = [] {
        std::array<std::uint16_t, 256> made{};
        for (unsigned byte = 0; byte < 256; ++byte) {
            unsigned remainder = byte;
            for (int bit = 0; bit < 8; ++bit) { remainder = remainder % 2 != 0 ? remainder / 2 ^ 0xA001U : remainder / 2; }
            made[byte] = static_cast<std::uint16_t>(remainder);
        }
        return made;
    }();
    std::uint16_t remainder = 0xFFFF;
    for (auto const byte : message) {
        remainder = static_cast<std::uint16_t>(remainder >> 8 ^ table[(remainder ^ byte) & 0xFF]);
    }
    return remainder;
}

[[nodiscard]] inline byte_list with_crc(byte_list frame)
{
    auto const check = crc(frame);
    frame.push_back(static_cast<std::uint8_t>(check));
    frame.push_back(static_cast<std::uint8_t>(check >> 8));
    return frame;
}

[[nodiscard]] inline byte_list adu_of(int address, auto const& pdu)
{
    byte_list frame{static_cast<std::uint8_t>(address)};
    frame.insert(frame.end(), pdu.begin(), pdu.end());
    return with_crc(frame);
}

[[nodiscard]] inline bool is_intact(bytes frame)
{
    auto const covered = frame.first(frame.size() - 2);
    return crc(covered) == (frame[frame.size() - 2] | frame[frame.size() - 1] << 8);
}

//=== how long the frame is that begins with `front` ===//

[[nodiscard]] inline reading counted(int kind, bytes front, std::size_t before_count, std::size_t around)
{
    if (front.size() <= before_count) { return {kind, what::needs_more, before_count + 1}; }
    return {kind, what::has_size, around + front[before_count]};
}

[[nodiscard]] inline reading of_diagnostics(int kind, bytes front)
{
    if (front.size() < 4) { return {kind, what::needs_more, 4}; }
    auto const sub      = front[2] << 8 | front[3];
    auto const is_known = (sub >= 1 and sub <= 4) or (sub >= 10 and sub <= 18) or sub == 20;
    return is_known ? reading{kind, what::has_size, 8} : reading{kind, what::until_silence};
}

[[nodiscard]] inline reading of_device_identification(bytes front)
{
    std::size_t end = 8;  // address, 43, 14, code, conformity, more follows, next, number of objects
    if (front.size() < end) { return {response, what::needs_more, end}; }
    for (int objects = front[7]; objects > 0; --objects) {
        // Objects that are still to come have at least two bytes each.
        if (front.size() < end + 2) { return {response, what::needs_more, end + 2 * static_cast<std::size_t>(objects)}; }
        end += 2U + front[end + 1];
    }
    return {response, what::has_size, end + 2};
}

/// Precondition: front.size() >= 2.
[[nodiscard]] inline reading request_of(bytes front)
{
    switch (front[1]) {
    case 1: case 2: case 3: case 4: case 5: case 6: return {request, what::has_size, 8};
    case 7: case 11: case 12: case 17: return {request, what::has_size, 4};
    case 8: return of_diagnostics(request, front);
    case 15: case 16: return counted(request, front, 6, 9);
    case 20: case 21: return counted(request, front, 2, 5);
    case 22: return {request, what::has_size, 10};
    case 23: return counted(request, front, 10, 13);
    case 24: return {request, what::has_size, 6};
    case 43:
        if (front.size() < 3) { return {request, what::needs_more, 3}; }
        return front[2] == 14 ? reading{request, what::has_size, 7} : reading{request, what::until_silence};
    default: return {request, front[1] < 0x80 ? what::until_silence : what::impossible};
    }
}

/// Precondition: front.size() >= 2.
[[nodiscard]] inline reading response_of(bytes front)
{
    switch (front[1]) {
    case 1: case 2: case 3: case 4: case 12: case 17: case 20: case 21: case 23: return counted(response, front, 2, 5);
    case 5: case 6: case 11: case 15: case 16: return {response, what::has_size, 8};
    case 7: return {response, what::has_size, 5};
    case 8: return of_diagnostics(response, front);
    case 22: return {response, what::has_size, 10};
    case 24:
        if (front.size() < 4) { return {response, what::needs_more, 4}; }
        return {response, what::has_size, 6 + 256 * std::size_t{front[2]} + front[3]};
    case 43:
        if (front.size() < 3) { return {response, what::needs_more, 3}; }
        return front[2] == 14 ? of_device_identification(front) : reading{response, what::until_silence};
    default: return front[1] < 0x80 ? reading{response, what::until_silence} : reading{response, what::has_size, 5};
    }
}

//=== the rule of the stream ===//

enum class listens_for { either, requests, responses };

struct rules {
    static constexpr std::size_t min_size = 4;
    static constexpr std::size_t max_size = 256;

    listens_for              to          = listens_for::either;
    int                      own_address = 0;
    std::optional<byte_list> asked{};  // address and function of the last frame, if that was a request with a reply

    [[nodiscard]] std::vector<reading> readings(bytes front) const
    {
        if (front.size() < 2) { return {{request, what::needs_more, 2}}; }
        auto const is_own = own_address != 0 and front[0] == own_address;
        if (is_own or to == listens_for::requests) { return {request_of(front)}; }

        std::vector<reading> found{response_of(front)};
        if (front[1] == 0xAB) { found.push_back({response, what::has_size, 6}); }
        if (to == listens_for::responses) { return found; }

        auto const answers = asked and (*asked)[0] == front[0] and (*asked)[1] == (front[1] & 0x7F);
        found.insert(answers ? found.end() : found.begin(), request_of(front));
        return found;
    }

    [[nodiscard]] static bool is_intact(bytes frame) { return rtu_model::is_intact(frame); }

    void took(int kind, bytes frame)
    {
        auto const is_listen_only = frame[1] == 8 and frame.size() >= 6 and frame[2] == 0 and frame[3] == 4;
        asked.reset();
        if (kind == request and frame[0] != 0 and not is_listen_only) { asked = byte_list{frame[0], frame[1]}; }
    }

    void timed_out() { asked.reset(); }
};

//=== random traffic ===//

/// A request or response of a random function that the specification's lengths allow; fields and payload are random.
[[nodiscard]] inline byte_list random_pdu(dice& random, int kind, int function)
{
    auto const size     = random.one_in(8) ? random.below(241) : random.below(12);
    auto       pdu      = random.noise(1);
    auto const append   = [&](std::size_t count) {
        auto const more = random.noise(count);
        pdu.insert(pdu.end(), more.begin(), more.end());
    };
    auto const counted = [&](std::size_t before) {
        append(before);
        pdu.push_back(static_cast<std::uint8_t>(size));
        append(size);
    };
    pdu[0] = static_cast<std::uint8_t>(function);
    if (function >= 0x80) {
        append(function == 0xAB and random.one_in(2) ? 2 : 1);
        return pdu;
    }
    switch (function) {
    case 5: case 6: append(4); break;
    case 1: case 2: case 3: case 4: kind == request ? append(4) : counted(0); break;
    case 7: append(kind == request ? 0 : 1); break;
    case 11: append(kind == request ? 0 : 4); break;
    case 12: case 17: if (kind == response) { counted(0); } break;
    case 8:
        pdu.push_back(0);
        pdu.push_back(static_cast<std::uint8_t>(random.below(22)));
        append(random.one_in(4) ? 2 * random.below(6) : 2);
        break;
    case 15: case 16: kind == request ? counted(4) : append(4); break;
    case 20: case 21: counted(0); break;
    case 22: append(6); break;
    case 23: counted(kind == request ? 8 : 0); break;
    case 24:
        if (kind == response) { pdu.push_back(static_cast<std::uint8_t>(random.one_in(9) ? random.below(256) : 0)); }
        kind == request ? append(2) : counted(0);
        break;
    case 43:
        pdu.push_back(static_cast<std::uint8_t>(13 + random.below(3)));
        if (pdu[1] != 14) {
            append(random.below(10));
        } else if (kind == request) {
            append(2);
        } else {
            append(4);
            pdu.push_back(static_cast<std::uint8_t>(random.below(4)));
            for (auto left = pdu.back(); left > 0; --left) {
                pdu.push_back(left);
                pdu.push_back(static_cast<std::uint8_t>(random.below(9)));
                append(pdu.back());
            }
        }
        break;
    default: append(size); break;
    }
    return pdu;
}

[[nodiscard]] inline int random_function(dice& random)
{
    static constexpr std::array<std::uint8_t, 22> functions{1,  2,  3,  4,  5,  6,  7,  8,  11, 12,   15,
                                                            16, 17, 20, 21, 22, 23, 24, 43, 66, 0x65, 43};
    return functions[random.below(functions.size())];
}

/// Valid frames in conversation, damaged ones, frames inside frames, noise, silences, time-outs. Ends with a silence.
[[nodiscard]] inline line random_line(dice& random)
{
    line       heard;
    auto const say = [&heard](auto const& list) { heard.insert(heard.end(), list.begin(), list.end()); };
    int        address  = 1;
    int        function = 3;
    for (auto pieces = 2 + random.below(7); pieces > 0; --pieces) {
        switch (random.below(10)) {
        case 0: say(random.noise(1 + random.below(random.one_in(6) ? 300 : 8))); break;
        case 1: heard.push_back(stream_model::timeout); break;
        case 2: heard.push_back(stream_model::silence); break;
        default: {
            auto const kind = random.one_in(2) ? request : response;
            if (kind == request) {
                address  = static_cast<int>(random.one_in(6) ? random.below(256) : 1 + random.below(2));
                function = random_function(random);
            }
            auto pdu = random_pdu(random, kind, kind == response and random.one_in(4) ? function | 0x80 : function);
            if (random.one_in(3)) {  // a valid frame amid the payload
                auto const inner = adu_of(1, random_pdu(random, request, random_function(random)));
                if (pdu.size() > inner.size() + 2) {
                    auto const at = 2 + random.below(pdu.size() - inner.size() - 1);
                    std::copy(inner.begin(), inner.end(), pdu.begin() + static_cast<std::ptrdiff_t>(at));
                }
            }
            auto frame = adu_of(address, pdu);
            auto const at    = random.below(frame.size());
            auto const where = frame.begin() + static_cast<std::ptrdiff_t>(at);
            switch (random.below(8)) {
            case 0: *where = static_cast<std::uint8_t>(*where ^ 1U << random.below(8)); break;
            case 1: frame.resize(at); break;
            case 2: frame.erase(where); break;
            case 3: frame.insert(where, random.byte()); break;
            default: break;
            }
            say(frame);
            if (random.one_in(2)) { heard.push_back(stream_model::silence); }
        }
        }
    }
    heard.push_back(stream_model::silence);
    return heard;
}

}  // namespace rtu_model
