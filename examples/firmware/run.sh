#!/bin/sh
# Builds the firmware example for a Cortex-M0 and runs it in QEMU. Exit status: that of its main().
#
#   sh examples/firmware/run.sh
set -eu
cd "$(dirname "$0")/../.."

sh tests/setup.sh cmake=cmake ninja=ninja-build qemu-system-arm=qemu-system-arm \
    arm-none-eabi-g++=gcc-arm-none-eabi '/usr/include/newlib/c++/*/span=libstdc++-arm-none-eabi-newlib'
build=build/examples-firmware
cmake -S . -B "$build" -G Ninja --no-warn-unused-cli --toolchain tests/toolchains/arm-none-eabi.cmake \
    -DDRIVECODEC_BUILD_TESTS=OFF >/dev/null
cmake --build "$build" >/dev/null
image=$build/examples/firmware/drive_control.microbit.elf
arm-none-eabi-size "$image"
exec qemu-system-arm -M microbit -display none -serial null -monitor none \
    -semihosting-config enable=on,target=native -kernel "$image"
