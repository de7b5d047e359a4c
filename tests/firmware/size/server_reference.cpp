#include "server.hpp"

// What the library does in server.cpp: it calls the functions below, which are its handler's. Called, and not there.
std::size_t library_serve(std::uint8_t const* request, std::size_t size, std::uint8_t* reply, std::size_t room);

std::uint16_t const* read_holding_registers(unsigned first, unsigned count)
{
    return exist(first, count) ? registers + first : nullptr;
}

int write_single_register(unsigned address, unsigned value)
{
    if (not exist(address, 1)) { return 2; }
    registers[address] = static_cast<std::uint16_t>(value);
    return 0;
}

int write_multiple_registers(unsigned first, unsigned count, std::uint8_t const* values)
{
    if (not exist(first, count)) { return 2; }
    for (unsigned i = 0; i < count; ++i) {
        registers[first + i] = static_cast<std::uint16_t>(values[2 * i] * 256U + values[2 * i + 1]);
    }
    return 0;
}

#ifdef READ_WRITE
std::uint16_t const* read_write_multiple_registers(unsigned to_read, unsigned read_count, unsigned to_write,
                                                   unsigned write_count, std::uint8_t const* values)
{
    if (not exist(to_read, read_count) or not exist(to_write, write_count)) { return nullptr; }
    for (unsigned i = 0; i < write_count; ++i) {
        registers[to_write + i] = static_cast<std::uint16_t>(values[2 * i] * 256U + values[2 * i + 1]);
    }
    return registers + to_read;
}
#endif

std::size_t serve(std::uint8_t const* request, std::size_t size)
{
    return library_serve(request, size, reply, sizeof reply);
}
