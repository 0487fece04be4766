#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Looks for input that breaks a law, with libFuzzer, address and undefined-behaviour sanitizers:
#
#     tests/fuzz/run.sh [TARGET] [MINUTES]      TARGET: tests/fuzz/TARGET.hpp, or all of them in turn; 5 minutes each, of
#                                               processor time: on a busy machine they take longer
#
# Installs what is missing, and needs clang++. A finding is tried again, made small and written to tests/corpus/fuzz/TARGET,
# which the ordinary tests replay: commit it with its mending. Each target's row of docs/fuzzing.md is written anew: the sum
# of its runs since its header was changed last. Fails if there are findings. Inputs that reach new code are kept in
# build/fuzz, or TYPEMESH_FUZZ_BUILD, and are where the next run begins; several targets may run at once.
# CXX: another clang++. TYPEMESH_FUZZ_FLAGS: further flags of libFuzzer, such as -max_len=4096.
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"
case ${1:-} in
    -h | --help) sed -n '3,14s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 0 ;;
esac
target=${1:-all}
minutes=${2:-5}
build=${TYPEMESH_FUZZ_BUILD:-$typemesh_root/build/fuzz}
compiler=${CXX:-clang++}
page=$typemesh_root/docs/fuzzing.md
slow_seconds=20  # of processor time, for one input
status=0

targets() {
    local test
    {
        for test in "$typemesh_root"/tests/fuzz/*.test.cpp; do basename "$test" .test.cpp; done
        echo svg  # tests/examples/svg_layers.test.cpp replays it
    } | LC_ALL=C sort
}

compile() {  # compile TARGET, if anything that it includes has changed
    local libraries= file
    if [ -x "$build/$1" ] && ! sed -e 's/^[^:]*://' -e 's/\\$//' "$build/$1.d" | tr -s ' ' '\n' | sed '/^$/d' |
        xargs -d '\n' sh -c 'for f; do [ "$f" -ot "$0" ] || echo "$f"; done' "$build/$1" | grep . >/dev/null; then
        return
    fi
    echo "$1: compiling"
    if grep -q 'typemesh/adapt/' "$typemesh_root/tests/fuzz/$1.hpp"; then
        libraries=$(pkg-config --cflags --libs harfbuzz freetype2)
    fi
    if grep -q 'text_to_mesh/svg' "$typemesh_root/tests/fuzz/$1.hpp"; then  # the program's reader, in the same unit
        libraries="-I$typemesh_root/examples -DTEXT_TO_MESH_PUGIXML -lpugixml"
        for file in values colour pen shapes style glyph reader; do
            libraries="$libraries -include $typemesh_root/examples/text_to_mesh/svg/svg_$file.cpp"
        done
    fi
    git -C "$typemesh_root" rev-parse --short=7 HEAD >"$build/$1.revision" 2>/dev/null || echo unknown >"$build/$1.revision"
    # shellcheck disable=SC2086  # several words
    "$compiler" -std=c++20 -O1 -g1 -MD -MF "$build/$1.d" -fsanitize=fuzzer,address,undefined -fno-sanitize-recover=undefined \
        -I"$typemesh_root/include" -I"$typemesh_root/tests" "-DTYPEMESH_FUZZ_TARGET=$1" \
        -include "$typemesh_root/tests/fuzz/$1.hpp" "$typemesh_root/tests/fuzz/fuzzer.cpp" -o "$build/$1" $libraries
}

# from_hex FILE, to_hex FILE: as replay.hpp reads them
from_hex() { sed 's/#.*//' "$1" | tr -d ' \t\r\n' | tr a-f A-F | basenc --base16 -d; }
to_hex() { basenc --base16 -w 100 "$1" | tr A-F a-f; }

fails() {  # fails TARGET INPUT: again, alone; what was slow only because the machine was busy does not
    ! (ulimit -t $slow_seconds && exec "$build/$1" -rss_limit_mb=3000 -timeout=0 "$2") >"$build/$1.again" 2>&1
}

# The smallest input found that breaks the same law, in the corpus, under a name of its content.
keep() {  # keep TARGET INPUT
    local small=$build/$1.small law name
    law=$(grep -m 1 -E '^BROKEN LAW|ERROR: |runtime error' "$build/$1.again" || echo "more than $slow_seconds s")
    rm -f "$small"
    case $law in
        more*) ;;
        *) "$build/$1" -minimize_crash=1 -max_total_time=60 -timeout=60 "-exact_artifact_path=$small" "$2" >"$build/$1.minimised" 2>&1 || true ;;
    esac
    if [ ! -s "$small" ] || ! fails "$1" "$small"; then cp "$2" "$small"; fi
    name=$(sha1sum "$small" | cut -c 1-12).hex
    echo "$law" >>"$build/$1.laws"
    mkdir -p "$typemesh_root/tests/corpus/fuzz/$1"
    { echo "# $law" | cut -c 1-110 && to_hex "$small"; } >"$typemesh_root/tests/corpus/fuzz/$1/$name"
    rm -f "$small"
    echo "    tests/corpus/fuzz/$1/$name  $law"
}

