#include "fc_master.hpp"

// What the library does in fc_master.cpp. Called, and not there.
void encode_process(std::uint8_t* telegram, std::uint16_t control_word, std::uint16_t reference);
void encode_read(std::uint8_t* telegram, std::uint16_t control_word, std::uint16_t reference);
bool check_process(std::uint8_t const* reply, std::size_t size, drive_state* state);
bool check_read(std::uint8_t const* reply, std::size_t size, std::uint16_t* value);

bool control(std::uint16_t control_word, std::uint16_t reference, drive_state* state)
{
    std::uint8_t reply[longest_reply];
    std::uint8_t telegram[8];
    encode_process(telegram, control_word, reference);
    transmit(telegram, sizeof telegram);
    return check_process(reply, receive(reply), state);
}

bool read(std::uint16_t control_word, std::uint16_t reference, std::uint16_t* value)
{
    std::uint8_t reply[longest_reply];
    std::uint8_t telegram[16];
    encode_read(telegram, control_word, reference);
    transmit(telegram, sizeof telegram);
    return check_read(reply, receive(reply), value);
}
