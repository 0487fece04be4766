#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The headers and the examples that use them compile without a warning in every standard that the compiler knows from C++20 on, with
# the flags of cmake/development.cmake and, by g++, -Wuseless-cast: a cast between two names of one type.
#
#     standards.sh COMPILER
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
includes=
for package in harfbuzz freetype2 fontconfig icu-uc; do
    folders=$(pkg-config --cflags-only-I "$package" 2>/dev/null) || { echo "left out: $package" && continue; }
    for folder in $folders; do includes="$includes -isystem ${folder#-I}"; done
done
for header in "$root"/include/typemesh/*.hpp "$root"/include/typemesh/adapt/*.hpp "$root"/include/typemesh/adapt/*/*.hpp \
    "$root"/include/typemesh/paragraph/paragraph.hpp; do
    case $header in
        *directwrite* | *gdi*) continue ;;
        *fontconfig*) pkg-config --exists fontconfig || continue ;;
        *icu*) pkg-config --exists icu-uc || continue ;;
    esac
    [ ! -e "$header" ] || echo "#include \"$header\""
done >"$scratch/all.cpp"
flags="-Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror"
! "$1" --version | grep -q 'Free Software' || flags="$flags -Wuseless-cast"
failed=0
for standard in c++20 c++23 c++26; do
    echo 'int main() {}' >"$scratch/empty.cpp"
    "$1" -std=$standard -fsyntax-only "$scratch/empty.cpp" 2>/dev/null || standard=$(echo $standard | sed 's/23/2b/; s/26/2c/')
    "$1" -std=$standard -fsyntax-only "$scratch/empty.cpp" 2>/dev/null || { echo "left out: $standard" && continue; }
    for file in "$scratch/all.cpp" "$root/examples/03_own_vertex.cpp" "$root/examples/04_own_policy.cpp" \
        "$root/examples/07_workers_and_chunks.cpp" "$root/examples/09_many_fonts.cpp" "$root/examples/10_bevelled_word.cpp"; do
        # shellcheck disable=SC2086  # words
        "$1" -std=$standard $flags -I"$root/include" $includes -fsyntax-only "$file" ||
            { echo "failed: $standard, $(basename "$file")" && failed=1; }
    done
    echo "$standard"
done
exit $failed
