// A drive that answers, and what its master must make of that.
#include "fc_master.hpp"

namespace {

constexpr std::uint8_t start[]   = {0x02, 0x06, 0x87, 0x04, 0x7F, 0x20, 0x00, 0xD8};
constexpr std::uint8_t running[] = {0x02, 0x06, 0x87, 0x0F, 0x07, 0x1F, 0xF0, 0x64};
constexpr std::uint8_t foreign[] = {0x02, 0x06, 0x88, 0x0F, 0x07, 0x1F, 0xF0, 0x6B};
constexpr std::uint8_t damaged[] = {0x02, 0x06, 0x87, 0x0F, 0x07, 0x1F, 0xF1, 0x64};

constexpr std::uint8_t read_518[]         = {0x02, 0x0E, 0x87, 0x12, 0x06, 0x00, 0x00, 0x00,
                                             0x00, 0x00, 0x00, 0x04, 0x7F, 0x20, 0x00, 0xC4};
constexpr std::uint8_t word_of_518[]      = {0x02, 0x0E, 0x87, 0x12, 0x06, 0x00, 0x00, 0x00,
                                             0x00, 0x01, 0xF4, 0x0F, 0x07, 0x1F, 0xF0, 0x8D};
constexpr std::uint8_t two_words_of_518[] = {0x02, 0x0E, 0x87, 0x22, 0x06, 0x00, 0x00, 0x00,
                                             0x00, 0x01, 0xF4, 0x0F, 0x07, 0x1F, 0xF0, 0xBD};
constexpr std::uint8_t word_of_519[]      = {0x02, 0x0E, 0x87, 0x12, 0x07, 0x00, 0x00, 0x00,
                                             0x00, 0x01, 0xF4, 0x0F, 0x07, 0x1F, 0xF0, 0x8C};
constexpr std::uint8_t refusal[]          = {0x02, 0x0E, 0x87, 0x72, 0x06, 0x00, 0x00, 0x00,
                                             0x00, 0x00, 0x82, 0x0F, 0x07, 0x1F, 0xF0, 0x9A};

std::uint8_t const* answer        = nullptr;
std::size_t         answer_size   = 0;
std::uint8_t const* expected      = nullptr;
std::size_t         expected_size = 0;
bool                was_sent      = false;

template <std::size_t N, std::size_t M>
void expect(std::uint8_t const (&request)[N], std::uint8_t const (&reply)[M])
{
    expected      = request;
    expected_size = N;
    answer        = reply;
    answer_size   = M;
    was_sent      = false;
}

template <std::size_t N>
bool controls(std::uint8_t const (&reply)[N], drive_state* state)
{
    expect(start, reply);
    return control(0x047F, 0x2000, state) and was_sent;
}

template <std::size_t N>
bool reads(std::uint8_t const (&reply)[N], std::uint16_t* value)
{
    expect(read_518, reply);
    return read(0x047F, 0x2000, value) and was_sent;
}

}  // namespace

void transmit(std::uint8_t const* telegram, std::size_t size)
{
    was_sent = size == expected_size;
    for (std::size_t i = 0; i < size; ++i) { was_sent = was_sent and telegram[i] == expected[i]; }
}

std::size_t receive(std::uint8_t* reply)
{
    for (std::size_t i = 0; i < answer_size; ++i) { reply[i] = answer[i]; }
    return answer_size;
}

int main()
{
    drive_state state = {};
    if (not controls(running, &state)) { return 1; }
    if (state.status_word != 0x0F07 or state.output_frequency != 0x1FF0) { return 2; }
    if (controls(foreign, &state) or controls(damaged, &state) or controls(word_of_518, &state)) { return 3; }

    std::uint16_t value = 0;
    if (not reads(word_of_518, &value) or value != 500) { return 4; }
    if (reads(two_words_of_518, &value) or reads(word_of_519, &value) or reads(refusal, &value)) { return 5; }
    return reads(running, &value) ? 6 : 0;
}
