"""What the tests against other programs share."""
import contextlib
import os
import random
import select
import signal
import subprocess
import sys
import tempfile
import threading
import time
import tty

DEADLINE = 5.0  # seconds for anything that should happen at once


class Checks:
    """Counts what went wrong, and goes on."""

    def __init__(self):
        self.done = 0
        self.failed = 0

    def equal(self, what, seen, wanted):
        self.done += 1
        if seen != wanted:
            self.failed += 1
            print(f"FAILED: {what}: {seen!r}, should be {wanted!r}")

    def contains(self, what, seen, wanted):
        self.done += 1
        if wanted not in seen:
            self.failed += 1
            print(f"FAILED: {what}: {wanted!r} is not in {seen!r}")

    def exit_status(self):
        print(f"{self.done} checks, {self.failed} failed")
        return 1 if self.failed or not self.done else 0


def wait_for(condition, what):
    end = time.monotonic() + DEADLINE
    while not condition():
        if time.monotonic() > end:
            sys.exit(f"FAILED: {what} did not happen in {DEADLINE} seconds")
        time.sleep(0.01)


@contextlib.contextmanager
def scratch_folder():
    with tempfile.TemporaryDirectory(prefix="drivecodec.") as folder:
        yield folder


@contextlib.contextmanager
def running(command, **options):
    """A process that is gone at the end, whatever happens."""
    process = subprocess.Popen(command, **options)
    try:
        yield process
    finally:
        if process.poll() is None:
            process.kill()
        process.wait()


@contextlib.contextmanager
def server_on_a_line(program, *options, **streams):
    """Our server on a pseudo-terminal: gives the process and the path of its line."""
    with scratch_folder() as folder:
        link = os.path.join(folder, "line")
        command = [program, "--link", link, *options]
        with running(command, stdout=subprocess.PIPE, text=True, **streams) as process:
            wait_for(lambda: os.path.exists(link) or process.poll() is not None, "the server's link")
            yield process, link


def stop(process, checks):
    """Ends the server as Ctrl-C does; gives what it printed."""
    process.send_signal(signal.SIGINT)
    printed, _ = process.communicate(timeout=DEADLINE)
    checks.equal("exit status of the server", process.returncode, 0)
    return printed


class Line:
    """The other end of a pseudo-terminal."""

    def __init__(self, end):
        self.end = end

    def receive(self, size, seconds=DEADLINE):
        """So many bytes; fewer if they do not come in time."""
        heard = b""
        end = time.monotonic() + seconds
        while len(heard) < size:
            ready, _, _ = select.select([self.end], [], [], max(0.0, end - time.monotonic()))
            if not ready:
                break
            heard += os.read(self.end, size - len(heard))
        return heard

    def send(self, *parts):
        os.write(self.end, b"".join(parts))


@contextlib.contextmanager
def open_line(path):
    """The other end of a server's line."""
    end = os.open(path, os.O_RDWR | os.O_NOCTTY)
    try:
        tty.setraw(end)
        yield Line(end)
    finally:
        os.close(end)


@contextlib.contextmanager
def asking(program, *command):
    """Our client as it asks: gives the process and the line to it."""
    end, device = os.openpty()
    tty.setraw(device)
    try:
        with running([program, "--device", os.ttyname(device), *command],
                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
            yield process, Line(end)
    finally:
        os.close(end)
        os.close(device)


def finish(process):
    """Exit status and all that the client printed."""
    printed, _ = process.communicate(timeout=2 * DEADLINE)
    return process.returncode, printed


@contextlib.contextmanager
def null_modem(carry_bytes=lambda heard: heard):
    """Two serial devices joined by a line: gives their paths. What one sends at once, the line may change."""
    ends = [os.openpty() for _ in range(2)]
    for _, device in ends:
        tty.setraw(device)
    wake, stop = os.pipe()
    others = {ends[0][0]: ends[1][0], ends[1][0]: ends[0][0]}

    def carry():
        while True:
            ready, _, _ = select.select([*others, wake], [], [])
            if wake in ready:
                return
            for end in ready:
                os.write(others[end], carry_bytes(os.read(end, 4096)))

    bridge = threading.Thread(target=carry)
    bridge.start()
    try:
        yield [os.ttyname(device) for _, device in ends]
    finally:
        os.close(stop)
        bridge.join()
        for number in (wake, *ends[0], *ends[1]):
            os.close(number)


def losses():
    """For `null_modem`: a line that loses, doubles and damages."""
    seed = random.SystemRandom().randrange(1 << 30)
    print("seed", seed)
    chance = random.Random(seed)

    def carry(heard):
        fate = chance.randrange(6)
        if fate == 0:
            return b""
        if fate == 1:
            return heard + heard
        if fate == 2:
            damaged = bytearray(heard)
            damaged[chance.randrange(len(damaged))] ^= 1 << chance.randrange(8)
            return bytes(damaged)
        return heard

    return carry


def with_crc(frame):
    """A Modbus RTU frame."""
    crc = 0xFFFF
    for byte in frame:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0xA001 if crc & 1 else 0)
    return bytes(frame) + crc.to_bytes(2, "little")


def run(*command):
    """Exit status and all that a command printed."""
    done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=2 * DEADLINE,
                          check=False)
    return done.returncode, done.stdout
