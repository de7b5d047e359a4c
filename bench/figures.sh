#!/bin/sh
# Measures what drivecodec claims, and prints a table: figure, value, budget, verdict. Exit status 1 if one is missed.
#
#   sh bench/figures.sh
#
# Bytes and instructions are exact. Times are processor times, each the least of several runs; they are compared with
# those of the same round, and a missed one is tried again in up to two more rounds.
set -eu
cd "$(dirname "$0")/.."

sh tests/setup.sh g++=g++ cmake=cmake ninja=ninja-build valgrind=valgrind \
    /usr/include/benchmark/benchmark.h=libbenchmark-dev \
    arm-none-eabi-g++=gcc-arm-none-eabi '/usr/include/newlib/c++/*/span=libstdc++-arm-none-eabi-newlib'

work=build/figures
mkdir -p "$work"
lines=$work/lines
: >"$lines"

run() {
    "$@" >"$work/log" 2>&1 || {
        cat "$work/log" >&2
        exit 1
    }
}

#=== flash, RAM and stack ===#

run cmake --preset firmware
run cmake --build --preset firmware
ctest --test-dir build/firmware -L figures --no-tests=error -V >"$work/flash" || true
grep -o 'figure|.*' "$work/flash" | sed 's/^figure|/Cortex-M0, /' >>"$lines"

#=== instructions ===#

run cmake --preset bench
run cmake --build --preset bench
bench=build/bench/bench
sh bench/check_instructions.sh "$bench/bench.modbus.rtu.instructions" >"$work/instructions"
awk '$1 == "measured_decode_request_03" {
         printf "decode and check request 03|%d instructions|at most 120|%s\n", $2, $2 <= 120 ? "ok" : "MISSED"
         found = 1
     }
     END { exit !found }' "$work/instructions" >>"$lines"
sh bench/check_instructions.sh "$bench/bench.cia402.instructions" >"$work/instructions"
awk '$1 == "measured_decode_state_of_65536_words" {
         each = $2 / 65536
         printf "decode the state of a statusword: of all, with the loop|%.1f instructions|at most 20|%s\n", each,
                each <= 20 ? "ok" : "MISSED"
         found = 1
     }
     END { exit !found }' "$work/instructions" >>"$lines"
sh bench/check_instructions.sh "$bench/bench.fc.instructions" >"$work/instructions"
awk '$1 ~ /^measured_(decode|check)_parameter_/ {
         what = substr($1, length("measured_") + 1)
         gsub("_", " ", what)
         printf "FC, %s|%d instructions|at most 130|%s\n", what, $2, $2 <= 130 ? "ok" : "MISSED"
         ++found
     }
     END { exit found != 2 }' "$work/instructions" >>"$lines"
sh bench/check_instructions.sh "$bench/bench.drives.smd.instructions" >"$work/instructions"
awk '$1 == "measured_decode_status_block" {
         printf "smd, decode the status block|%d instructions|at most 60|%s\n", $2, $2 <= 60 ? "ok" : "MISSED"
         found = 1
     }
     END { exit !found }' "$work/instructions" >>"$lines"

sh bench/check_instructions.sh "$bench/bench.drives.smd.map_instructions" >"$work/instructions"
awk '$1 ~ /^measured_find_by_/ {
         what = substr($1, length("measured_find_") + 1)
         gsub("_", " ", what)
         printf "smd, find a parameter %s|%d instructions|at most 150|%s\n", what, $2, $2 <= 150 ? "ok" : "MISSED"
         ++found
     }
     END { exit found != 2 }' "$work/instructions" >>"$lines"

#=== times ===#

# name,nanoseconds: the least of the repetitions.
round() {
    for program in modbus.crc16 modbus.rtu.messages modbus.rtu.reader; do
        "$bench/bench.$program" --benchmark_format=csv --benchmark_min_time=0.02 --benchmark_repetitions=9 \
            --benchmark_enable_random_interleaving=true 2>/dev/null
    done | awk -F, '/carryless/ && !/"native"/ { next }  # this machine has no carry-less multiply
                    /^"/ && !/_(mean|median|stddev|cv)",/ {
                        gsub("\"", "", $1)
                        if (!($1 in least) || $4 < least[$1]) least[$1] = $4
                    }
                    END { for (name in least) print name "," least[name] }'
}

# The line of each figure, and the exit status 1 if one is missed.
judge() {
    awk -F, '
        function figure(what, value, format, sense, budget,    good) {
            good = sense == "at least" ? value >= budget : value <= budget
            printf "%s|" format "|%s " format "|%s\n", what, value, sense, budget, good ? "ok" : "MISSED"
            missed += !good
        }
        function report(what, text) { printf "%s|%s||\n", what, text }
        function speed(name) { return sprintf("%.1f MB/s", 65536e3 / ns[name]) }
        { ns[$1] = $2 }
        END {
            table = ns["compute<crc16::byte_table>/256"]
            figure("CRC of 256 bytes, default: as fast as the table", table / ns["compute<crc16::slices>/256"],
                   "%.1f times", "at least", 3.5)
            if ("compute<crc16::carryless>/256" in ns)
                figure("CRC of 256 bytes, carry-less: as fast as the table",
                       table / ns["compute<crc16::carryless>/256"], "%.1f times", "at least", 12)
            figure("decode and check response 03, 125 registers: beyond its CRC",
                   ns["decode_response_03"] - ns["crc_of_response_03"], "%.0f ns", "at most", 40)
            figure("encode request 16, 123 registers: of its CRC", ns["encode_request_16"] / ns["crc_of_request_16"],
                   "%.2f times", "at most", 2)
            figure("stream reader, random garbage: of polls of 10 registers, a byte",
                   ns["random_garbage"] / ns["poll<10>"], "%.1f times", "at most", 20)
            report("stream reader, random garbage: of polls of 40 registers, a byte",
                   sprintf("%.1f times", ns["random_garbage"] / ns["poll<40>"]))
            report("stream reader, random garbage: of polls of 125 registers, a byte",
                   sprintf("%.1f times", ns["random_garbage"] / ns["poll<125>"]))
            report("CRC of 256 bytes, default", sprintf("%.0f ns", ns["compute<crc16::slices>/256"]))
            report("stream reader, polls of 10 registers", speed("poll<10>"))
            report("stream reader, polls of 40 registers", speed("poll<40>"))
            report("stream reader, polls of 125 registers", speed("poll<125>"))
            report("stream reader, valid frames of 8 bytes", speed("valid_short_frames"))
            report("stream reader, random garbage", speed("random_garbage"))
            report("stream reader, hostile", speed("hostile"))
            exit missed > 0
        }'
}

for attempt in 1 2 3; do
    round >"$work/times"
    if judge <"$work/times" >"$work/judged"; then
        break
    fi
    echo "round $attempt missed a figure" >&2
done
cat "$work/judged" >>"$lines"

#=== the table ===#

awk -F'|' '{ printf "%-72s %12s   %-20s %s\n", $1, $2, $3, $4; missed += $4 == "MISSED" }
    END {
        if (NR < 48) { print "figures are missing"; exit 1 }
        if (missed) { print missed " missed"; exit 1 }
    }' "$lines"
