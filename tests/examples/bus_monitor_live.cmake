# cmake -DBUS_MONITOR=<program> -DLIVE_LINE=<program> -DWORK=<folder> -P bus_monitor_live.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

set(times " +[+]?[0-9]+[.][0-9]+( ms| s)?")

expect("who says what is shown as it comes, and counted in the end" STATUS 1
    COMMAND ${LIVE_LINE} ${BUS_MONITOR} --drive 2=xd1000 --timeout 5000 HIDE ${times}
    INPUT
"02 06 23 29 00 0D 92 70
02 06 23 29 00 0D 92 70
11 03 00
02 06 23 29 00 0D 92 70
"
    OUTPUT "
        *    2 xd1000  ->              06 write_single_register  register_address=9001 value=13
                                                  acceleration 13 s
        *    2 xd1000  <-*  06 write_single_register  register_address=9001 value=13
                                                  acceleration 13 s
        *    -         xx              dropped 3 bytes  truncated: 11 03 00
        *    2 xd1000  ->              06 write_single_register  register_address=9001 value=13
                                                  acceleration 13 s

        3 frames of Modbus in*, 3 dropped bytes
          address  drive   requests   replies   refused  no reply   bad sum   dropped    min ms   mean ms    max ms
                2  xd1000         2         1         0         0         0         0***
                -                 0         0         0         0         0         3         -         -         -
              sum                 2         1         0         0         0         3***
")

expect("a request that nobody answers is given up, and the next is a request too" STATUS 1
    COMMAND ${LIVE_LINE} ${BUS_MONITOR} --protocol fc --request-first --timeout 60 HIDE ${times}
    INPUT
"02 06 01 04 7F 20 00 5E
02 06 01 04 7F 20 00 5E 02 06 01 0F 03 20 00 29
"
    OUTPUT "
        *    1  ->              PCD 047F 2000
        *    1  --              no reply in time
        *    1  ->              PCD 047F 2000
        *    1  <-              PCD 0F03 2000

        3 frames of FC in*
          address  requests   replies   refused  no reply   bad sum   dropped
                1         2         1         0         1         0         0
")

expect("only the table" STATUS 0
    COMMAND ${LIVE_LINE} ${BUS_MONITOR} --quiet --every 2 HIDE "( in)?${times}"
    INPUT
"02 06 23 29 00 0D 92 70 02 06 23 29 00 0D 92 70
"
    OUTPUT "
        2 frames of Modbus*
          address  requests   replies   refused  no reply   bad sum   dropped
                2         1         1         0         0         0         0
        2 frames of Modbus*
          address  requests   replies   refused  no reply   bad sum   dropped
                2         1         1         0         0         0         0
")

expect("what is no serial device is refused" STATUS 2
    COMMAND ${BUS_MONITOR} --device ${WORK}/nothing
    OUTPUT "
        bus_monitor: cannot open ${WORK}/nothing with 19200 baud: No such file or directory; see bus_monitor --help
")
