#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Does every machine make the same meshes? Builds hashes.cpp, and the tests of some rooms of the core, with many compilers and for
# many processors, and runs them, foreign ones under qemu, Wine or node.
#
#     tests/machines/run.sh [--hashes] [--jobs N] [--table FILE] [NAME...]      all machines without a name; NAME: aarch64, say
#
#     --hashes   hashes only, no tests: some minutes
#     --jobs     of the compiler, where tests are built
#     --table    where the table goes; build/machines/table.md by default. It has the last run of each machine, whatever was
#                named; docs/machines.md is such a table
#
# All of it, with the tests, takes an hour or two.
#
# A hash that is another fails, unless `other` in the list of this script says that the machine may: where a compiler may fuse
# multiplication and addition, or takes floats as numbers (-ffast-math), or computes in 80 bits (x87). Hashes of the grid and of levels are integers
# all the way, and must be the same everywhere. What is missing is installed if it may be, or its machines are named and skipped.
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"
here=$typemesh_root/tests/machines work=$typemesh_root/build/machines
rooms="core;sweep;unicode;discretise;triangulate;vertex"
tests=yes table=$work/table.md names=
while [ $# -gt 0 ]; do
    case $1 in
        --hashes) tests= ;;
        --jobs) export CMAKE_BUILD_PARALLEL_LEVEL=$2 && shift ;;
        --table) table=$2 && shift ;;
        -h | --help) sed -n '3,19s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 0 ;;
        -*) stop "$1 is not an option: see --help" ;;
        *) names="$names $1" ;;
    esac
    shift
done

# One line a machine:
#   name | what it needs | compiler | flags | what runs its programs | may | words
# may: `same`, everything is; `other`, curves and floats may be others; a + behind it: the rooms' tests run, too.
machines() {
    cat <<'END'
x86-64-O0           | g++        | g++                        | -O0                                        |                                     | same   | x86-64, g++ -O0
x86-64-O2           | g++        | g++                        | -O2                                        |                                     | same+  | x86-64, g++ -O2
x86-64-O3           | g++        | g++                        | -O3                                        |                                     | same   | x86-64, g++ -O3
x86-64-native       | g++        | g++                        | -O3 -march=x86-64-v3                       |                                     | other  | x86-64 with fused multiply-add, g++ -O3 -march=x86-64-v3
x86-64-unfused      | g++        | g++                        | -O3 -march=x86-64-v3 -ffp-contract=off     |                                     | same   | the same, -ffp-contract=off
x86-64-fast         | g++        | g++                        | -O3 -ffast-math                            |                                     | other  | x86-64, g++ -O3 -ffast-math
clang-O0            | clang++    | clang++                    | -O0                                        |                                     | same   | x86-64, clang++ -O0
clang-O3            | clang++    | clang++                    | -O3                                        |                                     | same+  | x86-64, clang++ -O3
clang-native        | clang++    | clang++                    | -O3 -march=x86-64-v3                       |                                     | other  | x86-64 with fused multiply-add, clang++ -O3 -march=x86-64-v3
clang-unfused       | clang++    | clang++                    | -O3 -march=x86-64-v3 -ffp-contract=off     |                                     | same   | the same, -ffp-contract=off
clang-fast          | clang++    | clang++                    | -O3 -ffast-math                            |                                     | other  | x86-64, clang++ -O3 -ffast-math
libc++              | libc++     | clang++                    | -O2 -stdlib=libc++                         |                                     | same   | x86-64, clang++ -O2 with libc++
i686-sse            | i686       | i686-linux-gnu-g++         | -O2 -msse2 -mfpmath=sse                    |                                     | same+  | x86, 32 bits, SSE2, g++ -O2
i686-x87            | i686       | i686-linux-gnu-g++         | -O2                                        |                                     | other  | x86, 32 bits, x87, g++ -O2
aarch64             | aarch64 qemu | aarch64-linux-gnu-g++      | -O2                                        | qemu-aarch64 -L /usr/aarch64-linux-gnu | other | aarch64, g++ -O2
aarch64-unfused     | aarch64 qemu | aarch64-linux-gnu-g++      | -O2 -ffp-contract=off                      | qemu-aarch64 -L /usr/aarch64-linux-gnu | same+ | the same, -ffp-contract=off
armhf               | armhf qemu | arm-linux-gnueabihf-g++    | -O2                                        | qemu-arm -L /usr/arm-linux-gnueabihf | same+ | armhf, 32 bits, g++ -O2
riscv64             | riscv64 qemu | riscv64-linux-gnu-g++      | -O2                                        | qemu-riscv64 -L /usr/riscv64-linux-gnu | other | riscv64, g++ -O2
riscv64-unfused     | riscv64 qemu | riscv64-linux-gnu-g++      | -O2 -ffp-contract=off                      | qemu-riscv64 -L /usr/riscv64-linux-gnu | same+ | the same, -ffp-contract=off
s390x               | s390x qemu | s390x-linux-gnu-g++        | -O2                                        | qemu-s390x -L /usr/s390x-linux-gnu  | other  | s390x, which counts bytes the other way, g++ -O2
s390x-unfused       | s390x qemu | s390x-linux-gnu-g++        | -O2 -ffp-contract=off                      | qemu-s390x -L /usr/s390x-linux-gnu  | same+  | the same, -ffp-contract=off
windows             | mingw wine | x86_64-w64-mingw32-g++     | -O2 -static                                | wine                                | same   | Windows, x86-64, mingw-w64 g++ -O2
wasm                | emcc node  | em++                       | -O1 -sNODERAWFS=1 -sALLOW_MEMORY_GROWTH=1  | node --no-experimental-fetch        | same   | WebAssembly, em++ -O1
END
}

