#!/usr/bin/python3
"""Does Wireshark's dissector see in the library's frames what was encoded?

wireshark_peer.py PATH/TO/wireshark_frames [SEED]
"""
import os
import random
import subprocess
import sys
import tempfile

TEXTS = {"modbus.data", "modbus.object_str_value", "modbus.diagnostic.return_query_data.request",
         "modbus.diagnostic.return_query_data.echo", "_ws.malformed"}


def occurrences(name, text):
    """The values of one field."""
    words = text.split("|") if text else []
    return words if name in TEXTS else [int(word, 0) for word in words]


def dissect(capture, names):
    """What tshark finds: for each frame, a dictionary of fields."""
    command = ["tshark", "-n", "-r", capture, "-o", "mbrtu.udp.port:5020", "-o", "mbrtu.crc_verification:TRUE",
               "--disable-protocol", "opensafety",  # it looks for its own frames in every payload
               "-T", "fields", "-E", "separator=/t", "-E", "aggregator=|", "-E", "occurrence=a"]
    for name in names:
        command += ["-e", name]
    done = subprocess.run(command, check=True, capture_output=True, text=True, timeout=60)
    return [dict(zip(names, map(occurrences, names, line.split("\t")))) for line in done.stdout.splitlines()]


def main():
    program = sys.argv[1]
    seed = sys.argv[2] if len(sys.argv) > 2 else str(random.randrange(1 << 31))
    print("seed", seed)
    with tempfile.TemporaryDirectory() as scratch:
        capture = os.path.join(scratch, "frames.pcap")
        expected_file = os.path.join(scratch, "expected")
        subprocess.run([program, capture, expected_file, seed], check=True, timeout=20)
        with open(expected_file, encoding="ascii") as lines:
            expected = [
                {name: occurrences(name, values) for name, _, values in
                 (field.partition("=") for field in line.rstrip("\n").split("\t") if field)}
                for line in lines]
        names = sorted({name for frame in expected for name in frame} | {"_ws.malformed"})
        found = dissect(capture, names)

    wrong = 0
    for number, (wanted, seen) in enumerate(zip(expected, found), start=1):
        for name, values in {**wanted, "_ws.malformed": []}.items():
            if name == "modbus.data" and seen["modbus.func_code"] in ([20], [21]):
                # The data of a record is shown up to the end of the frame.
                seen[name] = [text[:len(part)] for text, part in zip(seen[name], values)]
            if seen[name] != values and not (values == [] and seen[name] == ["<MISSING>"]):
                wrong += 1
                print(f"frame {number}, function {seen['modbus.func_code']}: {name} is {seen[name]}, "
                      f"encoded was {values}")
    if len(expected) != len(found):
        wrong += 1
    print(f"{len(expected)} frames encoded, {len(found)} dissected, {wrong} differences")
    return 1 if wrong else 0


sys.exit(main())
