#include "fc_slave.hpp"

// What the library does in fc_slave.cpp: it calls the functions below, which are its handler's. Called, and not there.
std::size_t library_serve(std::uint8_t const* request, std::size_t size, std::uint8_t* reply, std::size_t room);

std::uint32_t process(unsigned control, unsigned wanted)
{
    if ((control & data_valid) != 0) {
        control_word = static_cast<std::uint16_t>(control);
        reference    = static_cast<std::uint16_t>(wanted);
    }
    return std::uint32_t{output_frequency} << 16 | status_word;
}

/// The reply's AK; the value or the error number goes to `pwe`.
unsigned parameter_command(unsigned command, unsigned number, std::uint32_t* pwe)
{
    if (not exists(number)) {
        *pwe = 0;
        return 7;
    }
    auto& parameter = parameters[number - first_parameter];
    switch (command) {
    case 1: break;
    case 2:
    case 14: parameter = static_cast<std::uint16_t>(*pwe); break;
    default: *pwe = 5; return 7;
    }
    *pwe = parameter;
    return 1;
}

std::size_t serve(std::uint8_t const* request, std::size_t size)
{
    return library_serve(request, size, reply, sizeof reply);
}
