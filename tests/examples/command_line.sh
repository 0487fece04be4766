#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What text_to_mesh promises on its command line: exit statuses, one sentence on standard error, no file half-written.
#
#     command_line.sh PROGRAM
set -u
program=$1
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
sans=/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf
arabic=/usr/share/fonts/opentype/fonts-hosny-amiri/Amiri-Regular.ttf
passed=0
failed=0

# expect STATUS 'PATTERN ON STANDARD ERROR' ARGUMENT...   a pattern of "" wants silence
expect() {
    local status=$1 pattern=$2 got
    shift 2
    "$program" "$@" >out 2>err
    got=$?
    if [ "$got" = "$status" ] && if [ -z "$pattern" ]; then [ ! -s err ]; else grep -qE -- "$pattern" err; fi; then
        passed=$((passed + 1))
    else
        failed=$((failed + 1))
        printf 'FAILED: text_to_mesh'
        printf ' %q' "$@"
        printf '\n  status %s instead of %s; standard error: %s\n' "$got" "$status" "$(cat err)"
    fi
}
that() {  # that 'WHAT MUST HOLD' COMMAND...
    local what=$1
    shift
    if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)) && echo "FAILED: $what"; fi
}
lines() { [ "$(wc -l <err)" = "$1" ]; }
differ() { ! cmp -s "$1" "$2"; }

# Every format, every option once.
for kind in glb obj stl ply; do
    expect 0 "" "Hello world!" --font $sans --output mesh.$kind
    that "a $kind is written" test -s mesh.$kind
done
expect 0 "" "Two\\nlines" --font $sans --picture p.png --align center --shading gouraud --show triangles,points,contours,control,normals
expect 0 "" "One\\ntwo" --font $sans --align center --output center.glb
expect 0 "" "One\\ntwo" --font $sans --align centre --output centre.glb
that "center and centre are the same" cmp -s center.glb centre.glb
expect 0 "" "fi" --font $sans --feature liga=0 --feature -kern --language tr --script Latn --direction ltr --stats
that "the statistics are one line" [ "$(wc -l <out)" = 1 ]
for key in glyphs refused missing contour_points hard_edges vertices triangles smallest_angle shape outline discretise fill triangulate extrude; do
    that "the statistics hold $key" grep -qE "\"$key\":[0-9.]+[,}]" out
done
for option in "--quality low" "--quality best" "--tolerance 0.01" "--discretiser two_lines" "--discretiser adaptive" \
    "--triangulator monotone" "--triangulator delaunay" "--normals shared" "--normals averaged" "--normals creased --crease 40" "--normals curve" "--depth 0" \
    "--depth 1.5" "--fill evenodd" "--fill nonzero" "--uv em" "--uv box" "--strict" "--direction ttb" "--align right"; do
    # shellcheck disable=SC2086  # words
    expect 0 "" "Ego" --font $sans $option --output option.glb
done
expect 0 "" "مرحبا" --font $arabic --direction rtl --output arabic.glb
expect 0 "" "مرحبا" --font $arabic --merge --output merged.glb
that "merged letters have fewer vertices" [ "$(wc -c <merged.glb)" -lt "$(wc -c <arabic.glb)" ]
for kind in stl glb; do
    for option in "" --merge --no-merge; do
        # shellcheck disable=SC2086  # a word or none
        expect 0 "" "مرحبا" --font $arabic --output joined$option.$kind $option
    done
done
that "letters in an STL are merged" cmp -s joined.stl joined--merge.stl
that "--no-merge leaves the letters of an STL apart" differ joined.stl joined--no-merge.stl
that "letters in a GLB are apart" cmp -s joined.glb joined--no-merge.glb
that "--merge merges letters in a GLB" differ joined.glb joined--merge.glb
expect 2 "excludes" x --font $sans --output x.stl --merge --no-merge
for shown in contours points control; do
    expect 0 "" "سلام" --font $arabic --depth 0 --show $shown --picture apart.png
    expect 0 "" "سلام" --font $arabic --depth 0 --show $shown --merge --picture whole.png
    expect 0 "" "سلام" --font $arabic --depth 0 --merge --picture bare.png
    that "$shown are drawn on merged letters" differ whole.png bare.png
    [ $shown = control ] || that "$shown of merged letters are those of the whole" differ apart.png whole.png
done

# A picture is as fine as its pixels unless a quality is asked for or its lines are shown; the mesh keeps its own.
for quality in "" "--quality high" "--tolerance 0.00125" "--show triangles" "--quality high --show triangles"; do
    # shellcheck disable=SC2086  # words
    expect 0 "" "سلام" --font $arabic $quality --output fine.glb --picture "fine$quality.png"
    mv fine.glb "mesh$quality.glb"
