#!/usr/bin/python3
"""mbpoll and pymodbus drive our xD1000 simulator over a pseudo-terminal.

xd1000_peer.py PATH/TO/xd1000_simulator PATH/TO/xd1000_control
"""
import re
import signal
import sys
import time

import pymodbus.client
import pymodbus.mei_message

import support

ADDRESS = 2
ETA, TIME_OUT, CMD, LFRD, RFRD, ACC = 3201, 6005, 8501, 8602, 8604, 9001
FIRST_INPUT, FIRST_OUTPUT = 12741, 12761
STATE = 0x6F
SWITCH_ON_DISABLED, READY, SWITCHED_ON, OPERATION_ENABLED, QUICK_STOP_ACTIVE = 0x40, 0x21, 0x23, 0x27, 0x07


class Mbpoll:
    """A person at a keyboard."""

    def __init__(self, line):
        self.line = line

    def run(self, *options, values=()):
        return support.run("mbpoll", "-m", "rtu", "-P", "none", "-a", str(ADDRESS), "-0", "-1", "-o", "1", "-t", "4",
                           *options, self.line, "--", *map(str, values))

    def read(self, register):
        _, printed = self.run("-r", str(register))
        found = re.search(r"^\[\d+\]:\s+(\d+)", printed, re.MULTILINE)
        return int(found.group(1)) if found else printed

    def write(self, register, value):
        status, _ = self.run("-r", str(register), values=[value])
        return status


def by_hand(line, simulator, checks):
    """6, 7, F, a speed, a fault, its reset."""
    drive = Mbpoll(line)

    def state():
        return drive.read(ETA) & STATE

    checks.equal("state after power-on", state(), SWITCH_ON_DISABLED)
    checks.equal("ACC", drive.write(ACC, 1), 0)
    checks.equal("LFRD", drive.write(LFRD, 1500), 0)
    for word, wanted in ((0x06, READY), (0x07, SWITCHED_ON), (0x0F, OPERATION_ENABLED)):
        checks.equal(f"write {word:04X}", drive.write(CMD, word), 0)
        checks.equal(f"state after {word:04X}", state(), wanted)
    support.wait_for(lambda: drive.read(RFRD) == 1500, "50 Hz")
    checks.equal("reference reached, remote", drive.read(ETA) & 0x0600, 0x0600)

    checks.equal("ETA is read-only", drive.write(ETA, 0) != 0, True)
    checks.equal("no such register", drive.write(5000, 0) != 0, True)
    checks.equal("no such address of a drive", drive.write(6001, 248) != 0, True)

    simulator.send_signal(signal.SIGUSR1)
    support.wait_for(lambda: drive.read(ETA) & 0x4F == 0x08, "the fault")
    drive.write(CMD, 0x80)
    checks.equal("reset by an edge", state(), SWITCH_ON_DISABLED)
    simulator.send_signal(signal.SIGUSR1)
    support.wait_for(lambda: drive.read(ETA) & 0x4F == 0x08, "the next fault")
    drive.write(CMD, 0x80)
    checks.equal("no edge, no reset", drive.read(ETA) & 0x4F, 0x08)
    drive.write(CMD, 0x00)
    drive.write(CMD, 0x80)
    checks.equal("an edge again", state(), SWITCH_ON_DISABLED)
    drive.write(CMD, 0x00)

    # Silence for longer than register 6005 says trips the drive; then the time-out as delivered, and its reset.
    checks.equal("time-out of 0.5 s", drive.write(TIME_OUT, 5), 0)
    time.sleep(1)
    checks.equal("tripped", drive.read(ETA) & 0x4F, 0x08)
    drive.write(TIME_OUT, 100)
    drive.write(CMD, 0x80)
    drive.write(CMD, 0x00)
    checks.equal("reset", state(), SWITCH_ON_DISABLED)

    # Quick stop: the motor is stopped, and only Switch on disabled leads on.
    for word in (0x06, 0x07, 0x0F):
        drive.write(CMD, word)
    support.wait_for(lambda: drive.read(RFRD) > 300, "some speed")
    drive.write(CMD, 0x010F)
    support.wait_for(lambda: drive.read(RFRD) == 0, "the halt")
    checks.equal("halted in Operation enabled", state(), OPERATION_ENABLED)
    drive.write(CMD, 0x0002)
    checks.equal("quick stop active", state(), QUICK_STOP_ACTIVE)
    drive.write(CMD, 0x000F)
    checks.equal("no way back from there", state(), QUICK_STOP_ACTIVE)
    drive.write(CMD, 0x0000)
    checks.equal("but down", state(), SWITCH_ON_DISABLED)


def by_scanner(line, checks):
    """Function 23, and who the drive is."""
    client = pymodbus.client.ModbusSerialClient(port=line, baudrate=19200, timeout=2)
    checks.equal("connected", client.connect(), True)
    try:
        for word, wanted in ((0x06, READY), (0x07, SWITCHED_ON), (0x0F, OPERATION_ENABLED), (0x00, SWITCH_ON_DISABLED)):
            reply = client.readwrite_registers(read_address=FIRST_INPUT, read_count=2, write_address=FIRST_OUTPUT,
                                               write_registers=[word, 300], unit=ADDRESS)
            checks.equal(f"23 with {word:04X}", reply.isError(), False)
            checks.equal("state in its answer", reply.registers[0] & STATE, wanted)
            time.sleep(0.05)
        too_many = client.readwrite_registers(read_address=FIRST_INPUT, read_count=5, write_address=FIRST_OUTPUT,
                                              write_registers=[0], unit=ADDRESS)
        checks.equal("five words", too_many.isError(), True)

        request = pymodbus.mei_message.ReadDeviceInformationRequest(read_code=1, object_id=0, unit=ADDRESS)
        identity = client.execute(request)
        checks.equal("identification", identity.information, {0: b"Lauritz Knudsen Electrical & Automation",
                                                              1: b"xD1000H037N4", 2: b"0201"})
    finally:
        client.close()


def by_our_controller(line, control_program, checks):
    """From standstill to 50 Hz and back."""
    def control(*command):
        return support.run(control_program, "--device", line, "--address", str(ADDRESS), *command)

    status, printed = control("start", "50.0")
    checks.equal(f"start: {printed}", status, 0)
    support.wait_for(lambda: "1500 rpm" in control("status")[1], "50 Hz")
    checks.equal("stop", control("stop")[0], 0)
    checks.contains("stopped", control("status")[1], "switch_on_disabled")
    checks.equal("wrong usage", control("start")[0], 2)


def main():
    simulator_program, control_program = sys.argv[1:3]
    checks = support.Checks()
    with support.server_on_a_line(simulator_program, "--address", str(ADDRESS)) as (simulator, line):
        by_hand(line, simulator, checks)
        by_scanner(line, checks)
        by_our_controller(line, control_program, checks)
        support.stop(simulator, checks)
    sys.exit(checks.exit_status())


if __name__ == "__main__":
    main()
