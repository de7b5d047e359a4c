#!/bin/sh
# Builds and runs every test that this machine can run with g++ alone; .ci/run does the rest.
set -eu
cd "$(dirname "$0")/.."
sh tests/setup.sh g++=g++ cmake=cmake ninja=ninja-build pkg-config=pkg-config \
    /usr/include/gtest/gtest.h=libgtest-dev \
    mbpoll=mbpoll tshark=tshark /usr/bin/python3=python3 \
    /usr/lib/python3/dist-packages/pymodbus=python3-pymodbus \
    /usr/lib/python3/dist-packages/serial_asyncio=python3-serial-asyncio
exec cmake --workflow --preset gcc
