# cmake -DDECODE=<program> -DLIVE_LINE=<program> -DWORK=<folder> -P decode_live.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

expect("frames of a line are printed as they come; a silence ends what is incomplete" STATUS 1
    COMMAND ${LIVE_LINE} ${DECODE}
    INPUT
"11 03 00 6B 00 03 76 87
11 03 06 02 2B 00 00 00 64 C8 BA
11 03 00
02 06 23 29 00 0D 92 70
"
    OUTPUT "
        server 17  request  03 read_holding_registers  first=107 count=3
        server 17  response  03 read_holding_registers  byte_count=6 registers=[555 0 100]
        dropped 3 bytes  truncated: 11 03 00
        server 2  request  06 write_single_register  register_address=9001 value=13
        frames=3 unaligned_frames=0 dropped_runs=1 dropped_bytes=3 bad_checksums=0 truncated=1
")

expect("a request that nobody answers is forgotten, so that its repetition is a request too" STATUS 0
    COMMAND ${LIVE_LINE} ${DECODE} --json --baud 9600 --format 8N1 --timeout 20
    INPUT
"02 06 23 29 00 0D 92 70
02 06 23 29 00 0D 92 70
"
    OUTPUT [[
        {"protocol":"modbus-rtu","direction":"request","address":2,"function":6,"name":"write_single_register","register_address":9001,"value":13,"aligned":true,"raw":"02062329000D9270"}
        {"protocol":"modbus-rtu","direction":"request","address":2,"function":6,"name":"write_single_register","register_address":9001,"value":13,"aligned":true,"raw":"02062329000D9270"}
        {"counters":{"frames":2,"unaligned_frames":0,"dropped_runs":0,"dropped_bytes":0,"bad_checksums":0,"truncated":0}}
]])

expect("telegrams of an FC line; a request that nobody answers is forgotten" STATUS 0
    COMMAND ${LIVE_LINE} ${DECODE} --protocol fc --timeout 20
    INPUT
"02 06 20 04 3C 00 00 1C
02 06 01 04 7F 20 00 5E
02 06 01 04 7F 20 00 5E
"
    OUTPUT "
        broadcast: PCD 043C 0000
        request to slave 1: PCD 047F 2000
        request to slave 1: PCD 047F 2000
        frames=3 unaligned_frames=0 dropped_runs=0 dropped_bytes=0 bad_checksums=0 truncated=0
")

expect("behind a long silence a master speaks" STATUS 0
    COMMAND ${LIVE_LINE} ${DECODE} --protocol fc --timeout 60
    INPUT
"02 06 01 04 7F 20 00 5E
02 06 01 04 7F 20 00 5E 02 06 01 0F 03 20 00 29
"
    OUTPUT "
        to or from slave 1: PCD 047F 2000
        request to slave 1: PCD 047F 2000
        response from slave 1: PCD 0F03 2000
        frames=3 unaligned_frames=0 dropped_runs=0 dropped_bytes=0 bad_checksums=0 truncated=0
")

expect("the protocol of a line is found; two telegrams are enough" STATUS 1
    COMMAND ${LIVE_LINE} ${DECODE} --protocol auto --timeout 5000
    INPUT
"FF 02 06 20 04 3C 00 00 1C 02 06 01 04 7F 20 00 5E
02 06 01 0F 03 20 00 29
11 03 00 6B 00 03 76 87
"
    OUTPUT "
        dropped 1 byte  bad_length: FF
        broadcast: PCD 043C 0000  (found amid dropped bytes)
        request to slave 1: PCD 047F 2000
        response from slave 1: PCD 0F03 2000
        dropped 8 bytes  bad_length: 11 03 00 6B 00 03 76 87
        frames=3 unaligned_frames=1 dropped_runs=2 dropped_bytes=9 bad_checksums=0 truncated=0
")

expect("a frame is enough" STATUS 0
    COMMAND ${LIVE_LINE} ${DECODE} --protocol auto --json
    INPUT
"02 06 23 29 00 0D 92 70
"
    OUTPUT [[
        {"protocol":"modbus-rtu","direction":"request","address":2,"function":6,"name":"write_single_register","register_address":9001,"value":13,"aligned":true,"raw":"02062329000D9270"}
        {"counters":{"frames":1,"unaligned_frames":0,"dropped_runs":0,"dropped_bytes":0,"bad_checksums":0,"truncated":0}}
]])

expect("what is no serial device is refused" STATUS 2
    COMMAND ${DECODE} --device ${WORK}/nothing
    OUTPUT "
        decode: cannot open ${WORK}/nothing with 19200 baud: No such file or directory; see decode --help
")
expect("of which FC has another baud rate" STATUS 2
    COMMAND ${DECODE} --protocol fc --device ${WORK}/nothing
    OUTPUT "
        decode: cannot open ${WORK}/nothing with 9600 baud: No such file or directory; see decode --help
")
