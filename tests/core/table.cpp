#include <drivecodec/core/table.hpp>

#include "support/verify.hpp"

#include <string_view>

namespace {

using drivecodec::find_row;
using drivecodec::find_word;
using drivecodec::strictly_ascending;

struct row {
    int              number;
    std::string_view name;
};

constexpr std::array<row, 5> rows{{{-3, "a"}, {0, "b"}, {1, "c"}, {7, "d"}, {100, "e"}}};
constexpr std::array<row, 0> none{};

TEST(strictly_ascending, wants_every_key_above_the_one_before)
{
    VERIFY(strictly_ascending(rows, &row::number));
    VERIFY(strictly_ascending(rows, &row::name));
    VERIFY(strictly_ascending(none, &row::number));
    VERIFY(strictly_ascending(std::array<row, 1>{{{5, "a"}}}, &row::number));
    VERIFY(not strictly_ascending(std::array<row, 2>{{{5, "a"}, {5, "b"}}}, &row::number));
    VERIFY(not strictly_ascending(std::array<row, 3>{{{1, "a"}, {3, "b"}, {2, "c"}}}, &row::number));
}

TEST(find_row, finds_every_row)
{
    VERIFY(find_row(rows, &row::number, -3)->name == "a");
    VERIFY(find_row(rows, &row::number, 100)->name == "e");
    VERIFY(find_row(rows, &row::name, std::string_view{"d"})->number == 7);
    for (auto const& expected : rows) { EXPECT_EQ(find_row(rows, &row::number, expected.number), &expected); }
}

TEST(find_row, finds_nothing_between_below_and_above)
{
    for (auto const missing : {-1000, -4, -2, -1, 2, 6, 8, 99, 101, 1000}) {
        EXPECT_EQ(find_row(rows, &row::number, missing), nullptr) << missing;
    }
    VERIFY(find_row(rows, &row::number, 2) == nullptr);
    VERIFY(find_row(none, &row::number, 0) == nullptr);
}

template <std::size_t N>
void expect_found_in_a_table_of()
{
    std::array<row, N> made{};
    for (std::size_t i = 0; i < N; ++i) { made[i].number = static_cast<int>(2 * i); }
    for (std::size_t i = 0; i < N; ++i) {
        EXPECT_EQ(find_row(made, &row::number, static_cast<int>(2 * i)), &made[i]);
        EXPECT_EQ(find_row(made, &row::number, static_cast<int>(2 * i) + 1), nullptr);
    }
    EXPECT_EQ(find_row(made, &row::number, -1), nullptr);
}

TEST(find_row, works_for_every_size)
{
    expect_found_in_a_table_of<1>();
    expect_found_in_a_table_of<2>();
    expect_found_in_a_table_of<3>();
    expect_found_in_a_table_of<4>();
    expect_found_in_a_table_of<16>();
    expect_found_in_a_table_of<33>();
}

struct shared_words {
    std::string_view code;
    std::string_view name;
};
constexpr std::array<shared_words, 5> words{
    {{"A", "first"}, {"B", "second"}, {"C", "second"}, {"", "fourth"}, {"same", "same"}}};

TEST(find_word, finds_the_row_that_has_it_in_any_of_the_keys)
{
    VERIFY(find_word(words, "A", &shared_words::code, &shared_words::name) == &words[0]);
    VERIFY(find_word(words, "first", &shared_words::code, &shared_words::name) == &words[0]);
    VERIFY(find_word(words, "fourth", &shared_words::code, &shared_words::name) == &words[3]);
    VERIFY(find_word(words, "first", &shared_words::code) == nullptr);
    VERIFY(find_word(words, "same", &shared_words::code, &shared_words::name) == &words[4]);  // in one row: no doubt
}

TEST(find_word, finds_none_of_several)
{
    VERIFY(find_word(words, "second", &shared_words::code, &shared_words::name) == nullptr);
    VERIFY(
        find_word(std::array<shared_words, 2>{{{"A", "B"}, {"B", "A"}}}, "A", &shared_words::code, &shared_words::name)
        == nullptr);
}

TEST(find_word, finds_nothing_else)
{
    VERIFY(find_word(words, "", &shared_words::code, &shared_words::name) == nullptr);
    VERIFY(find_word(words, "a", &shared_words::code, &shared_words::name) == nullptr);
    VERIFY(find_word(words, "firs", &shared_words::code, &shared_words::name) == nullptr);
    VERIFY(find_word(std::array<shared_words, 0>{}, "A", &shared_words::code) == nullptr);
}

}  // namespace
