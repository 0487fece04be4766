#!/bin/sh
# SPDX-License-Identifier: MIT
#
#     tests/fuzz/run.sh [TARGET] [MINUTES]      one target, or all one after the other: "all"; 5 minutes each
#
# Builds tests/fuzz/TARGET.hpp with clang++ and libFuzzer, address and undefined-behaviour sanitizers, and runs it. What it
# finds is made small and written to tests/corpus/fuzz/TARGET, which the ordinary tests replay: commit it with its mending.
# The inputs that reach new code are kept in build/fuzz. Prints executions, coverage and findings of each target; fails if
# there are findings. CXX: another clang++. TYPEMESH_FUZZ_FLAGS: further flags of libFuzzer, such as -max_len=4096.
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
target=${1:-all}
minutes=${2:-5}
build=${TYPEMESH_FUZZ_BUILD:-$root/build/fuzz}
compiler=${CXX:-clang++}
mkdir -p "$build"
status=0

targets() {
    for test in "$root"/tests/fuzz/*.test.cpp; do basename "$test" .test.cpp; done
}

compile() {
    libraries=
    if grep -q 'typemesh/adapt/' "$root/tests/fuzz/$1.hpp"; then libraries=$(pkg-config --cflags --libs harfbuzz freetype2); fi
    # shellcheck disable=SC2086  # several words
    "$compiler" -std=c++20 -O1 -g1 -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined \
        -I"$root/include" -I"$root/tests" "-DTYPEMESH_FUZZ_TARGET=$1" -include "$root/tests/fuzz/$1.hpp" \
        "$root/tests/fuzz/fuzzer.cpp" -o "$build/$1" $libraries
}

# from_hex FILE, to_hex FILE: as replay.hpp reads them
from_hex() {
    sed 's/#.*//' "$1" | tr -d ' \t\r\n' | tr a-f A-F | basenc --base16 -d
}
to_hex() {
    basenc --base16 -w 100 "$1" | tr A-F a-f
}

# The smallest input found that breaks the law of $2, in the corpus, under a name of its content.
keep() {
    small=$build/$1.small
    "$build/$1" -minimize_crash=1 -runs=20000 -timeout=20 "-exact_artifact_path=$small" "$2" >"$build/$1.minimised" 2>&1 || true
    [ -s "$small" ] || cp "$2" "$small"
    law=$("$build/$1" -timeout=20 "$small" 2>&1 | grep -m 1 -E '^BROKEN LAW|ERROR: |runtime error' || true)
    name=$(sha1sum "$small" | cut -c 1-12).hex
    mkdir -p "$root/tests/corpus/fuzz/$1"
    { echo "# $law" | cut -c 1-110 && to_hex "$small"; } >"$root/tests/corpus/fuzz/$1/$name"
    rm -f "$small"
    echo "    $name  $law"
}

run() {
    compile "$1"
    corpus=$build/corpus/$1
    found=$build/found/$1
    rm -rf "$found"
    mkdir -p "$corpus" "$found"
    for kept in "$root/tests/corpus/fuzz/$1"/*.hex; do
        [ ! -e "$kept" ] || from_hex "$kept" >"$corpus/$(basename "$kept" .hex)"
    done
    # shellcheck disable=SC2086  # several words
    (cd "$build" && "$build/$1" "$corpus" "-max_total_time=$((60 * minutes))" "-artifact_prefix=$found/" -max_len=256 -timeout=20 \
        -rss_limit_mb=3000 -fork=1 -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1 ${TYPEMESH_FUZZ_FLAGS:-} >"$build/$1.log" 2>&1) || true
    last=$(grep -E '^#[0-9]+: cov:' "$build/$1.log" | tail -n 1)
    executions=$(echo "$last" | sed -n 's/^#\([0-9]*\):.*/\1/p')
    coverage=$(echo "$last" | sed -n 's/.* cov: \([0-9]*\) .*/\1/p')
    number=$(find "$found" -type f | wc -l)
    printf '%-12s %3d minutes  %11s executions  %7s edges covered  %5s inputs kept  %3d findings\n' \
        "$1" "$minutes" "${executions:-0}" "${coverage:-0}" "$(find "$corpus" -type f | wc -l)" "$number"
    [ "$number" -eq 0 ] || status=1
    find "$found" -type f | LC_ALL=C sort | head -n 5 | while read -r input; do keep "$1" "$input"; done  # often the same one
}

for name in $(targets); do
    case $target in all | "$name") run "$name" ;; esac
done
[ "$target" = all ] || [ -e "$root/tests/fuzz/$target.hpp" ] || { echo "tests/fuzz/$target.hpp: no such target" && exit 2; }
exit $status
