// Five ways to compute one CRC. Carry-less multiply is only measured as such when built with -mpclmul (x86) or
// -march=armv8-a+crypto; the label says what it was.

#include <drivecodec/modbus/crc16.hpp>
#include <drivecodec/modbus/crc16/byte_table.hpp>
#include <drivecodec/modbus/crc16/carryless.hpp>
#include <drivecodec/modbus/crc16/nibble.hpp>

#include <benchmark/benchmark.h>

#include <vector>

namespace {

using namespace drivecodec;
namespace crc16 = modbus::crc16;

template <crc16::algorithm Algorithm>
void compute(benchmark::State& state)
{
    std::vector<std::uint8_t> message(static_cast<std::size_t>(state.range(0)));
    for (std::size_t i = 0; i < message.size(); ++i) { message[i] = static_cast<std::uint8_t>(151 * i + 7); }
    for (auto _ : state) {
        benchmark::DoNotOptimize(message.data());
        benchmark::ClobberMemory();
        benchmark::DoNotOptimize(crc16::compute<Algorithm>(message));
    }
    state.SetBytesProcessed(state.iterations() * state.range(0));
    if constexpr (requires { Algorithm::is_native; }) { state.SetLabel(Algorithm::is_native ? "native" : "slices"); }
}

BENCHMARK_TEMPLATE(compute, crc16::bitwise)->Arg(8)->Arg(256);
BENCHMARK_TEMPLATE(compute, crc16::nibble)->Arg(8)->Arg(256);
BENCHMARK_TEMPLATE(compute, crc16::byte_table)->Arg(8)->Arg(256);
BENCHMARK_TEMPLATE(compute, crc16::slices)->Arg(8)->Arg(256);
BENCHMARK_TEMPLATE(compute, crc16::carryless)->Arg(8)->Arg(256);

}  // namespace
