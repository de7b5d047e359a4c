#include "support/auto_decoder.hpp"

#include "support/fc_decoder.hpp"
#include "support/hex.hpp"
#include "support/modbus_decoder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace {

using drivecodec::bytes;
using buffer = std::vector<std::uint8_t>;

std::unique_ptr<support::protocol_decoder> make_modbus(support::sink out)
{
    return std::make_unique<support::modbus_decoder>(support::modbus_options{.how = support::style::json},
                                                     std::move(out));
}
std::unique_ptr<support::protocol_decoder> make_fc(support::sink out)
{
    return support::make_fc_decoder({.how = support::style::json}, std::move(out));
}

/// What comes along a line: bytes, then a silence, bytes ...
using line = std::vector<buffer>;

using chunk_sizes = std::function<std::size_t()>;

/// Feeds all of it, in chunks of a size that `size_of_chunk` gives. The last bytes are not followed by a silence.
void feed(support::decoder& decoder, line const& heard, chunk_sizes const& size_of_chunk)
{
    for (std::size_t i = 0; i < heard.size(); ++i) {
        if (i > 0) { decoder.silence(); }
        for (bytes rest = heard[i]; not rest.empty();) {
            auto const chunk = rest.first(std::min<std::size_t>(size_of_chunk(), rest.size()));
            decoder.push(chunk);
            rest = rest.subspan(chunk.size());
        }
    }
    decoder.silence();
}

std::size_t whole()
{
    return 0xFFFF;
}

struct decoded {
    std::string                 lines;
    drivecodec::stream_counters counted;
};

decoded decode_with(auto make, line const& heard)
{
    std::ostringstream out;
    auto const         decoder = make(support::lines_to(out, true));
    feed(*decoder, heard, whole);
    decoder->end(true);
    return {out.str(), decoder->counters()};
}

decoded decode_auto(line const& heard, bool is_whole = true, chunk_sizes const& size_of_chunk = whole)
{
    std::ostringstream    out;
    support::auto_decoder decoder{make_modbus, make_fc, support::lines_to(out, true)};
    feed(decoder, heard, size_of_chunk);
    decoder.end(is_whole);
    return {out.str(), decoder.counters()};
}

/// The bytes that the lines of JSON have as `raw` or `dropped`, together.
std::string bytes_in(std::string const& lines)
{
    std::string        all;
    std::istringstream in{lines};
    for (std::string one; std::getline(in, one);) {
        auto key = one.find("\"raw\":\"");
        auto at  = key + 7;
        if (key == std::string::npos) {
            key = one.find("{\"dropped\":\"");
            at  = key + 12;
        }
        EXPECT_NE(key, std::string::npos) << one;
        all += one.substr(at, one.find('"', at) - at);
    }
    return all;
}

std::string bytes_in(line const& heard)
{
    std::string all;
    for (auto const& part : heard) { all += support::to_hex(part); }
    return all;
}

bool has(std::string const& lines, std::string_view protocol)
{
    return lines.find("\"protocol\":\"" + std::string{protocol} + '"') != std::string::npos;
}

buffer const both{0x02, 0x06, 0x21, 0x9A, 0x00, 0xF2, 0x22, 0x6F};
buffer const broadcast{0x02, 0x06, 0x20, 0x04, 0x3C, 0x00, 0x00, 0x1C};
buffer const parameter{0x02, 0x0E, 0x01, 0x10, 0xCA, 0, 0, 0, 0, 0, 0, 0x04, 0x7F, 0x20, 0x00, 0x8C};
buffer const reading{0x11, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x76, 0x87};
buffer const writing{0x02, 0x06, 0x23, 0x29, 0x00, 0x0D, 0x92, 0x70};

buffer operator+(buffer a, buffer const& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Noise, frames, telegrams, and what is cut off, in any order.
line random_line(std::mt19937& random)
{
    auto const below = [&](std::uint32_t bound) { return static_cast<std::uint32_t>(random() % bound); };
    line       heard(1);
    for (auto pieces = 1 + below(12); pieces > 0; --pieces) {
        buffer piece;
        switch (below(8)) {
        case 0: piece = both; break;
        case 1: piece = reading; break;
        case 2: piece = writing; break;
        case 3:
        case 4: piece = broadcast; break;
        case 5: piece = parameter; break;
        default:
            for (auto size = below(40); size > 0; --size) {
                piece.push_back(below(4) == 0 ? std::uint8_t{0x02} : static_cast<std::uint8_t>(random()));
            }
        }
        if (below(8) == 0 and not piece.empty()) { piece.resize(below(static_cast<std::uint32_t>(piece.size()))); }
        heard.back() = heard.back() + piece;
        if (below(3) == 0) { heard.emplace_back(); }
    }
    return heard;
}

TEST(auto_decoder, prints_what_one_of_the_two_would_have_printed_whatever_the_chunks)
{
    std::mt19937 random{4};
    unsigned     modbus_chosen = 0;
    unsigned     fc_chosen     = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        auto const heard = random_line(random);
        auto const given = decode_auto(heard);
        EXPECT_EQ(bytes_in(given.lines), bytes_in(heard));

        auto const as_modbus = decode_with(make_modbus, heard);
        auto const as_fc     = decode_with(make_fc, heard);
        auto const is_modbus = given.lines == as_modbus.lines;
        ASSERT_TRUE(is_modbus or given.lines == as_fc.lines) << given.lines;
        EXPECT_EQ(given.counted, (is_modbus ? as_modbus : as_fc).counted);
        modbus_chosen += has(given.lines, "modbus-rtu");
        fc_chosen += has(given.lines, "fc");

        EXPECT_EQ(decode_auto(heard, true, [] { return std::size_t{1}; }).lines, given.lines);
        EXPECT_EQ(decode_auto(heard, true, [&] { return std::size_t{1} + random() % 30; }).lines, given.lines);
    }
    EXPECT_GT(modbus_chosen, 500U);
    EXPECT_GT(fc_chosen, 500U);
}

