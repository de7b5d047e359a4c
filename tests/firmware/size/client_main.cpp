// A drive that answers, and what its client must make of that.
#include "client.hpp"

namespace {

constexpr std::uint8_t poll_request[] = {0x07, 0x03, 0x00, 0x6B, 0x00, 0x03, 0x74, 0x71};
constexpr std::uint8_t poll_reply[]   = {0x07, 0x03, 0x06, 0x02, 0x2B, 0x00, 0x00, 0x00, 0x64, 0x2E, 0xDA};
constexpr std::uint8_t set_request[]  = {0x07, 0x06, 0x12, 0x34, 0x56, 0x78, 0xF2, 0x98};
constexpr std::uint8_t refusal[]      = {0x07, 0x86, 0x02, 0x23, 0xA0};

std::uint8_t const* answer      = nullptr;
std::size_t         answer_size = 0;
std::uint8_t const* expected    = nullptr;
bool                was_sent    = false;

template <std::size_t N, std::size_t M>
void expect(std::uint8_t const (&request)[N], std::uint8_t const (&reply)[M])
{
    expected    = request;
    answer      = reply;
    answer_size = M;
    was_sent    = false;
}

}  // namespace

void transmit(std::uint8_t const* frame, std::size_t size)
{
    was_sent = size == 8;
    for (std::size_t i = 0; i < size; ++i) { was_sent = was_sent and frame[i] == expected[i]; }
}

std::size_t receive(std::uint8_t* reply)
{
    for (std::size_t i = 0; i < answer_size; ++i) { reply[i] = answer[i]; }
    return answer_size;
}

int main()
{
    std::uint16_t values[polled_count] = {};

    expect(poll_request, poll_reply);
    if (not poll(values) or not was_sent) { return 1; }
    if (values[0] != 0x022B or values[1] != 0 or values[2] != 0x0064) { return 2; }

    expect(set_request, set_request);
    if (not set(0x1234, 0x5678) or not was_sent) { return 3; }
    expect(set_request, refusal);
    if (set(0x1234, 0x5678)) { return 4; }
    expect(set_request, poll_reply);
    return set(0x1234, 0x5678) ? 5 : 0;
}
