// EXPECT: a handler answers a text_request with a text_answer, bytes or a parameter_error
#include <drivecodec/fc/slave.hpp>

using namespace drivecodec;

#ifdef OK
using answer = bytes;
#else
using answer = char const*;
#endif

struct drive {
    fc::process_status operator()(fc::process_command const&) const { return {}; }
    answer             operator()(fc::text_request const&) const { return answer{}; }
};

bytes served(bytes wire, mutable_bytes reply)
{
    return fc::serve(fc::address::short_format(1), wire, reply, drive{});
}
