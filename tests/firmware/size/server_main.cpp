// A client that asks, and what the server must answer.
#include "server.hpp"

namespace {

template <std::size_t N, std::size_t M>
bool answers(std::uint8_t const (&request)[N], std::uint8_t const (&expected)[M])
{
    if (serve(request, N) != M) { return false; }
    for (std::size_t i = 0; i < M; ++i) {
        if (reply[i] != expected[i]) { return false; }
    }
    return true;
}

template <std::size_t N>
bool is_silent(std::uint8_t const (&request)[N])
{
    return serve(request, N) == 0;
}

constexpr std::uint8_t write_two[]         = {0x07, 0x10, 0x00, 0x01, 0x00, 0x02, 0x04,
                                              0x00, 0x0A, 0x01, 0x02, 0x8C, 0xB8};
constexpr std::uint8_t two_written[]       = {0x07, 0x10, 0x00, 0x01, 0x00, 0x02, 0x10, 0x6E};
constexpr std::uint8_t read_two[]          = {0x07, 0x03, 0x00, 0x01, 0x00, 0x02, 0x95, 0xAD};
constexpr std::uint8_t two_read[]          = {0x07, 0x03, 0x04, 0x00, 0x0A, 0x01, 0x02, 0x3C, 0x60};
constexpr std::uint8_t write_last[]        = {0x07, 0x06, 0x00, 0x0F, 0x12, 0x34, 0xB4, 0xD8};
constexpr std::uint8_t read_past_last[]    = {0x07, 0x03, 0x00, 0x0F, 0x00, 0x02, 0xF4, 0x6E};
constexpr std::uint8_t no_such_address[]   = {0x07, 0x83, 0x02, 0x20, 0xF0};
constexpr std::uint8_t read_126[]          = {0x07, 0x03, 0x00, 0x00, 0x00, 0x7E, 0xC5, 0x8C};
constexpr std::uint8_t no_such_quantity[]  = {0x07, 0x83, 0x03, 0xE1, 0x30};
constexpr std::uint8_t other_server[]      = {0x08, 0x03, 0x00, 0x01, 0x00, 0x02, 0x95, 0x52};
constexpr std::uint8_t damaged[]           = {0x07, 0x03, 0x00, 0x01, 0x00, 0x03, 0x95, 0xAD};
constexpr std::uint8_t write_first_read_last[] = {0x07, 0x17, 0x00, 0x0F, 0x00, 0x01, 0x00, 0x00,
                                                  0x00, 0x01, 0x02, 0xAB, 0xCD, 0xD3, 0xFD};
#ifdef READ_WRITE
constexpr std::uint8_t to_write_and_read[] = {0x07, 0x17, 0x02, 0x12, 0x34, 0x38, 0xC3};
#else
constexpr std::uint8_t to_write_and_read[] = {0x07, 0x97, 0x01, 0x6F, 0xF1};
#endif

}  // namespace

int main()
{
    if (not answers(write_two, two_written)) { return 1; }
    if (not answers(read_two, two_read)) { return 2; }
    if (not answers(write_last, write_last)) { return 3; }
    if (not answers(read_past_last, no_such_address)) { return 4; }
    if (not answers(read_126, no_such_quantity)) { return 5; }
    if (not is_silent(other_server) or not is_silent(damaged)) { return 6; }
    return answers(write_first_read_last, to_write_and_read) ? 0 : 7;
}
