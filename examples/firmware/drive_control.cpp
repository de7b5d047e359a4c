// Firmware that starts a drive and watches its speed: no operating system, no heap, no static RAM for the library. The
// start-up is tests/firmware/startup.cpp; firmware::write prints through the debugger.
//
// The two frames that never change are built by the compiler and lie in flash. What changes is built when it is needed.

#include "firmware.hpp"

#include <drivecodec/modbus.hpp>

namespace modbus = drivecodec::modbus;
namespace rtu    = drivecodec::modbus::rtu;
using drivecodec::bytes;

//=== the drive, and its registers ===//

constexpr rtu::server_address drive{7};
constexpr std::uint16_t       speed_setpoint = 0x0102;

constexpr auto start       = modbus::write_single_coil::request{0x0010, true};
constexpr auto start_frame = rtu::encode(drive, start);

constexpr auto actual_values       = modbus::read_holding_registers::request{{0x006B, 3}};  // speed, current, faults
constexpr auto actual_values_frame = rtu::encode(drive, actual_values);
static_assert(actual_values_frame == std::array<std::uint8_t, 8>{0x07, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x74, 0x71});

//=== a stand-in for the UART: it shows what is sent, and a drive answers ===//

namespace uart {

void print(bytes frame)
{
    constexpr char digits[] = "0123456789ABCDEF";
    for (auto const byte : frame) {
        char const text[] = {digits[byte >> 4], digits[byte & 15], ' ', '\0'};
        firmware::write(text);
    }
    firmware::write("\n");
}

void send(bytes frame)
{
    firmware::write("sent      ");
    print(frame);
}

/// The frame that came before the line fell silent.
bytes receive(bytes what_the_drive_says)
{
    firmware::write("received  ");
    print(what_the_drive_says);
    return what_the_drive_says;
}

}  // namespace uart

//=== what the drive says here ===//

// A response is a message like a request: these too are built by the compiler.
using three_registers = modbus::read_holding_registers::basic_response<modbus::register_array<3>>;

constexpr auto values_frame  = rtu::encode(drive, three_registers{{modbus::register_array<3>{{1450, 37, 0}}}});
constexpr auto refusal       = modbus::exception_response{modbus::function_code::write_single_register,
                                                          modbus::exception_code::illegal_data_value};
constexpr auto refusal_frame = rtu::encode(drive, refusal);

//=== the application ===//

static bool succeeded(bool good, char const* what)
{
    firmware::write(good ? "ok:       " : "FAILED:   ");
    firmware::write(what);
    firmware::write("\n");
    return good;
}

static bool start_drive()
{
    uart::send(start_frame);
    // A drive that obeys repeats the request.
    auto const response = rtu::check(drive, start, uart::receive(start_frame));
    return succeeded(response.has_value(), "the drive runs");
}

static bool watch_drive()
{
    uart::send(actual_values_frame);
    auto const response = rtu::check(drive, actual_values, uart::receive(values_frame));
    return succeeded(response and response->values[0] == 1450 and response->values[2] == 0, "1450 rpm, no fault");
}

static bool overspeed_is_refused(std::uint16_t rpm)
{
    auto const request = modbus::write_single_register::request{speed_setpoint, rpm};
    auto const frame   = rtu::encode(drive, request);  // known only now: eight bytes on the stack
    uart::send(frame);
    auto const response = rtu::check(drive, request, uart::receive(refusal_frame));
    return succeeded(not response and response.error().code() == drivecodec::errc::exception_reply
                         and response.error().exception() == modbus::exception_code::illegal_data_value,
                     "the drive refuses that speed");
}

static bool noise_is_no_reply()
{
    auto damaged = values_frame;
    damaged[4] ^= 0x20;
    auto const response = rtu::check(drive, actual_values, uart::receive(damaged));
    return succeeded(not response and response.error().code() == drivecodec::errc::bad_checksum,
                     "a damaged reply is not taken");
}

int main()
{
    bool const good = start_drive() and watch_drive() and overspeed_is_refused(9000) and noise_is_no_reply();
    firmware::write(good ? "drive_control: passed\n" : "drive_control: FAILED\n");
    return good ? 0 : 1;
}
