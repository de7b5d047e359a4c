# cmake -DELF= -DNM= -DSIZE= [-DTEXT_MAX= -DDATA_MAX= -DBSS_MAX=] -P check_symbols.cmake
#
# No heap, exceptions, RTTI, global constructors or text output in the image, and no more bytes than its budget.
cmake_minimum_required(VERSION 3.25)

set(forbidden
    malloc calloc realloc _sbrk "operator new" "operator delete" abort printf
    __cxa_ _Unwind_ __gxx_personality __aeabi_unwind std::__throw_ std::terminate
    "typeinfo for" "vtable for" _GLOBAL__sub_I)
list(JOIN forbidden "|" forbidden)
execute_process(COMMAND ${NM} -C ${ELF} OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "[^\n]*(${forbidden})[^\n]*" found "${symbols}")
if(found)
    list(JOIN found "\n  " found)
    message(FATAL_ERROR "forbidden symbols in ${ELF}:\n  ${found}")
endif()

execute_process(COMMAND ${SIZE} ${ELF} OUTPUT_VARIABLE size COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCH "\n *([0-9]+)[\t ]+([0-9]+)[\t ]+([0-9]+)" _ "${size}")
set(TEXT ${CMAKE_MATCH_1})
set(DATA ${CMAKE_MATCH_2})
set(BSS  ${CMAKE_MATCH_3})
message(STATUS "text ${TEXT}, data ${DATA}, bss ${BSS} bytes")
foreach(section TEXT DATA BSS)
    if(DEFINED ${section}_MAX AND ${section} GREATER ${section}_MAX)
        message(FATAL_ERROR "${section} is ${${section}} bytes, its budget ${${section}_MAX}")
    endif()
endforeach()
