// EXPECT: deleted function
#include <drivecodec/fc.hpp>

using namespace drivecodec::fc;

std::array<std::uint8_t, 16> received();
constexpr auto               one   = address::short_format(1);
constexpr auto               asked = read_text(621, data_not_valid);

#ifdef OK
bool answered()
{
    auto const wire = received();
    return check(one, asked, wire).has_value();
}
#else
bool answered()
{
    return check(one, asked, received()).has_value();
}
#endif
