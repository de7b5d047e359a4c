// SPDX-License-Identifier: MIT
//
// Frames that the compiler builds and checks; and a function of one's own beside the public ones.
#include <drivecodec/modbus.hpp>
#include <drivecodec/text/modbus.hpp>

#include <array>
#include <cstdint>
#include <iostream>

namespace modbus = drivecodec::modbus;
namespace rtu    = modbus::rtu;

//=== a frame at compile time ===//

// Eight bytes in flash, CRC included; no code runs to build them.
constexpr auto read_three = rtu::encode(17, modbus::read_holding_registers::request{{107, 3}});

static_assert(read_three == std::array<std::uint8_t, 8>{0x11, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x76, 0x87});

// None of these compiles; the compiler says why:
//   rtu::encode(17, modbus::read_holding_registers::request{{107, 126}})   register_count_must_be_between<1, 125>
//   rtu::encode(250, ...)                                                  server_address_must_be_between_1_and_247
//   rtu::encode(rtu::broadcast, modbus::read_coils::request{{0, 8}})       only a write can be broadcast

// Decoding works there too.
constexpr auto decoded = rtu::decode<modbus::read_holding_registers::request>(read_three);
static_assert(decoded and decoded->address == 17 and decoded->message.range.first() == 107
              and decoded->message.range.count() == 3);

// So does the question whether a reply answers the request.
constexpr auto reply_of_three =
    std::to_array<std::uint8_t>({0x11, 0x03, 0x06, 0x02, 0x2B, 0x00, 0x00, 0x00, 0x64, 0xC8, 0xBA});
constexpr auto three          = rtu::check(17, decoded->message, reply_of_three);
static_assert(three and three->values[0] == 555 and three->values[2] == 100);

//=== a function of one's own ===//

/// Function 100 of an imaginary drive: the hours that one of its fans has run.
///
/// What a function is, is this: a code, a name, a request and a response that say how they lie on the wire.
struct read_run_hours {
    static constexpr auto        code = static_cast<modbus::function_code>(100);  // 65 to 72, 100 to 110 are the users'
    static constexpr char const* name = "read_run_hours";

    struct request;
    struct response;
};

struct read_run_hours::response {  // | function | fan | hours hi lo |
    using function = read_run_hours;

    using fan_at   = drivecodec::u8_at<1>;
    using hours_at = drivecodec::be16_at<2>;

    std::uint8_t  fan;
    std::uint16_t hours;

    static constexpr std::size_t wire_size() noexcept { return hours_at::end; }
    static constexpr auto        length(drivecodec::bytes) noexcept
    {
        return drivecodec::message_length::exactly(wire_size());
    }

    static constexpr drivecodec::error check(drivecodec::bytes pdu) noexcept
    {
        return modbus::check_fixed(pdu, function::code, wire_size());
    }
    static constexpr response read(drivecodec::bytes pdu) noexcept
    {
        return {.fan = fan_at::load(pdu), .hours = hours_at::load(pdu)};
    }
    constexpr void write(drivecodec::mutable_bytes out) const noexcept
    {
        modbus::layout::function.store(out, modbus::to_byte(function::code));
        fan_at::store(out, fan);
        hours_at::store(out, hours);
    }
};

struct read_run_hours::request {  // | function | fan |
    using function = read_run_hours;

    using fan_at = drivecodec::u8_at<1>;

    std::uint8_t fan;

    static constexpr std::size_t wire_size() noexcept { return fan_at::end; }
    static constexpr auto        length(drivecodec::bytes) noexcept
    {
        return drivecodec::message_length::exactly(wire_size());
    }

    static constexpr drivecodec::error check(drivecodec::bytes pdu) noexcept
    {
        return modbus::check_fixed(pdu, function::code, wire_size());
    }
    static constexpr request read(drivecodec::bytes pdu) noexcept { return {.fan = fan_at::load(pdu)}; }
    constexpr void           write(drivecodec::mutable_bytes out) const noexcept
    {
        modbus::layout::function.store(out, modbus::to_byte(function::code));
        fan_at::store(out, fan);
    }

    /// A response about another fan does not answer this.
    constexpr drivecodec::error matches(response const& given) const noexcept
    {
        return modbus::expect_equal(given.fan == fan, response::fan_at::begin);
    }
};

// Words for it, should one want them: then `describe` prints the fields.
constexpr void for_each_field(read_run_hours::request const& asked, auto&& visit) { visit("fan", asked.fan); }
constexpr void for_each_field(read_run_hours::response const& given, auto&& visit)
{
    visit("fan", given.fan);
    visit("hours", given.hours);
}

// It joins the others: readers know its length, servers serve it, logs name it.
using functions = modbus::public_functions::with<read_run_hours>;

struct drive {
    using functions = ::functions;

    constexpr modbus::answer<read_run_hours::response> operator()(read_run_hours::request const& asked) const
    {
        if (asked.fan > 1) { return modbus::exception_code::illegal_data_address; }
        return read_run_hours::response{.fan = asked.fan, .hours = 4321};
    }
};

// The whole way at compile time: encode, serve, check, decode.
constexpr auto hours_of(std::uint8_t fan)
{
    std::array<std::uint8_t, rtu::max_adu_size> buffer{};
    auto const asked  = read_run_hours::request{.fan = fan};
    auto const answer = rtu::serve(17, rtu::encode(17, asked), buffer, drive{});
    return rtu::check(17, asked, answer);
}
static_assert(hours_of(1)->hours == 4321);
static_assert(hours_of(2).error() == modbus::reply_error{modbus::exception_code::illegal_data_address});

namespace {

void print(drivecodec::bytes raw, modbus::direction direction)
{
    std::array<char, 200> digits{};
    std::array<char, 200> words{};
    std::cout << drivecodec::text_writer{digits}.hex(raw).view() << "\n    "
              << rtu::describe<functions>({.raw = raw, .direction = direction, .aligned = true}, words) << '\n';
}

}  // namespace

int main()
{
    print(read_three, modbus::direction::request);
    print(reply_of_three, modbus::direction::response);

    // At run time: a frame of one's own function amid others, as a stream reader finds it.
    auto const                                  asked = rtu::encode(17, read_run_hours::request{.fan = 1});
    std::array<std::uint8_t, rtu::max_adu_size> buffer{};
    rtu::basic_reader<functions>                reader;
    for (drivecodec::bytes const chunk : {drivecodec::bytes{read_three}, drivecodec::bytes{asked}}) {
        if (not reader.push(chunk).empty()) { return 1; }
        while (auto const item = reader.next()) {
            if (item.frame() == nullptr) { return 1; }
            auto const answer = rtu::serve(17, *item.frame(), buffer, drive{});  // it serves that function only
            print(item.frame()->raw, modbus::direction::request);
            print(answer, modbus::direction::response);
        }
    }
    return 0;
}
