#pragma once

#include <drivecodec/drives/smd/controller.hpp>
#include <drivecodec/drives/smd/watchdog.hpp>

/// A drive without ramps, as much of it as a controller sees.
class small_drive {
public:
    using status_block = drivecodec::smd::status_block;

    drivecodec::smd::locks        locks{drivecodec::smd::control_mode::c40_modbus, 0};
    drivecodec::smd::watchdog     watchdog{};
    drivecodec::smd::control_mode c01           = drivecodec::smd::control_mode::c40_modbus;
    drivecodec::smd::fault        fault         = drivecodec::smd::fault::no_fault;
    bool                          terminal_28   = true;
    bool                          inhibited     = false;  // by a time-out, until the next start
    bool                          deaf_to_start = false;
    bool                          is_running    = false;
    bool                          is_reverse    = false;
    bool                          is_serial     = false;
    std::uint16_t                 speed         = 0;
    unsigned                      starts        = 0;   // that set the motor going
    bool                          was_set_up = false;  // reference, speed and direction written since it was unlocked
    unsigned                      writes_of_setup = 0;

    /// 0 if it did it, else the exception.
    unsigned receive(drivecodec::modbus::write_single_register::request wanted)
    {
        watchdog.heard();
        if (wanted.address != 1 and wanted.address != 40 and wanted.address != 48) { return 2; }
        if (not locks.write(wanted.address, wanted.value)) { return 1; }
        if (wanted.address == 48) { writes_of_setup = 0; }
        if (wanted.address == 40) {
            if (wanted.value > 500) { return 3; }
            speed = wanted.value;
            writes_of_setup |= 1U;
        }
        if (wanted.address != 1) { return 0; }
        switch (wanted.value) {
        case 0x0002: break;
        case 0x0004: is_running = false; break;
        case 0x0008:
            if (deaf_to_start) { break; }
            inhibited = false;
            if (terminal_28 and fault == drivecodec::smd::fault::no_fault and not is_running) {
                is_running = true;
                was_set_up = writes_of_setup == 7U;
                ++starts;
            }
            break;
        case 0x0040:
        case 0x0080:
            is_reverse = wanted.value == 0x0040;
            writes_of_setup |= 2U;
            break;
        case 0x0100:
            is_serial = true;
            writes_of_setup |= 4U;
            break;
        default: return 4;
        }
        return 0;
    }

    [[nodiscard]] status_block poll()
    {
        using namespace drivecodec::smd;
        watchdog.heard();
        status_block status{};
        status.operational_status  = fault != drivecodec::smd::fault::no_fault ? operational_status::fault
                                     : is_running                              ? operational_status::run
                                     : inhibited or not terminal_28            ? operational_status::inhibit
                                                                               : operational_status::stop;
        status.control_mode        = c01;
        status.fault               = fault;
        status.speed_reference     = is_serial ? speed_reference::serial : speed_reference::local;
        status.command_speed       = {speed, -1};
        status.commanded_direction = is_reverse ? direction::reverse : direction::forward;
        return status;
    }

    void pass(std::uint32_t microseconds)
    {
        using enum drivecodec::smd::time_out_reaction;
        switch (watchdog.pass(microseconds, locks)) {
        case lock_and_inhibit: inhibited = true; [[fallthrough]];
        case lock_and_stop: is_running = false; break;
        case lock_and_trip:
            is_running = false;
            fault      = drivecodec::smd::fault::communication_fault;
            break;
        default: break;
        }
    }
    void set_c01(drivecodec::smd::control_mode mode)
    {
        c01 = mode;
        locks.set_control_mode(mode);
        if (not modbus_controls(mode)) { is_running = false; }
    }
    void open_terminal_28()
    {
        terminal_28 = false;
        is_running  = false;
    }
    void power_cycle()
    {
        locks.lock();
        is_running = is_reverse = is_serial = inhibited = false;
    }
};
