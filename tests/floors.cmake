# cmake -D INCLUDE_DIR=include/drivecodec -P floors.cmake
#
# Which folder of include/drivecodec may include which. What is not listed is refused; version.hpp is open to all,
# and the umbrellas at the top may include anything.
cmake_minimum_required(VERSION 3.25)

set(core_may_include   core)
set(modbus_may_include core modbus)
set(fc_may_include     core fc)
set(cia402_may_include core cia402)
set(drives_may_include core modbus fc cia402)  # and what lies in drives/ itself; a drive its own folder: none knows another
set(text_may_include   core modbus fc cia402 drives text)

# Below text, everything has to fit into firmware.
set(too_heavy
    algorithm deque exception functional iostream list map memory new optional set stdexcept string typeinfo
    unordered_map variant vector)

file(GLOB_RECURSE headers RELATIVE ${INCLUDE_DIR} ${INCLUDE_DIR}/*.hpp)
set(violations "")
foreach(header IN LISTS headers)
    if(NOT header MATCHES "^([^/]+)/(([^/]+)/)?")
        continue()  # an umbrella
    endif()
    set(floor ${CMAKE_MATCH_1})
    set(allowed ${${floor}_may_include})
    set(drive "")
    if(header MATCHES "^drives/([^/]+)/")
        set(drive ${CMAKE_MATCH_1})
    endif()
    if(drive)
        list(APPEND allowed drives/${drive})
    elseif(NOT allowed)
        string(APPEND violations "  ${header}: no floor holds this header\n")
        continue()
    endif()

    file(STRINGS ${INCLUDE_DIR}/${header} includes REGEX "^[ \t]*#[ \t]*include")
    foreach(include IN LISTS includes)
        if(include MATCHES "<drivecodec/version\\.hpp>")
            continue()
        elseif(floor STREQUAL drives AND include MATCHES "<drivecodec/drives/[^/>]+>")
            continue()
        elseif(include MATCHES "<drivecodec/(drives/[^/>]+|[^/>]+)/")
            set(target ${CMAKE_MATCH_1})
            if(NOT floor STREQUAL drives)  # above the drives, one drive is like another
                string(REGEX REPLACE "/.*" "" target ${target})
            endif()
            if(NOT target IN_LIST allowed)
                string(APPEND violations "  ${header}: '${floor}' may not include '${target}'\n")
            endif()
        elseif(include MATCHES "<drivecodec/([^>]*)>")
            string(APPEND violations "  ${header}: only users include the umbrella '${CMAKE_MATCH_1}'\n")
        elseif(include MATCHES "\"")
            string(APPEND violations "  ${header}: write ${include} as <drivecodec/...>\n")
        elseif(include MATCHES "<([^>]+)>" AND CMAKE_MATCH_1 IN_LIST too_heavy AND NOT floor STREQUAL text)
            string(APPEND violations "  ${header}: <${CMAKE_MATCH_1}> is too heavy for firmware\n")
        endif()
    endforeach()
endforeach()
if(violations)
    message(FATAL_ERROR "the floors are broken:\n${violations}")
endif()
