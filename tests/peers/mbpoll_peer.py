#!/usr/bin/python3
"""mbpoll, a client made with libmodbus, reads and writes our server over a pseudo-terminal.

mbpoll_peer.py PATH/TO/modbus_server PATH/TO/modbus_poll
"""
import random
import re
import sys

import support


class Peer:
    """mbpoll at a line."""

    def __init__(self, line, address):
        self.line = line
        self.address = address

    def run(self, *options, values=(), address=None):
        # 0: addresses count from 0, 1: once. A pseudo-terminal has no parity; asked for one, the C library may refuse.
        return support.run("mbpoll", "-m", "rtu", "-P", "none", "-a", str(address or self.address), "-0", "-1",
                           "-o", "1", *options, self.line, "--", *map(str, values))

    def read(self, kind, first, count, *options):
        _, printed = self.run("-t", kind, "-r", str(first), "-c", str(count), *options)
        to_number = float if kind.endswith("float") else lambda text: int(text, 0)
        return [to_number(text) for text in re.findall(r"^\[\d+\]:\s+(\S+)", printed, re.MULTILINE)]

    def write(self, kind, first, values, *options):
        status, _ = self.run("-t", kind, "-r", str(first), *options, values=values)
        return status


def main():
    server_program, our_client = sys.argv[1:3]
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else random.randrange(1 << 31)
    print("seed", seed)
    values = random.Random(seed)
    checks = support.Checks()

    with support.server_on_a_line(server_program, "--address", "17", "--holding", "500") as (server, line):
        peer = Peer(line, 17)

        def ours(*command):
            return support.run(our_client, "--device", line, "--address", "17", *command)

        # Holding registers: 16 and 06, then 03.
        words = [values.randrange(0x10000) for _ in range(100)]
        checks.equal("16", peer.write("4", 10, words), 0)
        checks.equal("03 of 16", [value & 0xFFFF for value in peer.read("4", 10, 100)], words)
        checks.equal("06", peer.write("4", 499, [0xABCD]), 0)
        checks.equal("03 of 06", peer.read("4:hex", 499, 1), [0xABCD])

        # 32 bits: mbpoll's default has the low word first; -B the high one. Our client reads what mbpoll wrote.
        numbers = [values.randrange(-(1 << 31), 1 << 31) for _ in range(10)]
        floats = [f"{values.randrange(-99999, 99999) * 10.0 ** values.randrange(-3, 5):.5g}" for _ in range(10)]
        for options, order in ((), "cdab"), (("-B",), "abcd"):
            checks.equal("int32 written", peer.write("4:int", 200, numbers, *options), 0)
            checks.equal("int32 read", peer.read("4:int", 200, 10, *options), numbers)
            _, printed = ours("--as", "int32", "--order", order, "read-holding", "200", "20")
            checks.equal("int32 of ours", [int(text.split()[1]) for text in printed.splitlines()], numbers)

            checks.equal("float written", peer.write("4:float", 300, floats, *options), 0)
            checks.equal("float read", peer.read("4:float", 300, 10, *options), [float(text) for text in floats])
            _, printed = ours("--as", "float", "--order", order, "read-holding", "300", "20")
            checks.equal("float of ours", [float(text.split()[1]) for text in printed.splitlines()],
                         [float(text) for text in floats])

        # Coils: 15 and 05, then 01. What our client writes, mbpoll reads.
        states = [values.randrange(2) for _ in range(77)]
        checks.equal("15", peer.write("0", 5, states), 0)
        checks.equal("01 of 15", peer.read("0", 5, 77), states)
        checks.equal("05", peer.write("0", 5, [1 - states[0]]), 0)
        checks.equal("01 of 05", peer.read("0", 5, 2), [1 - states[0], states[1]])
        checks.equal("15 of ours", ours("write-coils", "300", "1", "0", "1", "1"), (0, "done\n"))
        checks.equal("01 of ours", peer.read("0", 300, 4), [1, 0, 1, 1])
        checks.equal("16 of ours", ours("write-registers", "0", "1", "0xFFFF", "-2"), (0, "done\n"))
        checks.equal("03 of ours", [value & 0xFFFF for value in peer.read("4", 0, 3)], [1, 0xFFFF, 0xFFFE])

        # Inputs: they live. The uptime is a 32-bit integer, high word first.
        before = peer.read("3:int", 0, 1, "-B")
        after = peer.read("3:int", 0, 1, "-B")
        checks.equal("04: the time goes on", len(before) == len(after) == 1 and 0 < before[0] < after[0] < 60_000, True)
        checks.equal("02", peer.read("1", 1, 9), [0] * 9)

        # Report Server ID: libmodbus takes the first byte as the ID and the second as the state.
        status, printed = peer.run("-u")
        checks.equal("17", status, 0)
        checks.contains("17", printed, "Id    : 0xDC")
        checks.contains("17", printed, "Status: On")
        checks.contains("17", printed, "drivecodec")

        # Refused, and not answered.
        status, printed = peer.run("-t", "4", "-r", "499", "-c", "2")
        checks.equal("beyond the last register", status, 1)
        checks.contains("beyond the last register", printed, "Illegal data address")
        status, printed = peer.run("-t", "4", "-r", "499", values=[1, 2])
        checks.contains("writing beyond the last register", printed, "Illegal data address")
        status, printed = peer.run("-t", "4", "-o", "0.2", address=18)
        checks.equal("another address", status, 1)
        checks.contains("another address", printed, "Connection timed out")

        printed = support.stop(server, checks)
        checks.contains("counters", printed, "2 exceptions")
        checks.contains("counters", printed, "0 bytes dropped")
    return checks.exit_status()


sys.exit(main())
