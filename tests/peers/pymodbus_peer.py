#!/usr/bin/python3
"""Our client asks a server made with pymodbus, over two pseudo-terminals with a bridge between them.

pymodbus_peer.py PATH/TO/modbus_poll [SEED]
"""
import os
import random
import sys

import support


def main():
    client = sys.argv[1]
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else random.randrange(1 << 31)
    print("seed", seed)
    values = random.Random(seed)
    checks = support.Checks()
    here = os.path.dirname(os.path.abspath(__file__))

    with support.null_modem() as (near, far), \
            support.running([sys.executable, "-B", os.path.join(here, "pymodbus_server.py"), far, "17"]) as server:

        def poll(*command, address=17):
            return support.run(client, "--device", near, "--address", str(address), "--timeout", "1000",
                               *map(str, command))

        def numbers(*command):
            status, printed = poll(*command)
            if status != 0:
                return printed
            return [int(line.split()[1]) for line in printed.splitlines()]

        def states(*command):
            _, printed = poll(*command)
            return [line.split()[1] == "on" for line in printed.splitlines()]

        done = (0, "done\n")
        support.wait_for(lambda: poll("--retries", 0, "--timeout", 100, "read-holding", 0, 1)[0] == 0
                         or server.poll() is not None, "the answer of pymodbus")

        words = [values.randrange(0x10000) for _ in range(123)]
        checks.equal("16", poll("write-registers", 100, *words), done)
        checks.equal("03", numbers("read-holding", 100, 123), words)
        checks.equal("06", poll("write-register", 100, 0xABCD), done)
        checks.equal("03 of 06", numbers("read-holding", 100, 2), [0xABCD, words[1]])
        checks.equal("04", numbers("read-input", 0, 125), [word * 257 for word in range(125)])
        checks.equal("22", poll("mask-write", 100, 0xF2F2, 0x2525), done)
        checks.equal("03 of 22", numbers("read-holding", 100, 1), [(0xABCD & 0xF2F2) | (0x2525 & ~0xF2F2)])
        checks.equal("23", numbers("read-write", 200, 4, 201, 11, 12), [words[100], 11, 12, words[103]])

        bits = [values.randrange(2) for _ in range(1000)]
        checks.equal("15", poll("write-coils", 7, *bits), done)
        checks.equal("01", states("read-coils", 7, 1000), [bit == 1 for bit in bits])
        checks.equal("05", poll("write-coil", 1999, "on"), done)
        checks.equal("01 of 05", states("read-coils", 1998, 2), [False, True])
        checks.equal("02", states("read-inputs", 0, 13), [bit % 3 == 0 for bit in range(13)])

        status, printed = poll("identify")
        checks.equal("43/14", (status, printed.splitlines()),
                     (0, ["vendor_name: pymodbus", "product_code: PM", "major_minor_revision: 3.0",
                          "model_name: a peer"]))
        checks.equal("43/14, one object", poll("identify", 1), (0, "product_code: PM\n"))
        checks.equal("17", poll("server-id"),
                     (0, f"byte_count=16 data=[{' '.join(f'0x{byte:02X}' for byte in b'pymodbus-PM-3.0')} 0xFF]\n"))
        checks.equal("07", poll("exception-status"), (0, "outputs=0x00\n"))
        checks.equal("08/00", poll("diagnostics", 0, 0x1234), (0, "sub_function=return_query_data data=[4660]\n"))
        checks.equal("08/11", poll("diagnostics", 11), (0, "sub_function=return_bus_message_count data=[0]\n"))
        checks.equal("11", poll("event-counter"), (0, "status=ready event_count=0\n"))
        checks.equal("12", poll("event-log"),
                     (0, "byte_count=6 status=ready event_count=0 message_count=0 events=[]\n"))
        checks.equal("21", poll("write-file", 1, 0, 3), done)
        checks.equal("24", poll("fifo", 0), (0, "byte_count=2 fifo_count=0 registers=[]\n"))

        checks.equal("an address that is not there", poll("read-holding", 999, 2),
                     (1, "exception 2 illegal_data_address\n"))
        checks.equal("a server that is not there",
                     poll("--timeout", 200, "--retries", 1, "read-holding", 0, 1, address=18),
                     (1, "no answer from the server\n"))
        checks.equal("broadcast", poll("write-register", 5, 4711, address=0), (0, "sent; nobody answers this\n"))
        checks.equal("03 of a broadcast", numbers("read-holding", 5, 1), [4711])
    return checks.exit_status()


sys.exit(main())
