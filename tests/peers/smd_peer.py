#!/usr/bin/python3
"""mbpoll drives our smd simulator as section 7 of the smd manual says, then our own control program does.

smd_peer.py PATH/TO/smd_simulator PATH/TO/smd_control
"""
import re
import signal
import subprocess
import sys
import time

import support

ADDRESS = "5"
# 4xxxx, as the manual writes them.
CONTROL, STATUS, OPERATIONAL_STATUS, SPEED, UNLOCK, UNLOCK_PARAMETERS = 40002, 40025, 40027, 40041, 40049, 40050
C12, C13 = 40062, 40063
STOP_COMMAND, START, REVERSE, FORWARD, SERIAL_REFERENCE, LOCK = 0x0004, 0x0008, 0x0040, 0x0080, 0x0100, 0x0002
FAULT, OFF, RUN, ACCEL, INHIBIT = 1, 12, 6, 7, 13


class Mbpoll:
    """A person at a keyboard. mbpoll counts registers from 1, as 4xxxx does: 40049 is its 49."""

    def __init__(self, line):
        self.line = line

    def run(self, reference, *options, values=()):
        return support.run("mbpoll", "-m", "rtu", "-b", "9600", "-P", "none", "-s", "2", "-a", ADDRESS, "-1",
                           "-o", "1", *options, "-r", str(reference % 10000), self.line, "--", *map(str, values))

    def read(self, reference, count=1, kind="4"):
        _, printed = self.run(reference, "-t", kind, "-c", str(count))
        found = [int(value) for value in re.findall(r"^\[\d+\]:\s+(\d+)", printed, re.MULTILINE)]
        return found if len(found) == count else printed

    def operational_status(self):
        return self.read(OPERATIONAL_STATUS)[0] & 0xFF

    def write(self, reference, value):
        """What it says when it fails; mbpoll writes one register with function 06."""
        status, printed = self.run(reference, "-t", "4", values=[value])
        return "" if status == 0 else printed


def quick_start(line, simulator, checks):
    """Section 7, step by step."""
    drive = Mbpoll(line)
    checks.contains("a write to a locked drive", drive.write(CONTROL, START), "Illegal function")
    checks.equal("unlock", drive.write(UNLOCK, 0), "")
    checks.equal("manual mode", drive.write(CONTROL, SERIAL_REFERENCE), "")
    checks.equal("ramps", drive.write(C12, 5) + drive.write(C13, 5), "")
    checks.equal("speed", drive.write(SPEED, 412), "")
    checks.equal("start", drive.write(CONTROL, START), "")
    support.wait_for(lambda: drive.operational_status() == RUN, "41.2 Hz")
    status = drive.read(STATUS, 6)
    checks.equal("status block", [*status[:2], status[2] & 0xFF, *status[3:]], [412, 412, RUN, 0x000B, 0x0600, 0x0000])
    checks.equal("by function 04", drive.read(STATUS, 6, "3"), status)

    checks.equal("reverse", drive.write(CONTROL, REVERSE), "")
    support.wait_for(lambda: drive.read(STATUS, 6)[3:] == [0x010B, 0x0600, 0x0001], "the other direction")
    support.wait_for(lambda: drive.operational_status() == RUN, "41.2 Hz in reverse")
    checks.equal("forward", drive.write(CONTROL, FORWARD), "")
    checks.contains("two commands", drive.write(CONTROL, START | REVERSE), "Slave device or server failure")
    checks.contains("too fast", drive.write(SPEED, 501), "Illegal data value")
    checks.contains("no such register", drive.write(40057, 1), "Illegal data address")
    checks.contains("seven registers", str(drive.read(STATUS, 7)), "Illegal data value")
    checks.contains("of which one is written", drive.run(C12, "-t", "4", values=[5, 5])[1], "Illegal data value")
    checks.equal("stop among others", drive.write(CONTROL, STOP_COMMAND | START), "")
    checks.equal("stopped", drive.operational_status(), OFF)

    checks.equal("start", drive.write(CONTROL, START), "")
    simulator.send_signal(signal.SIGUSR1)
    support.wait_for(lambda: drive.operational_status() == FAULT, "the fault")
    checks.equal("its number", drive.read(STATUS, 6)[5] >> 8, 5)
    simulator.send_signal(signal.SIGUSR2)
    support.wait_for(lambda: drive.operational_status() == OFF, "its reset by mains")
    checks.contains("which locks", drive.write(C12, 50), "Illegal function")
    checks.equal("unlock parameters", drive.write(UNLOCK_PARAMETERS, 0), "")
    checks.equal("a parameter", drive.write(C12, 50), "")
    checks.contains("not control", drive.write(CONTROL, START), "Illegal function")
    checks.equal("lock", drive.write(CONTROL, LOCK), "")
    checks.contains("locked", drive.write(C12, 5), "Illegal function")


