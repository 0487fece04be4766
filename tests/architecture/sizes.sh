#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Headers of at most 500 lines, functions of at most 60, parameter lists of at most 6, at most 5 macros. What was longer
# when these limits came stands in size_exceptions.txt, which only gets shorter.
#
#     sizes.sh [FOLDER]      of headers; include/typemesh without it
set -eu
here=$(cd "$(dirname "$0")" && pwd)
headers=${1:-$here/../../include/typemesh}
max_lines=500 max_function_lines=60 max_parameters=6 max_macros=5
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT

# The reader of functions itself, tried with forms that are hard to read.
cat >"$scratch/wanted" <<'END'
sample.hpp declared_0_2 0 2
sample.hpp short_1_0 1 0
sample.hpp constrained_7_3 7 3
sample.hpp thing 4 2
sample.hpp thing 1 1
sample.hpp ~thing 0 0
sample.hpp operator== 0 1
sample.hpp operator< 1 1
sample.hpp operator_call 8 3
sample.hpp befriended_3_1 3 1
END
(cd "$here" && awk -f functions.awk sample.hpp) >"$scratch/seen"
diff "$scratch/wanted" "$scratch/seen" || { echo "functions.awk no longer reads sample.hpp" && exit 1; }

cd "$headers"
find . -name '*.hpp' | sed 's,^\./,,' | sort >"$scratch/files"
of_all_headers() { tr '\n' '\0' <"$scratch/files" | xargs -0 "$@"; }
of_all_headers awk -f "$here/functions.awk" >"$scratch/functions"
of_all_headers awk '{ ++lines[FILENAME] } END { for (f in lines) print f, lines[f] }' >"$scratch/lines"
of_all_headers sed -nE 's/^[ \t]*#[ \t]*define[ \t]+([A-Za-z_0-9]+).*/\1/p' | sort -u >"$scratch/macros"

# MEASURE FILE NAME SIZE LIMIT of all that is measured, the largest of functions of one name.
{
    awk -v limit=$max_lines '{ print "header", $1, "-", $2, limit }' "$scratch/lines"
    awk -v limit=$max_function_lines '{ print "lines", $1, $2, $3, limit }' "$scratch/functions"
    awk -v limit=$max_parameters '{ print "parameters", $1, $2, $4, limit }' "$scratch/functions"
} | sort -k 1,3 -k 4,4nr | awk '!seen[$1, $2, $3]++' >"$scratch/sizes"

status=0
awk '
    exceptions { if (NF && $1 !~ /^#/) allowed[$1 " " $2 " " $3] = $4; next }
    { key = $1 " " $2 " " $3 }
    key in allowed {
        if ($4 > allowed[key]) { print key ": " $4 " instead of the " allowed[key] " of size_exceptions.txt"; bad = 1 }
        if ($4 <= $5) { print key ": " $4 " keeps the limit of " $5 ": take it out of size_exceptions.txt"; bad = 1 }
        delete allowed[key]
        next
    }
    $4 > $5 { print key ": " $4 ", more than " $5; bad = 1 }
    END {
        for (key in allowed) { print key ": is no more: take it out of size_exceptions.txt"; bad = 1 }
        exit bad
    }' exceptions=1 "$here/size_exceptions.txt" exceptions=0 "$scratch/sizes" || status=1
if [ "$(grep -c . "$scratch/macros")" -gt $max_macros ]; then
    echo "More than $max_macros macros:" && cat "$scratch/macros"
    status=1
fi
for what in files functions macros; do echo "$what: $(grep -c . "$scratch/$what")"; done
exit $status
