# SPDX-License-Identifier: MIT
#
# PrusaSlicer takes every kind of solid as STL, OBJ and 3MF: it calls each manifold, with the volume of its triangles, and it
# slices some of them. The two solids of an inlay come to it as one object.
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
command -v prusa-slicer >/dev/null 2>&1 || { echo "prusa-slicer is not installed"; exit 77; }
export HOME=$scratch  # its settings

# The facts about all objects of a file: how many there are, how many of them are manifold, and their volume.
facts_of() {  # facts_of FILE
    prusa-slicer --info "$1" 2>"$scratch/words" | awk -F' *= *' '
        $1 == "manifold" { ++objects; whole += $2 == "yes" }
        $1 == "volume" { volume += $2 }
        END { printf "%d %d %.9g\n", objects, whole, volume }'
}

kinds=0 ways=stl
! writes_3mf || ways="stl 3mf"
[ "$ways" = "stl 3mf" ] || echo "without 3MF, which text_to_mesh was built without"
check() {  # check NAME FONT TEXT OPTION...
    local way objects whole seen volume
    for way in $ways; do
        write_kind "$scratch/text.$way" "$@" || return
        [ "$way" != stl ] || read -r volume _ < <(binary_corners "$scratch/text.stl" | measure)
        read -r objects whole seen < <(facts_of "$scratch/text.$way")
        [ "$objects" -ge 1 ] && [ "$objects" = "$whole" ] || fail "prusa-slicer finds $whole of $objects objects manifold: $1.$way"
        # Letters in layers of colours are several solids in a 3MF, and their silhouette in an STL.
        [ "$1" = colour ] || awk -v a="$volume" -v b="$seen" 'BEGIN { exit !(a > 0 && a - b < a / 1000 && b - a < a / 1000) }' ||
            fail "prusa-slicer finds a volume of $seen, not $volume: $1.$way"
    done
    kinds=$((kinds + 1))
    case $1 in
        filleted | chamfered | stencil-bevelled | tapered | keyring)
            rm -f "$scratch/text.gcode"
            prusa-slicer --export-gcode --nozzle-diameter 0.4 --layer-height 0.2 --scale 3 --output "$scratch/text.gcode" "$scratch/text.stl" \
                >"$scratch/words" 2>&1 || fail "prusa-slicer cannot slice: $1: $(tail -n 2 "$scratch/words")"
            grep -q '^G1 ' "$scratch/text.gcode" 2>/dev/null || fail "prusa-slicer has sliced nothing: $1"
            ;;
    esac
}
for_every_kind check

# An inlay: one object, whose volume is the plate's.
if [ "$ways" = "stl 3mf" ]; then
    font=/usr/share/fonts/truetype/liberation/LiberationSerif-Bold.ttf
    write_kind "$scratch/inlay.3mf" inlay "$font" "Rag 8&" --plate 0.2 --inlay --colour red
    write_kind "$scratch/plate.stl" plate "$font" "Rag 8&" --plate 0.2 --depth 0.0001
    read -r objects whole seen < <(facts_of "$scratch/inlay.3mf")
    read -r _ _ plate < <(facts_of "$scratch/plate.stl")
    [ "$objects" -ge 1 ] && [ "$objects" = "$whole" ] || fail "prusa-slicer finds $whole of $objects objects of an inlay manifold"
    awk -v a="$plate" -v b="$seen" 'BEGIN { exit !(a - b < a / 100 && b - a < a / 100) }' || fail "the inlay's volume is $seen, the plate's $plate"
fi
echo "$kinds kinds"
[ "$failures" = 0 ] && [ "$kinds" -ge 25 ]
