// EXPECT: algorithm
#include <drivecodec/modbus/functions.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec::modbus;

struct my_crc {
#ifdef OK
    static constexpr std::uint16_t update(std::uint16_t crc, drivecodec::bytes) noexcept { return crc; }
#else
    static constexpr std::uint16_t update(std::uint16_t crc) noexcept { return crc; }
#endif
};

constexpr auto frame = rtu::encode<my_crc>(1, write_single_register::request{.address = 1, .value = 2});
