// EXPECT: cannot convert|no matching|no viable|could not convert|no known conversion
#include <drivecodec/core/word.hpp>

using namespace drivecodec;

struct status : word<status, std::uint16_t> {
    static constexpr flag<status> ready{0};
};
struct control : word<control, std::uint16_t> {
    static constexpr flag<control> enable{0};
};

#ifdef OK
constexpr bool ready = status{}.test(status::ready);
#else
constexpr bool ready = status{}.test(control::enable);
#endif
