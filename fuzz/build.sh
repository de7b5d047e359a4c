#!/bin/bash
# Builds the fuzzers into $OUT: what OSS-Fuzz and ClusterFuzzLite call, with their $CXX, $CXXFLAGS and
# $LIB_FUZZING_ENGINE. Without these variables: libFuzzer with Clang, into build/fuzzers.
set -euo pipefail

root=$(cd "$(dirname "$0")/.." && pwd)
out=${OUT:-$root/build/fuzzers}
work=${WORK:-$root/build}/fuzz-out
export CXX=${CXX:-clang++}
export CXXFLAGS=${CXXFLAGS:--O1 -g1 -fno-omit-frame-pointer -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all}

cmake -S "$root" -B "$work" -G Ninja -DCMAKE_BUILD_TYPE=None \
    -DDRIVECODEC_BUILD_TESTS=OFF -DDRIVECODEC_BUILD_EXAMPLES=OFF -DDRIVECODEC_BUILD_FUZZ=ON \
    -DDRIVECODEC_FUZZ_ENGINE="${LIB_FUZZING_ENGINE:--fsanitize=fuzzer}"
cmake --build "$work" --target fuzzers

mkdir -p "$out"
for fuzzer in "$work"/fuzz/fuzz.*; do
    [ -x "$fuzzer" ] || continue
    name=$(basename "$fuzzer")
    path=${name#fuzz.}
    cp "$fuzzer" "$out/"
    printf '[libfuzzer]\nmax_len = 600\ntimeout = 5\n' >"$out/$name.options"
    if [ -f "$root/fuzz/dict/${path%%.*}.dict" ]; then cp "$root/fuzz/dict/${path%%.*}.dict" "$out/$name.dict"; fi
    if command -v zip >/dev/null; then (cd "$root/fuzz/corpus/${path//.//}" && zip -qr "$out/${name}_seed_corpus.zip" .); fi
    echo "$out/$name"
done
