// A stream reader on a line with valid traffic, on one with noise, and on one with what an adversary would send.

#include <drivecodec/modbus/rtu/client.hpp>
#include <drivecodec/modbus/rtu/reader.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>
#include <vector>

namespace {

using namespace drivecodec;
using namespace drivecodec::modbus;

constexpr std::size_t stream_size = 65536;
constexpr std::size_t chunk_size  = 64;

void read(benchmark::State& state, std::vector<std::uint8_t> const& stream)
{
    static rtu::reader reader;
    stream_counters    before{};
    for (auto _ : state) {
        before = reader.counters();
        for (std::size_t at = 0; at < stream.size(); at += chunk_size) {
            bytes rest = bytes{stream}.subspan(at, std::min(chunk_size, stream.size() - at));
            while (not rest.empty()) {
                rest = reader.push(rest);
                while (auto const item = reader.next()) { benchmark::DoNotOptimize(item.frame()); }
            }
        }
        reader.silence();
        while (auto const item = reader.next()) { benchmark::DoNotOptimize(item.frame()); }
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(stream.size()));
    state.counters["frames"]  = reader.counters().frames - before.frames;
    state.counters["dropped"] = reader.counters().dropped_bytes - before.dropped_bytes;
}

/// A client that polls `Count` registers of one server.
template <std::size_t Count>
void poll(benchmark::State& state)
{
    using response_type     = read_holding_registers::basic_response<register_array<Count>>;
    constexpr auto request  = rtu::encode(7, read_holding_registers::request{{0x006B, Count}});
    constexpr auto response = rtu::encode(7, response_type{{register_array<Count>{{0x1234, 0x5678, 0x9ABC}}}});

    std::vector<std::uint8_t> stream;
    while (stream.size() < stream_size) {
        stream.insert(stream.end(), request.begin(), request.end());
        stream.insert(stream.end(), response.begin(), response.end());
    }
    read(state, stream);
    if (state.counters["dropped"] != 0) { state.SkipWithError("valid frames were dropped"); }
}
BENCHMARK_TEMPLATE(poll, 10);   // 8 bytes, then 25
BENCHMARK_TEMPLATE(poll, 40);   // 85
BENCHMARK_TEMPLATE(poll, 125);  // 255

/// The shortest frames: requests and responses of eight bytes.
void valid_short_frames(benchmark::State& state)
{
    constexpr auto            frame = rtu::encode(7, write_single_register::request{0x1234, 0x5678});
    std::vector<std::uint8_t> stream;
    while (stream.size() < stream_size) { stream.insert(stream.end(), frame.begin(), frame.end()); }
    read(state, stream);
    if (state.counters["dropped"] != 0) { state.SkipWithError("valid frames were dropped"); }
}
BENCHMARK(valid_short_frames);

void random_garbage(benchmark::State& state)
{
    std::mt19937              random{1};
    std::vector<std::uint8_t> stream(stream_size);
    for (auto& byte : stream) { byte = static_cast<std::uint8_t>(random() >> 24); }
    read(state, stream);
}
BENCHMARK(random_garbage);

/// Every second byte begins what may be a request and a response, both as long as a frame can be.
void hostile(benchmark::State& state)
{
    std::vector<std::uint8_t> stream;
    while (stream.size() < stream_size) {
        stream.push_back(0x14);
        stream.push_back(0xF5);
    }
    read(state, stream);
}
BENCHMARK(hostile);

}  // namespace
