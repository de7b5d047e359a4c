# drivecodec_firmware(name board source... [TEXT_MAX bytes] [DATA_MAX bytes] [BSS_MAX bytes] [NO_TESTS])
#
# An image NAME.BOARD without C start files, heap, exceptions and RTTI; a test of its symbols and its size; and, where
# QEMU is installed, a run: main() returns 0 for success. More options are set on the target NAME.BOARD afterwards.

set(firmware_dir ${CMAKE_CURRENT_LIST_DIR})
find_program(QEMU_SYSTEM_ARM qemu-system-arm)
find_program(ARM_SIZE arm-none-eabi-size REQUIRED)

#   QEMU's board      processor  flash           RAM
set(board_microbit    cortex-m0  0x00000000 256K 0x20000000 16K)
set(board_mps2-an385  cortex-m3  0x00000000 4M   0x20000000 4M)
set(board_mps2-an505  cortex-m33 0x10000000 4M   0x38000000 4M)

function(drivecodec_firmware name board)
    cmake_parse_arguments(PARSE_ARGV 2 image "NO_TESTS" "TEXT_MAX;DATA_MAX;BSS_MAX" "")
    list(GET board_${board} 0 processor)
    list(GET board_${board} 1 flash_origin)
    list(GET board_${board} 2 flash_size)
    list(GET board_${board} 3 ram_origin)
    list(GET board_${board} 4 ram_size)

    set(target ${name}.${board})
    add_executable(${target} ${firmware_dir}/startup.cpp ${image_UNPARSED_ARGUMENTS})
    target_include_directories(${target} PRIVATE ${firmware_dir})
    target_link_libraries(${target} PRIVATE drivecodec_dev c gcc)
    target_compile_options(${target} PRIVATE -mcpu=${processor} -mthumb -Os
        -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffunction-sections -fdata-sections
        -fstack-usage -Wstack-usage=512)
    target_link_options(${target} PRIVATE -mcpu=${processor} -mthumb -nostdlib --specs=nano.specs
        -T ${firmware_dir}/cortexm.ld -Wl,--gc-sections,--fatal-warnings,-Map=${target}.map
        -Wl,--defsym=FLASH_ORIGIN=${flash_origin},--defsym=FLASH_SIZE=${flash_size}
        -Wl,--defsym=RAM_ORIGIN=${ram_origin},--defsym=RAM_SIZE=${ram_size})
    set_target_properties(${target} PROPERTIES SUFFIX .elf LINK_DEPENDS ${firmware_dir}/cortexm.ld)

    if(image_NO_TESTS)
        return()
    endif()
    foreach(budget TEXT_MAX DATA_MAX BSS_MAX)
        if(DEFINED image_${budget})
            list(APPEND budgets -D${budget}=${image_${budget}})
        endif()
    endforeach()
    add_test(NAME firmware.symbols.${target} COMMAND ${CMAKE_COMMAND} -DELF=$<TARGET_FILE:${target}>
        -DNM=${CMAKE_NM} -DSIZE=${ARM_SIZE} ${budgets} -P ${firmware_dir}/check_symbols.cmake)
    if(QEMU_SYSTEM_ARM)
        add_test(NAME firmware.run.${target} COMMAND ${QEMU_SYSTEM_ARM} -M ${board} -display none -serial null
            -monitor none -semihosting-config enable=on,target=native -kernel $<TARGET_FILE:${target}>)
        set_tests_properties(firmware.run.${target} PROPERTIES TIMEOUT 30)
    endif()
endfunction()
