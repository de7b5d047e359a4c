// EXPECT: constraints not satisfied|no matching function
#include <drivecodec/core/word.hpp>

using namespace drivecodec;

struct status : word<status, std::uint16_t> {
    static constexpr flag<status> ready{0};
};
struct control : word<control, std::uint16_t> {
    static constexpr flag<control> enable{0};
};

#ifdef OK
constexpr auto made = status::of(status::ready);
#else
constexpr auto made = status::of(control::enable);
#endif
