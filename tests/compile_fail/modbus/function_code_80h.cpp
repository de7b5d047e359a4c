// EXPECT: a function code is below 80h
#include <drivecodec/modbus.hpp>

#include <array>

using namespace drivecodec;
using namespace drivecodec::modbus;

template <int Code>
struct mine : write_single_coil {
    static constexpr auto code = static_cast<function_code>(Code);
};

#ifdef OK
using set = function_set<mine<0x7F>>;
static_assert(set::name(bytes{}) == nullptr);
#else
using set = function_set<mine<0x80>>;
static_assert(set::name(bytes{}) == nullptr);
#endif