def our_control(simulator_program, program, checks):
    """Every command, its words and exit status."""
    with support.server_on_a_line(simulator_program, "--address", ADDRESS, "--password", "7",
                                  stdin=subprocess.PIPE) as (simulator, path):
        def control(*command):
            return support.run(program, "--device", path, "--address", ADDRESS, *command)

        def expect(wanted_status, wanted, *command):
            status, printed = control(*command)
            checks.equal(f"{command} ends: {printed}", status, wanted_status)
            checks.contains(f"{command}", printed, wanted)

        def type_line(line):
            simulator.stdin.write(line + "\n")
            simulator.stdin.flush()
            time.sleep(0.05)

        ours = ("--password", "7")
        expect(0, 'version 507, software "SMD 2.01"', "status")
        expect(0, "C12 acceleration_time 5.0 s", "get", "C12")
        expect(0, "C12 acceleration_time 5.0 s", "get", "acceleration_time")
        expect(0, "c01 accel_rate_2 5.0 s", "get", "c01")
        expect(1, "the drive is locked", "set", "C12", "0.5")
        expect(1, "not unlocked with this --password", "unlock", "--password", "8")
        expect(0, "unlocked", "unlock")  # 0: control only
        expect(1, "the drive is locked", "set", "C12", "0.5")
        expect(0, "unlocked", "unlock", *ours)
        expect(0, "C12 acceleration_time 0.5 s", "set", "C12", "0.5")
        expect(0, "C13 deceleration_time 0.5 s", "set", "C13", "0.5")
        for words, what in ((("C12", "1000"), "C12 takes 0.0 s to 999.0 s"), (("C12", "0.55"), "so many digits"),
                            (("C50", "1"), "can only be read"), (("C99", "1"), "can only be read"),
                            (("x", "1"), "no register 'x'"), (("C12", "fast"), "not a number")):
            expect(2, what, "set", *words)
        for words in (("start",), ("start", "41.25"), ("start", "-1"), ("start", "241"), ("stop", "now"), ("go",),
                      ("--address", "0", "status"), ("--password", "1000", "status")):
            checks.equal(f"{words}", control(*words)[0], 2)

        expect(0, "command 41.2 Hz forward", "start", "41.2")
        support.wait_for(lambda: "run 41.2 Hz forward" in control("status")[1], "41.2 Hz")
        expect(0, "reverse", "reverse")
        support.wait_for(lambda: "run 41.2 Hz reverse" in control("status")[1], "41.2 Hz in reverse")
        expect(0, "command 41.2 Hz forward", "forward")
        expect(0, "off 0.0 Hz", "stop")
        expect(1, "between C10 and C11", "start", "60")
        expect(0, "locked", "lock")
        expect(0, "locked already", "lock")
        expect(0, "off 0.0 Hz", "stop")
        expect(1, "the drive is locked", "reverse")
        expect(1, "is it this --password", "start", "10", "--password", "8")

        type_line("28")
        expect(1, "terminal 28 is open", "start", "10")
        type_line("28")
        type_line("f 25")
        expect(1, "earth_fault 25 OC2", "start", "10")
        type_line("p")
        type_line("b")
        expect(1, "busy", "start", "10")
        type_line("b")

        # A time-out of 0.6 s, and what keeps it from happening.
        control("unlock", *ours)
        expect(0, "0.600 s", "set", "n23", "0.6")
        expect(0, "controller_inhibit", "set", "n22", "1")
        expect(0, "command 10.0 Hz", "start", "10", *ours)
        with support.running([program, "--device", path, "--address", ADDRESS, "watch"], stdout=subprocess.PIPE,
                             text=True) as watch:
            # Alone on the line: a second master would collide with it.
            checks.contains("watch", watch.stdout.readline(), "command 10.0 Hz")
            time.sleep(1.5)
            watch.send_signal(signal.SIGINT)
            seen = watch.communicate(timeout=support.DEADLINE)[0].splitlines()
            checks.contains("kept alive", seen[-1] if seen else "nothing", "run 10.0 Hz")
            checks.equal("watch ends", watch.returncode, 0)
        time.sleep(0.8)
        expect(0, "inhibit 0.0 Hz", "status")
        expect(0, "command 10.0 Hz", "start", "10", *ours)
        support.stop(simulator, checks)

    with support.server_on_a_line(simulator_program, "--control-mode", "9") as (_, path):
        for command, what in ((("start", "10"), "C01 is neither 10 nor 11"), (("unlock",), "parameters unlocked")):
            checks.contains(f"{command}", support.run(program, "--device", path, *command)[1], what)
    with support.server_on_a_line(simulator_program, "--version", "pv400") as (_, path):
        checks.contains("pv400", support.run(program, "--device", path, "status")[1], '400, software "SMD 1.51"')
        checks.contains("it lacks C31", support.run(program, "--device", path, "get", "C31")[1], "no register 'C31'")
    with support.server_on_a_line(simulator_program, "--control-mode", "7") as (_, path):
        _, printed = support.run(program, "--device", path, "--timeout", "50", "status")
        checks.contains("no Modbus", printed, "no answer")


