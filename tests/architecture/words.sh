#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Turns of phrase that readers stumble over, in the pages and in the comments of the headers. words.txt says how many of
# each are left; the numbers only get smaller, and 0 stays 0.
#
#     words.sh [ROOT]      another copy of the tree
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$here/../..}"
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
# planted_bugs.md quotes the reasons of patches.
find README.md CONTRIBUTING.md docs examples bench tests -name '*.md' ! -name planted_bugs.md -exec cat {} + >"$scratch/pages"
find include -name '*.hpp' ! -name '*_table.hpp' -exec sed -n 's,^\(.*[^:"]\)\{0\,1\}//\(.*\),\2,p' {} + >"$scratch/headers"
sed '/^#/d' "$here/words.txt" | while read -r pages headers turn; do
    for place in pages headers; do
        limit=$pages && [ $place = pages ] || limit=$headers
        found=$(grep -ioE -- "$turn" "$scratch/$place" | wc -l)
        [ "$found" -le "$limit" ] || echo "$place: $found times \"$turn\", not $limit at most: say it in plainer words"
        [ "$found" -ge "$limit" ] || echo "$place: \"$turn\" is left $found times: lower the $limit in words.txt"
    done
done >"$scratch/wrong"
[ ! -s "$scratch/wrong" ] || { cat "$scratch/wrong" && exit 1; }
