#!/usr/bin/env python3
"""Mutation testing: does a test fail when a header is wrong?

    python3 tests/mutate.py include/drivecodec/modbus/crc16.hpp ... [--cxx g++] [--limit N] [--min PERCENT]

One token of a header is changed at a time. The mutant is killed when the header's test, tests/modbus/crc16.cpp, does
not compile any more (its static_asserts failed), or with --run does not pass. Survivors are printed; --check FILE names
further test files. The exit status tells whether at least --min percent were killed.
"""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parent.parent

RULES = [
    (r'(?<![<>=!\-])<(?![<=])(?= )', '<='), (r'(?<![->=])>(?![>=])(?= \w)', '>='), (r'<=(?!>)', '<'), (r'>=', '>'),
    (r'==', '!='), (r'!=', '=='), (r'\bor\b|\|\|', 'and'), (r'\band\b|&&(?= )', 'or'), (r'\bnot ', ''),
    (r' \| ', ' & '), (r' & ', ' | '), (r' \^ ', ' | '), (r' >> ', ' << '), (r' << ', ' >> '),
    (r' \+ ', ' - '), (r' - ', ' + '), (r'\+= ', '-= '), (r' / ', ' * '), (r' % ', ' / '),
    (r'\b(0x[0-9A-Fa-f]+)(U?)\b', lambda m: hex(int(m[1], 16) ^ 1) + m[2]),
    (r'(?<![\w.])(\d+)(U?)\b(?!x)', lambda m: str(int(m[1]) + 1) + m[2]),
    (r'\btrue\b', 'false'), (r'\bfalse\b', 'true'),
    (r'errc::truncated', 'errc::bad_value'),
]


def mutants(text):
    lines = text.split('\n')
    for number, line in enumerate(lines):
        if re.match(r'\s*(#|//|template|namespace|using|static_assert|requires)', line):
            continue
        code = re.sub(r'"[^"]*"', lambda m: '"' + ' ' * (len(m[0]) - 2) + '"', line.split('//')[0])
        for pattern, replacement in RULES:
            for match in re.finditer(pattern, code):
                new = replacement(match) if callable(replacement) else replacement
                mutant = line[:match.start()] + new + line[match.end():]
                yield number + 1, line.strip(), mutant.strip(), '\n'.join(lines[:number] + [mutant] + lines[number + 1:])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('headers', nargs='+', type=pathlib.Path)
    parser.add_argument('--check', action='append', default=[], type=pathlib.Path, help='a test file besides the own one')
    parser.add_argument('--run', action='store_true', help='run the tests of mutants that compile')
    parser.add_argument('--cxx', default='g++')
    parser.add_argument('--limit', type=int, default=0, help='at most so many mutants, spread evenly')
    parser.add_argument('--min', type=float, default=0.0)
    options = parser.parse_args()

    with tempfile.TemporaryDirectory() as scratch:
        def survives(header, text):
            relative = header.resolve().relative_to(ROOT / 'include')
            own = ROOT / 'tests' / relative.relative_to('drivecodec').with_suffix('.cpp')
            tests = ([own] if own.exists() else []) + [check.resolve() for check in options.check]
            if not tests:
                sys.exit(f'{header}: no test')
            with tempfile.TemporaryDirectory(dir=scratch) as folder:
                shutil.copytree(ROOT / 'include', folder, dirs_exist_ok=True)
                pathlib.Path(folder, relative).write_text(text)
                compile_one = [options.cxx, '-std=c++20', '-w', f'-I{folder}', f'-I{ROOT / "tests"}']
                for test in tests:
                    program = pathlib.Path(folder, 'program')
                    link = ['-o', program, '-lgtest', '-lgtest_main', '-pthread'] if options.run else ['-fsyntax-only']
                    steps = [compile_one + [test] + link] + ([[program]] if options.run else [])
                    for step in steps:
                        try:
                            if subprocess.run(step, capture_output=True, timeout=120).returncode != 0:
                                return False
                        except subprocess.TimeoutExpired:
                            return False
            return True

        for header in options.headers:
            if not survives(header, header.read_text()):
                sys.exit(f'{header}: its test fails without a mutation')
        jobs = [(header, *mutant) for header in options.headers for mutant in mutants(header.read_text())]
        if options.limit:
            jobs = jobs[::-(-len(jobs) // options.limit)]
        start = time.time()
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            alive = list(pool.map(lambda job: survives(job[0], job[4]), jobs))

    for (header, line, old, new, _), survived in zip(jobs, alive):
        if survived:
            print(f'SURVIVED {header}:{line}: {old}  ->  {new}')
    killed = len(jobs) - sum(alive)
    percent = 100 * killed / max(1, len(jobs))
    print(f'{killed} of {len(jobs)} mutants killed, {percent:.0f} %, {time.time() - start:.0f} s')
    return percent < options.min


sys.exit(main())
