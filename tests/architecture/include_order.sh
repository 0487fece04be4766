#!/bin/sh
# SPDX-License-Identifier: MIT
#
# The includes of a header: typemesh's own, a blank line, other libraries', a blank line, the standard's; sorted in each
# block. typemesh.hpp has a block for each room. What stands under an #if is not looked at. Files that are not so yet are
# named here; the list only gets shorter.
#
#     include_order.sh [FOLDER]      of headers; include/typemesh without it
set -eu
exceptions=""

cd "${1:-$(dirname "$0")/../../include/typemesh}"
# shellcheck disable=SC2016  # awk's
find . -name '*.hpp' | sed 's,^\./,,' | LC_ALL=C sort | tr '\n' '\0' |
    LC_ALL=C xargs -0 awk -v exceptions="$exceptions" '
    function wrong(what) { if (!(FILENAME in bad)) bad[FILENAME] = FNR ": " what }
    FNR == 1 { rank = blank = conditional = 0; last = "" }
    /^#[ \t]*if/ { ++conditional }
    /^#[ \t]*endif/ { --conditional }
    NF == 0 { blank = 1 }
    /^#[ \t]*include/ && !conditional {
        name = $0
        gsub(/^#[ \t]*include[ \t]*[<"]|[>"].*$/, "", name)
        new = name ~ /^typemesh\// ? 1 : name ~ /[.\/]|^#/ ? 2 : 3  # # where a macro names the file
        if (new < rank) wrong(name " stands after what should follow it")
        if (new > rank && rank && !blank) wrong("a blank line is missing before " name)
        if (new == rank && blank && FILENAME != "typemesh.hpp") wrong("a blank line too many before " name)
        if (new == rank && !blank && name <= last && name !~ /^#/) wrong(name " is out of order")
        rank = new
        last = name
        blank = 0
    }
    END {
        n = split(exceptions, list, " ")
        for (i = 1; i <= n; ++i) {
            if (!(list[i] in bad)) { print list[i] " is in order: take it out of the list of exceptions"; status = 1 }
            delete bad[list[i]]
        }
        for (file in bad) { print file ":" bad[file]; status = 1 }
        exit status
    }'
