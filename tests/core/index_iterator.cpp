#include <drivecodec/core/index_iterator.hpp>

#include "support/verify.hpp"

#include <iterator>
#include <vector>

namespace {

/// 0, 1, 4, 9, ...
struct squares {
    std::size_t count = 0;

    constexpr std::size_t                                         operator[](std::size_t index) const { return index * index; }
    constexpr drivecodec::index_iterator<squares, std::size_t>    begin() const { return {*this, 0}; }
    constexpr drivecodec::index_iterator<squares, std::size_t>    end() const { return {*this, count}; }
};

using iterator = drivecodec::index_iterator<squares, std::size_t>;

TEST(index_iterator, is_an_input_iterator)
{
    VERIFY(std::input_iterator<iterator>);
    VERIFY(std::sentinel_for<iterator, iterator>);
    VERIFY(std::default_initializable<iterator>);
}

TEST(index_iterator, visits_every_element_in_order)
{
    std::vector<std::size_t> seen;
    for (auto const square : squares{4}) { seen.push_back(square); }
    EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1, 4, 9}));
}

TEST(index_iterator, visits_nothing_of_an_empty_view)
{
    VERIFY(squares{0}.begin() == squares{0}.end());
}

TEST(index_iterator, steps_before_and_after)
{
    constexpr auto stepped = [] {
        auto       it     = squares{3}.begin();
        auto const before = it++;
        auto const after  = ++it;
        return *before * 100 + *it * 10 + *after;
    };
    VERIFY(stepped() == 44);
}

TEST(index_iterator, outlives_the_name_of_its_view)
{
    constexpr auto last = [] {
        auto it = squares{9}.begin();
        ++it;
        return *it;
    };
    VERIFY(last() == 1);
}

}  // namespace
