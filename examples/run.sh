#!/bin/sh
# Builds the examples from a bare checkout and shows them at work. Exit status 0: everything went as it should.
set -eu
cd "$(dirname "$0")/.."

sh tests/setup.sh g++=g++ cmake=cmake ninja=ninja-build
cmake -S . -B build/examples -G Ninja -DCMAKE_CXX_FLAGS=-O1 -DDRIVECODEC_BUILD_TESTS=OFF >/dev/null
cmake --build build/examples

PATH=$PWD/build/examples/examples:$PATH
scratch=$(mktemp -d)
server=
clean_up() {
    [ -z "$server" ] || kill "$server" 2>/dev/null || true
    rm -rf "$scratch"
}
trap clean_up EXIT
trap 'exit 1' INT TERM

heading() {
    printf '\n=== %s ===\n' "$1"
}

# Prints a command, then runs it.
show() {
    printf '\n$ %s\n' "$*"
    "$@"
}

# The same for one that must fail: a refusal is part of what is shown.
show_refusal() {
    printf '\n$ %s\n' "$*"
    if "$@"; then
        echo "this should have been refused" >&2
        exit 1
    fi
}

# Until the server, which is our child, has opened its line.
wait_for_line() {
    tries=100
    until [ -e "$line" ]; do
        kill -0 "$server" && [ "$tries" -gt 0 ]
        tries=$((tries - 1))
        sleep 0.05
    done
}

stop_server() {
    printf '\n$ %s\n' "kill %1"
    kill "$server"
    wait "$server"
    server=
}

heading "a frame that the compiler builds, and a function of one's own beside the public ones"
grep -A 3 '^constexpr auto read_three' examples/frames.cpp
show frames

heading "its decoding"
show decode 11 03 00 6B 00 03 76 87
show decode --json 11 03 00 6B 00 03 76 87
show decode 11 03 00 6B 00 03 76 87 11 03 06 02 2B 00 00 00 64 C8 BA

heading "a server and a client, over a pseudo-terminal"
line=$scratch/line
log=$scratch/traffic
printf '\n$ %s\n' "modbus_server --address 17 --link $line --log $log &"
modbus_server --address 17 --link "$line" --log "$log" >"$scratch/server" &
server=$!
wait_for_line
poll() {
    show modbus_poll --device "$line" --address 17 "$@"
}
poll identify
poll write-registers 107 555 0 100
poll read-holding 107 3
poll --as float write-registers 10 0x4048 0xF5C3
poll --as float read-holding 10 2
poll write-coils 19 1 0 1 1
poll read-coils 19 4
poll --as uint32 read-input 0 2
poll diagnostics 14
show_refusal modbus_poll --device "$line" --address 17 read-holding 999 2
stop_server
cat "$scratch/server"

heading "the traffic on that line, decoded"
printf '\n$ %s\n' "decode <$log"
decode <"$log"

heading "an xD1000 drive, from standstill to 50 Hz and back"
line=$scratch/drive
log=$scratch/drive_traffic
printf '\n$ %s\n' "xd1000_simulator --address 2 --link $line --log $log &"
xd1000_simulator --address 2 --link "$line" --log "$log" </dev/null >"$scratch/drive_states" &
server=$!
wait_for_line
drive() {
    show xd1000_control --device "$line" --address 2 "$@"
}
drive status
drive start 50.0
sleep 4
drive status
drive reverse
drive stop
show_refusal xd1000_control --device "$line" --address 2 start 50.01
stop_server
printf '\n%s\n' "the states it went through:"
cat "$scratch/drive_states"
printf '\n$ %s\n' "decode --drive xd1000 <$log"
decode --drive xd1000 <"$log"

heading "its state machine"
show state_diagram

heading "a VLT 6000 HVAC, from standstill to 25 Hz and back"
line=$scratch/vlt6000
log=$scratch/vlt6000_traffic
printf '\n$ %s\n' "vlt6000_simulator --address 1 --link $line --log $log &"
vlt6000_simulator --address 1 --link "$line" --log "$log" </dev/null >"$scratch/vlt6000_states" &
server=$!
wait_for_line
vlt() {
    show vlt6000_control --device "$line" --address 1 "$@"
}
vlt write 206 5 --eeprom
vlt write 207 5 --as word --scale 0
vlt status
vlt --verbose start 50%
sleep 3
vlt status
vlt stop
sleep 3
vlt status
vlt read 202
vlt write 202 60.0 --eeprom
vlt read 615 --index 1
vlt text 621
vlt text 533 HELLO
show_refusal vlt6000_control --device "$line" --address 1 write 202 200.0
show_refusal vlt6000_control --device "$line" --address 1 read 999
stop_server
printf '\n%s\n' "what it showed:"
cat "$scratch/vlt6000_states"
printf '\n$ %s\n' "decode --request-first --drive vlt6000 <$log"
decode --request-first --drive vlt6000 <"$log"

heading "an smd: unlocked, from standstill to 41.2 Hz, turned round, watched for its time-out, locked"
line=$scratch/smd
log=$scratch/smd_traffic
printf '\n$ %s\n' "smd_simulator --address 5 --link $line --log $log &"
smd_simulator --address 5 --link "$line" --log "$log" </dev/null >"$scratch/smd_states" &
server=$!
wait_for_line
smd() {
    show smd_control --device "$line" --address 5 "$@"
}
smd status
show_refusal smd_control --device "$line" --address 5 set C12 0.5
smd unlock
smd set C12 0.5
smd set C13 0.5
smd start 41.2
sleep 1
smd status
smd reverse
sleep 1
smd status
smd set n23 0.5
smd set n22 2
show timeout --preserve-status -s INT 1 smd_control --device "$line" --address 5 watch
sleep 1.5
smd status
show_refusal smd_control --device "$line" --address 5 forward
show_refusal smd_control --device "$line" --address 5 start 60
smd stop
smd lock
show_refusal smd_control --device "$line" --address 5 set C12 1000
stop_server
printf '\n%s\n' "what it went through:"
cat "$scratch/smd_states"
printf '\n$ %s\n' "decode --drive smd <$log"
decode --drive smd <"$log"

heading "what a bus monitor makes of these recordings, and of one with a silence, a refusal and a damaged reply"
show bus_monitor --drive 2=xd1000 --quiet "$scratch/drive_traffic"
show bus_monitor --drive 1=vlt6000 --request-first --quiet "$scratch/vlt6000_traffic"
show bus_monitor --drive 5=smd --quiet "$scratch/smd_traffic"
cat >"$scratch/recording" <<'END'
# seconds since the recorder was started, and what it heard
100.000000 02 03 0C 1E 00 04 27 6C
100.012345 02 03 08 00 28 02 58 01 F4 00 00 52 B0
100.200000 02 06 23 29 00 0D 92 70
100.208000 02 86 02 33 A1
100.300000 07 03 00 18 00 01 04 6B
101.500000 05 03 00 18 00 01 05 89
101.508000 05 03 02 01 02 C9 55
101.600000 05 03 00 18 00 01 05 89
101.609500 05 03 02 01 02 C9 D5
END
printf '\n$ %s\n' "cat recording"
cat "$scratch/recording"
printf '\n$ %s\n' "bus_monitor --drive 2=xd1000 --drive 5=smd:pump recording"
if bus_monitor --drive 2=xd1000 --drive 5=smd:pump "$scratch/recording"; then
    echo "this line should not have been called healthy" >&2
    exit 1
fi

printf '\n%s\n' "everything worked"
