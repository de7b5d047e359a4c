#!/usr/bin/python3
"""An FC master and an FC slave of this script's own, from the VLT 6000 manual, at the other end of our programs.

vlt6000_peer.py PATH/TO/vlt6000_simulator PATH/TO/vlt6000_control
"""
import functools
import operator
import os
import signal
import subprocess
import sys
import time

import support
from support import DEADLINE

SHORT, LONG = 0x01, 0x81  # address 1 in both formats
READY, RUNNING, TRIPPED, SPEED_EQUALS_REFERENCE = 0x0001, 0x0800, 0x0008, 0x0100
STOP, START, RESET, JOG = 0x043C, 0x047C, 0x0080, 0x0100
NO_DC_BRAKE, NO_COASTING, NO_QUICK_STOP, NO_FREEZE = 0x0004, 0x0008, 0x0010, 0x0020


def telegram(adr, data):
    front = bytes([0x02, len(data) + 2, adr]) + data
    return front + bytes([functools.reduce(operator.xor, front, 0)])


def words(*numbers):
    return b"".join((number & 0xFFFF).to_bytes(2, "big") for number in numbers)


def parameter(pke, ind=0, value=0, word=0, reference=0):
    return words(pke, ind, value >> 16, value, word, reference)


class Drive:
    """What one may ask the simulator; a telegram that is asked with no word leaves the motor alone."""

    def __init__(self, line, checks):
        self.line = line
        self.checks = checks

    def ask(self, data, adr=SHORT):
        """The data of the reply; they have to come in the telegram of that address."""
        self.line.send(telegram(adr, data))
        front = self.line.receive(2)
        if len(front) < 2:
            self.checks.equal(f"reply to {data.hex()}", front, "two bytes and more")
            return bytes(12)
        rest = self.line.receive(front[1])
        self.checks.equal(f"telegram with {data.hex()}", front + rest, telegram(adr, rest[1:-1]))
        return rest[1:-1]

    def is_silent(self, what, raw):
        self.line.send(raw)
        self.checks.equal(what, self.line.receive(1, 0.15), b"")

    def send(self, word=0, reference=0):
        """Status word and output frequency."""
        data = self.ask(words(word, reference))
        return int.from_bytes(data[:2], "big"), int.from_bytes(data[2:], "big", signed=True)

    def read(self, number, ind=0):
        data = self.ask(parameter(0x1000 | number, ind))
        return int.from_bytes(data[4:8], "big")

    def write(self, number, value, eeprom=False):
        reply = self.ask(parameter((0xE000 if eeprom else 0x2000) | number, 0, value))[:8]
        self.checks.equal(f"write {number}", reply, words(0x1000 | number, 0, 0, value))

    def refuses(self, error, request):
        number = int.from_bytes(request[:2], "big") & 0x07FF
        ind = int.from_bytes(request[2:4], "big")
        self.checks.equal(f"error {error} of {number}", self.ask(request)[:8], words(0x7000 | number, ind, 0, error))

    def keep_sending(self, word, reference, until):
        """As a master does; gives the last answer."""
        end = time.monotonic() + DEADLINE
        while True:
            status, frequency = self.send(word, reference)
            if until(status, frequency) or time.monotonic() > end:
                self.checks.equal(f"what {word:04X} {reference:04X} leads to", bool(until(status, frequency)), True)
                return status, frequency
            time.sleep(0.02)

    def run_at(self, reference):
        self.keep_sending(START, reference, lambda status, at: at == reference and status & SPEED_EQUALS_REFERENCE)

    def be_quick(self):
        """1 s from 0 Hz to 1000 Hz, in RAM."""
        for number, value in ((104, 1000), (206, 1), (207, 1)):
            self.write(number, value)

    def stop(self):
        self.keep_sending(STOP, 0, lambda status, at: at == 0 and not status & RUNNING)


def examples_of_the_manual(drive, checks):
    """Byte for byte; what the manual leaves out, the process words, is 0 and the status of a drive that stands by."""
    def expect(what, asked, wanted):
        checks.equal(what, drive.ask(bytes.fromhex(asked + "0000 0000")), bytes.fromhex(wanted + "0607 0000"))

    expect("write 202 = 100 Hz", "E0CA 0000 0000 03E8", "10CA 0000 0000 03E8")
    expect("read 206", "10CE 0000 0000 0000", "10CE 0000 0000 000A")
    expect("write 415 = [20]", "E19F 0000 0000 0014", "119F 0000 0000 0014")
    expect("read 615, index 1", "1267 0001 0000 0000", "1267 0001 0000 0000")
    expect("nothing", "0000 0000 0000 0000", "0000 0000 0000 0000")
    drive.line.send(bytes.fromhex("02 06 01 00 00 00 00 05"))
    checks.equal("a whole telegram", drive.line.receive(8), bytes.fromhex("02 06 01 06 07 00 00 04"))
    drive.write(202, 500, eeprom=True)


