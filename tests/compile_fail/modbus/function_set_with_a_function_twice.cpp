// EXPECT: a function_set holds each function once
#include <drivecodec/modbus/function_set.hpp>
#include <drivecodec/modbus/functions/read_bits.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr auto name = function_set<read_coils, read_discrete_inputs>::name({});
#else
constexpr auto name = function_set<read_coils, basic_read_coils<8>>::name({});
#endif
