// The jobs of a client and a server, from frame to fields and back, beside the CRC that they cannot do without.

#include "modbus/rtu/messages.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace drivecodec;
namespace rtu = modbus::rtu;

/// Runs `job(bytes)` over a frame of which the compiler knows nothing.
template <typename Job>
void measure(benchmark::State& state, bytes wire, Job job)
{
    for (auto _ : state) {
        benchmark::DoNotOptimize(wire);
        benchmark::ClobberMemory();
        auto done = job(wire);
        benchmark::DoNotOptimize(done);
    }
}

void crc_of_response_03(benchmark::State& state)
{
    measure(state, messages::response_03, [](bytes wire) { return modbus::crc16::compute(wire); });
}
BENCHMARK(crc_of_response_03);

void decode_response_03(benchmark::State& state)
{
    static std::array<std::uint16_t, 125> values{};
    measure(state, messages::response_03, [](bytes wire) { return messages::decode_response_03(wire, values); });
}
BENCHMARK(decode_response_03);

void crc_of_request_16(benchmark::State& state)
{
    auto const covered = bytes{messages::response_03}.first(messages::request_16_size - 2);
    measure(state, covered, [](bytes wire) { return modbus::crc16::compute(wire); });
}
BENCHMARK(crc_of_request_16);

void encode_request_16(benchmark::State& state)
{
    static std::array<std::uint8_t, rtu::max_adu_size> out{};
    measure(state, {}, [](bytes) { return messages::encode_request_16(messages::words_123, out); });
}
BENCHMARK(encode_request_16);

void crc_of_request_03(benchmark::State& state)
{
    measure(state, messages::request_03, [](bytes wire) { return modbus::crc16::compute(wire); });
}
BENCHMARK(crc_of_request_03);

void decode_request_03(benchmark::State& state)
{
    measure(state, messages::request_03, [](bytes wire) { return messages::decode_request_03(wire); });
}
BENCHMARK(decode_request_03);

}  // namespace