def unknown_version(program, checks):
    """A drive of version 600 is not written to, whatever the command."""
    ask = support.with_crc(b"\x05\x03\x00\x32\x00\x01")
    for command in (("start", "10"), ("stop",), ("reverse",), ("forward",), ("lock",), ("unlock",),
                    ("set", "C12", "5"), ("get", "C12")):
        heard = []
        with support.asking(program, "--address", ADDRESS, "--timeout", "300", *command) as (process, line):
            while request := line.receive(8, 0.4):
                heard.append(request)
                line.send(support.with_crc(b"\x05\x03\x02\x02\x58" if request == ask else b"\x05\x03\x0c" + bytes(6)
                                   + b"\x00\x0b" + bytes(4)))
            status, printed = support.finish(process)
        checks.equal(f"{command} of version 600", status, 1)
        checks.contains(f"{command}", printed, "register 50 says version 600")
        checks.equal(f"{command} writes", [request for request in heard if request[1] != 3], [])


def bad_line(simulator_program, program, checks):
    """A line that loses, doubles and damages frames: every command succeeds, or says what went wrong."""
    succeeded = 0
    commands = [(("get", "C12"), "C12 acceleration_time 5.0 s\n"),
                (("set", "C37", "21.0"), "C37 fixed_setpoint_1 21.0"),
                (("start", "10"), ""), (("stop",), "off 0.0 Hz")]
    with support.null_modem(support.losses()) as (near, far), \
            support.running([simulator_program, "--device", far], stdout=subprocess.DEVNULL):
        time.sleep(0.2)
        for command, wanted in [(("start", "10"), "")] + 6 * commands:
            status, printed = support.run(program, "--device", near, "--timeout", "60", *command)
            if status == 0:
                succeeded += 1
                checks.contains(f"{command}", printed, wanted)
            else:
                says_why = "no answer" in printed or "the drive is locked" in printed
                checks.equal(f"{command}: {printed}", (status, says_why), (1, True))
    checks.equal(f"{succeeded} of 25 succeeded, which is many of them", succeeded > 8, True)


def main():
    simulator_program, control_program = sys.argv[1:3]
    checks = support.Checks()
    with support.server_on_a_line(simulator_program, "--address", ADDRESS) as (simulator, line):
        quick_start(line, simulator, checks)
        support.stop(simulator, checks)
    our_control(simulator_program, control_program, checks)
    unknown_version(control_program, checks)
    bad_line(simulator_program, control_program, checks)
    sys.exit(checks.exit_status())


if __name__ == "__main__":
    main()
