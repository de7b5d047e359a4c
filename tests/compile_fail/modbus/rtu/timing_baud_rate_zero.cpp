// EXPECT: baud_rate_must_be_positive
#include <drivecodec/modbus/rtu/timing.hpp>

using namespace drivecodec::modbus;

#ifdef OK
static_assert(rtu::timing::of(1).character() == 11'000'000);
#else
static_assert(rtu::timing::of(0).character() == 11'000'000);
#endif