def addresses(drive, checks):
    drive.ask(words(0, 0), LONG)
    read = parameter(0x10CA)
    for adr in (0x02, 0x1F, 0x82, 0xFE, 0x00, 0x40, 0xFF):
        drive.is_silent(f"address {adr:02X}", telegram(adr, read))
    for adr, value in ((0x20, 11), (0x3F, 12), (0x80, 13)):
        drive.is_silent(f"broadcast {adr:02X}", telegram(adr, parameter(0x20CF, 0, value)))
        checks.equal(f"what {adr:02X} wrote", drive.read(207), value)

    whole = telegram(SHORT, parameter(0x20CF, 0, 99))
    drive.is_silent("a wrong BCC", whole[:-1] + bytes([whole[-1] ^ 1]))
    drive.is_silent("a telegram cut short", whole[:9])
    drive.is_silent("six bytes of data", telegram(SHORT, bytes(6)))
    drive.is_silent("noise in front", b"\x55\x02" + whole)
    for bit in range(8 * len(whole)):
        damaged = bytearray(whole)
        damaged[bit // 8] ^= 1 << bit % 8
        drive.line.send(damaged)
        time.sleep(0.006)
    checks.equal("one wrong bit, of all", (drive.line.receive(1, 0.15), drive.read(207)), (b"", 13))


def refusals(drive, checks):
    drive.refuses(0, parameter(0x112C))
    drive.refuses(1, parameter(0x2200, 0, 1))
    drive.refuses(2, parameter(0xE0CA, 0, 1201))
    drive.refuses(3, parameter(0x1267, 11))
    drive.refuses(3, parameter(0x1267, 0))
    drive.refuses(4, parameter(0x10CA, 1))
    drive.refuses(5, parameter(0xD0CA, 0, 1000))
    drive.refuses(5, parameter(0x40CA))
    drive.refuses(130, parameter(0x21F5, 0, 5))
    drive.run_at(0x1000)
    drive.refuses(17, parameter(0x21F4, 0, 1))
    drive.stop()
    drive.write(2, 0)
    drive.refuses(131, parameter(0x20CE, 0, 5))
    drive.write(2, 1)

    def text(pke, ind, characters):
        data = drive.ask(words(pke, ind) + characters + words(0, 0))
        return data[:-4]

    checks.equal("read 621", text(0xF26D, 0x0400, bytes(4)), words(0xF26D, 0x0400) + b"VLT 6006 HVAC")
    checks.equal("write 533", text(0xF215, 0x0500, b"HELLO"), words(0xF215, 0x0500) + b"HELLO")
    checks.equal("read 533", text(0xF215, 0x0400, bytes(4)), words(0xF215, 0x0400) + b"HELLO")
    checks.equal("nine characters", text(0xF215, 0x0500, b"NINECHARS"), words(0x7215, 0x0500, 0, 2))
    checks.equal("write 621", text(0xF26D, 0x0500, b"NO"), words(0x726D, 0x0500, 0, 1))


def words_of_control(drive, checks):
    checks.equal("without data valid", drive.send(0x007C, 0x2000)[0] & RUNNING, 0)
    drive.run_at(0x2000)
    checks.equal("the example of a running drive", drive.send(START, 0x2000), (0x0F03, 0x2000))
    checks.equal("live read-outs", [drive.read(number) for number in (512, 527, 530)], [250, 0x0F03, START])
    checks.equal("coasting", drive.send(START & ~NO_COASTING, 0x2000), (0x0603, 0))
    drive.run_at(-0x2000)
    checks.equal("DC brake", drive.send(START & ~NO_DC_BRAKE, 0x2000)[1], 0)
    drive.run_at(0x2000)
    drive.keep_sending(START & ~NO_QUICK_STOP, 0x2000, lambda status, at: at == 0)
    drive.run_at(0x2000)
    drive.send(START & ~NO_FREEZE, 0x4000)
    drive.send(STOP & ~NO_FREEZE, 0)
    time.sleep(0.1)
    checks.equal("frozen, not stopped", drive.send(STOP & ~NO_FREEZE, 0)[1], 0x2000)
    checks.equal("coasting leaves it", drive.send(STOP & ~NO_FREEZE & ~NO_COASTING, 0)[1], 0)
    drive.stop()
    drive.keep_sending(STOP | JOG, 0, lambda status, at: at == round(0x4000 / 5))
    drive.write(213, 1000)  # preset reference 3 is 10.00 %
    drive.keep_sending(START | 2, 0x1000, lambda status, at: at == 0x1000 + round(0x4000 / 10))
    drive.stop()


def terminals(drive, checks, type_key):
    type_key("27")
    support.wait_for(lambda: not drive.send(START, 0x2000)[0] & RUNNING, "coasting by terminal 27")
    drive.write(503, 1)  # serial communication
    drive.run_at(0x2000)
    type_key("27")
    drive.write(503, 3)
    drive.stop()
    type_key("18")
    drive.keep_sending(STOP, 0x2000, lambda status, at: at == 0x2000)
    drive.write(505, 2)  # logic and
    drive.stop()
    type_key("18")
    drive.write(505, 3)


def trips(drive, checks, simulator, type_key):
    drive.run_at(0x2000)
    simulator.send_signal(signal.SIGUSR1)
    support.wait_for(lambda: drive.send()[0] & TRIPPED, "the trip")
    checks.equal("alarm word", drive.ask(parameter(0x1211))[:8], words(0x2211, 0, 0, 0x1000))
    checks.equal("error code", drive.read(615, 1), 13)
    drive.send(STOP)
    checks.equal("reset by an edge", drive.send(STOP | RESET)[0] & (TRIPPED | READY), READY)
    type_key("t 0x400")
    support.wait_for(lambda: drive.send(STOP | RESET)[0] & TRIPPED, "the next trip")
    checks.equal("no edge, no reset", drive.send(STOP | RESET)[0] & TRIPPED, TRIPPED)
    checks.equal("the latest error is the first", [drive.read(615, index) for index in (1, 2)], [11, 13])
    drive.send(STOP)
    checks.equal("an edge again", drive.send(STOP | RESET)[0] & TRIPPED, 0)
    drive.send(STOP)
    type_key("w 0x40")
    support.wait_for(lambda: drive.send()[0] & 0x4080 == 0x4080, "the warning")
    checks.equal("warning word", drive.read(531), 0x40)
    type_key("c")
    support.wait_for(lambda: not drive.send()[0] & 0x4080, "the end of the warning")
    type_key("l")
    support.wait_for(lambda: not drive.send(START, 0x2000)[0] & 0x0200, "local operation")
    checks.equal("no word is obeyed", drive.send(START, 0x2000)[0] & RUNNING, 0)
    drive.send(STOP)
    type_key("l")
    support.wait_for(lambda: drive.send(STOP)[0] & 0x0200, "serial control")


def mains(drive, checks, simulator):
    drive.write(206, 22, eeprom=True)
    drive.write(207, 33)
    drive.run_at(0x0100)
    simulator.send_signal(signal.SIGUSR2)
    support.wait_for(lambda: drive.send()[1] == 0, "mains off and on")
    checks.equal("EEPROM and RAM", [drive.read(206), drive.read(207)], [22, 10])


def bus_time_outs(drive, checks):
    """All six reactions to a second of silence, from 12.5 Hz; jog is at 5 Hz."""
    drive.be_quick()
    drive.write(209, 50)
    for reaction, wanted in ((0, 0x1000), (1, 0x1000), (2, 0), (3, 0x4000 / 10), (4, 0x4000), (5, 0)):
        drive.write(556, reaction)
        drive.run_at(0x1000)
        time.sleep(1.3)
        status, frequency = drive.send()
        checks.equal(f"frequency of reaction {reaction}", frequency, round(wanted))
        checks.equal(f"trip of reaction {reaction}", status & TRIPPED, TRIPPED if reaction == 5 else 0)
    checks.equal("alarm word", drive.read(529), 0x10)
    drive.send(STOP)
    drive.send(STOP | RESET)
    drive.write(556, 0)


def simulator_by_hand(program, checks):
    with support.scratch_folder() as folder:
        eeprom = os.path.join(folder, "eeprom")
        with support.server_on_a_line(program, "--eeprom", eeprom, stdin=subprocess.PIPE) as (simulator, path), \
                support.open_line(path) as line:
            def type_key(text):
                simulator.stdin.write(text + "\n")
                simulator.stdin.flush()

            drive = Drive(line, checks)
            examples_of_the_manual(drive, checks)
            addresses(drive, checks)
            drive.be_quick()
            refusals(drive, checks)
            words_of_control(drive, checks)
            terminals(drive, checks, type_key)
            trips(drive, checks, simulator, type_key)
            mains(drive, checks, simulator)
            bus_time_outs(drive, checks)
            support.stop(simulator, checks)
        with support.server_on_a_line(program, "--eeprom", eeprom, "--address", "100") as (simulator, path), \
                support.open_line(path) as line:
            line.send(telegram(0x80 | 100, parameter(0x10CE)))
            checks.equal("EEPROM of another day", line.receive(16),
                         telegram(0x80 | 100, parameter(0x10CE, 0, 22, 0x0607)))
            support.stop(simulator, checks)


def control_with_simulator(simulator_program, program, checks):
    """From standstill to 50 % and back."""
    with support.server_on_a_line(simulator_program) as (simulator, path):
        def control(*command):
            return support.run(program, "--device", path, *command)

        for number in ("206", "207"):
            checks.equal(f"write {number}", control("write", number, "1", "--as", "word", "--scale", "0")[0], 0)
        checks.contains("stands by", control("status")[1], "STW 0607 serial_control control_ready")
        checks.equal("start", control("start", "50%")[0], 0)
        support.wait_for(lambda: "25.00 Hz between 0.0 Hz and 50.0 Hz" in control("status")[1], "50 %")
        checks.equal("read", control("read", "202"), (0, "202 output_frequency_high_limit 50.0 Hz\n"))
        checks.equal("read a word", control("read", "530"),
                     (0, "530 control_word CTW 047C start preset_reference_1 setup_1\n"))
        checks.equal("start in Hz", control("start", "-12.5Hz", "--scale", "-3")[0], 0)
        support.wait_for(lambda: "-12.50 Hz between" in control("status")[1], "-12.5 Hz")
        checks.contains("freeze", control("freeze")[1], "-25.00 %")
        checks.contains("still", control("status")[1], "freeze_output")
        checks.contains("coast", control("coast")[1], "0.00 %")
        checks.equal("jog", control("jog")[0], 0)
        support.wait_for(lambda: "20.00 %" in control("status")[1], "jog")
        checks.equal("stop", control("stop")[0], 0)
        support.wait_for(lambda: "stand_by" in control("status")[1], "standstill")
        checks.equal("nothing to reset", control("reset"), (0, "no trip to reset\n"))
        simulator.send_signal(signal.SIGUSR1)
        support.wait_for(lambda: "00001000 overcurrent" in control("status")[1], "the trip")
        checks.contains("start of a tripped drive", control("start", "50%")[1], "has tripped")
        checks.contains("reset", control("reset")[1], "stand_by")
        checks.equal("error code", control("read", "615", "--index", "1"), (0, "615 error_code 13\n"))

        checks.equal("write", control("write", "202", "100.0", "--eeprom"),
                     (0, "202 output_frequency_high_limit 100.0 Hz\n"))
        checks.equal("text", control("text", "533", "HELLO"), (0, '533 display_text_1 "HELLO"\n'))
        checks.equal("a text of the name plate", control("text", "621"), (0, '621 unit_type "VLT 6006 HVAC"\n'))
        refusal = "vlt6000_control: the drive refuses with error 2: the value is outside the limits of the parameter\n"
        checks.equal("a refusal", control("write", "202", "200.0"), (1, refusal))
        checks.equal("nobody there", control("--address", "2", "--timeout", "20", "status"),
                     (1, "vlt6000_control: no answer from drive 2\n"))
        for wrong in (("start",), ("start", "50"), ("write", "202", "50.05"), ("write", "207", "5"), ("read", "2048"),
                      ("write", "512", "1"), ("text", "533", "NINECHARS"), ("frobnicate",), ("stop", "now"),
                      ("--address", "32", "--address-format", "short", "status"), ("start", "200%"),
                      ("start", "25Hz"), ("read", "202", "--as", "byte")):
            checks.equal(f"wrong usage: {wrong}", control(*wrong)[0], 2)
        checks.contains("verbose", control("read", "202", "--verbose")[1],
                        "response from slave 1: word 202 = 1000, PCD 0607 0000")

        with support.running([program, "--device", path, "watch"], stdout=subprocess.PIPE, text=True) as watch:
            checks.contains("watch", watch.stdout.readline(), "STW 0607")
            watch.send_signal(signal.SIGINT)
            checks.equal("watch ends", watch.wait(DEADLINE), 0)
        support.stop(simulator, checks)


def control_with_a_slave_by_hand(program, checks):
    """Lost, late, foreign and damaged replies to: read 202."""
    request = telegram(SHORT, parameter(0x10CA))
    reply = telegram(SHORT, parameter(0x10CA, 0, 1000, 0x0607))
    printed = (0, "202 output_frequency_high_limit 100.0 Hz\n")
    ask = functools.partial(support.asking, program, "--timeout", "800")

    with ask("read", "202") as (process, line):
        checks.equal("request", line.receive(16), request)
        line.send(b"\x02\x55", telegram(0x02, parameter(0x10CA, 0, 1)), telegram(SHORT, parameter(0x10CB, 0, 2)),
                  telegram(LONG, parameter(0x10CA, 0, 3)), reply[:-1] + b"\x00", telegram(SHORT, words(0, 0)), reply)
        checks.equal("the reply among others", support.finish(process), printed)
    with ask("read", "202") as (process, line):
        for _ in range(2):
            checks.equal("first and second try", line.receive(16), request)
        line.send(reply[:7])
        checks.equal("third try", line.receive(16), request)
        line.send(reply, reply)
        checks.equal("third try, two replies", support.finish(process), printed)
    with support.asking(program, "--timeout", "50", "--retries", "1", "read", "202") as (process, line):
        line.receive(32)
        checks.equal("nobody answers", support.finish(process), (1, "vlt6000_control: no answer from drive 1\n"))
    # A drive that never says its control word, 530, is stopped all the same: 043C is a ramp stop and nothing else.
    for command, word in (("stop", 0x043C), ("coast", 0x0434), ("brake", 0x0438), ("quick-stop", 0x042C)):
        with support.asking(program, "--timeout", "50", "--retries", "0", command) as (process, line):
            checks.equal("asks for 530", line.receive(16), telegram(SHORT, parameter(0x1212)))
            checks.equal(f"{command} in any case", line.receive(8), telegram(SHORT, words(word, 0)))
            line.send(telegram(SHORT, words(0x0607, 0)))
            checks.equal(f"{command} is done", support.finish(process)[0], 0)
    with ask("--echo", "read", "202") as (process, line):
        line.send(line.receive(16), reply)
        checks.equal("an adapter with echo", support.finish(process), printed)
    for error, meaning in ((131, "the factory setup is selected"), (99, "error 99\n")):
        with ask("read", "202") as (process, line):
            line.receive(16)
            line.send(telegram(SHORT, parameter(0x70CA, 0, error)))
            status, said = support.finish(process)
            checks.equal("refused", status, 1)
            checks.contains("and why", said, meaning)


def control_on_a_bad_line(simulator_program, program, checks):
    """A line that loses, doubles and damages telegrams: every command succeeds, or says what went wrong."""
    succeeded = 0
    commands = [(("read", "206"), "206 ramp_up_time 10 s\n"), (("text", "621"), '621 unit_type "VLT 6006 HVAC"\n'),
                (("write", "202", "60.0"), "202 output_frequency_high_limit 60.0 Hz\n"),
                (("start", "10%"), "STW 0"), (("stop",), "STW 0")]
    with support.null_modem(support.losses()) as (near, far), \
            support.running([simulator_program, "--device", far], stdout=subprocess.DEVNULL):
        time.sleep(0.2)
        for command, wanted in 8 * commands:
            status, printed = support.run(program, "--device", near, "--timeout", "60", "--retries", "4", *command)
            if status == 0:
                succeeded += 1
                checks.equal(f"{command}", printed[:len(wanted)], wanted)
            else:
                checks.equal(f"{command}", (status, printed), (1, "vlt6000_control: no answer from drive 1\n"))
    checks.equal(f"{succeeded} of 40 succeeded, which is most of them", succeeded > 20, True)


def main():
    simulator_program, control_program = sys.argv[1:3]
    checks = support.Checks()
    simulator_by_hand(simulator_program, checks)
    control_with_simulator(simulator_program, control_program, checks)
    control_with_a_slave_by_hand(control_program, checks)
    control_on_a_bad_line(simulator_program, control_program, checks)
    sys.exit(checks.exit_status())


if __name__ == "__main__":
    main()
