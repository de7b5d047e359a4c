// EXPECT: constraint.*function
#include <drivecodec/modbus/function_set.hpp>
#include <drivecodec/modbus/functions/read_bits.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr auto name = function_set<read_coils>::name({});
#else
constexpr auto name = function_set<read_coils::request>::name({});
#endif
