#include <drivecodec/core/word.hpp>

#include "support/verify.hpp"

#include <type_traits>

namespace {

using drivecodec::field;
using drivecodec::flag;
using drivecodec::word;

enum class mode : std::uint8_t { off, slow, fast, turbo };

struct status : word<status, std::uint16_t> {
    static constexpr flag<status>               ready{0};
    static constexpr flag<status>               fault{3};
    static constexpr flag<status>               remote{15};
    static constexpr field<status, mode, 4, 2>  speed{};
    static constexpr field<status, int, 8, 7>   level{};
    static constexpr field<status, int, 0, 16>  all{};
};

struct small : word<small, std::uint8_t> {
    static constexpr flag<small>                       top{7};
    static constexpr field<small, unsigned, 4, 4>      high{};
};

struct wide : word<wide, std::uint32_t> {
    static constexpr flag<wide>                          top{31};
    static constexpr field<wide, std::uint32_t, 0, 32>   all{};
    static constexpr field<wide, std::uint32_t, 30, 2>   high{};
};

TEST(word, is_its_integer)
{
    VERIFY(sizeof(status) == 2 and sizeof(small) == 1 and sizeof(wide) == 4);
    VERIFY(std::is_trivially_copyable_v<status>);
    VERIFY(status{}.raw == 0);
    VERIFY(status::from_raw(0xABCD).raw == 0xABCD);
}

TEST(word, is_made_of_flags)
{
    VERIFY(status::of() == status{});
    VERIFY(status::of(status::ready, status::remote).raw == 0x8001);
    VERIFY(small::of(small::top).raw == 0x80);
    VERIFY(wide::of(wide::top).raw == 0x8000'0000);
}

TEST(word, tests_flags)
{
    VERIFY(status::from_raw(0x0008).test(status::fault));
    VERIFY(not status::from_raw(0xFFF7).test(status::fault));
    VERIFY(wide::from_raw(0x8000'0000).test(wide::top));
}

TEST(word, sets_and_clears_flags_and_leaves_other_bits)
{
    VERIFY(status::from_raw(0x1240).with(status::fault).raw == 0x1248);
    VERIFY(status::from_raw(0x1248).with(status::fault).raw == 0x1248);
    VERIFY(status::from_raw(0xFFFF).without(status::fault).raw == 0xFFF7);
    VERIFY(status::from_raw(0xFFF7).without(status::fault).raw == 0xFFF7);
    VERIFY(small::from_raw(0xFF).without(small::top).raw == 0x7F);
}

TEST(word, reads_fields)
{
    VERIFY(status::from_raw(0x0020).get(status::speed) == mode::fast);
    VERIFY(status::from_raw(0xFFCF).get(status::speed) == mode::off);
    VERIFY(status::from_raw(0xFFFF).get(status::level) == 0x7F);
    VERIFY(status::from_raw(0xABCD).get(status::all) == 0xABCD);
    VERIFY(small::from_raw(0xA5).get(small::high) == 0xA);
    VERIFY(wide::from_raw(0xDEAD'BEEF).get(wide::all) == 0xDEAD'BEEF);
    VERIFY(wide::from_raw(0xC000'0000).get(wide::high) == 3);
}

TEST(word, writes_fields_and_leaves_other_bits)
{
    VERIFY(status::from_raw(0xFFFF).with(status::speed, mode::slow).raw == 0xFFDF);
    VERIFY(status::from_raw(0x0000).with(status::speed, mode::turbo).raw == 0x0030);
    VERIFY(status::from_raw(0x80FF).with(status::level, 0x55).raw == 0xD5FF);
    VERIFY(wide{}.with(wide::all, 0xDEAD'BEEF).raw == 0xDEAD'BEEF);
}

TEST(word, ignores_what_is_wider_than_the_field)
{
    VERIFY(status{}.with(status::level, 0xFFFF).raw == 0x7F00);
    VERIFY(small::from_raw(0x05).with(small::high, 0x1F).raw == 0xF5);
}

TEST(word, keeps_every_unknown_bit)
{
    for (unsigned raw = 0; raw <= 0xFFFF; ++raw) {
        auto const before = status::from_raw(static_cast<std::uint16_t>(raw));
        ASSERT_EQ(before.with(status::speed, before.get(status::speed)), before);
        ASSERT_EQ(before.test(status::fault) ? before.with(status::fault) : before.without(status::fault), before);
    }
}

template <status Status>
struct named_by {
    static constexpr auto raw = Status.raw;
};

TEST(word, can_be_a_template_argument_and_a_case)
{
    VERIFY(named_by<status::of(status::fault)>::raw == 8);
    constexpr auto is_faulty = [](status current) {
        switch (current.raw) {
        case status::of(status::fault).raw: return true;
        default: return false;
        }
    };
    VERIFY(is_faulty(status::of(status::fault)));
    VERIFY(not is_faulty(status{}));
}

template <typename Word, typename Flag>
concept testable = requires(Word const& w, Flag f) { w.test(f); };

TEST(word, does_not_know_the_flags_of_another)
{
    VERIFY(testable<status, flag<status>>);
    VERIFY(not testable<status, flag<small>>);
    VERIFY(not testable<small, flag<status>>);
    VERIFY(not testable<small, int>);
}

}  // namespace
