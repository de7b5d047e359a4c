#include "fc_master.hpp"

#include <drivecodec/fc.hpp>

namespace fc = drivecodec::fc;

namespace {

constexpr auto drive = fc::address::long_format(7);

}  // namespace

bool control(std::uint16_t control_word, std::uint16_t reference, drive_state* state)
{
    std::uint8_t reply[longest_reply];
    auto const   command  = fc::data_valid(control_word, fc::reference::from_raw(reference));
    auto const   telegram = fc::encode(drive, command);
    transmit(telegram.data(), telegram.size());
    auto response = fc::check(drive, command, {reply, receive(reply)});
    if (not response) { return false; }
    *state = {response->status_word(), response->output_frequency().raw()};
    return true;
}

bool read(std::uint16_t control_word, std::uint16_t reference, std::uint16_t* value)
{
    std::uint8_t reply[longest_reply];
    auto const   command  = fc::data_valid(control_word, fc::reference::from_raw(reference));
    auto const   request  = fc::read_value(parameter, command);
    auto const   telegram = fc::encode(drive, request);
    transmit(telegram.data(), telegram.size());
    auto response = fc::check(drive, request, {reply, receive(reply)});
    if (not response) { return false; }
    auto word = response->value<std::uint16_t>();
    if (not word) { return false; }
    *value = *word;
    return true;
}
