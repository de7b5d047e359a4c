// EXPECT: deleted function
#include <drivecodec/fc.hpp>

using namespace drivecodec::fc;

std::array<std::uint8_t, 16> received();

#ifdef OK
bool understood()
{
    auto const wire = received();
    return decode<text_request>(wire).has_value() and decode<parameter_request>(received()).has_value();
}
#else
bool understood()
{
    return decode<text_request>(received()).has_value();
}
#endif