# The row of a target in the page's last table: where the names' order has it, in place of the one before.
write_row() {  # write_row TARGET ROW
    awk -v name="| \`$1\` |" -v row="$2" '
        /^\| target \| minutes / { in_table = 1 }
        in_table && index($0, name) == 1 { next }
        in_table && !written && (!/^\|/ || /^\| `/ && $0 > row) { print row; written = 1 }
        { print }
        END { if (!written) print row }' "$page" >"$build/page.md"
    cp "$build/page.md" "$page"
}

# Runs a target for some seconds of real time, at most; adds the processor's, and the executions, to spent and executions.
fuzz_for() {  # fuzz_for TARGET SECONDS
    local last
    # shellcheck disable=SC2086  # several words
    spent=$((spent + $( (cd "$build" && "./$1" "corpus/$1" "-max_total_time=$2" "-artifact_prefix=found/$1/" -max_len=256 \
        -timeout=$((10 * slow_seconds)) -rss_limit_mb=3000 -fork=1 -ignore_crashes=1 -ignore_timeouts=1 -ignore_ooms=1 \
        ${TYPEMESH_FUZZ_FLAGS:-} >"$1.log" 2>&1 || true; times) | tail -n 1 | tr ms '  ' |
        awk '{ printf "%d", 60 * $1 + $2 + 60 * $3 + $4 }')))
    last=$(grep -E '^#[0-9]+: cov:' "$build/$1.log" | tail -n 1)
    executions=$((executions + $(echo "${last:-#0:}" | sed 's/^#\([0-9]*\):.*/\1/')))
    coverage=$(echo "$last" | sed -n 's/.* cov: \([0-9]*\) .*/\1/p')
}

run() {  # run TARGET
    local corpus=$build/corpus/$1 found=$build/found/$1 kept spent=0 executions=0 coverage= input number=0 before sum version
    # The sums since the target's header was changed: seconds, executions; and which laws were broken.
    version=$(sha1sum <"$typemesh_root/tests/fuzz/$1.hpp" | cut -c 1-40)
    sum=$(sed -n "s/^$version //p" "$build/$1.sum" 2>/dev/null || true)
    [ -n "$sum" ] || rm -f "$build/$1.laws"
    (flock 9 && compile "$1") 9>"$build/compile.lock"  # one at a time: it takes more than a gigabyte
    rm -rf "$found"
    mkdir -p "$corpus" "$found"
    for kept in "$typemesh_root/tests/corpus/fuzz/$1"/*.hex; do
        [ ! -e "$kept" ] || from_hex "$kept" >"$corpus/$(basename "$kept" .hex)"
    done
    while [ $((60 * minutes - spent)) -gt 5 ]; do
        before=$spent
        fuzz_for "$1" $((60 * minutes - spent))
        [ "$spent" -gt "$before" ] || stop "$1 does not run: see $build/$1.log"
    done
    for input in "$found"/*; do
        if [ -e "$input" ] && fails "$1" "$input"; then
            number=$((number + 1))
            [ $number -gt 5 ] || keep "$1" "$input"  # often the same one
        fi
    done
    [ $number -eq 0 ] || status=1
    spent=$((spent + $(echo "${sum:-0 0}" | cut -d ' ' -f 1)))
    executions=$((executions + $(echo "${sum:-0 0}" | cut -d ' ' -f 2)))
    echo "$version $spent $executions" >"$build/$1.sum"
    number=0
    if [ -s "$build/$1.laws" ]; then number=$(sort -u "$build/$1.laws" | wc -l); fi
    (
        flock 9
        write_row "$1" "$(printf '| `%s` | %d | %d | %d | %d | %d | %s |' "$1" $(((spent + 30) / 60)) "$executions" \
            "${coverage:-0}" "$(find "$corpus" -type f | wc -l)" "$number" "$(cat "$build/$1.revision")")"
    ) 9>"$build/page.lock"
    grep -F "| \`$1\` |" "$page" | tail -n 1
}

[ "$target" = all ] || [ -e "$typemesh_root/tests/fuzz/$target.hpp" ] ||
    stop "tests/fuzz/$target.hpp: no such target; there are: $(targets | tr '\n' ' ')"
case $minutes in
    '' | *[!0-9]* | 0*) stop "$minutes is no number of minutes." ;;
esac
install_missing clang++ asan pkg-config harfbuzz freetype
case $target in all | svg) install_missing pugixml ;; esac
mkdir -p "$build"
grep -E '^\| target \| minutes ' "$page"
for name in $(targets); do
    case $target in all | "$name") run "$name" ;; esac
done
exit $status
