# cmake -DEXPECT=regex | -DEXPECT_IN=file -P must_fail.cmake -- command...
#
# The command must fail and must say why: ctest's own WILL_FAIL ignores the text, PASS_REGULAR_EXPRESSION the exit code.
# EXPECT_IN names a file whose first line is "// EXPECT: regex".
cmake_minimum_required(VERSION 3.25)

if(EXPECT_IN)
    file(STRINGS ${EXPECT_IN} EXPECT LIMIT_COUNT 1)
    if(NOT EXPECT MATCHES "^// EXPECT: (.+)$")
        message(FATAL_ERROR "${EXPECT_IN}: the first line must be '// EXPECT: regex'")
    endif()
    set(EXPECT "${CMAKE_MATCH_1}")
endif()

set(command "")
foreach(index RANGE ${CMAKE_ARGC})
    if(in_command)
        list(APPEND command ${CMAKE_ARGV${index}})
    elseif("${CMAKE_ARGV${index}}" STREQUAL "--")
        set(in_command TRUE)
    endif()
endforeach()

execute_process(COMMAND ${command} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(status EQUAL 0)
    message(FATAL_ERROR "succeeded, but must fail with '${EXPECT}'")
elseif(NOT output MATCHES "${EXPECT}")
    message(FATAL_ERROR "failed, but not with '${EXPECT}':\n${output}")
endif()
message(STATUS "refused: ${CMAKE_MATCH_0}")
