#!/bin/sh
# SPDX-License-Identifier: MIT
#
# 11_menu makes what is chosen: triangulators have the same counts, solids more and more, another font others, and what is chosen
# again is what it was.
#
#     menu.sh PROGRAM
set -eu
fonts=/usr/share/fonts/truetype
said=$(printf 'febd2m1?9q' | "$1" Hello "$fonts/dejavu/DejaVuSans.ttf" "$fonts/liberation/LiberationSans-Regular.ttf")
printf '%s\n' "$said"
printf '%s\n' "$said" | awk '
    /^[a-z0-9]: / { key = substr($1, 1, 1); of[key] = $2 " " $4; vertices[key] = $2; order = order key }
    END {
        if (order != "febd2m1") { print "chosen were " order; exit 1 }
        if (!(vertices["f"] < vertices["e"] && vertices["e"] < vertices["b"])) { print "a solid is as large as another"; exit 1 }
        if (of["b"] != of["d"] || of["2"] != of["m"]) { print "the triangulator changes what there is"; exit 1 }
        if (of["1"] != of["d"] || of["2"] == of["1"]) { print "the font does not change"; exit 1 }
    }'
