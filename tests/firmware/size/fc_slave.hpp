#pragma once

#include <cstddef>
#include <cstdint>

// An application that is a drive with three parameters. Written twice: fc_slave.cpp with the library,
// fc_slave_reference.cpp without. fc_slave_main.cpp is the world around both.

constexpr unsigned    first_parameter = 201;
constexpr unsigned    parameter_count = 3;
constexpr std::size_t longest_reply   = 16;

/// Returns the size of the reply; 0 if there is none.
std::size_t serve(std::uint8_t const* request, std::size_t size);

inline std::uint16_t parameters[parameter_count];
inline std::uint8_t  reply[longest_reply];

inline std::uint16_t control_word;
inline std::uint16_t reference;
inline std::uint16_t status_word;
inline std::uint16_t output_frequency;

constexpr std::uint16_t data_valid = 0x0400;

inline bool exists(unsigned number)
{
    return number - first_parameter < parameter_count;
}
