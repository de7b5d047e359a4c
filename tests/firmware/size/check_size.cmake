# cmake -DNAME= -DELF= -DREFERENCE= -DSIZE= -DBUDGET= [-DEXACT=ON] -P check_size.cmake
#
# How many bytes of flash and of static RAM the first image has more than the second one: at most BUDGET (exactly, if
# EXACT), and none.
cmake_minimum_required(VERSION 3.25)

function(measure elf)
    execute_process(COMMAND ${SIZE} ${elf} OUTPUT_VARIABLE size COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCH "\n *([0-9]+)[\t ]+([0-9]+)[\t ]+([0-9]+)" _ "${size}")
    math(EXPR flash "${CMAKE_MATCH_1} + ${CMAKE_MATCH_2}")
    math(EXPR ram   "${CMAKE_MATCH_2} + ${CMAKE_MATCH_3}")
    return(PROPAGATE flash ram)
endfunction()

# A line for bench/figures.sh.
function(report what value bound budget)
    set(verdict ok)
    if(value GREATER budget OR (bound STREQUAL "exactly" AND NOT value EQUAL budget))
        set(verdict MISSED)
        set(missed TRUE)
    endif()
    set(line "figure|${NAME}: ${what}|${value} B|${bound} ${budget} B|${verdict}")
    execute_process(COMMAND ${CMAKE_COMMAND} -E echo ${line})
    return(PROPAGATE missed)
endfunction()

measure(${REFERENCE})
set(reference_flash ${flash})
set(reference_ram   ${ram})
measure(${ELF})
math(EXPR flash "${flash} - ${reference_flash}")
math(EXPR ram   "${ram} - ${reference_ram}")

if(EXACT)
    set(bound "exactly")
else()
    set(bound "at most")
endif()
report("flash" ${flash} ${bound} ${BUDGET})
report("static RAM" ${ram} "exactly" 0)
if(missed)
    message(FATAL_ERROR "over its budget")
endif()
