# cmake -DBUS_MONITOR=<program> -DWORK=<folder> -P bus_monitor_recorded.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

#=== Modbus, with times ===#

set(modbus_traffic
"# xD1000 manual: the two examples; then a register that there is not
100.000000 02 03 0C 1E 00 04 27 6C
100.012345 02 03 08 00 28 02 58 01 F4 00 00 52 B0
100.200000 02 06 23 29 00 0D 92 70
100.208000 02 86 02 33 A1
# nobody at 7
100.300000 07 03 00 18 00 01 04 6B
# a reply with a wrong CRC, one cut short, one with noise in front, one that nobody asked for
101.500000 05 03 00 18 00 01 05 89
101.508000 05 03 02 01 02 C9 55
101.600000 05 03 00 18 00 01 05 89
101.610000 05 03 02 01
101.700000 05 03 00 18 00 01 05 89
101.704000 FF 05 03 02 01 02 C9 D5
101.800000 05 03 02 01 02 C9 D5
# to all
101.900000 00 06 00 18 00 01 C9 DC
101.950000 FF 00
101.960000 02 03 0C
# the last
102.000000 07 03 00 18 00 01 04 6B
")
expect("every kind of thing that happens on a line" STATUS 1
    COMMAND ${BUS_MONITOR} --drive 2=xd1000 --drive "5=smd:pump"
    INPUT "${modbus_traffic}"
    OUTPUT "
               0.000    2 xd1000  ->              03 read_holding_registers  first=3102 count=4
               0.012    2 xd1000  <-    +12.3 ms  03 read_holding_registers  byte_count=8 registers=[40 600 500 0]
                                                  switching_frequency 4.0 kHz, maximum_output_frequency 60.0 Hz, high_speed 50.0
                                                  Hz, low_speed 0.0 Hz
               0.200    2 xd1000  ->              06 write_single_register  register_address=9001 value=13
                                                  acceleration 13 s
               0.208    2 xd1000  <!     +8.0 ms  06 write_single_register  exception 02 illegal_data_address
               0.300    7         ->              03 read_holding_registers  first=24 count=1
               1.300    7         --              no reply in time
               1.500    5 pump    ->              03 read_holding_registers  first=24 count=1
               1.508    5 pump    xx              dropped 7 bytes  bad_checksum: 05 03 02 01 02 C9 55
               1.600    5 pump    --              no whole reply
               1.600    5 pump    ->              03 read_holding_registers  first=24 count=1
               1.610    5 pump    xx              dropped 4 bytes  truncated: 05 03 02 01
               1.700    5 pump    --              no whole reply
               1.700    5 pump    ->              03 read_holding_registers  first=24 count=1
               1.704    5 pump    xx              dropped 1 byte  bad_checksum: FF
               1.704    5 pump    <-     +4.0 ms  03 read_holding_registers  byte_count=2 registers=[258]  (found amid dropped
                                                  bytes)
                                                  command_speed 25.8 Hz
               1.800    5 pump    <-              03 read_holding_registers  byte_count=2 registers=[258]  (no request heard)
               1.900  all         ->              06 write_single_register  register_address=24 value=1
               1.950    -         xx              dropped 2 bytes  bad_length: FF 00
               1.960    2 xd1000  xx              dropped 3 bytes  truncated: 02 03 0C
               2.000    7         ->              03 read_holding_registers  first=24 count=1
               2.000    7         --              no reply before the end

        12 frames of Modbus in 2.0 s, 17 dropped bytes
          address  drive   requests   replies   refused  no reply   bad sum   dropped    min ms   mean ms    max ms
              all                 1         0         0         0         0         0         -         -         -
                2  xd1000         2         1         1         0         0         3       8.0      10.2      12.3
                5  pump           3         2         0         2         2        12       4.0       4.0       4.0
                7                 2         0         0         2         0         0         -         -         -
                -                 0         0         0         0         0         2         -         -         -
              sum                 8         3         1         4         2        17       4.0       8.1      12.3
")

set(one_exchange "12.000001 11 03 00 6B 00 03 76 87
12.500001 11 03 06 02 2B 00 00 00 64 C8 BA
")
expect("the times of the recording" STATUS 1 COMMAND ${BUS_MONITOR} --absolute --timeout 499 INPUT "${one_exchange}" OUTPUT "
              12.000   17  ->              03 read_holding_registers  first=107 count=3
              12.499   17  --              no reply in time
              12.500   17  <-              03 read_holding_registers  byte_count=6 registers=[555 0 100]  (no request heard)

        2 frames of Modbus in 0.5 s
          address  requests   replies   refused  no reply   bad sum   dropped
               17         1         1         0         1         0         0
")
expect("only the table" STATUS 0 COMMAND ${BUS_MONITOR} --quiet INPUT "${one_exchange}" OUTPUT "
        2 frames of Modbus in 0.5 s
          address  requests   replies   refused  no reply   bad sum   dropped    min ms   mean ms    max ms
               17         1         1         0         0         0         0     500.0     500.0     500.0
")
expect("as JSON" STATUS 0 COMMAND ${BUS_MONITOR} --json --drive 17=xd1000 
    INPUT "${one_exchange}00 06 00 18 00 01 C9 DC" OUTPUT [[
        {"protocol":"modbus-rtu","direction":"request","address":17,"function":3,"name":"read_holding_registers","first":107,"count":3,"aligned":true,"raw":"1103006B00037687","time":12000001,"drive":"xd1000"}
        {"protocol":"modbus-rtu","direction":"response","address":17,"function":3,"name":"read_holding_registers","byte_count":6,"registers":[555,0,100],"aligned":true,"raw":"110306022B00000064C8BA","meaning":"register 107: 022B, register 108: 0000, register 109: 0064","time":12500001,"response_time":500000,"drive":"xd1000"}
        {"protocol":"modbus-rtu","direction":"request","address":0,"function":6,"name":"write_single_register","register_address":24,"value":1,"aligned":true,"raw":"000600180001C9DC","time":12500001}
        {"statistics":0,"requests":1,"replies":0,"refusals":0,"silences":0,"unclear":0,"bad_checksums":0,"dropped_bytes":0}
        {"statistics":17,"drive":"xd1000","requests":1,"replies":1,"refusals":0,"silences":0,"unclear":0,"bad_checksums":0,"dropped_bytes":0,"least_response_time":500000,"mean_response_time":500000,"most_response_time":500000}
        {"counters":{"frames":3,"unaligned_frames":0,"dropped_runs":0,"dropped_bytes":0,"bad_checksums":0,"truncated":0}}
]])

#=== FC, without times, as the simulators log it ===#

set(fc_traffic
"02 0E 01 10 CA 00 00 00 00 00 00 04 7F 20 00 8C
02 0E 01 10 CA 00 00 00 00 03 E8 0F 03 20 00 10
02 0E 01 E0 CA 00 00 00 00 03 E8 00 00 00 00 CC
02 0E 01 70 CA 00 00 00 00 00 02 0F 03 20 00 99
02 06 02 04 7F 20 00 5D
02 06 01 04 7F 20 00 5E
02 06 01 0F 03 20 00 2A
02 06 20 04 3C 00 00 1C
")
expect("telegrams, a refusal, a silence, a wrong BCC" STATUS 1
    COMMAND ${BUS_MONITOR} --request-first --drive 1=vlt6000 --width 100 INPUT "${fc_traffic}" OUTPUT "
          1 vlt6000  ->  read_value 202, PCD 047F 2000
                         202 output_frequency_high_limit; CTW 047F start preset_reference_4 setup_1,
                         reference 50.00 %
          1 vlt6000  <-  word 202 = 1000, PCD 0F03 2000
                         202 output_frequency_high_limit 100.0 Hz; STW 0F03 serial_control control_ready
                         drive_ready speed_equals_reference within_frequency_range running, output frequency
                         50.00 %
          1 vlt6000  ->  write_word_to_eeprom 202 = 1000, PCD 0000 0000
                         202 output_frequency_high_limit 100.0 Hz; process data ignored
          1 vlt6000  <!  cannot_be_executed 202: value_exceeds_limits (2), PCD 0F03 2000
                         202 output_frequency_high_limit; STW 0F03 serial_control control_ready drive_ready
                         speed_equals_reference within_frequency_range running, output frequency 50.00 %
          2          ->  PCD 047F 2000
          2          --  no reply
          1 vlt6000  ->  PCD 047F 2000
                         CTW 047F start preset_reference_4 setup_1, reference 50.00 %
          1 vlt6000  xx  dropped 8 bytes  bad_checksum: 02 06 01 0F 03 20 00 2A
          1 vlt6000  --  no whole reply
        all          ->  PCD 043C 0000

        7 frames of FC, 8 dropped bytes
          address  drive    requests   replies   refused  no reply   bad sum   dropped
              all                  1         0         0         0         0         0
                1  vlt6000         3         1         1         1         1         8
                2                  1         0         0         1         0         0
              sum                  5         1         1         2         1         8
")

expect("what nothing tells is unclear" STATUS 0
    COMMAND ${BUS_MONITOR} --protocol=fc INPUT "02 06 01 04 7F 20 00 5E 02 06 01 0F 03 20 00 29" OUTPUT "
          1  <>  PCD 047F 2000
          1  <>  PCD 0F03 2000

        2 frames of FC
          address  requests   replies   refused  no reply   bad sum   dropped   unclear
                1         0         0         0         0         0         0         2
")

#=== colours ===#

string(ASCII 27 escape)
set(a_broadcast "00 06 00 18 00 01 C9 DC")
expect("colours where they are wanted" STATUS 0 COMMAND ${BUS_MONITOR} --colour always INPUT "${a_broadcast}" OUTPUT "
        ${escape}[1mall${escape}[0m  ${escape}[36m->${escape}[0m  06 write_single_register  register_address=24 value=1

        ${escape}[1m1 frame of Modbus${escape}[0m
        ${escape}[1m  address  requests   replies   refused  no reply   bad sum   dropped${escape}[0m
              all         1${escape}[2m         0${escape}[0m${escape}[2m         0${escape}[0m${escape}[2m         0${escape}[0m${escape}[2m         0${escape}[0m${escape}[2m         0${escape}[0m
")
set(plain "
        all  ->  06 write_single_register  register_address=24 value=1

        1 frame of Modbus
          address  requests   replies   refused  no reply   bad sum   dropped
              all         1         0         0         0         0         0
")
expect("none where it is no terminal" STATUS 0 COMMAND ${BUS_MONITOR} INPUT "${a_broadcast}" OUTPUT "${plain}")
expect("nor where they are not wanted" STATUS 0
    COMMAND ${BUS_MONITOR} --colour never INPUT "${a_broadcast}" OUTPUT "${plain}")

#=== what is refused ===#

function(expect_refusal message)
    expect("${message}" STATUS 2 ${ARGN} OUTPUT "bus_monitor: ${message}; see bus_monitor --help\n")
endfunction()
expect_refusal("there is no option --loud" COMMAND ${BUS_MONITOR} --loud)
expect_refusal("there is no option --quiet=1" COMMAND ${BUS_MONITOR} --quiet=1)
expect_refusal("'smd' is no drive such as 5=smd" COMMAND ${BUS_MONITOR} --drive smd)
expect_refusal("'acs550' is no drive that is known here: xd1000, vlt6000, smd" COMMAND ${BUS_MONITOR} --drive 5=acs550)
expect_refusal("'0' is not a number from 1 to 247" COMMAND ${BUS_MONITOR} --drive 0=smd)
expect_refusal("'red' is none of auto, always, never" COMMAND ${BUS_MONITOR} --colour red)
expect_refusal("either a file or --device, not both" COMMAND ${BUS_MONITOR} --device /dev/null file)
expect_refusal("there is more than one file" COMMAND ${BUS_MONITOR} one two)
expect_refusal("cannot read ${WORK}/nothing: No such file or directory" COMMAND ${BUS_MONITOR} ${WORK}/nothing)
expect("bad hexadecimal, behind what was read before" STATUS 2
    COMMAND ${BUS_MONITOR} INPUT "00 06 00 18 00 01 C9 DC\n12.345678 0x\n" OUTPUT "
        all  ->  06 write_single_register  register_address=24 value=1

        1 frame of Modbus
          address  requests   replies   refused  no reply   bad sum   dropped
              all         1         0         0         0         0         0
        bus_monitor: line 2, character 11: no digits behind the prefix; see bus_monitor --help
")
expect("nothing" STATUS 0 COMMAND ${BUS_MONITOR} INPUT "# nothing\n" OUTPUT "
        0 frames
          address  requests   replies   refused  no reply   bad sum   dropped
")
