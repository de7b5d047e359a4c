#include "server.hpp"

#include <drivecodec/modbus.hpp>

namespace modbus = drivecodec::modbus;
namespace rtu    = drivecodec::modbus::rtu;

namespace {

constexpr auto no_such_register = modbus::exception_code::illegal_data_address;

struct holding_registers {
    using functions = modbus::function_set<modbus::read_holding_registers, modbus::write_single_register,
#ifdef READ_WRITE
                                           modbus::read_write_multiple_registers,
#endif
                                           modbus::write_multiple_registers>;

    modbus::answer<modbus::register_view> operator()(modbus::read_holding_registers::request const& asked) const
    {
        if (not exist(asked.range.first(), asked.range.count())) { return no_such_register; }
        return modbus::register_view{std::span{registers + asked.range.first(), asked.range.count()}};
    }

    modbus::answer<modbus::done> operator()(modbus::write_single_register::request const& asked) const
    {
        if (not exist(asked.address, 1)) { return no_such_register; }
        registers[asked.address] = asked.value;
        return modbus::done{};
    }

    modbus::answer<modbus::done> operator()(modbus::write_multiple_registers::request const& asked) const
    {
        if (not exist(asked.block.first(), asked.block.count())) { return no_such_register; }
        asked.block.values().copy_to({registers + asked.block.first(), asked.block.count()});
        return modbus::done{};
    }

#ifdef READ_WRITE
    modbus::answer<modbus::register_view> operator()(modbus::read_write_multiple_registers::request const& asked) const
    {
        auto const& to_read  = asked.read_range;
        auto const& to_write = asked.write_block;
        if (not exist(to_read.first(), to_read.count()) or not exist(to_write.first(), to_write.count())) {
            return no_such_register;
        }
        to_write.values().copy_to({registers + to_write.first(), to_write.count()});
        return modbus::register_view{std::span{registers + to_read.first(), to_read.count()}};
    }
#endif
};

}  // namespace

std::size_t serve(std::uint8_t const* request, std::size_t size)
{
    return rtu::serve(7, {request, size}, reply, holding_registers{}).size();
}
