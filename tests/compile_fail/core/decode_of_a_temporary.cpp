// EXPECT: deleted
#include <drivecodec/core/codec.hpp>

using namespace drivecodec;

struct text {
    bytes letters;

    constexpr std::size_t  wire_size() const noexcept { return letters.size(); }
    static constexpr error check(bytes) noexcept { return {}; }
    static constexpr text  read(bytes wire) noexcept { return {wire}; }
    constexpr void         write(mutable_bytes out) const noexcept { copy_bytes(letters, out); }
};

#ifdef OK
constexpr std::array<std::uint8_t, 2> wire{1, 2};
constexpr auto                        whole = decode<text>(wire);
#else
constexpr auto whole = decode<text>(std::array<std::uint8_t, 2>{1, 2});
#endif
