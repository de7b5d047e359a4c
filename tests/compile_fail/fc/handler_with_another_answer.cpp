// EXPECT: a handler answers a parameter_request with a parameter_answer or a parameter_error
#include <drivecodec/fc/slave.hpp>

using namespace drivecodec;

#ifdef OK
using answer = fc::parameter_error;
#else
using answer = std::uint16_t;
#endif

struct drive {
    fc::process_status operator()(fc::process_command const&) const { return {}; }
    answer             operator()(fc::parameter_request const&) const { return answer{1}; }
};

bytes served(bytes wire, mutable_bytes reply)
{
    return fc::serve(fc::address::short_format(1), wire, reply, drive{});
}
