# cmake -DDECODE=<program> -DWORK=<folder> -P decode_fc.cmake
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/expect.cmake)

set(fc ${DECODE} --protocol fc)

#=== every kind of telegram ===#

foreach(kind hex txt json)
    file(READ ${CMAKE_CURRENT_LIST_DIR}/decode/fc.${kind} fc_${kind})
endforeach()
expect("every kind as text" STATUS 0 COMMAND ${fc}        INPUT "${fc_hex}" OUTPUT "${fc_txt}")
expect("every kind as JSON" STATUS 0 COMMAND ${fc} --json INPUT "${fc_hex}" OUTPUT "${fc_json}")

#=== what nothing tells is unknown ===#

set(read_and_reply 02 0E 01 10 CA 00 00 00 00 00 00 04 7F 20 00 8C 02 0E 01 10 CA 00 00 00 00 03 E8 0F 03 20 00 10)
expect("a direction that nothing tells" STATUS 0 COMMAND ${fc} ${read_and_reply} OUTPUT "
        to or from slave 1: AK 1 202, PWE 00000000, PCD 047F 2000
        to or from slave 1: AK 1 202, PWE 000003E8, PCD 0F03 2000
")
expect("has no names in JSON" STATUS 0 COMMAND ${fc} --json ${read_and_reply} OUTPUT [[
        {"protocol":"fc","direction":"unknown","address":1,"broadcast":false,"kind":"parameter","ak":1,"parameter":202,"index":0,"value":0,"pcd":[1151,8192],"aligned":true,"raw":"020E0110CA000000000000047F20008C"}
        {"protocol":"fc","direction":"unknown","address":1,"broadcast":false,"kind":"parameter","ak":1,"parameter":202,"index":0,"value":1000,"pcd":[3843,8192],"aligned":true,"raw":"020E0110CA0000000003E80F03200010"}
]])
expect("a direction that the user tells" STATUS 0 COMMAND ${fc} --request-first ${read_and_reply} OUTPUT "
        request to slave 1: read_value 202, PCD 047F 2000
        response from slave 1: word 202 = 1000, PCD 0F03 2000
")
expect("but a refusal is a response" STATUS 0
    COMMAND ${fc} --json 02 0E 01 70 CA 00 00 00 00 00 02 0F 03 20 00 99 OUTPUT [[
        {"protocol":"fc","direction":"response","address":1,"broadcast":false,"kind":"parameter","ak":7,"ak_name":"cannot_be_executed","parameter":202,"index":0,"error":2,"error_name":"value_exceeds_limits","pcd":[3843,8192],"aligned":true,"raw":"020E0170CA0000000000020F03200099"}
]])
expect("unless only requests are expected" STATUS 0 COMMAND ${fc} --expect request ${read_and_reply} OUTPUT "
        request to slave 1: read_value 202, PCD 047F 2000
        request to slave 1: read_value 202, PWE 000003E8, PCD 0F03 2000
")
expect("or only responses" STATUS 0 COMMAND ${fc} --expect=response ${read_and_reply} OUTPUT "
        response from slave 1: word 202 = 0, PCD 047F 2000
        response from slave 1: word 202 = 1000, PCD 0F03 2000
")

#=== other layouts ===#

set(twelve_bytes 02 0E 01 04 7F 20 00 00 01 00 02 00 03 00 04 52)
expect("twelve bytes are a parameter" STATUS 0 COMMAND ${fc} --expect request ${twelve_bytes} OUTPUT "
        request to slave 1: no_command 1151, PWE 00010002, PCD 0003 0004
")
expect("or six words" STATUS 0 COMMAND ${fc} --expect request --pcd 6 ${twelve_bytes} OUTPUT "
        request to slave 1: PCD 047F 2000 0001 0002 0003 0004
")
expect("as the user says" STATUS 0 COMMAND ${fc} --json --pcd=6 ${twelve_bytes} OUTPUT [[
        {"protocol":"fc","direction":"unknown","address":1,"broadcast":false,"kind":"process","pcd":[1151,8192,1,2,3,4],"aligned":true,"raw":"020E01047F2000000100020003000452"}
]])
expect("what another layout has is of an unknown kind" STATUS 0 COMMAND ${fc} --pcd 16 02 06 20 04 3C 00 00 1C OUTPUT "
        broadcast: 4 bytes of data: 04 3C 00 00
")
set(read_4000 02 0E 01 1F A0 00 00 00 00 00 00 00 00 00 00 B2)
expect("parameter numbers have 11 bits" STATUS 0 COMMAND ${fc} --expect request ${read_4000} OUTPUT "
        request to slave 1: read_value 1952, PCD 0000 0000
")
expect("or 12" STATUS 0 COMMAND ${fc} --expect request --pnu-bits 12 ${read_4000} OUTPUT "
        request to slave 1: read_value 4000, PCD 0000 0000
")

#=== what is no telegram ===#

expect("a telegram amid noise, a wrong BCC, a part of one" STATUS 1
    COMMAND ${fc} INPUT "FF 02 06 20 04 3C 00 00 1C\n02 06 20 04 3C 00 00 1D\n02 06 20\n" OUTPUT "
        dropped 1 byte  bad_length: FF
        broadcast: PCD 043C 0000  (found amid dropped bytes)
        dropped 8 bytes  bad_checksum: 02 06 20 04 3C 00 00 1D
        dropped 3 bytes  truncated: 02 06 20
")
expect("as JSON" STATUS 1 COMMAND ${fc} --json FF 02 06 20 04 3C 00 00 1C 02 OUTPUT [[
        {"dropped":"FF","reason":"bad_length"}
        {"protocol":"fc","direction":"request","address":0,"broadcast":true,"kind":"process","pcd":[1084,0],"aligned":false,"raw":"020620043C00001C"}
        {"dropped":"02","reason":"truncated"}
]])
expect("Modbus" STATUS 1 COMMAND ${fc} 11 03 00 6B 00 03 76 87 OUTPUT "
        dropped 8 bytes  bad_length: 11 03 00 6B 00 03 76 87
")

#=== what is refused ===#

function(expect_refusal problem)
    expect("${problem}" STATUS 2 ${ARGN} OUTPUT "decode: ${problem}; see decode --help\n")
endfunction()
expect_refusal("'usb' is none of modbus, fc, auto" COMMAND ${DECODE} --protocol usb)
expect_refusal("the value of --protocol is missing" COMMAND ${DECODE} --protocol)
expect_refusal("'1' is not a number from 2 to 16" COMMAND ${fc} --pcd 1)
expect_refusal("'17' is not a number from 2 to 16" COMMAND ${fc} --pcd 17)
expect_refusal("'10' is not a number from 11 to 12" COMMAND ${fc} --pnu-bits 10)
expect_refusal("an xd1000 does not have the FC protocol" COMMAND ${fc} --drive xd1000)
expect_refusal("a vlt6000 does not have Modbus" COMMAND ${DECODE} --protocol modbus --drive vlt6000)
expect_refusal("a vlt6000 has two process words and parameter numbers of 11 bits"
    COMMAND ${DECODE} --drive vlt6000 --pnu-bits 12)
expect_refusal("'acs550' is no drive that is known here: xd1000, vlt6000, smd" COMMAND ${DECODE} --drive acs550)

#=== what telegrams mean to a drive ===#

# Written 100 Hz, with start and 50 %; answered with the manual's 0F03 and 50 %. Then the name plate, and a reversed start.
set(conversation
    02 0E 01 E0 CA 00 00 00 00 03 E8 04 7F 20 00 97  02 0E 01 10 CA 00 00 00 00 03 E8 0F 03 20 00 10
    02 0E 01 F2 6D 04 00 00 00 00 00 00 00 00 00 96  02 12 01 F2 6D 04 00 56 4C 54 20 36 30 30 30 0F 03 20 00 CE
    02 06 01 04 7C E0 00 9D)
expect("a drive's parameters and words" STATUS 0 COMMAND ${DECODE} --drive vlt6000 ${conversation} OUTPUT [[
        request to slave 1: write_word_to_eeprom 202 = 1000, PCD 047F 2000
            202 output_frequency_high_limit 100.0 Hz; CTW 047F start preset_reference_4 setup_1, reference 50.00 %
        response from slave 1: word 202 = 1000, PCD 0F03 2000
            202 output_frequency_high_limit 100.0 Hz; STW 0F03 serial_control control_ready drive_ready speed_equals_reference within_frequency_range running, output frequency 50.00 %
        request to slave 1: text 621 read, PCD 0000 0000
            621 unit_type; process data ignored
        response from slave 1: text 621 "VLT 6000", PCD 0F03 2000
            621 unit_type; STW 0F03 serial_control control_ready drive_ready speed_equals_reference within_frequency_range running, output frequency 50.00 %
        request to slave 1: PCD 047C E000
            CTW 047C start preset_reference_1 setup_1, reference -50.00 %
]])
expect("where the direction is unknown, the parameter alone" STATUS 0
    COMMAND ${DECODE} --drive vlt6000 ${read_and_reply} OUTPUT "
        to or from slave 1: AK 1 202, PWE 00000000, PCD 047F 2000
            202 output_frequency_high_limit
        to or from slave 1: AK 1 202, PWE 000003E8, PCD 0F03 2000
            202 output_frequency_high_limit
")
expect("their meaning in JSON" STATUS 0 COMMAND ${DECODE} --json --drive vlt6000 02 06 20 04 3C 00 00 1C OUTPUT [[
        {"protocol":"fc","direction":"request","address":0,"broadcast":true,"kind":"process","pcd":[1084,0],"aligned":true,"raw":"020620043C00001C","meaning":"CTW 043C ramp_stop preset_reference_1 setup_1, reference 0.00 %"}
]])
expect("that of Modbus too" STATUS 0 COMMAND ${DECODE} --json --drive xd1000 02 06 21 35 00 06 13 C9 OUTPUT [[
        {"protocol":"modbus-rtu","direction":"request","address":2,"function":6,"name":"write_single_register","register_address":8501,"value":6,"aligned":true,"raw":"02062135000613C9","meaning":"CMD 0006 shutdown"}
]])
