# cmake -DDECODE=<program> -DWORK=<folder> -P decode_hex.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

#=== every function ===#

file(READ ${CMAKE_CURRENT_LIST_DIR}/decode/every_function.hex  frames)
file(READ ${CMAKE_CURRENT_LIST_DIR}/decode/every_function.txt  as_text)
file(READ ${CMAKE_CURRENT_LIST_DIR}/decode/every_function.json as_json)
expect("every function as text" STATUS 0 COMMAND ${DECODE}        INPUT "${frames}" OUTPUT "${as_text}")
expect("every function as JSON" STATUS 0 COMMAND ${DECODE} --json INPUT "${frames}" OUTPUT "${as_json}")

#=== what is written how ===#

set(read_request "
        server 17  request  03 read_holding_registers  first=107 count=3
")
foreach(hex "11 03 00 6B 00 03 76 87" "1103006B00037687" "0x11,0x03,0x00,0x6b,0x00,0x03,0x76,0x87" "11:03:00:6b:0:3:76:87"
        "\\x11\\x03\\x00\\x6B\\x00\\x03\\x76\\x87" "11h 03h 00h 6Bh 00h 03h 76h 87h" "{0x11, 3, 0, 0x6B, 0, 3, 0x76, 0x87}"
        "  [1103]-006B/0003|7687 # a comment: zz")
    expect("one argument" STATUS 0 COMMAND ${DECODE} "${hex}" OUTPUT "${read_request}")
    expect("one line" STATUS 0 COMMAND ${DECODE} INPUT "${hex}\r\n" OUTPUT "${read_request}")
endforeach()
expect("all arguments are one line" STATUS 0 COMMAND ${DECODE} 11 03 00 6B --expect=request 00 03 76 87
    OUTPUT "${read_request}")
expect("nothing" STATUS 0 COMMAND ${DECODE} INPUT "\n# a comment\n  \n" OUTPUT "")

#=== what is a frame ===#

expect("the end of a line is a silence" STATUS 1 COMMAND ${DECODE} INPUT "11 03 00 6B\n00 03 76 87\n" OUTPUT "
        dropped 4 bytes  truncated: 11 03 00 6B
        dropped 4 bytes  truncated: 00 03 76 87
")
expect("several frames on a line" STATUS 0
    COMMAND ${DECODE} 02 03 0C1E 0004 276C 02 03 08 0028 0258 01F4 0000 52B0 02 06 2329 000D 9270 OUTPUT "
        server 2  request  03 read_holding_registers  first=3102 count=4
        server 2  response  03 read_holding_registers  byte_count=8 registers=[40 600 500 0]
        server 2  request  06 write_single_register  register_address=9001 value=13
")
expect("the second of two equal frames is the response" STATUS 0
    COMMAND ${DECODE} INPUT "02 06 23 29 00 0D 92 70\n02 06 23 29 00 0D 92 70\n" OUTPUT "
        server 2  request  06 write_single_register  register_address=9001 value=13
        server 2  response  06 write_single_register  register_address=9001 value=13
")
expect("unless only requests are expected" STATUS 0
    COMMAND ${DECODE} --expect request INPUT "02 06 23 29 00 0D 92 70\n02 06 23 29 00 0D 92 70\n" OUTPUT "
        server 2  request  06 write_single_register  register_address=9001 value=13
        server 2  request  06 write_single_register  register_address=9001 value=13
")
expect("or only responses" STATUS 0
    COMMAND ${DECODE} --expect response 02 06 23 29 00 0D 92 70 OUTPUT "
        server 2  response  06 write_single_register  register_address=9001 value=13
")
expect("a response without its request has whole bytes of coils" STATUS 0
    COMMAND ${DECODE} --expect response 11 01 01 05 95 4B OUTPUT "
        server 17  response  01 read_coils  byte_count=1 coils=[1 0 1 0 0 0 0 0]
")
expect("a valid frame that asks for too much" STATUS 0 COMMAND ${DECODE} --json 01 03 00 00 00 7E C5 EA OUTPUT [[
        {"protocol":"modbus-rtu","direction":"request","address":1,"function":3,"name":"read_holding_registers","error":"bad_quantity","error_offset":4,"aligned":true,"raw":"01030000007EC5EA"}
]])
expect("bytes of no frame" STATUS 1 COMMAND ${DECODE} --json FF 11 03 00 6B 00 03 76 87 00 OUTPUT [[
        {"dropped":"FF","reason":"bad_checksum"}
        {"protocol":"modbus-rtu","direction":"request","address":17,"function":3,"name":"read_holding_registers","first":107,"count":3,"aligned":false,"raw":"1103006B00037687"}
        {"dropped":"00","reason":"truncated"}
]])

#=== what is refused ===#

function(expect_refusal problem)
    expect("${problem}" STATUS 2 ${ARGN} OUTPUT "decode: ${problem}; see decode --help\n")
endfunction()
expect_refusal("character 4: 'g' is not a hexadecimal digit" COMMAND ${DECODE} 11 g3)
expect_refusal("line 2, character 5: 'z' is not a hexadecimal digit" COMMAND ${DECODE} INPUT "# comment\n 11 z\n")
expect_refusal("line 1, character 1: an odd number of digits: '110'" COMMAND ${DECODE} INPUT "110 3\n")
expect_refusal("line 1, character 4: no digits behind the prefix" COMMAND ${DECODE} INPUT "11 0x 3\n")
expect_refusal("line 1, character 2: byte 0xC3 is not a hexadecimal digit" COMMAND ${DECODE} INPUT " é\n")
expect_refusal("there is no option --jsn" COMMAND ${DECODE} --jsn 11)
expect_refusal("'both' is none of request, response, either" COMMAND ${DECODE} --expect both)
expect_refusal("the value of --expect is missing" COMMAND ${DECODE} --expect)
expect_refusal("'8X1' is not a character format such as 8E1" COMMAND ${DECODE} --format=8X1)
expect_refusal("either hexadecimal or --device, not both" COMMAND ${DECODE} --device /dev/null 11 03)

execute_process(COMMAND ${DECODE} --help OUTPUT_VARIABLE help RESULT_VARIABLE status)
if(NOT status STREQUAL 0 OR NOT help MATCHES "--expect WHAT" OR NOT help MATCHES "--device PATH")
    message(SEND_ERROR "--help explains no options:\n${help}")
endif()
