#include <drivecodec/text/modbus/describe.hpp>

#include "support/hex.hpp"
#include "support/pdu_vectors.hpp"
#include "support/verify.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <string>
#include <vector>

namespace maker {

namespace modbus = drivecodec::modbus;

/// A function of the user, in a shape of the library.
struct read_trace {
    static constexpr auto        code = static_cast<modbus::function_code>(0x41);
    static constexpr char const* name = "read_trace";
    using request                     = modbus::range_message<read_trace, modbus::register_range<9>>;
    using response                    = modbus::values_response<read_trace, modbus::register_view, 9>;
};

}  // namespace maker

namespace {

namespace modbus = drivecodec::modbus;
using drivecodec::bytes;
using modbus::direction;

template <typename Functions = modbus::public_functions>
std::string text_of(direction which, bytes pdu, bytes request = {})
{
    std::vector<char> buffer(modbus::max_description_size);
    return std::string{modbus::describe<Functions>(which, pdu, buffer, request)};
}

TEST(text_describe, is_a_constant_expression)
{
    constexpr auto is_right = [] {
        std::array<char, 80> buffer{};
        return modbus::describe(direction::request, vectors::read_holding_registers_request, buffer)
               == "request  03 read_holding_registers  first=107 count=3";
    }();
    VERIFY(is_right);
}

TEST(text_describe, shows_requests)
{
    EXPECT_EQ(text_of(direction::request, vectors::read_holding_registers_request),
              "request  03 read_holding_registers  first=107 count=3");
    EXPECT_EQ(text_of(direction::request, "07"_hex), "request  07 read_exception_status");
    EXPECT_EQ(text_of(direction::request, vectors::write_multiple_registers_request),
              "request  16 write_multiple_registers  first=1 count=2 byte_count=4 registers=[10 258]");
}

TEST(text_describe, shows_responses)
{
    EXPECT_EQ(text_of(direction::response, vectors::read_holding_registers_response),
              "response  03 read_holding_registers  byte_count=6 registers=[555 0 100]");
    EXPECT_EQ(text_of(direction::response, "01 01 05"_hex),
              "response  01 read_coils  byte_count=1 coils=[1 0 1 0 0 0 0 0]");
    EXPECT_EQ(text_of(direction::response, "01 01 05"_hex, "01 00 13 00 03"_hex),
              "response  01 read_coils  byte_count=1 coils=[1 0 1]");
}

TEST(text_describe, shows_exceptions)
{
    EXPECT_EQ(text_of(direction::response, vectors::exception_response),
              "response  01 read_coils  exception 02 illegal_data_address");
    EXPECT_EQ(text_of(direction::response, "90 0B"_hex),
              "response  16 write_multiple_registers  exception 11 gateway_target_device_failed_to_respond");
    EXPECT_EQ(text_of(direction::response, "83 63"_hex), "response  03 read_holding_registers  exception 99");
    EXPECT_EQ(text_of(direction::response, "AB 01"_hex),
              "response  43 encapsulated_interface_transport  exception 01 illegal_function");
    EXPECT_EQ(text_of(direction::response, "AB 0E 03"_hex),
              "response  43 read_device_identification  exception 03 illegal_data_value");
}

TEST(text_describe, shows_what_is_wrong)
{
    EXPECT_EQ(text_of(direction::request, {}), "request  truncated, 1 bytes needed");
    EXPECT_EQ(text_of(direction::request, "03 00 00 00 7E"_hex),
              "request  03 read_holding_registers  bad_quantity at byte 3: 03 00 00 00 7E");
    EXPECT_EQ(text_of(direction::request, "03 00 00"_hex),
              "request  03 read_holding_registers  truncated, 5 bytes needed: 03 00 00");
    EXPECT_EQ(text_of(direction::request, "83 02"_hex),
              "request  03 read_holding_registers  unsupported_function at byte 0: 83 02");
}

TEST(text_describe, shows_functions_that_nobody_knows)
{
    EXPECT_EQ(text_of(direction::request, "41 00 01"_hex), "request  65  unsupported_function at byte 0: 41 00 01");
    EXPECT_EQ(text_of(direction::response, "C1 01"_hex), "response  65  exception 01 illegal_function");
    EXPECT_EQ(text_of(direction::request, "2B 7F 01"_hex),
              "request  43 encapsulated_interface_transport  unsupported_function at byte 0: 2B 7F 01");
}

TEST(text_describe, knows_a_user_s_function)
{
    using mine = modbus::public_functions::with<maker::read_trace>;
    EXPECT_EQ(text_of<mine>(direction::request, "41 00 01 00 02"_hex), "request  65 read_trace  first=1 count=2");
    EXPECT_EQ(text_of<mine>(direction::response, "C1 02"_hex),
              "response  65 read_trace  exception 02 illegal_data_address");
    EXPECT_EQ(modbus::function_name<mine>("41"_hex), "read_trace");
}

TEST(text_describe, shows_everything_that_the_specification_prints)
{
    for (std::size_t i = 0; i < vectors::printed_requests.size(); ++i) {
        auto const [name, request] = vectors::printed_requests[i];
        auto const asked           = text_of(direction::request, request);
        auto const given           = text_of(direction::response, vectors::printed_responses[i].pdu, request);
        for (auto const& text : {asked, given}) {
            EXPECT_NE(text.find(name), std::string::npos) << text;
            EXPECT_EQ(text.find(" at byte "), std::string::npos) << text;
        }
    }
}

TEST(text_describe, writes_into_buffers_of_every_size_and_never_outside)
{
    auto const check = [](direction which, bytes pdu) {
        auto const whole = text_of(which, pdu);
        for (std::size_t size = 0; size <= whole.size() + 1; ++size) {
            auto const buffer = std::make_unique<char[]>(size);  // a sanitizer sees the first byte outside
            auto const text   = modbus::describe(which, pdu, {buffer.get(), size});
            auto const kept   = size < whole.size() ? size - std::min<std::size_t>(size, 3) : whole.size();
            ASSERT_EQ(text.size(), std::min(size, whole.size()));
            ASSERT_EQ(text.substr(0, kept), whole.substr(0, kept));
            ASSERT_EQ(text.substr(kept), size < whole.size() ? std::string(text.size() - kept, '.') : "");
        }
    };
    for (auto const& printed : vectors::printed_requests) { check(direction::request, printed.pdu); }
    for (auto const& printed : vectors::printed_responses) { check(direction::response, printed.pdu); }
    check(direction::request, "03 00 00 00 7E"_hex);
    check(direction::request, {});
}

TEST(text_describe, needs_no_more_than_it_says)
{
    auto const longest = [](std::vector<std::uint8_t> head, std::uint8_t fill, std::size_t size) {
        head.resize(size, fill);
        drivecodec::text_writer out;
        auto const              fault = modbus::write_message(out, direction::response, head);
        EXPECT_TRUE(fault.ok()) << static_cast<int>(head[0]);
        return out.needed();
    };
    auto const events = longest({0x0C, 70, 0, 0, 0, 0, 0, 0}, 0x7F, 72);
    EXPECT_LE(events + 60, modbus::max_description_size);  // and the address before it
    EXPECT_LT(longest({0x01, 250}, 0xFF, 252), events);
    EXPECT_LT(longest({0x03, 250}, 0xFF, 252), events);
    EXPECT_LT(longest({0x11, 251}, 0xFF, 253), events);

    std::vector<std::uint8_t> objects{0x2B, 0x0E, 0x01, 0x01, 0, 0, 123};
    for (int i = 0; i < 123; ++i) { objects.insert(objects.end(), {6, 0}); }
    EXPECT_LT(longest(objects, 0, objects.size()), events);

    std::vector<std::uint8_t> records{0x14, 248};
    for (int i = 0; i < 62; ++i) { records.insert(records.end(), {3, 6, 0xFF, 0xFF}); }
    EXPECT_LT(longest(records, 0, records.size()), events);
}

TEST(text_describe, says_something_of_whatever_comes)
{
    std::mt19937      random{2};
    std::vector<char> buffer(modbus::max_description_size);
    for (int trial = 0; trial < 20'000; ++trial) {
        std::vector<std::uint8_t> pdu(random() % 24);
        for (auto& byte : pdu) { byte = static_cast<std::uint8_t>(random()); }
        if (trial % 2 == 0 and pdu.size() > 2) {  // often a known function with a byte count that fits
            pdu[0] = static_cast<std::uint8_t>(random() % 0x30);
            pdu[1] = static_cast<std::uint8_t>(pdu.size() - 2);
        }
        auto const request = std::span{pdu}.first(random() % (pdu.size() + 1));
        for (auto const which : {direction::request, direction::response}) {
            auto const exact = std::vector<std::uint8_t>(pdu.begin(), pdu.end());  // no byte behind it
            auto const text  = modbus::describe(which, exact, buffer, request);
            ASSERT_TRUE(text.starts_with(to_string(which)));
            for (auto const character : text) { ASSERT_TRUE(character >= ' ' and character <= '~'); }
        }
    }
}

TEST(text_describe, says_something_of_every_function_byte)
{
    for (unsigned code = 0; code <= 0xFF; ++code) {
        for (unsigned second = 0; second <= 0xFF; ++second) {
            std::array const pdu{static_cast<std::uint8_t>(code), static_cast<std::uint8_t>(second)};
            for (std::size_t size = 1; size <= 2; ++size) {
                for (auto const which : {direction::request, direction::response}) {
                    std::array<char, 200> buffer;
                    auto const            text = modbus::describe(which, std::span{pdu}.first(size), buffer);
                    ASSERT_TRUE(text.starts_with(to_string(which)));
                }
            }
        }
    }
}

}  // namespace
