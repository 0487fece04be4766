#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Every glyph of every face of the fonts of tests/workload/smoke-fonts.tsv and the glyphs of nasty-glyphs.tsv, against
# the laws of glyph_laws.hpp, on all cores. Debian packages that are not installed are fetched (about 83 MB for the
# nasty glyphs) and unpacked under build/every_glyph; nothing is installed.
#
#     tests/every_glyph/run.sh                      everything: smoke fonts, then nasty glyphs
#     tests/every_glyph/run.sh --quality high       more options: see every_glyph.cpp
#     tests/every_glyph/run.sh --only nasty         smoke, nasty, or the name of one package
#     tests/every_glyph/run.sh --program every_bevel    or every_offset, every_refined, every_plate, every_tube: the same
set -eu
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$root/build/every_glyph
fonts=$build/fonts
workload=$root/tests/workload

only=
program=every_glyph
options=()
while [ $# -gt 0 ]; do
    case $1 in
        --only) only=$2 && shift ;;
        --program) program=$2 && shift ;;
        -h | --help) sed -n '3,12s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 0 ;;
        *) options+=("$1") ;;
    esac
    shift
done

mkdir -p "$build"
cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DTYPEMESH_BUILD_BENCH=OFF -DTYPEMESH_BUILD_EXAMPLES=OFF \
    -DTYPEMESH_TEST_ROOMS=every_glyph >"$build/log" 2>&1 || { cat "$build/log" >&2 && exit 1; }
cmake --build "$build" --target "typemesh_$program" >"$build/log" 2>&1 || { cat "$build/log" >&2 && exit 1; }

# unpacked PACKAGE: its files lie under $fonts/PACKAGE afterwards.
unpacked() {
    [ -d "$fonts/$1" ] && return
    mkdir -p "$fonts/tmp"
    (cd "$fonts/tmp" && apt-get download "$1" >/dev/null) || { echo "The package $1 cannot be fetched." >&2 && exit 1; }
    dpkg -x "$fonts/tmp/$1"_*.deb "$fonts/$1.part"
    mv "$fonts/$1.part" "$fonts/$1"
    rm -f "$fonts/tmp/$1"_*.deb
}

wanted=()
while IFS=$'\t' read -r package _; do
    [ "$package" != debian_package ] || continue
    [ -z "$only" ] || [ "$only" = smoke ] || [ "$only" = "$package" ] || continue
    unpacked "$package"
    wanted+=("$package=$fonts/$package")
done <"$workload/smoke-fonts.tsv"
if [ -z "$only" ] || [ "$only" = nasty ]; then
    while IFS=$'\t' read -r package file face glyph _; do
        [ "$package" != debian_package ] || continue
        unpacked "$package"
        wanted+=("$package $glyph=$fonts/$package/$file@$face:$glyph")
    done <"$workload/nasty-glyphs.tsv"
fi
"$build/tests/typemesh_$program" ${options[@]+"${options[@]}"} "${wanted[@]}"
