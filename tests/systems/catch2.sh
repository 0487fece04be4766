#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Do the tests compile with Catch2 3? Only the older one is installed where this is of use: the headers of Debian 13's are fetched
# and unpacked, and clang++ reads every test with them. Nothing is linked, for that library is made by another compiler.
#
#     tests/systems/catch2.sh FOLDER [FILE...]     FOLDER keeps what is fetched; FILE: tests, all of them but tests/windows without
#
# Ends with 77 and a reason where it is skipped. TYPEMESH_CATCH2_SUITE: another Debian than trixie.
set -u
tests=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$tests/systems/debian.bash"
mkdir -p "$1" && folder=$(cd "$1" && pwd) || exit 1
shift
cd "$tests" || exit 1
skip() { printf 'skipped: %s\n' "$*" && exit 77; }
compiler=${CXX:-clang++}
command -v "$compiler" >/dev/null || skip "there is no $compiler"
if [ ! -e "$folder/fetched" ]; then
    reason=$(unpack_packages "$folder/catch2" "${TYPEMESH_CATCH2_SUITE:-trixie}" libcatch2-dev 2>&1 >/dev/null) ||
        skip "Catch2 3 could not be fetched: $reason"
    touch "$folder/fetched"
fi
[ $# -gt 0 ] || set -- $(ls ./*/*.test.cpp | sed '/windows/d;s,^[.]/,,')
[ $# -gt 0 ] || { echo "no tests were found" && exit 1; }

flags=(-std=c++20 -w -isystem "$folder/catch2/root/usr/include" -I. -I../include -I../examples
    -I../examples/text_to_mesh -DTYPEMESH_TEST_DATA='""' -DTYPEMESH_TEXT_TO_MESH='""')
for package in harfbuzz freetype2 fontconfig icu-uc; do
    # shellcheck disable=SC2207  # words
    flags+=($(pkg-config --cflags-only-I "$package" 2>/dev/null | sed 's/-I/-isystem /g'))
done
for name in fontconfig icu; do [ ! -e "/usr/include/$name" ] && [ $name != icu ] || flags+=(-DTYPEMESH_TEST_WITH_${name^^}); done

# What nearly all of them read is read once. Not by those that set macros before it, or that have names like the library's.
apart='^(asserts|compiled|core)/|without_'
printf '#include "support/catch.hpp"\n' >"$folder/few.hpp"
printf '#include "%s"\n' support/catch.hpp support/toy_font.hpp support/counting_memory.hpp support/font_file.hpp \
    typemesh/adapt/harfbuzz.hpp typemesh/paragraph/paragraph.hpp typemesh/typemesh.hpp >"$folder/all.hpp"
for name in few all; do
    "$compiler" "${flags[@]}" -x c++-header -fpch-instantiate-templates "$folder/$name.hpp" -o "$folder/$name.pch" || exit 1
done

compiles() {  # compiles PRECOMPILED FILE
    local flag=
    ! [[ $2 == compiled/* ]] || flag=-DTYPEMESH_COMPILED
    "$compiler" "${flags[@]}" $flag -fsyntax-only -include-pch "$folder/$1.pch" "$2"
}
failed=0
# Several at a time, which is quicker; where that fails, as where two files use one name, half of them at a time.
read_batch() {  # read_batch FILE...
    local precompiled=all
    [ $# -gt 0 ] || return 0
    ! grep -qE "$apart" <<<"$1" || precompiled=few
    if [ $# = 1 ]; then
        compiles $precompiled "$1" >"$folder/file.log" 2>&1 || compiles few "$1" ||
            { echo "failed: tests/$1" && failed=$((failed + 1)); }
        return 0
    fi
    printf '#include "%s"\n' "$@" >"$folder/batch.cpp"
    compiles $precompiled "$folder/batch.cpp" >"$folder/batch.log" 2>&1 && return 0
    read_batch "${@:1:$#/2}"
    read_batch "${@:$#/2+1}"
}
size_of() { if grep -qE '^(adapt|asserts|examples|inspect|stranger|unicode|vertex)/' <<<"$1"; then echo 3; else echo 12; fi; }
batch=()
for file in "$@"; do
    if [ ${#batch[@]} -gt 0 ] && { [ ${#batch[@]} -ge "$(size_of "$file")" ] || [ "${batch[0]%%/*}" != "${file%%/*}" ]; }; then
        read_batch "${batch[@]}"
        batch=()
    fi
    batch+=("$file")
done
read_batch ${batch[@]+"${batch[@]}"}
version=$(sed -nE 's/^# *define CATCH_VERSION_(MAJOR|MINOR|PATCH) ([0-9]+)$/\2/p' "$folder"/catch2/root/usr/include/catch2/catch_version_macros.hpp | paste -sd.)
echo "$# tests read with Catch2 $version, $failed failed"
[ $failed = 0 ]
