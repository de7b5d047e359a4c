#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string_view>
#include <type_traits>

/// The texts of all values that an enum can have, also of those without a name. No two may share one.
template <typename Enum>
std::set<std::string_view> names_of_all_values()
{
    std::set<std::string_view> names;
    for (std::uint32_t value = 0; value <= std::underlying_type_t<Enum>(-1); ++value) {
        auto const name = to_string(static_cast<Enum>(value));
        if (not name.empty()) { EXPECT_TRUE(names.insert(name).second) << name; }
    }
    return names;
}
