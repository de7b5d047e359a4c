#!/bin/sh
# Builds and runs every test that this machine can run with g++ alone; .ci/run does the rest.
set -eu
cd "$(dirname "$0")/.."
sh tests/setup.sh g++=g++ cmake=cmake ninja=ninja-build pkg-config=pkg-config \
    /usr/include/gtest/gtest.h=libgtest-dev
exec cmake --workflow --preset gcc
