#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Turns of phrase that readers stumble over, in the pages and in the comments of the headers. words.txt counts what is
# left of each; the numbers only get smaller, and 0 stays 0. Messages, examples and scripts have none at all: the strings
# of headers, examples and benchmarks, the comments of examples, and whole scripts.
#
#     words.sh [ROOT]      another copy of the tree
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$here/../..}"
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
# planted_bugs.md quotes the reasons of patches.
find README.md CONTRIBUTING.md docs examples bench tests -name '*.md' ! -name planted_bugs.md -exec cat {} + >"$scratch/pages"
find include -name '*.hpp' ! -name '*_table.hpp' -exec sed -n 's,^\(.*[^:"]\)\{0\,1\}//\(.*\),\2,p' {} + >"$scratch/headers"
{
    find include examples bench \( -name '*.hpp' -o -name '*.cpp' \) ! -name '*_table.hpp' -exec grep -ohE '"([^"\\]|\\.)*"' {} +
    find examples \( -name '*.hpp' -o -name '*.cpp' \) -exec sed -n 's,^\(.*[^:"]\)\{0\,1\}//\(.*\),\2,p' {} +
    find examples \( -name '*.js' -o -name '*.mjs' -o -name '*.ts' -o -name '*.html' \) -exec cat {} +
    find cmake bench examples tests -name '*.sh' ! -name words.sh -exec cat {} +
} | grep -v '^"typemesh/' >"$scratch/programs"
sed '/^#/d' "$here/words.txt" | while read -r pages headers turn; do
    for place in pages headers programs; do
        case $place in pages) limit=$pages ;; headers) limit=$headers ;; programs) limit=0 ;; esac
        found=$(grep -ioE -- "$turn" "$scratch/$place" | wc -l)
        [ "$found" -le "$limit" ] || echo "$place: $found times \"$turn\", more than $limit: write it in plainer words"
        [ "$found" -ge "$limit" ] || echo "$place: \"$turn\" is left $found times: lower the $limit in words.txt"
    done
done >"$scratch/wrong"
[ ! -s "$scratch/wrong" ] || { cat "$scratch/wrong" && exit 1; }
