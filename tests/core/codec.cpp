#include <drivecodec/core/codec.hpp>

#include "support/hex.hpp"
#include "support/verify.hpp"

#include <vector>

namespace {

using namespace drivecodec;

/// | value hi lo |
struct number {
    std::uint16_t value;

    static constexpr std::size_t wire_size() noexcept { return 2; }

    static constexpr error check(bytes wire) noexcept
    {
        if (wire.size() < 2) { return {errc::truncated, 2}; }
        return wire.size() > 2 ? error{errc::trailing_bytes, 2} : error{};
    }
    static constexpr number read(bytes wire) noexcept { return {be16_at<0>::load(wire)}; }
    constexpr void          write(mutable_bytes out) const noexcept { be16_at<0>::store(out, value); }

    friend constexpr bool operator==(number, number) = default;
};

/// | 01 | bytes ... |: borrows them.
struct text {
    bytes value;

    constexpr std::size_t wire_size() const noexcept { return 1 + value.size(); }

    static constexpr error check(bytes wire) noexcept
    {
        if (wire.empty()) { return {errc::truncated, 1}; }
        return wire[0] == 1 ? error{} : error{errc::bad_value, 0};
    }
    static constexpr text read(bytes wire) noexcept { return {wire.subspan(1)}; }
    constexpr void        write(mutable_bytes out) const noexcept
    {
        u8_at<0>::store(out, 1);
        copy_bytes(value, out.subspan(1));
    }
};

/// Can be sent, cannot be received.
struct only_writable {
    static constexpr std::size_t wire_size() noexcept { return 0; }
    constexpr void               write(mutable_bytes) const noexcept {}
};

struct may_throw {
    static std::size_t wire_size() { return 0; }
    void               write(mutable_bytes) const {}
};

TEST(codec, is_told_by_its_members)
{
    VERIFY(codec<number> and fixed_size<number>);
    VERIFY(codec<text> and not fixed_size<text>);
    VERIFY(writable<only_writable> and not codec<only_writable>);
    VERIFY(not writable<may_throw>);
    VERIFY(not writable<int>);
}

TEST(encode, gives_an_array_for_a_fixed_size)
{
    VERIFY(encode(number{0x1234}) == "12 34"_hex);
    VERIFY(std::is_same_v<decltype(encode(number{0x1234})), std::array<std::uint8_t, 2>>);
}

TEST(encode, writes_to_the_front_of_a_buffer)
{
    std::array<std::uint8_t, 4> out{0xEE, 0xEE, 0xEE, 0xEE};
    auto const                  written = encode(number{0x1234}, out);
    ASSERT_TRUE(written);
    EXPECT_EQ(written->data(), out.data());
    EXPECT_EQ(written->size(), 2U);
    EXPECT_EQ(out, "12 34 EE EE"_hex);
}

TEST(encode, takes_a_buffer_of_just_the_size)
{
    std::array<std::uint8_t, 2> out{};
    ASSERT_TRUE(encode(number{0x1234}, out));
    EXPECT_EQ(out, "12 34"_hex);
}

TEST(encode, leaves_a_buffer_that_is_too_small_untouched)
{
    static constexpr auto       payload = "0A 0B 0C"_hex;
    std::array<std::uint8_t, 3> out{0xEE, 0xEE, 0xEE};
    auto const                  written = encode(text{payload}, out);
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error(), (error{errc::no_space, 4}));
    EXPECT_EQ(out, "EE EE EE"_hex);
    EXPECT_EQ(encode(number{1}, mutable_bytes{}).error(), (error{errc::no_space, 2}));
}

TEST(decode, reads_what_check_allows)
{
    VERIFY(*decode<number>("12 34"_hex) == number{0x1234});
}

TEST(decode, gives_the_error_of_check)
{
    VERIFY(decode<number>("12"_hex).error() == error{errc::truncated, 2});
    VERIFY(decode<number>("12 34 56"_hex).error() == error{errc::trailing_bytes, 2});
    VERIFY(decode<number>(bytes{}).error() == error{errc::truncated, 2});
}

TEST(decode, borrows_from_the_caller_s_bytes)
{
    std::vector<std::uint8_t> const wire{0x01, 0x0A, 0x0B};
    auto const                      decoded = decode<text>(wire);
    ASSERT_TRUE(decoded);
    EXPECT_EQ(decoded->value.data(), wire.data() + 1);
    EXPECT_EQ(decoded->value.size(), 2U);
}

template <typename T, typename Wire>
concept can_decode = requires(Wire&& wire) { decode<T>(static_cast<Wire&&>(wire)); };

TEST(decode, refuses_to_borrow_from_a_temporary)
{
    using array = std::array<std::uint8_t, 2>;
    VERIFY(not can_decode<text, array>);
    VERIFY(not can_decode<text, std::vector<std::uint8_t>>);
    VERIFY(can_decode<text, array&>);
    VERIFY(can_decode<text, array const&>);
    VERIFY(can_decode<text, bytes>);
    VERIFY(can_decode<text, mutable_bytes>);
    VERIFY(can_decode<number, array>);  // a value that borrows nothing
}

}  // namespace
