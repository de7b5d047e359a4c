// EXPECT: Frame must be trivially copyable
#include <drivecodec/core/stream_item.hpp>

#include <vector>

struct frame {
#ifdef OK
    drivecodec::bytes raw;
#else
    std::vector<std::uint8_t> raw;
#endif
};

bool is_nothing(drivecodec::stream_item<frame> const& item) { return not item; }
