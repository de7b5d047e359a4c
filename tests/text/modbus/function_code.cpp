#include <drivecodec/text/modbus/function_code.hpp>

#include "support/enum_names.hpp"
#include "support/verify.hpp"

#include <drivecodec/modbus/functions.hpp>

namespace {

namespace modbus = drivecodec::modbus;
using modbus::direction;
using modbus::function_code;

template <typename Functions>
struct names_of;
template <typename... Functions>
struct names_of<modbus::function_set<Functions...>> {
    /// What shares a code with others is known by the code's name.
    static constexpr bool agree =
        ((modbus::detail::has_mei<Functions> or to_string(Functions::code) == Functions::name) and ...);
};

TEST(text_function_code, has_a_name_for_every_public_function)
{
    EXPECT_EQ(names_of_all_values<function_code>().size(), 19);
    VERIFY(names_of<modbus::public_functions>::agree);
    VERIFY(to_string(function_code::encapsulated_interface_transport) == "encapsulated_interface_transport");
    VERIFY(to_string(static_cast<function_code>(0x41)).empty());
    VERIFY(to_string(static_cast<function_code>(0x83)).empty());
}

TEST(text_direction, has_two_names)
{
    EXPECT_EQ(names_of_all_values<direction>(), (std::set<std::string_view>{"request", "response"}));
    VERIFY(to_string(direction::request) == "request");
    VERIFY(to_string(direction::response) == "response");
}

}  // namespace