known=" $(machines | sed 's/ .*//' | tr '\n' ' ')"
for name in $names; do
    case $known in *" $name "*) ;; *) stop "There is no machine $name; there are:$known" ;; esac
done

trimmed() { sed 's/^ *//;s/ *$//' <<<"$1"; }
run_with() {  # run_with RUNNER PROGRAM ARGUMENT...
    local runner=$1
    shift
    # shellcheck disable=SC2086  # a list of words
    if [ "$runner" = wine ]; then
        env WINEPREFIX="$work/wine" WINEDEBUG=-all WINEDLLOVERRIDES='mscoree,mshtml=' DISPLAY= wine "$@"
    else
        $runner "$@"
    fi
}

# The rooms' tests; the number of those that pass goes to $told.
test_rooms() {  # test_rooms NAME COMPILER FLAGS RUNNER
    local build=$work/$1/tests log=$work/$1/tests.log
    # shellcheck disable=SC2086  # no runner is no list
    cmake -S "$typemesh_root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE= -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR="$1" \
        -DCMAKE_CXX_COMPILER="$2" -DCMAKE_CXX_FLAGS="$3" -DCMAKE_CROSSCOMPILING_EMULATOR="$(tr ' ' ';' <<<"$4")" \
        -DTYPEMESH_BUILD_EXAMPLES=OFF -DTYPEMESH_BUILD_BENCH=OFF -DTYPEMESH_TEST_EVERYTHING=OFF -DTYPEMESH_TEST_ROOMS="$rooms" \
        >"$log" 2>&1 && nice cmake --build "$build" --target typemesh_tests >>"$log" 2>&1 || { told="not built: $log" && return 1; }
    local status=0
    ctest --test-dir "$build" --output-on-failure >"$work/$1/ctest.log" 2>&1 || status=1
    told=$(sed -nE 's/^([0-9]+)% tests passed, ([0-9]+) tests failed out of ([0-9]+)$/\2 of \3 rooms failed/p' "$work/$1/ctest.log" |
        sed 's/^0 of \(.*\) rooms failed/\1 rooms passed/')
    return $status
}

row() {  # row HASHES TESTS: of the table
    mkdir -p "$work/$name" && printf '| %s | %s | %s |\n' "$words" "$1" "$2" >"$work/$name/row.md"
}

mkdir -p "$work" "$(dirname "$table")"
failed=0
while IFS='|' read -r name need compiler flags runner may words; do
    name=$(trimmed "$name") need=$(trimmed "$need") compiler=$(trimmed "$compiler") flags=$(trimmed "$flags")
    runner=$(trimmed "$runner") may=$(trimmed "$may") words=$(trimmed "$words")
    case " $names " in *" $name "* | "  ") ;; *) continue ;; esac
    # shellcheck disable=SC2086  # a list of words
    if ! (install_missing $need) >"$work/install.log" 2>&1 || ! command -v "$compiler" >/dev/null; then
        printf '%-16s skipped: %s is missing and cannot be installed\n' "$name" "$need"
        row "skipped: $need was not there" -
        continue
    fi
    mkdir -p "$work/$name"
    program=$work/$name/hashes
    case $compiler in em++) program=$program.js ;; *mingw*) program=$program.exe ;; esac
    # shellcheck disable=SC2086  # a list of words
    if ! "$compiler" -std=c++20 $flags -DNDEBUG -I"$typemesh_root/include" -I"$typemesh_root/tests" "$here/hashes.cpp" -o "$program" \
        >"$work/$name/compiler.log" 2>&1; then
        printf '%-16s NOT COMPILED: %s\n' "$name" "$(grep -m1 error "$work/$name/compiler.log")"
        row "not compiled" -
        failed=$((failed + 1))
        continue
    fi
    run_with "$runner" "$program" "$here" >"$work/$name/hashes.log" 2>&1 || true
    tr -d '\r' <"$work/$name/hashes.log" >"$work/$name/hashes.txt"
    all=$(grep -cE '^(same |OTHER)' "$work/$name/hashes.txt" || true)
    others=$(sed -n 's/^OTHER *[0-9]* numbers  //p' "$work/$name/hashes.txt")
    count=$(grep -c . <<<"$others" || true)
    verdict=good
    if [ "$all" -eq 0 ] || { [ "${may%+}" = same ] && [ "$count" -gt 0 ]; } || grep -qE '^(grid|text: levels)' <<<"$others"; then
        verdict=BAD failed=$((failed + 1))
    fi
    if [ "$all" -eq 0 ]; then said="did not run"; elif [ "$count" -eq 0 ]; then said="all $all"; else
        said="$((all - count)) of $all, not $(sed 's/:.*//' <<<"$others" | sort | uniq -c | awk '{ printf "%s%s of \"%s\"", (NR > 1 ? ", " : ""), $1, $2 }')"
    fi
    told=-
    if [ -n "$tests" ] && [ "${may%+}" != "$may" ]; then
        test_rooms "$name" "$compiler" "$flags" "$runner" || { verdict=BAD failed=$((failed + 1)); }
    fi
    printf '%-16s %s: %s; tests: %s\n' "$name" "$verdict" "$said" "$told"
    row "$said" "$told"
done < <(machines)
{
    printf '| machine | results with the hash of x86-64, g++ -O2 | tests of the core |\n|---|---|---|\n'
    while IFS='|' read -r name _; do
        name=$(trimmed "$name")
        [ ! -e "$work/$name/row.md" ] || cat "$work/$name/row.md"
    done < <(machines)
} >"$table"
say "The table is written: $table"
[ $failed = 0 ] || stop "$failed machines failed"
