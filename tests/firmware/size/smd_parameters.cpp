#include "smd_parameters.hpp"

#include <drivecodec/drives/smd/parameters.hpp>
#include <drivecodec/modbus/rtu/adu.hpp>

using namespace drivecodec;
using namespace drivecodec::literals;
using smd::pv507;

constexpr auto acceleration = modbus::rtu::encode(5, smd::C12<pv507>.write(5.0_s));
constexpr auto mode         = modbus::rtu::encode(5, smd::C14<pv507>.write(smd::operating_mode{2}));
constexpr auto fault_time   = modbus::rtu::encode(5, smd::n23<pv507>.write(100_ms));

void send()
{
    transmit(acceleration.data(), acceleration.size());
    transmit(mode.data(), mode.size());
    transmit(fault_time.data(), fault_time.size());
}
