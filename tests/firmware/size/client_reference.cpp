#include "client.hpp"

// What the library does in client.cpp. Called, and not there.
extern std::uint8_t const question_frame[8];
void                      encode_set(std::uint8_t* frame, std::uint16_t address, std::uint16_t value);
bool                      check_poll(std::uint8_t const* reply, std::size_t size, std::uint16_t* values);
bool check_set(std::uint8_t const* reply, std::size_t size, std::uint16_t address, std::uint16_t value);

bool poll(std::uint16_t* values)
{
    std::uint8_t reply[longest_reply];
    transmit(question_frame, sizeof question_frame);
    return check_poll(reply, receive(reply), values);
}

bool set(std::uint16_t address, std::uint16_t value)
{
    std::uint8_t reply[longest_reply];
    std::uint8_t frame[8];
    encode_set(frame, address, value);
    transmit(frame, sizeof frame);
    return check_set(reply, receive(reply), address, value);
}
