#!/bin/sh
# SPDX-License-Identifier: MIT
#
# typemesh.hpp is light to include: of the standard library it takes what standard_headers.txt names, and of the library
# nothing of inspect/, which is for tests, nor of compat/ and adapt/, which are for some.
#
#     umbrella.sh [FOLDER]      of headers; include without it
set -eu
here=$(cd "$(dirname "$0")" && pwd)
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
cd "${1:-$here/../../include}"

# All headers that are reached; what stands under an #if does not count.
echo typemesh/typemesh.hpp >"$scratch/new"
: >"$scratch/seen"
while [ -s "$scratch/new" ]; do
    sort -u "$scratch/seen" "$scratch/new" >"$scratch/all" && mv "$scratch/all" "$scratch/seen"
    tr '\n' '\0' <"$scratch/new" | xargs -0 awk '
        FNR == 1 { conditional = 0 }
        /^#[ \t]*if/ { ++conditional }
        /^#[ \t]*endif/ { --conditional }
        /^#[ \t]*include/ && !conditional { gsub(/^#[ \t]*include[ \t]*[<"]|[>"].*$/, ""); print }' >"$scratch/included"
    grep -v / "$scratch/included" >>"$scratch/standard" || true
    grep / "$scratch/included" | sort -u | comm -13 "$scratch/seen" - >"$scratch/new"
done

status=0
sort -u "$scratch/standard" >"$scratch/is"
grep -v '^#' "$here/standard_headers.txt" | sort >"$scratch/was"
comm -23 "$scratch/is" "$scratch/was" | sed 's,.*,typemesh.hpp now includes <&>: do without it,' | grep . && status=1
comm -13 "$scratch/is" "$scratch/was" | sed 's,.*,typemesh.hpp no longer includes <&>: take it out of standard_headers.txt,' | grep . && status=1
grep -E '^typemesh/(inspect|compat|adapt)/' "$scratch/seen" | sed 's,.*,typemesh.hpp includes &,' | grep . && status=1
echo "headers: $(grep -c . "$scratch/seen"), lines: $(tr '\n' '\0' <"$scratch/seen" | xargs -0 cat | grep -c .)"
exit $status
