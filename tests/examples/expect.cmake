# expect(<what> STATUS <n> [COMMAND <word>...] [INPUT <text>] [HIDE <regex>] OUTPUT <text>)
#
# Runs the command with the text as its standard input; standard output and standard error together must be OUTPUT, but
# for a newline at its begin and the eight spaces that indent its lines. What HIDE matches is given as `*`.
function(expect what)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "STATUS;INPUT;HIDE;OUTPUT" "COMMAND")
    string(REGEX REPLACE "^\n" "" expected "${arg_OUTPUT}")
    string(REPLACE "\n        " "\n" expected "\n${expected}")
    string(SUBSTRING "${expected}" 1 -1 expected)
    file(WRITE ${WORK}/input "${arg_INPUT}")
    execute_process(COMMAND ${arg_COMMAND} INPUT_FILE ${WORK}/input OUTPUT_VARIABLE output ERROR_VARIABLE output
        RESULT_VARIABLE status)
    if(arg_HIDE)
        string(REGEX REPLACE "${arg_HIDE}" "*" output "${output}")
    endif()
    if(NOT output STREQUAL expected OR NOT status STREQUAL arg_STATUS)
        list(JOIN arg_COMMAND " " command)
        message(SEND_ERROR "${what}\n${command}\nexpected, with status ${arg_STATUS}:\n${expected}\n"
            "given, with status ${status}:\n${output}")
    endif()
endfunction()
