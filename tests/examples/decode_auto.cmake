# cmake -DDECODE=<program> -DWORK=<folder> -P decode_auto.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

set(auto ${DECODE} --protocol auto)

#=== traffic of one protocol ===#

foreach(kind hex txt json)
    file(READ ${CMAKE_CURRENT_LIST_DIR}/decode/fc.${kind} fc_${kind})
    file(READ ${CMAKE_CURRENT_LIST_DIR}/decode/every_function.${kind} modbus_${kind})
endforeach()
foreach(protocol fc modbus)
    expect("${protocol} as text" STATUS 0 COMMAND ${auto}        INPUT "${${protocol}_hex}" OUTPUT "${${protocol}_txt}")
    expect("${protocol} as JSON" STATUS 0 COMMAND ${auto} --json INPUT "${${protocol}_hex}" OUTPUT "${${protocol}_json}")
endforeach()
expect("nothing" STATUS 0 COMMAND ${auto} INPUT "\n" OUTPUT "")

expect("which way the first telegram goes" STATUS 0
    COMMAND ${auto} --request-first 02 06 01 04 7F 20 00 5E 02 06 01 0F 03 20 00 29 OUTPUT "
        request to slave 1: PCD 047F 2000
        response from slave 1: PCD 0F03 2000
")

#=== what is both is Modbus ===#

set(both        "02 06 21 9A 00 F2 22 6F")
set(a_broadcast "02 06 20 04 3C 00 00 1C")
set(a_request   "02 06 01 04 7F 20 00 5E")
set(a_reading   "11 03 00 6B 00 03 76 87")

expect("both as FC" STATUS 0 COMMAND ${DECODE} --protocol fc ${both} OUTPUT "
        broadcast: PCD 9A00 F222
")
expect("both" STATUS 0 COMMAND ${auto} ${both} OUTPUT "
        server 2  request  06 write_single_register  register_address=8602 value=242
")
expect("both, and its response, which is the same" STATUS 0 COMMAND ${auto} INPUT "${both}\n${both}\n" OUTPUT "
        server 2  request  06 write_single_register  register_address=8602 value=242
        server 2  response  06 write_single_register  register_address=8602 value=242
")
expect("both, first of three" STATUS 1 COMMAND ${auto} ${both} ${a_request} ${a_broadcast} OUTPUT "
        server 2  request  06 write_single_register  register_address=8602 value=242
        dropped 16 bytes  bad_checksum: 02 06 01 04 7F 20 00 5E 02 06 20 04 3C 00 00 1C
")

#=== Modbus from the first frame on, FC from the second telegram on ===#

expect("a frame behind one telegram" STATUS 1 COMMAND ${auto} INPUT "${a_request}\n${a_reading}\n${a_request}\n" OUTPUT "
        dropped 8 bytes  bad_checksum: 02 06 01 04 7F 20 00 5E
        server 17  request  03 read_holding_registers  first=107 count=3
        dropped 8 bytes  bad_checksum: 02 06 01 04 7F 20 00 5E
")
expect("what is both behind one telegram" STATUS 1 COMMAND ${auto} INPUT "${a_request}\n${both}\n" OUTPUT "
        dropped 8 bytes  bad_checksum: 02 06 01 04 7F 20 00 5E
        server 2  request  06 write_single_register  register_address=8602 value=242
")
expect("what is both behind two telegrams" STATUS 0
    COMMAND ${auto} INPUT "${a_request}\n${a_broadcast}\n${both}\n" OUTPUT "
        to or from slave 1: PCD 047F 2000
        broadcast: PCD 043C 0000
        broadcast: PCD 9A00 F222
")
expect("a frame behind two telegrams, on one line" STATUS 1
    COMMAND ${auto} ${a_request} ${a_broadcast} ${a_reading} OUTPUT "
        to or from slave 1: PCD 047F 2000
        broadcast: PCD 043C 0000
        dropped 8 bytes  bad_length: 11 03 00 6B 00 03 76 87
")
expect("a telegram to a reserved address does not tell" STATUS 1
    COMMAND ${auto} INPUT "02 06 00 04 7F 20 00 5F\n${a_request}\n${a_reading}\n" OUTPUT "
        dropped 8 bytes  bad_checksum: 02 06 00 04 7F 20 00 5F
        dropped 8 bytes  bad_checksum: 02 06 01 04 7F 20 00 5E
        server 17  request  03 read_holding_registers  first=107 count=3
")

#=== noise ===#

expect("noise about Modbus" STATUS 1 COMMAND ${auto} --json INPUT "FF FE\n00 ${a_reading} 00\n" OUTPUT [[
        {"dropped":"FFFE","reason":"truncated"}
        {"dropped":"00","reason":"bad_checksum"}
        {"protocol":"modbus-rtu","direction":"request","address":17,"function":3,"name":"read_holding_registers","first":107,"count":3,"aligned":false,"raw":"1103006B00037687"}
        {"dropped":"00","reason":"truncated"}
]])
expect("noise about FC" STATUS 1 COMMAND ${auto} --json INPUT "FF FE\n00 ${a_broadcast} 00\n${a_broadcast}" OUTPUT [[
        {"dropped":"FFFE","reason":"bad_length"}
        {"dropped":"00","reason":"bad_length"}
        {"protocol":"fc","direction":"request","address":0,"broadcast":true,"kind":"process","pcd":[1084,0],"aligned":false,"raw":"020620043C00001C"}
        {"dropped":"00","reason":"bad_length"}
        {"protocol":"fc","direction":"request","address":0,"broadcast":true,"kind":"process","pcd":[1084,0],"aligned":true,"raw":"020620043C00001C"}
]])
expect("nothing but noise" STATUS 1 COMMAND ${auto} INPUT "FF FE\n02 06 20 04\n" OUTPUT "
        dropped 2 bytes  truncated: FF FE
        dropped 4 bytes  truncated: 02 06 20 04
")

#=== one telegram, and the input ends ===#

expect("one telegram" STATUS 0 COMMAND ${auto} ${a_request} OUTPUT "
        to or from slave 1: PCD 047F 2000
")
expect("one telegram at the begin of a line" STATUS 1 COMMAND ${auto} INPUT "FF FE\n${a_broadcast} 01\n" OUTPUT "
        dropped 2 bytes  bad_length: FF FE
        broadcast: PCD 043C 0000
        dropped 1 byte  bad_length: 01
")
expect("one telegram amid noise may be noise" STATUS 1 COMMAND ${auto} FF ${a_broadcast} OUTPUT "
        dropped 9 bytes  bad_checksum: FF 02 06 20 04 3C 00 00 1C
")
expect("what was read before a mistake is printed" STATUS 2 COMMAND ${auto} INPUT "${a_broadcast}\nzz\n" OUTPUT "
        broadcast: PCD 043C 0000
        decode: line 2, character 1: 'z' is not a hexadecimal digit; see decode --help
")
