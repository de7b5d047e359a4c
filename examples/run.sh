#!/bin/sh
# Builds the examples from a bare checkout and runs them.
set -eu
cd "$(dirname "$0")/.."
sh tests/setup.sh g++=g++ cmake=cmake ninja=ninja-build
cmake -S . -B build/examples -G Ninja -DCMAKE_BUILD_TYPE=Release -DDRIVECODEC_BUILD_TESTS=OFF >/dev/null
cmake --build build/examples >/dev/null

for source in examples/*.cpp; do
    [ -e "$source" ] || continue
    name=$(basename "$source" .cpp)
    case $name in modbus_*) continue ;; esac
    echo "== $name"
    "build/examples/examples/$name"
done
