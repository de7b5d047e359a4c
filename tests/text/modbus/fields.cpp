#include <drivecodec/text/modbus/fields.hpp>

#include "support/field_log.hpp"
#include "support/hex.hpp"
#include "support/verify.hpp"

#include <drivecodec/modbus/functions.hpp>

namespace modbus = drivecodec::modbus;

// A user's own messages: one that says what its fields are, in its own namespace, and one that does not.
namespace maker {

struct told {
    std::uint8_t speed;
};
constexpr void for_each_field(told const& message, auto&& visit)
{
    visit("speed", message.speed);
}

struct untold {};

/// A function of the user in a shape of the library.
struct read_trace {
    static constexpr auto        code = static_cast<modbus::function_code>(0x41);
    static constexpr char const* name = "read_trace";
    using request                     = modbus::range_message<read_trace, modbus::register_range<9>>;
    using response                    = modbus::values_response<read_trace, modbus::register_view, 9>;
};

}  // namespace maker

namespace {

template <typename Functions>
struct all_of;
template <typename... Functions>
struct all_of<modbus::function_set<Functions...>> {
    static constexpr bool have_fields = (modbus::has_fields<typename Functions::request> and ...)
                                        and (modbus::has_fields<typename Functions::response> and ...);
};

TEST(text_fields, every_public_message_says_what_its_fields_are)
{
    VERIFY(all_of<modbus::public_functions>::have_fields);
    VERIFY(modbus::has_fields<modbus::exception_response>);
}

TEST(text_fields, every_record_does)
{
    VERIFY(modbus::has_fields<modbus::file_record_range>);
    VERIFY(modbus::has_fields<modbus::file_record>);
    VERIFY(modbus::has_fields<modbus::file_values>);
    VERIFY(modbus::has_fields<modbus::device_object>);
}

TEST(text_fields, no_plain_field_does)
{
    VERIFY(not modbus::has_fields<std::uint16_t>);
    VERIFY(not modbus::has_fields<drivecodec::bytes>);
    VERIFY(not modbus::has_fields<modbus::register_view>);
    VERIFY(not modbus::has_fields<modbus::comm_event>);
    VERIFY(not modbus::has_fields<modbus::read_device_id_code>);  // though a request can be made of it
}

TEST(text_fields, a_user_s_message_may_bring_its_own)
{
    VERIFY(modbus::has_fields<maker::told>);
    VERIFY(not modbus::has_fields<maker::untold>);
    EXPECT_EQ(fields_of_message(maker::told{7}), "speed=7 ");
}

TEST(text_fields, a_user_s_function_in_a_known_shape_needs_none)
{
    EXPECT_EQ(fields_of<maker::read_trace::request>("41 00 01 00 02"_hex), "first=1 count=2 ");
    EXPECT_EQ(fields_of<maker::read_trace::response>("41 02 00 05"_hex), "byte_count=2 registers=[5 ] ");
}

}  // namespace
