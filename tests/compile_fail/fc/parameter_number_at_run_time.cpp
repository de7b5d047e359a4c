// EXPECT: not a constant expression|is not usable in a constant expression|not constant
#include <drivecodec/fc/parameter_requests.hpp>

using namespace drivecodec::fc;

#ifdef OK
bool is_known(std::uint16_t number)
{
    return parameter_number::make(number).has_value();
}
#else
parameter_request ask(std::uint16_t number)
{
    return read_value(number, data_not_valid);
}
#endif
