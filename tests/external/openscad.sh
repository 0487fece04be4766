# SPDX-License-Identifier: MIT
#
# OpenSCAD takes the STL of a text for a solid: sunk to half its depth into a block it leaves the block's volume less half
# its own, without a word of complaint. (After a mesh that it cannot take OpenSCAD goes on, and the text is just not there.)
. "$(dirname "${BASH_SOURCE[0]}")/common.bash"
command -v openscad >/dev/null 2>&1 || { echo "openscad is not installed"; exit 77; }

ascii_corners() {  # ascii_corners FILE
    awk '$1 == "vertex" { printf "%s %s %s%s", $2, $3, $4, ++n % 3 ? " " : "\n" }' "$1"
}

checked=0
check() {  # check FONT TEXT OPTION...
    local volume x0 x1 y0 y1 z0 z1 block left
    "$TYPEMESH_TEXT_TO_MESH" --font "$1" --output "$scratch/text.stl" "${@:3}" -- "$2" >/dev/null 2>"$scratch/losses" ||
        fail "text_to_mesh failed: $*: $(cat "$scratch/losses")"
    read -r volume x0 x1 y0 y1 z0 z1 < <(binary_corners "$scratch/text.stl" | measure)

    # A block about it with a margin of 1 em, whose upper face halves the text's depth.
    block=$(awk -v x0="$x0" -v x1="$x1" -v y0="$y0" -v y1="$y1" -v z0="$z0" -v z1="$z1" 'BEGIN {
        printf "translate([%.9f, %.9f, %.9f]) ", x0 - 1, y0 - 1, z0 - 1
        printf "cube([%.9f, %.9f, %.9f]);", x1 - x0 + 2, y1 - y0 + 2, (z1 - z0) / 2 + 1 }')
    printf 'difference() { %s import("text.stl"); }\n' "$block" >"$scratch/cut.scad"
    rm -f "$scratch/cut.stl"
    openscad -o "$scratch/cut.stl" "$scratch/cut.scad" >"$scratch/words" 2>&1 ||
        fail "openscad failed: $*: $(cat "$scratch/words")"
    ! grep -iE 'warning|error|not closed|assertion|Simple: *no' "$scratch/words" || fail "openscad complains: $*"
    read -r left _ < <(ascii_corners "$scratch/cut.stl" | measure)

    # OpenSCAD writes six digits.
    awk -v volume="$volume" -v left="$left" -v x="$x0 $x1" -v y="$y0 $y1" -v z="$z0 $z1" 'BEGIN {
        split(x, a); split(y, b); split(z, c)
        whole = (a[2] - a[1] + 2) * (b[2] - b[1] + 2) * ((c[2] - c[1]) / 2 + 1)
        cut = whole - left
        if (volume > 0 && cut - volume / 2 < volume / 1000 && volume / 2 - cut < volume / 1000) exit 0
        printf "half the text is %.6g, what is cut out is %.6g\n", volume / 2, cut
        exit 1 }' || fail "openscad has cut out something else: $*"
    checked=$((checked + 1))
}

# Other kinds of solids lie whole in a block: OpenSCAD leaves the block less their volume.
check_kind() {  # check_kind NAME FONT TEXT OPTION...
    local volume x0 x1 y0 y1 z0 z1 left
    write_kind "$scratch/text.stl" "$@" || return
    read -r volume x0 x1 y0 y1 z0 z1 < <(binary_corners "$scratch/text.stl" | measure)
    awk -v x0="$x0" -v x1="$x1" -v y0="$y0" -v y1="$y1" -v z0="$z0" -v z1="$z1" 'BEGIN {
        printf "difference() { translate([%.9f, %.9f, %.9f]) ", x0 - 1, y0 - 1, z0 - 1
        printf "cube([%.9f, %.9f, %.9f]); import(\"text.stl\"); }\n", x1 - x0 + 2, y1 - y0 + 2, z1 - z0 + 2 }' >"$scratch/cut.scad"
    rm -f "$scratch/cut.stl"
    openscad -o "$scratch/cut.stl" "$scratch/cut.scad" >"$scratch/words" 2>&1 || fail "openscad failed: $1: $(cat "$scratch/words")"
    ! grep -iE 'warning|error|not closed|assertion|Simple: *no' "$scratch/words" || fail "openscad complains: $1"
    read -r left _ < <(ascii_corners "$scratch/cut.stl" | measure)
    awk -v volume="$volume" -v left="$left" -v x="$x0 $x1" -v y="$y0 $y1" -v z="$z0 $z1" 'BEGIN {
        split(x, a); split(y, b); split(z, c)
        cut = (a[2] - a[1] + 2) * (b[2] - b[1] + 2) * (c[2] - c[1] + 2) - left
        if (volume > 0 && cut - volume < volume / 1000 && volume - cut < volume / 1000) exit 0
        printf "the solid is %.6g, what is cut out is %.6g\n", volume, cut
        exit 1 }' || fail "openscad has cut out something else: $1"
    kinds=$((kinds + 1))
}
kinds=0
for_every_kind check_kind

# Scripts that join their letters, and others; quadratic and cubic curves.
fonts=/usr/share/fonts
phrases=$TYPEMESH_TEST_DATA/workload/phrases
while read -r font script lines; do
    [ -e "$fonts/$font" ] || { fail "$fonts/$font is not installed"; continue; }
    while IFS= read -r text; do
        check "$fonts/$font" "$text"
    done < <(grep . "$phrases-$script.txt" | head -n "$lines")
done <<'LIST'
opentype/fonts-hosny-amiri/Amiri-Regular.ttf arabic 8
truetype/dejavu/DejaVuSans.ttf arabic 8
truetype/liberation/LiberationSerif-Regular.ttf latin 2
opentype/comic-neue/ComicNeue-Regular.otf latin 2
truetype/wqy/wqy-microhei.ttc chinese 2
truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf japanese 2
LIST
for_every_bevel check

# Two squares that touch in a corner, and others: OpenSCAD takes them for solids once they are parted or joined, and only then.
touching() {  # touching FONT TEXT OPTION...
    local way
    for way in part join; do check "$@" --touching $way; done
}
mono=$fonts/truetype/dejavu/DejaVuSansMono.ttf
for look in "" "--bevel 0.01" "--bevel 0.02 --profile stepped" "--bevel 0.02 --bevel-out" "--outline 0.01" "--outline 0.02 --outline-letter" \
    "--embolden -0.01"; do
    # shellcheck disable=SC2086  # words
    touching "$mono" "▚" $look
done
touching "$mono" "a▚▞▚▙ b▟"
touching "$fonts/truetype/wqy/wqy-microhei.ttc" "螺"
"$TYPEMESH_TEXT_TO_MESH" --font "$mono" --output "$scratch/text.stl" --touching keep "▚" >/dev/null || fail "text_to_mesh failed"
printf 'difference() { translate([-1, -1, -1]) cube([3, 3, 1.9]); import("text.stl"); }\n' >"$scratch/cut.scad"
rm -f "$scratch/cut.stl"
openscad -o "$scratch/cut.stl" "$scratch/cut.scad" >"$scratch/words" 2>&1
grep -qiE 'warning|error|not closed|assertion|Simple: *no' "$scratch/words" || fail "openscad takes squares that touch for a solid: these tests show nothing"
echo "$checked texts, $kinds other kinds"
[ "$failures" = 0 ] && [ "$checked" = 82 ] && [ "$kinds" -ge 25 ]
