#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Every program of docs/recipes.md is at most 60 lines long, compiles without a warning, and runs: it says something, and returns 0.
# A program is left out where a font file that it names is not installed.
#
#     recipes.sh COMPILER [NUMBER...]      all programs, or those with these numbers, from 1
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
page=$root/docs/recipes.md
compiler=$1 && shift
flags="-std=c++20 -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror -O0"
most=60
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT

pkg-config --exists harfbuzz || { echo "left out: all programs, for pkg-config does not find HarfBuzz" && exit 0; }
includes=
for folder in $(pkg-config --cflags-only-I harfbuzz); do includes="$includes -isystem ${folder#-I}"; done
libraries=$(pkg-config --libs harfbuzz)

awk -v folder="$scratch" '
    /^```cpp$/ { file = sprintf("%s/%d.cpp", folder, ++count); printf "" >file; next }
    /^```/ { if (file != "") close(file); file = ""; next }
    file != "" { print >file }' "$page"
[ -e "$scratch/9.cpp" ] || { echo "docs/recipes.md holds fewer than nine programs: is it read correctly?" && exit 1; }
[ $# -gt 0 ] || set -- $(seq "$(find "$scratch" -name '*.cpp' | wc -l)")

failed=0
fail() { echo "failed: program $number, $1" && failed=1; }
for number; do
    program=$scratch/$number
    lines=$(wc -l <"$program.cpp")
    [ "$lines" -le $most ] || fail "which has $lines lines; $most are allowed"
    # shellcheck disable=SC2086  # words
    "$compiler" $flags -I"$root/include" $includes "$program.cpp" -o "$program" $libraries ||
        { fail "which does not compile" && continue; }
    missing=
    for file in $font $(grep -o '"/[^"]*\.[ot]t[cf]"' "$program.cpp" | tr -d '"'); do [ -e "$file" ] || missing="$missing $file"; done
    [ -z "$missing" ] || { echo "program $number compiles; it is not run, for there is no$missing" && continue; }
    mkdir "$program.run"
    code=0
    (cd "$program.run" && "$program" $font) >"$program.out" 2>&1 || code=$?
    sed "s/^/$number: /" "$program.out"
    [ $code -eq 0 ] || fail "which returns $code"
    [ -s "$program.out" ] || fail "which says nothing"
done
exit $failed
