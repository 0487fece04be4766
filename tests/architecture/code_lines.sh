#!/bin/sh
# SPDX-License-Identifier: MIT
#
# How many lines of code the headers have, room by room: without comments, blank lines and the tables that
# scripts make. All together must not be more than the limit: who raises it says in the commit what for.
#
#     code_lines.sh [FOLDER]      of headers; include/typemesh without it
set -eu
here=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$here/../../include/typemesh}"
find . -name '*.hpp' ! -name '*_table.hpp' | sed 's,^\./,,' | LC_ALL=C sort | tr '\n' '\0' | xargs -0 awk -v limit=57200 '
    FNR == 1 { room = FILENAME; if (!sub(/\/.*/, "", room)) room = "typemesh.hpp"; comment = 0 }
    {
        line = $0
        if (comment) { if (!sub(/^.*\*\//, "", line)) next; comment = 0 }
        gsub(/"(\\.|[^"\\])*"/, "0", line)
        sub(/\/\/.*/, "", line)
        gsub(/\/\*([^*]|\*[^\/])*\*\//, " ", line)
        if (sub(/\/\*.*/, "", line)) comment = 1
        if (line ~ /^[ \t]*$/) next
        ++lines[room]
        ++all
    }
    END {
        for (room in lines) print room, lines[room] | "sort"
        close("sort")
        print "all " all
        if (all > limit) { print "more than " limit; exit 1 }
    }'
