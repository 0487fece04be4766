#!/bin/sh
# SPDX-License-Identifier: MIT
#
# 13_moving_letters plans a text once; its frames move letters and ask for no memory, and the last one moves nothing.
#
#     moving_letters.sh PROGRAM
set -eu
font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf
said=$("$1" "$font" "20:15 1")
printf '%s\n' "$said"
printf '%s\n' "$said" | awk '
    NR == 1 && ($1 != 6 || $3 != 3) { print "letters or words are missing"; bad = 1 }
    /^frame/ { height[$2 + 0] = $4 }
    /allocations/ { frames = 1; if ($1 != 0) { print "a frame allocates"; bad = 1 } }
    END {
        if (!frames || height[20] == height[60] || height[60] + 0 == 0) { print "nothing moves"; bad = 1 }
        exit bad
    }'
if "$1" /no/such/font > /dev/null; then echo "a font that is not there is opened" && exit 1; fi
