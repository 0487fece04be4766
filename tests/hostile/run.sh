#!/bin/sh
# SPDX-License-Identifier: MIT
#
#     tests/hostile/run.sh [FOLDER] [GLYPHS]     FOLDER: of hostile fonts; else that in TYPEMESH_HOSTILE_FONTS
#
# Builds every_font.cpp with clang++ and the address and undefined-behaviour sanitizers and runs it over the folder's
# files: all glyphs, or at most GLYPHS of each. CXX: another compiler.
set -eu
case ${1:-} in
    -h | --help) sed -n '3,7s/^# \{0,1\}//p' "$0" && exit 0 ;;
esac
here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
folder=${1:-${TYPEMESH_HOSTILE_FONTS:-}}
[ -n "$folder" ] || { echo "Skipped: TYPEMESH_HOSTILE_FONTS names no folder of hostile fonts." && exit 77; }
build=$root/build/hostile
mkdir -p "$build"
# shellcheck disable=SC2046  # several words
"${CXX:-clang++}" -std=c++20 -O1 -g1 -fsanitize=address,undefined -fno-sanitize-recover=all -I"$root/include" \
    -I"$root/tests" "$here/every_font.cpp" -o "$build/every_font" $(pkg-config --cflags --libs harfbuzz freetype2)
exec "$build/every_font" "$folder" ${2:+"$2"}
