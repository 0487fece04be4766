#!/bin/sh
# SPDX-License-Identifier: MIT
#
# 12_label shows one text after another in the same memory, and names what its font does not have.
#
#     label.sh PROGRAM
set -eu
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
said=$("$1" "$font" 0 42 0 "$(printf '\346\227\245\346\234\254')" Hello)
printf '%s\n' "$said"
printf '%s\n' "$said" | awk '
    { triangles[NR] = $(NF - 4); missing[NR] = $(NF - 2) }
    END {
        if (NR != 5) { print "of five texts are shown " NR; exit 1 }
        if (triangles[1] != triangles[3] || triangles[1] + 0 == 0) { print "a text is another the second time"; exit 1 }
        if (triangles[2] == triangles[1]) { print "the text does not change"; exit 1 }
        if (missing[4] != 2 || triangles[4] != 0 || missing[5] != 0) { print "what is missing is not said"; exit 1 }
    }'
if "$1" /no/such/font x > /dev/null; then echo "a font that is not there is opened" && exit 1; fi