done
that "the picture of the default quality is finer than the mesh" differ fine.png "fine--quality high.png"
that "a quality that is asked for is drawn" cmp -s "fine--quality high.png" "fine--tolerance 0.00125.png"
that "triangles are shown as they are" cmp -s "fine--show triangles.png" "fine--quality high --show triangles.png"
that "the mesh keeps its quality beside a picture" cmp -s mesh.glb "mesh--quality high.glb"

expect 0 "" "$(printf 'a\tb')" --font $sans --strict --output tab.glb  # a tab is no missing character
expect 0 "" "你好" --font /usr/share/fonts/truetype/wqy/wqy-microhei.ttc --face 1 --output face.glb
expect 0 "" "Bold" --font /usr/share/fonts/truetype/inter-vf/Inter.var.ttf --variation wght=900 --output bold.glb
expect 0 "" "Bold" --font /usr/share/fonts/truetype/inter-vf/Inter.var.ttf --variation wght=100 --output thin.glb
that "weights differ" [ "$(cksum <bold.glb)" != "$(cksum <thin.glb)" ]
expect 0 "" "" --font $sans --output empty.glb
that "an empty text gives a valid file" test -s empty.glb
expect 0 "" --help
that "the help names every option" grep -q -- --triangulator out

# Losses are named, and are errors only with --strict.
expect 0 "no glyph for 2 of 3 characters.*byte 1" "a日本" --font $sans --output some.glb
that "what can be drawn is drawn" test -s some.glb
expect 1 "strict" "a日本" --font $sans --output strict.glb --strict
that "--strict leaves no file behind" [ ! -e strict.glb ]
expect 1 "strict" "$(printf 'a\377b')" --font $sans --output strict.glb --strict
expect 0 "" "Å" --font $sans --output ring.glb --strict  # its ring overlaps the A
expect 0 "not valid UTF-8 at 1 place; .*byte 1 of the text" "$(printf 'a\377b')" --font $sans --output bytes.glb
expect 0 "not valid UTF-8 at 2 places" "$(printf 'a\377b\377')" --font $sans --output bytes.glb

# One clear sentence, status 1.
expect 1 "cannot be opened or read" x --font /nowhere/font.ttf --output x.glb
that "one line is enough" lines 1
head -c 2000 /dev/urandom >noise.ttf
expect 1 "not a font" x --font noise.ttf --output x.glb
expect 1 "no face of that number" x --font $sans --face 7 --output x.glb
expect 1 "no such variation axis" x --font $sans --variation wght=700 --output x.glb
expect 1 "at byte 4 of the text: .*left-to-right and right-to-left" "abc مرحبا" --font $arabic --output x.glb
expect 1 "cannot be written" x --font $sans --output /nowhere/x.glb
that "nothing was half-written" [ ! -e x.glb ]

# Wrong usage, status 2.
expect 2 "TEXT" --font $sans --output x.glb
expect 2 "--font" x --output x.glb
expect 2 "nothing to do" x --font $sans
expect 2 "must end in" x --font $sans --output x.fbx
expect 2 "^text_to_mesh: --quality: must be low, normal, high or best, not superb$" x --font $sans --output x.glb --quality superb
that "what to do comes after what is wrong" lines 2
expect 2 "align: must be left, center or right, not middle" x --font $sans --output x.glb --align middle
expect 2 "show: must be .*checker, not trangles" x --font $sans --output x.glb --show points,trangles
expect 2 "excludes" x --font $sans --output x.glb --quality low --tolerance 0.1
expect 2 "feature: must be .*, not ligatures" x --font $sans --output x.glb --feature ligatures
expect 2 "variation: must be .*, not bold" x --font $sans --output x.glb --variation bold
expect 2 "nonsense is not an option$" x --font $sans --output x.glb --nonsense
expect 2 "--fnot is not an option; is --font meant\?" x --fnot $sans --output x.glb
expect 2 "--ouptut is not an option; is --output meant\?" x --font $sans --ouptut=x.glb
expect 0 "" x --font $sans --output --fnot.glb  # a value may look like an option
that "a value may look like an option" test -s ./--fnot.glb
expect 2 "-q is not an option" x --font $sans --output x.glb -q
expect 2 "^text_to_mesh: y was not expected; .*quotes" x y --font $sans --output x.glb
expect 2 "output: needs a value" x --font $sans --output
expect 2 "font: may be given once only" x --font $sans --font $sans --output x.glb
expect 2 "tolerance: must be a positive number, not -1" x --font $sans --output x.glb --tolerance -1
expect 2 "tolerance: must be a positive number, not abc" x --font $sans --output x.glb --tolerance abc
expect 2 "depth: must be a number from 0 to 1000, not nan" x --font $sans --output x.glb --depth nan
expect 2 "face: must be a whole number, not -1" x --font $sans --output x.glb --face -1
expect 2 "crease: must be a number from 0 to 180, not 200" x --font $sans --output x.glb --crease 200

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
