#pragma once

#include "support/stream_model.hpp"

#include <optional>

// FC telegrams as the manual describes them, written without the library: what its stream reader is compared with.

namespace fc_model {

using stream_model::byte_list;
using stream_model::bytes;
using stream_model::dice;
using stream_model::line;
using stream_model::reading;
using what = stream_model::reading::what;

inline constexpr int unknown  = 0;
inline constexpr int request  = 1;
inline constexpr int response = 2;

//=== telegrams ===//

/// The exclusive or of all bytes.
[[nodiscard]] inline std::uint8_t bcc(auto const& covered)
{
    unsigned folded = 0;
    for (unsigned const byte : covered) { folded ^= byte; }
    return static_cast<std::uint8_t>(folded);
}

[[nodiscard]] inline byte_list telegram_of(int adr, auto const& data)
{
    byte_list made{0x02, static_cast<std::uint8_t>(data.size() + 2), static_cast<std::uint8_t>(adr)};
    made.insert(made.end(), data.begin(), data.end());
    made.push_back(bcc(made));
    return made;
}

/// The telegram with this byte instead, and a right BCC.
[[nodiscard]] inline byte_list with_byte(bytes telegram, std::size_t at, unsigned byte)
{
    byte_list made{telegram.begin(), telegram.end()};
    made[at]    = static_cast<std::uint8_t>(byte);
    made.back() = bcc(bytes{made}.first(made.size() - 1));
    return made;
}

/// "bit 5 = 1: broadcast" in the format 1-31, "bit 0-6 = 0: broadcast" in the format 1-126.
[[nodiscard]] inline bool is_broadcast(int adr)
{
    return adr < 0x80 ? adr / 0x20 % 2 != 0 : adr == 0x80;
}

[[nodiscard]] inline int number_of(int adr)
{
    return adr < 0x80 ? adr % 0x20 : adr % 0x80;
}

//=== the rule of the stream ===//

enum class listens_for { either, requests, responses };

template <std::size_t ProcessWords = 2, int NumberBits = 11>
struct rules_of {
    static constexpr std::size_t min_size       = 8;  // of any layout
    static constexpr std::size_t max_size       = 256;
    static constexpr std::size_t parameter_size = 12 + 2 * ProcessWords;  // of a whole telegram

    listens_for        to         = listens_for::either;
    int                own_number = 0;
    std::optional<int> last{};  // the direction of the last telegram
    int                last_adr = 0;

    [[nodiscard]] std::vector<reading> readings(bytes front) const
    {
        if (front[0] != 0x02) { return {{unknown, what::impossible}}; }
        if (front.size() < 2) { return {{unknown, what::needs_more, 2}}; }
        auto const size    = std::size_t{front[1]} + 2;
        auto const is_here = size >= min_size and size <= front.size();
        return {{is_here ? direction_of(front.first(size)) : unknown, what::has_size, size}};
    }

    [[nodiscard]] static bool is_intact(bytes telegram)
    {
        return telegram.back() == bcc(telegram.first(telegram.size() - 1));
    }

    void took(int kind, bytes telegram)
    {
        last     = kind;
        last_adr = telegram[2];
    }

    void timed_out() { last = response; }

private:
    [[nodiscard]] int direction_of(bytes telegram) const
    {
        int const adr = telegram[2];
        if (to == listens_for::requests) { return request; }
        if (to == listens_for::responses) { return response; }
        if (is_broadcast(adr) or (own_number != 0 and number_of(adr) == own_number)) { return request; }
        if (telegram.size() == parameter_size) {
            switch (telegram[3] >> 4) {
            case 0xD:
            case 0xE: return request;
            case 0x7: return response;
            case 0x3:
                if (NumberBits == 11) { return request; }
                break;
            default: break;
            }
        }
        if (not last or *last == unknown) { return unknown; }
        return *last == request and adr == last_adr ? response : request;
    }
};
using rules = rules_of<>;

//=== random traffic ===//

/// Process data, a parameter or a text of either direction, or as many data as no layout has; fields are random.
[[nodiscard]] inline byte_list random_data(dice& random, std::size_t process_words = 2)
{
    auto const process = 2 * process_words;
    if (random.one_in(4)) { return random.noise(process); }
    if (random.one_in(10)) { return random.noise(process + random.below(200)); }
    if (random.one_in(3)) {
        auto made = random.noise(4 + random.below(random.one_in(6) ? 249 - process : 30) + process);
        made[0]   = static_cast<std::uint8_t>(0xF0 | made[0] % 8);
        made[2]   = static_cast<std::uint8_t>(random.below(8));
        return made;
    }
    static constexpr std::array<std::uint8_t, 11> aks{0x0, 0x1, 0x1, 0x2, 0x2, 0x3, 0x4, 0x7, 0xD, 0xE, 0xF};

    auto made = random.noise(8 + process);
    made[0]   = static_cast<std::uint8_t>(aks[random.below(aks.size())] << 4 | made[0] % 16);
    return made;
}

/// Of few slaves, so that what follows often is of the same.
[[nodiscard]] inline int random_adr(dice& random)
{
    static constexpr std::array<std::uint8_t, 6> few{0x01, 0x01, 0x02, 0x81, 0x82, 0x01};
    return random.one_in(6) ? random.byte() : few[random.below(few.size())];
}

[[nodiscard]] inline byte_list random_telegram(dice& random, std::size_t process_words = 2)
{
    return telegram_of(random_adr(random), random_data(random, process_words));
}

/// Valid telegrams in conversation, damaged ones, telegrams inside telegrams, noise, silences, time-outs. Ends with a
/// silence.
[[nodiscard]] inline line random_line(dice& random, std::size_t process_words = 2)
{
    line       heard;
    auto const say = [&heard](auto const& list) { heard.insert(heard.end(), list.begin(), list.end()); };
    int        adr = 1;
    for (auto pieces = 2 + random.below(9); pieces > 0; --pieces) {
        switch (random.below(12)) {
        case 0: say(random.noise(1 + random.below(random.one_in(6) ? 300 : 8))); break;
        case 1: heard.push_back(stream_model::timeout); break;
        case 2: heard.push_back(stream_model::silence); break;
        case 3: say(byte_list{0x02, random.byte()}); break;  // noise that begins a telegram
        default: {
            if (random.one_in(2)) { adr = random_adr(random); }
            auto data = random_data(random, process_words);
            if (random.one_in(3)) {  // a valid telegram amid the data
                auto const inner = random_telegram(random, process_words);
                if (data.size() > inner.size()) {
                    auto const at = random.below(data.size() - inner.size() + 1);
                    std::copy(inner.begin(), inner.end(), data.begin() + static_cast<std::ptrdiff_t>(at));
                }
            }
            auto       whole = telegram_of(adr, data);
            auto const at    = random.below(whole.size());
            auto const where = whole.begin() + static_cast<std::ptrdiff_t>(at);
            switch (random.below(8)) {
            case 0: *where = static_cast<std::uint8_t>(*where ^ 1U << random.below(8)); break;
            case 1: whole.resize(at); break;
            case 2: whole.erase(where); break;
            case 3: whole.insert(where, random.byte()); break;
            default: break;
            }
            say(whole);
            if (random.one_in(2)) { heard.push_back(stream_model::silence); }
        }
        }
    }
    heard.push_back(stream_model::silence);
    return heard;
}

}  // namespace fc_model
