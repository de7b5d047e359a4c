#!/usr/bin/python3
"""Our client and our server on a line that is late, noisy and shared: this script is the other end.

bad_line_peer.py PATH/TO/modbus_server PATH/TO/modbus_poll
"""
import sys
import time

import support


def registers(address, *values):
    """A response of function 03."""
    data = b"".join(value.to_bytes(2, "big") for value in values)
    return support.with_crc(bytes([address, 3, len(data)]) + data)


def client(program, checks):
    request = support.with_crc(b"\x11\x03\x00\x6b\x00\x01")
    patient = ["--timeout", "3000"]
    read = ["read-holding", "107", "1"]

    def asking(*command):
        return support.asking(program, "--address", "17", *command)

    # Before the reply: noise, other servers' replies, replies to something else, a damaged one, a longer one.
    with asking(*patient, *read) as (process, line):
        checks.equal("request", line.receive(8), request)
        line.send(b"\x00\xff\x11\x03", registers(18, 1), support.with_crc(b"\x11\x04\x02\x00\x02"), registers(17, 3, 3),
                  registers(17, 4)[:-1] + b"\x00", registers(17, 5))
        checks.equal("the reply among others", support.finish(process), (0, "107: 5\n"))

    # Nobody answers the first try; half a reply to the second.
    with asking("--timeout", "800", *read) as (process, line):
        checks.equal("first try", line.receive(8), request)
        checks.equal("second try", line.receive(8), request)
        line.send(registers(17, 6)[:4])
        checks.equal("third try", line.receive(8), request)
        line.send(registers(17, 7))
        checks.equal("the third try", support.finish(process), (0, "107: 7\n"))
    with asking("--timeout", "100", "--retries", "1", *read) as (process, line):
        line.receive(16)
        checks.equal("nobody answers", support.finish(process), (1, "no answer from the server\n"))

    # Two replies to two tries: the second belongs to no later request.
    with asking("--timeout", "800", "--every", "1", *read) as (process, line):
        line.receive(16)
        line.send(registers(17, 8))
        time.sleep(0.1)
        line.send(registers(17, 8))
        checks.equal("the next request", line.receive(8), request)
        line.send(registers(17, 9))
        line.receive(8)
        process.terminate()
        line.send(registers(17, 9))
        status, printed = support.finish(process)
        checks.equal("no stale reply", (status, printed.splitlines()), (0, ["107: 8", "107: 9", "107: 9"]))

    # Exceptions: of this function, of another.
    with asking(*patient, *read) as (process, line):
        line.receive(8)
        line.send(support.with_crc(b"\x11\x86\x02"), support.with_crc(b"\x11\x83\x06"))
        checks.equal("exception", support.finish(process), (1, "exception 6 server_device_busy\n"))

    # An adapter that hears what it sends.
    with asking(*patient, "--echo", *read) as (process, line):
        line.send(line.receive(8), registers(17, 10))
        checks.equal("echo", support.finish(process), (0, "107: 10\n"))
    with asking(*patient, "--echo", "--address", "0", "write-register", "1", "2") as (process, line):
        line.send(line.receive(8))
        checks.equal("echo of a broadcast", support.finish(process), (0, "sent; nobody answers this\n"))
    with asking("--timeout", "800", "--retries", "1", "--echo", *read) as (process, line):
        line.receive(8)
        line.send(b"\x11\x13", registers(17, 11))
        line.send(line.receive(8), registers(17, 12))
        checks.equal("a collision, then the echo", support.finish(process), (0, "107: 12\n"))


def server(program, checks):
    # A long silence, so that a busy machine does not make pauses where there are none.
    with support.server_on_a_line(program, "--address", "17", "--holding", "200",
                                  "--silence", "50000") as (process, path), support.open_line(path) as line:
        def expect(what, wanted, *parts):
            """Sends the parts; the server answers this, or stays silent."""
            for part in parts:
                line.send(part)
            heard = line.receive(len(wanted)) if wanted else line.receive(1, 0.2)
            checks.equal(what, heard, wanted)

        read = support.with_crc(b"\x11\x03\x00\x6b\x00\x01")
        write = support.with_crc(b"\x11\x06\x00\x6b\x02\x2b")
        expect("write", write, write)
        expect("read", registers(17, 555), read)

        # Noise: what follows it is not aligned and not answered; after a silence everything is as before.
        expect("behind noise", b"", b"\x55\xaa\x00" + read)
        expect("after the silence", registers(17, 555), read)
        expect("a damaged request", b"", read[:-1] + b"\x00")
        expect("a truncated request", b"", read[:5])
        expect("after all that", registers(17, 555), read)
        expect("byte by byte", registers(17, 555), *(bytes([byte]) for byte in read))

        # Others on the line: not answered, and a write to us within their reply is not carried out.
        expect("another server's request", b"", support.with_crc(b"\x05\x03\x00\x00\x00\x04"))
        inner = support.with_crc(b"\x11\x06\x00\x6b\x00\x00")
        expect("its reply", b"", support.with_crc(b"\x05\x03\x08" + inner))
        expect("its damaged reply", b"", b"\x05\x03\x0a" + inner + b"\x00\x00\x00\x00")
        expect("the register is as it was", registers(17, 555), read)

        # Broadcasts: writes are carried out, nothing is answered.
        expect("broadcast", b"", support.with_crc(b"\x00\x06\x00\x6b\x00\x07"))
        expect("broadcast of a read", b"", support.with_crc(b"\x00\x03\x00\x6b\x00\x01"))
        expect("what was broadcast", registers(17, 7), read)

        # Exceptions: function, address, quantity, value.
        for request, code in ((b"\x41", 1), (b"\x03\xff\xff\x00\x02", 2), (b"\x03\x00\xc7\x00\x02", 2),
                              (b"\x03\x00\x00\x00\x7e", 3), (b"\x05\x00\x00\x12\x34", 3), (b"\x08\x00\x05\x00\x00", 1)):
            expect(f"exception of {request.hex()}", support.with_crc(bytes([0x11, request[0] | 0x80, code])),
                   support.with_crc(b"\x11" + request))

        # Listening only, until it is restarted; the restart is not answered.
        expect("force listen only", b"", support.with_crc(b"\x11\x08\x00\x04\x00\x00"))
        expect("listening only", b"", read)
        expect("restart", b"", support.with_crc(b"\x11\x08\x00\x01\x00\x00"))
        expect("after the restart", registers(17, 7), read)
        expect("messages since the restart", support.with_crc(b"\x11\x08\x00\x0e\x00\x02"),
               support.with_crc(b"\x11\x08\x00\x0e\x00\x00"))
        support.stop(process, checks)


def main():
    checks = support.Checks()
    client(sys.argv[2], checks)
    server(sys.argv[1], checks)
    return checks.exit_status()


sys.exit(main())
