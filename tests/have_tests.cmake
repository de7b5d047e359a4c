# cmake -D INCLUDE_DIR=include/drivecodec -P have_tests.cmake
#
# include/drivecodec/X/Y.hpp is tested by tests/X/Y.cpp, so that whoever opens a header knows where its test is.
cmake_minimum_required(VERSION 3.25)

file(GLOB_RECURSE headers RELATIVE ${INCLUDE_DIR} ${INCLUDE_DIR}/*/*.hpp)
set(missing "")
foreach(header IN LISTS headers)
    string(REGEX REPLACE "\\.hpp$" ".cpp" test ${header})
    if(header MATCHES "/" AND NOT EXISTS ${CMAKE_CURRENT_LIST_DIR}/${test})
        string(APPEND missing "  ${header}: no tests/${test}\n")
    endif()
endforeach()
if(missing)
    message(FATAL_ERROR "headers without a test:\n${missing}")
endif()