TEST(auto_decoder, says_nothing_before_it_knows_and_then_all)
{
    std::ostringstream    out;
    support::auto_decoder decoder{make_modbus, make_fc, support::lines_to(out, true)};
    decoder.push(broadcast);
    decoder.silence();
    EXPECT_EQ(out.str(), "");
    decoder.push(parameter);
    decoder.silence();
    EXPECT_EQ(bytes_in(out.str()), support::to_hex(broadcast + parameter));
    decoder.push(parameter);
    EXPECT_EQ(bytes_in(out.str()), support::to_hex(broadcast + parameter + parameter));
}

TEST(auto_decoder, says_at_once_what_is_modbus)
{
    std::ostringstream    out;
    support::auto_decoder decoder{make_modbus, make_fc, support::lines_to(out, true)};
    decoder.push(both);
    EXPECT_TRUE(has(out.str(), "modbus-rtu"));
    EXPECT_TRUE(decoder.is_waiting_for_response());
    decoder.request_timed_out();
    EXPECT_FALSE(decoder.is_waiting_for_response());
}

TEST(auto_decoder, waits_for_modbus_frames_that_lie_behind_the_begin_of_a_longer_one)
{
    // It begins like a write of 123 registers: only the silence tells that it is none.
    auto const heard = buffer{0x11, 0x10, 0x00, 0x00, 0x00, 0x7B, 0xF6} + both + both;
    auto const given = decode_auto({heard});
    EXPECT_TRUE(has(given.lines, "modbus-rtu"));
    EXPECT_FALSE(has(given.lines, "fc"));
}

TEST(auto_decoder, believes_a_single_telegram_only_where_the_input_is_over)
{
    EXPECT_TRUE(has(decode_auto({parameter}, true).lines, "fc"));
    auto const live = decode_auto({parameter}, false);
    EXPECT_FALSE(has(live.lines, "fc"));
    EXPECT_EQ(bytes_in(live.lines), support::to_hex(parameter));
    EXPECT_EQ(live.counted.dropped_bytes, parameter.size());
}

TEST(auto_decoder, forgets_the_request_of_a_single_telegram)
{
    std::ostringstream    out;
    support::auto_decoder decoder{make_modbus, make_fc, support::lines_to(out, true)};
    buffer const          to_eeprom{0x02, 0x0E, 0x01, 0xE0, 0xCA, 0, 0, 0, 0, 0x03, 0xE8, 0, 0, 0, 0, 0xCC};
    decoder.push(to_eeprom);
    EXPECT_TRUE(decoder.is_waiting_for_response());
    decoder.request_timed_out();
    EXPECT_FALSE(decoder.is_waiting_for_response());
    decoder.silence();
    decoder.push(parameter);
    decoder.silence();
    EXPECT_EQ(out.str().find("response"), std::string::npos) << out.str();
    EXPECT_NE(out.str().find("read_value"), std::string::npos) << out.str();
}

TEST(auto_decoder, holds_back_at_most_4096_bytes)
{
    constexpr auto        most = support::auto_decoder::most_held;
    std::ostringstream    out;
    support::auto_decoder decoder{make_modbus, make_fc, support::lines_to(out, true)};
    buffer const          noise(10 * most + 100, 0x55);
    std::size_t           pushed = 0;
    for (auto const byte : noise) {
        decoder.push({&byte, 1});
        ++pushed;
        if (pushed % 512 == 0 or pushed % most == most - 1) {
            EXPECT_EQ(bytes_in(out.str()).size() / 2, pushed / most * most);
        }
    }
    decoder.silence();
    decoder.push(broadcast + broadcast);
    decoder.silence();
    EXPECT_EQ(bytes_in(out.str()), support::to_hex(noise + broadcast + broadcast));
    EXPECT_TRUE(has(out.str(), "fc"));
    EXPECT_EQ(decoder.counters().frames, 2U);
    EXPECT_EQ(decoder.counters().dropped_bytes, noise.size());
    decoder.end(false);
    EXPECT_EQ(bytes_in(out.str()), support::to_hex(noise + broadcast + broadcast));
}

TEST(auto_decoder, begins_anew_behind_4096_bytes)
{
    constexpr auto most = support::auto_decoder::most_held;
    // One telegram in front of the noise and one behind it are not two.
    auto const given = decode_auto({broadcast + buffer(most, 0x55) + broadcast}, false);
    EXPECT_FALSE(has(given.lines, "fc"));
    auto const modbus = decode_auto({broadcast + buffer(most, 0x55), reading}, false);
    EXPECT_TRUE(has(modbus.lines, "modbus-rtu"));
    EXPECT_EQ(modbus.counted.frames, 1U);
    EXPECT_EQ(modbus.counted.dropped_bytes, most + broadcast.size());
}

}  // namespace
