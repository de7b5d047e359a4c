// EXPECT: register_count_must_be_between.*0.*31
#include <drivecodec/modbus/functions/read_fifo_queue.hpp>

using namespace drivecodec::modbus;

#ifdef OK
constexpr read_fifo_queue::basic_response<register_array<31>> given{.values = register_array<31>{}};
#else
constexpr read_fifo_queue::basic_response<register_array<32>> given{.values = register_array<32>{}};
#endif
