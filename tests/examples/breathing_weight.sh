#!/bin/sh
# SPDX-License-Identifier: MIT
#
# 17_breathing_weight keeps its triangles while the word becomes wider and narrower again.
#
#     breathing_weight.sh PROGRAM
set -eu
font_names=$(dirname "$0")/../support/font_path.hpp
. "$(dirname "$0")/../support/font_file.sh"
said=$("$1" "$(font_file truetype/inter-vf/Inter-roman.var.ttf)" breathe)
printf '%s\n' "$said"
printf '%s\n' "$said" | awk '
    NR == 1 && ($1 != 7 || $3 != 0) { print "letters are missing"; bad = 1 }
    /^frame/ { width[$2 + 0] = $7; triangles[$5] = 1 }
    END {
        for (t in triangles) ++counts
        if (counts != 1) { print "triangles change"; bad = 1 }
        if (!(width[0] < width[15] && width[15] < width[30]) || width[60] != width[0]) { print "it does not breathe"; bad = 1 }
        exit bad
    }'
if "$1" /no/such/font > /dev/null; then echo "a font that is not there is opened" && exit 1; fi
