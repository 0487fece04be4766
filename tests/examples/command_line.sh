#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# What text_to_mesh promises on its command line: exit statuses, one sentence on standard error, no file half-written.
#
#     command_line.sh PROGRAM [icu]     icu: the program must find words with it
set -u
program=$1
icu=${2:-}
support=$(cd "$(dirname "$0")/../support" && pwd) font_names=$support/font_path.hpp
. "$support/font_file.sh"
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
cd "$scratch" || exit 1
sans=/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf
arabic=/usr/share/fonts/opentype/fonts-hosny-amiri/Amiri-Regular.ttf
inter=$(font_file truetype/inter-vf/Inter.var.ttf)
awami=$(font_file truetype/awami/AwamiNastaliq-Regular.ttf)
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
        printf 'FAILED: text_to_mesh%s\n' "$(printf ' %q' "$@" | shortened)"
        printf '  status        %s\n  wanted        %s\n' "$got" "$status"
        printf '  on stderr     %s\n  wanted        %s\n' "$(shortened <err)" "${pattern:-nothing}"
    fi
}
# The beginning and the end of what may be thousands of characters long.
shortened() { awk '{ all = all (NR > 1 ? " / " : "") $0 } END { n = length(all); if (n > 240) all = substr(all, 1, 120) " [" n - 240 " characters] " substr(all, n - 119); print all }'; }
that() {  # that 'WHAT MUST HOLD' COMMAND...
    local what=$1
    shift
    if "$@"; then passed=$((passed + 1)); else failed=$((failed + 1)) && echo "FAILED: $what"; fi
}
lines() { [ "$(wc -l <err)" = "$1" ]; }
differ() { ! cmp -s "$1" "$2"; }
# alike 'WHAT MUST HOLD' KIND ARGUMENT... / ARGUMENT...    two files of a kind, written with these arguments, are equal
# unlike 'WHAT MUST HOLD' KIND ARGUMENT... / ARGUMENT...   they differ
compared() {
    local how=$1 what=$2 kind=$3 first=()
    shift 3
    while [ "$1" != / ]; do first+=("$1") && shift; done
    expect 0 "" "${first[@]}" "--$([ "$kind" = png ] && echo picture || echo output)" "compared.$kind"
    mv "compared.$kind" "first.$kind"
    expect 0 "" "${@:2}" "--$([ "$kind" = png ] && echo picture || echo output)" "compared.$kind"
    that "$what" "$how" "first.$kind" "compared.$kind"
}
alike() { compared cmp "$@"; }
unlike() { compared differ "$@"; }

# Every format, every option once.
for kind in glb obj stl ply; do
    expect 0 "" "Hello world!" --font $sans --output mesh.$kind
    that "a $kind is written" test -s mesh.$kind
done
expect 0 "" "Two\\nlines" --font $sans --picture p.png --align center --shading gouraud --show triangles,points,contours,control,normals
for turn in -30 30; do expect 0 "" "One" --font $sans --picture turned$turn.png --turn $turn; done
that "a turned picture is another" [ "$(cmp -s turned-30.png turned30.png && echo same)" = "" ]
alike "center and centre are the same" glb "One\\ntwo" --font $sans --align center / "One\\ntwo" --font $sans --align centre
expect 0 "" "fi" --font $sans --feature liga=0 --feature -kern --language tr --script Latn --direction ltr --stats
that "the statistics are one line" [ "$(wc -l <out)" = 1 ]
for key in glyphs refused missing contour_points hard_edges vertices triangles smallest_angle shape outline discretise fill triangulate extrude; do
    that "the statistics hold $key" grep -qE "\"$key\":[0-9.]+[,}]" out
done
for option in "--quality low" "--quality best" "--tolerance 0.01" "--discretiser two_lines" "--discretiser adaptive" \
    "--triangulator monotone" "--triangulator delaunay" "--normals cap" "--normals shared" "--normals averaged" "--normals creased --crease 40" "--normals curve" "--depth 0" \
    "--depth 1.5" "--fill evenodd" "--fill nonzero" "--uv em" "--uv box" "--strict" "--direction ttb" "--direction ttb --latin upright" "--direction ttb --combine-digits 2" "--direction ttb --columns right" "--align right"; do
    # shellcheck disable=SC2086  # words
    expect 0 "" "Ego" --font $sans $option --output option.glb
done
for quality in low normal high best; do
    expect 0 "" "Ego" --font $sans --discretiser adaptive --quality $quality --output adaptive_$quality.glb
done
expect 0 "" "Ego" --font $sans --discretiser two_lines --output two_lines.glb
that "the thesis' low is two lines a curve" cmp -s adaptive_low.glb two_lines.glb
that "its normal is not its low" differ adaptive_normal.glb adaptive_low.glb
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
    [ $shown = control ] || that "$shown of merged letters belong to the whole" differ apart.png whole.png
done

# A picture is as fine as its pixels unless a quality is given or its lines are shown; the mesh keeps its own.
for quality in "" "--quality high" "--tolerance 0.00125" "--show triangles" "--quality high --show triangles"; do
    # shellcheck disable=SC2086  # words
    expect 0 "" "سلام" --font $arabic $quality --output fine.glb --picture "fine$quality.png"
    mv fine.glb "mesh$quality.glb"
done
that "the picture of the default quality is finer than the mesh" differ fine.png "fine--quality high.png"
that "a given quality is drawn" cmp -s "fine--quality high.png" "fine--tolerance 0.00125.png"
that "triangles are shown as they are" cmp -s "fine--show triangles.png" "fine--quality high --show triangles.png"
that "the mesh keeps its quality beside a picture" cmp -s mesh.glb "mesh--quality high.glb"

# Paragraphs.
alike "a text that fits is the plain one" glb "one two" --font $sans --width 100 / "one two" --font $sans
unlike "lines end at the width" glb "one two" --font $sans --width 3 / "one two" --font $sans --width 100
for option in "--wrap word" "--wrap break" "--wrap letter" "--wrap none" "--align justify" "--align justify --justify auto" "--align justify --justify letters" "--align justify --justify kashida" "--align start" "--align end" "--indent 1" \
    "--max-lines 1" "--max-lines 1 --ellipsis ..." "--max-lines 1 --ellipsis ... --elide middle" "--wrap none --ellipsis . --elide start"; do
    # shellcheck disable=SC2086  # words
    expect 0 "" "one two three four" --font $sans --width 6 $option --output option.glb
done
for how in spaces letters kashida; do
    expect 0 "" "بسم الله الرحمن الرحيم" --font $arabic --width 6 --align justify --justify $how --output $how.glb
done
that "letters that are joined do not move apart" cmp -s spaces.glb letters.glb
that "strokes are drawn" differ spaces.glb kashida.glb
for how in spaces letters; do
    expect 0 "" "one two three four" --font $sans --width 6 --align justify --justify $how --output $how.glb
done
that "letters move apart" differ spaces.glb letters.glb
expect 0 "" "one two three four" --font $sans --width 6 --align justify --output by_default.glb
that "Latin is justified by its spaces" cmp -s spaces.glb by_default.glb
for side in left right auto; do
    expect 0 "" "One\\ntwo" --font $sans --direction ttb --columns $side --output columns_$side.glb
done
that "columns go to the left" cmp -s columns_left.glb columns_auto.glb
that "columns go to the right" differ columns_left.glb columns_right.glb
for align in "" " left" " start" " right"; do
    # shellcheck disable=SC2086  # words or none
    expect 0 "" "قال 2024 hello" --font $arabic ${align:+--align$align} --output "mixed${align# }.glb"
done
that "without a width, what is read to the left ends at x = 0" cmp -s mixed.glb mixedright.glb
that "lines are aligned to their start" cmp -s mixed.glb mixedstart.glb
that "what is read to the left may begin at x = 0, too" differ mixed.glb mixedleft.glb
if [ -n "$icu" ]; then  # lines end between words, as where U+200B separates these
    thai=/usr/share/fonts/opentype/tlwg/Purisa.otf
    expect 0 "" "กินข้าวกินปลากินข้าว" --font $thai --width 3 --output thai.obj
    expect 0 "" "กิน​ข้าว​กิน​ปลา​กิน​ข้าว" --font $thai --width 3 --output parted.obj
    expect 0 "" "กินข้าวกินปลากินข้าว" --font $thai --output one_line.obj
    that "Thai is broken between its words" cmp -s <(grep '^v ' thai.obj) <(grep '^v ' parted.obj)
    that "and is not one line" differ <(grep '^v ' thai.obj) <(grep '^v ' one_line.obj)
else
    expect 0 "no dictionary for the words of 2 runs of Thai.*at byte 4 of the text" "one ภาษา two ລາວ" --font $sans --width 6 --output thai.glb
    that "the text that was not broken is built" test -s thai.glb
fi

# Emoji of several code points whose parts are drawn one by one.
symbola=/usr/share/fonts/truetype/ancient-scripts/Symbola_hint.ttf
expect 0 "no glyph for 2 of 5 characters; the first is at byte 1 " "a👍🏽🇩🇪" --font $symbola --output apart.glb
that "emoji that have fallen apart are named" grep -q "2 of them are emoji whose parts are drawn one by one.*at byte 1 of the text" err
that "their parts are drawn" test -s apart.glb
expect 1 "--strict: nothing is written" "👩‍🚀" --font $symbola --width 9 --output apart.glb --strict
expect 0 "" "👍👍🇩x❤️" --font $symbola --output apart.glb --strict

# Styles of parts of a text.
expect 0 "" "Hello world!" --font $sans --style 6..11:colour=#2060c0,underline --style 0..5:size=1.5,slant=0.2 --output styled.obj
that "a colour is a material of its own, named after it" grep -q "usemtl front_2060c0" styled.obj
alike "a colour moves nothing" stl "Hello world!" --font $sans --style 0..12:colour=red / "Hello world!" --font $sans --width 100
for setting in overline strike-through superscript subscript rise=0.2 letter-spacing=0.1 word-spacing=0.5 language=tr feature=-kern; do
    expect 0 "" "AV wo" --font $sans --style 1..4:$setting --picture styled.png
done
expect 0 "1 end lies inside a character" "$(printf 'e\xCC\x81x')" --font $sans --style 0..1:colour=red --output moved.glb
expect 1 "--strict: nothing is written" "$(printf 'e\xCC\x81x')" --font $sans --style 0..1:colour=red --output x.glb --strict
expect 2 "--style: 0..3 and 2..4 overlap" abcd --font $sans --stats --style 0..3:underline --style 2..4:underline
expect 2 "--style: 2..9 ends after the text, which has 4 code points" abcd --font $sans --stats --style 2..9:underline
expect 2 "--style must end after its beginning, not 3..2" abcd --font $sans --stats --style 3..2:underline
expect 2 "--style must end after its beginning, not 3..3" abcd --font $sans --stats --style 3..3:underline
expect 2 "underline or size=1.5, not nothing" abcd --font $sans --stats --style 0..3:
for range in 1 1..2 x..2:underline 1..:underline -1..2:underline; do
    expect 2 "--style must have the form" abcd --font $sans --stats "--style=$range"
done
expect 2 "--style must contain settings such as" abcd --font $sans --stats --style 1..2:wavy
expect 2 "--style: colour must be" abcd --font $sans --stats --style 1..2:colour=#12345
for size in 0 1e-300 1001; do
    expect 2 "--style: size must be a number from 0.001 to 1000, not $size" abcd --font $sans --stats --style 1..2:size=$size
done
for setting in colour language feature font rise; do
    expect 2 "--style: $setting must have a value" abcd --font $sans --stats --style 1..2:$setting=
done
for twice in "colour=red,color=blue/colour" "underline,underline/underline" "superscript,subscript/superscript or subscript" \
    "combined,upright/upright, sideways or combined" "size=2,size=3/size"; do
    expect 2 "--style may set ${twice#*/} only once" abcd --font $sans --stats --style "1..2:${twice%/*}"
done
expect 0 "" abcd --font $sans --stats --style 1..2:feature=-liga,feature=-kern
for digit in 1..2 2..3; do
    expect 0 "--style: 1 end lies inside a character or a combined number" a12b --font $sans --direction ttb --combine-digits 2 --style $digit:colour=red --output digit.obj
    that "a combined number has one style" [ "$(grep -c usemtl.front_red digit.obj)" = 1 ]
    expect 1 "--strict: nothing" a12b --font $sans --direction ttb --combine-digits 2 --style $digit:colour=red --output digit.obj --strict
done
expect 0 "" a12b --font $sans --direction ttb --combine-digits 2 --style 1..3:colour=red --output digit.obj --strict
for option in "--latin upright" "--combine-digits 2" "--columns right"; do
    # shellcheck disable=SC2086  # words
    expect 2 "${option% *} needs --direction ttb" ab --font $sans --stats $option
done
for word in upright sideways combined; do
    expect 2 "--style: upright, sideways and combined need --direction ttb" ab --font $sans --stats --style 0..1:$word
    expect 0 "" ab --font $sans --stats --style 0..1:$word --direction ttb
done
expect 0 "" سلام --font $arabic --quality normal --style 1..2:size=1 --output plain.stl
expect 0 "" سلام --font $arabic --quality normal --style 1..2:colour=red --output red.stl --picture red.png
expect 0 "" سلام --font $arabic --quality normal --picture plain.png
that "what holds no colours is merged without them" cmp -s plain.stl red.stl
that "the picture is coloured" differ plain.png red.png
expect 2 "--style: font=2 needs another --fallback, because there is only 1 font" abcd --font $sans --stats --style 1..2:font=2
expect 0 "" abcd --font $sans --fallback $arabic --stats --style 1..2:font=2
expect 2 "--style: font must be a whole number" abcd --font $sans --stats --style 1..2:font=0
# Mark-up: the same as --style, and solids of their own.
alike "tags say what --style says" obj "Hello [u][colour=#2060c0]world[/][/]!" --markup --font $sans / "Hello world!" --font $sans --style 6..11:colour=#2060c0,underline
alike "a text without tags stays as it is" glb "a [[b] c" --markup --font $sans / "a [b] c" --font $sans
coloured=/usr/share/fonts/opentype/fonts-hosny-amiri/AmiriQuranColored.ttf
for layers in --colour-layers --colour-layers=stacked; do
    expect 0 "" "بِسْمِ" --font $coloured $layers --anchor base --output coloured.obj
    that "$layers writes both colours" [ "$(grep '^usemtl' coloured.obj | sort -u | wc -l)" = 6 ]
done
that "levels of a stack share planes" [ "$(awk '/^v / { print $4 }' coloured.obj | sort -u | tr '\n' ' ')" = "0 0.2 0.21000001 " ]
alike "a font has a number or a name" stl "a[font=2]b[/]" --markup --font $sans --fallback $arabic / "a[font=$arabic]b" --markup --font $sans --fallback $arabic
alike "what holds no colours is merged without them" stl "سل[colour=#f00]ا[/]م" --markup --font $arabic / "سلام" --font $arabic
expect 1 "--markup: line 2, character 3: there is an unknown tag; write \\[\\[ for a bracket of the text" 'é\né [x]' --markup --font $sans --stats
expect 1 "--markup: line 1, character 8: there is a number out of range" "a[size=0]b" --markup --font $sans --stats
expect 1 "--markup: \\[font=...\\] must be 1 for --font" "[font=2]b" --markup --font $sans --stats
expect 1 "--markup: a bevel is deeper than half of its letters" "[bevel=0.2]b" --markup --font $sans --stats
expect 1 "--markup: \\[depth=...\\] must be more than 0" "[depth=0]b" --markup --font $sans --stats
expect 1 "--markup: .* do not work with --instances" "[depth=1]b" --markup --font $sans --instances --output x.glb
expect 2 "--style does not work with --markup" "b" --markup --style 0..1:underline --font $sans --stats
expect 0 "" "ab[depth=0.5][colour=#f00]c[/]d[/][bevel=0.01]e[/][b]f" --markup --font $sans --output solids.obj --picture solids.png
depth_of() { awk -v name="$1" '$1 == "v" { z[++n] = $4 } $1 == "usemtl" { on = $2 == name } $1 == "f" && on {
    for (i = 2; i < 5; ++i) { split($i, v, "/"); if (!k++ || z[v[1]] < low) low = z[v[1]]; if (k == 1 || z[v[1]] > high) high = z[v[1]] } }
    END { printf "%.3f", high - low }' solids.obj; }
that "a depth is its letters' own" [ "$(depth_of side_ff0000)" = 0.500 ]
that "bevels are their letters' own" grep -q "usemtl front_bevel" solids.obj
that "backs lie in one plane" [ "$(awk '$1 == "v" && $4 < low { low = $4 } END { printf "%.3f", low }' solids.obj)" = -0.200 ]
expect 0 "" "[style=7]a[/][colour=#f00][style=7]b" --markup --font $sans --output named.obj
that "a style's number is in the names of parts" grep -q "usemtl front_style7" named.obj
that "beside a colour's" grep -q "usemtl front_ff0000-style7" named.obj
printf '[b]one[/b]\nt[i]w[/]o\n[c]three\n' >marked.txt
expect 1 "line 3: --markup: line 1, character 1: there is an unknown tag" --batch marked.txt --markup --font $sans --output "marked{n}.stl"
that "the other lines of a batch are made" test -s marked1.stl -a -s marked2.stl
expect 0 "" "a[ruby=xy]bc[/]d" --markup --font $sans --output ruby.obj
expect 0 "" "abcd" --font $sans --output base.obj
highest() { awk '$1 == "v" && $3 > high { high = $3 } END { print high }' "$1"; }
that "a ruby stands above its text" awk -v a="$(highest base.obj)" -v b="$(highest ruby.obj)" 'BEGIN { exit !(b > a + 0.2) }'
expect 0 "" "[ruby=x]b" --markup --font $sans --direction ttb --stats
expect 0 "" "a[mark=#ff0]b [box=1,0.5][/]" --markup --font $sans --output marked.obj
alike "both solids and one solid with the same numbers are alike in STL" stl "[depth=0.2]ab" --markup --font $sans / ab --font $sans
for width in 0 -1 nan x 1e7; do expect 2 "--width must be a positive number" x --font $sans --stats --width $width; done
expect 2 "--max-lines must be a whole number" x --font $sans --stats --max-lines 0
expect 0 "" "one two three" --font $sans --fit 30x10 --stats
unlike "a larger box makes a larger text" glb "one two three" --font $sans --fit 30x1e1 --align justify / "one two three" --font $sans --fit 60x20 --align justify
within() {  # within X Y FILE.obj: its mesh is at most so wide and high, and reaches nine tenths of one of them
    awk -v w="$1" -v h="$2" '$1 == "v" { if (!n++) { a = b = $2; c = d = $3 }
        if ($2 < a) a = $2; if ($2 > b) b = $2; if ($3 < c) c = $3; if ($3 > d) d = $3 }
        END { exit !(n && b - a <= w && d - c <= h && (b - a >= 0.9 * w || d - c >= 0.9 * h)) }' "$3"
}
for box in 10x20 20x10; do
    expect 0 "" "one two three four" --font $sans --direction ttb --fit $box --output column.obj
    that "columns fit into $box" within "${box%x*}" "${box#*x}" column.obj
done
for box in 30 x 0x1 -1x2 30x 30x10x1 1x1e7 "3 x 4"; do
    expect 2 "--fit must be two positive numbers" x --font $sans --stats --fit "$box"
done
grown() {  # grown WIDTH OPTION...
    expect 0 "" "nnnnnnnn" --font $sans --fit "$1x90" --output grown.obj "${@:2}"
    that "a box of $1 is filled with ${*:2}" within "$1" 90 grown.obj
}
grown 10
grown 10 --outline 0.2 --outline-place outer
grown 10 --outline 0.2 --outline-place centre --embolden 0.02
grown 10 --bevel 0.1 --bevel-out
grown 0.1 --outline 0.9 --outline-place outer
expect 2 "--size does not work with --fit" x --font $sans --stats --fit 3x1 --size 2
expect 2 "--width does not work with --fit" x --font $sans --stats --fit 3x1 --width 2
expect 1 "--fit: the text needs more lines" "$(printf 'a\nb')" --font $sans --stats --fit 3x1 --max-lines 1
expect 2 "--align justify needs --width" x --font $sans --stats --align justify
expect 2 "--justify needs --align justify" x --font $sans --stats --width 9 --justify letters
expect 2 "--justify must be auto, spaces, letters or kashida, not words" x --font $sans --stats --width 9 --align justify --justify words
expect 2 "--wrap needs --width or --fit" x --font $sans --stats --wrap word
expect 2 "--ellipsis needs --width or --max-lines" x --font $sans --stats --ellipsis x
expect 2 "--ellipsis must be one line" x --font $sans --stats --width 3 --ellipsis 'a\nb'
for wrong in 茶/": the font has no glyph for it, so three full stops" $'\xFF/ is not valid UTF-8'; do
    expect 0 "--ellipsis${wrong#*/}" "one two" --font $sans --width 2 --max-lines 1 --ellipsis "${wrong%%/*}" --output elided.glb
    expect 1 "--strict: nothing" "one two" --font $sans --width 2 --max-lines 1 --ellipsis "${wrong%%/*}" --output x.glb --strict
done
broken=("aaa bb cc ddddd" --font "$sans" --width 3.2 --breaker)
alike "the first fit is the default" obj "${broken[@]}" first_fit / "${broken[@]::5}"
unlike "lines are more even" obj "${broken[@]}" first_fit / "${broken[@]}" total_fit
expect 0 "" "aaa bb cc ddddd" --font $sans --fit 4x3 --breaker total_fit --stats
that "the time to shape a paragraph is counted" grep -q '"shape":[1-9]' out
expect 2 "--breaker needs --width or --fit" x --font $sans --stats --breaker total_fit
expect 2 "--breaker does not work with --wrap none" x --font $sans --stats --width 3 --wrap none --breaker total_fit
expect 2 "breaker must be first_fit or total_fit, not even" x --font $sans --stats --width 3 --breaker even
expect 2 "--elide needs --ellipsis" x --font $sans --stats --width 3 --elide start

# Many fonts: what one lacks the next one has, and the text of the first is as without them.
many="Tea شاي 茶!"
comic=/usr/share/fonts/opentype/comic-neue/ComicNeue-Regular.otf
cjk=/usr/share/fonts/truetype/wqy/wqy-microhei.ttc
expect 0 "no glyph for 4 of 10 characters" "$many" --font $comic --output lacking.glb
expect 0 "no font has a glyph for 1 of 10 characters" "$many" --font $comic --fallback $arabic --output lacking.glb
expect 0 "" "$many" --font $comic --fallback $arabic --fallback $cjk --strict --output many.glb --picture many.png --show contours
expect 0 "" "$many" --font $comic --fallback $arabic --fallback $cjk --strict --instances --width 3 --output many_letters.glb
alike "what the first font has is its own" glb "Tea" --font $comic / "Tea" --font $comic --fallback $arabic
expect 1 "--fallback: Nope is n" x --font $sans --stats --fallback Nope
expect 1 "--fallback: nope.ttf: The font file cannot be opened" x --font $sans --stats --fallback nope.ttf
expect 2 "--fallback" x --font $sans --stats --fallback
expect 2 "--family does not work with --font" x --font $sans --stats --family Amiri
expect 1 "--family must be an installed family, not the file" x --stats --family $sans

expect 0 "" "$(printf 'a\tb')" --font $sans --strict --output tab.glb  # a tab is no missing character
expect 0 "" "你好" --font /usr/share/fonts/truetype/wqy/wqy-microhei.ttc --face 1 --output face.glb
unlike "weights differ" glb "Bold" --font "$inter" --variation wght=900 / "Bold" --font "$inter" --variation wght=100
expect 0 "" --help
that "the help names the things to do" grep -qF "(--output FILE | --picture FILE.png | --stats)" out
that "the help names every option" grep -q -- --triangulator out
that "the help speaks no word of the library's own" sh -c '! grep -E "TEXT TEXT|REQUIRED|Excludes|TEXT:|OPTIONS\]" out'
that "the help lists what --style takes" grep -q "strike-through.*superscript" out
that "the help lists the tags of --markup" grep -q "bevel=EM" out
that "the help's lines fit" sh -c '! grep -E ".{121}" out'
expect 0 "" --version
that "the version is one line" grep -qE '^text_to_mesh [0-9]+\.[0-9]+\.[0-9]+$' out

# Size and spacing: every coordinate twice as large, letters and lines farther apart.
widest() { grep '^v ' "$1" | awk -v c="$2" 'NR == 1 || $c > m { m = $c } NR == 1 || $c < l { l = $c } END { print m - l }'; }
larger() { awk -v a="$1" -v b="$2" -v by="$3" 'BEGIN { d = a - b - by; exit d * d > 1e-8 }'; }  # a is b and so much
expect 0 "" "ab" --font $sans --output one.obj
expect 0 "" "ab" --font $sans --output two.obj --size 2
that "--size is how large an em is" larger "$(widest two.obj 2)" "$(widest one.obj 2)" "$(widest one.obj 2)"
that "--size is for the depth too" larger "$(widest two.obj 4)" 0 0.4
expect 0 "" "ab" --font $sans --output apart.obj --letter-spacing 0.25
that "--letter-spacing stands between letters, in em" larger "$(widest apart.obj 2)" "$(widest one.obj 2)" 0.25
expect 0 "" "a\\na" --font $sans --output lines.obj
expect 0 "" "a\\na" --font $sans --output far.obj --line-spacing 2
expect 0 "" "a\\na" --font $sans --output near.obj --line-spacing 1e-3
once=$(awk -v a="$(widest lines.obj 3)" -v b="$(widest near.obj 3)" 'BEGIN { print (a - b) / 0.999 }')
that "--line-spacing is times the font's own" larger "$(widest far.obj 3)" "$(widest lines.obj 3)" "$once"
expect 0 "" "سلام" --font $arabic --output joined.obj
expect 0 "" "سلام" --font $arabic --output joined-apart.obj --letter-spacing 0.25
that "letters that are written joined stay joined" cmp -s <(grep '^v ' joined.obj) <(grep '^v ' joined-apart.obj)
alike "the picture does not depend on the size" png "x" --font $sans --output sized.glb --size 250 / "x" --font $sans
for size in 1e-7 1e-12 1e6; do
    alike "the picture does not depend on the size $size" png "Ego" --font $sans --size $size / "Ego" --font $sans
done

# Endings count without regard to case; an OBJ comes with its materials, both or none.
for kind in GLB Obj sTL PLY; do
    expect 0 "" "x" --font $sans --output upper.$kind
    that "a $kind is written" test -s upper.$kind
done
expect 0 "" "x" --font $sans --picture upper.PNG
that "an OBJ names its materials" grep -qx "mtllib upper.mtl" upper.Obj
for part in front back side; do
    that "the OBJ uses $part" grep -qx "usemtl $part" upper.Obj
    that "there is a material $part" grep -qx "newmtl $part" upper.mtl
done
mkdir taken && mkdir taken/x.obj taken/y.mtl
expect 1 "x.obj cannot be written" x --font $sans --output taken/x.obj
that "no materials without their OBJ" [ ! -e taken/x.mtl ]
expect 1 "y.mtl cannot be written" x --font $sans --output taken/y.obj
that "no OBJ without its materials" [ ! -e taken/y.obj ]

# All files of a run take their places, or none does.
echo old >old.glb
expect 1 "^text_to_mesh: /nowhere/x.png cannot be written: there is no folder /nowhere\.$" x --font $sans --output old.glb --picture /nowhere/x.png
that "a picture that fails leaves the old mesh" [ "$(cat old.glb)" = old ]
if [ -c /dev/full ]; then
    ln -s /dev/full full.png
    expect 1 "full.png cannot be written" x --font $sans --output old.glb --picture full.png
    that "a picture on a full device leaves the old mesh" [ "$(cat old.glb)" = old ]
fi
that "no temporary is left" sh -c '! ls -A | grep -F .part'

# Instances: each different letter once, and the same places.
expect 0 "" "banana bandana" --font $sans --output flat.glb
expect 0 "" "banana bandana" --font $sans --output instances.glb --instances
that "letters that come again are written once" [ "$(wc -c <instances.glb)" -lt "$(($(wc -c <flat.glb) / 2))" ]
that "there is a node for each letter" [ "$(grep -ao '"translation"' instances.glb | wc -l)" = 13 ]
expect 2 "--instances needs --output FILE.glb" x --font $sans --output x.obj --instances
expect 2 "excludes" x --font $sans --output x.glb --instances --merge
expect 0 "" "Hello" --font $sans --output apart.glb --per-letter
that "each letter has a node" [ "$(grep -ao '"translation"' apart.glb | wc -l)" = 5 ]
that "which is named after it" grep -aq '"name":"H_1"' apart.glb
expect 0 "" "Hello" --font $sans --output numbered.glb --letters
that "vertices know their letters" grep -aq '"_PIVOT"' numbered.glb
that "and the text's node names them" grep -aq '"letters":\["H","e","l","l","o"\]' numbered.glb
expect 2 "--per-letter needs --output FILE.glb" x --font $sans --output x.obj --per-letter
expect 2 "--letters does not work with --instances" x --font $sans --output x.glb --letters --instances
expect 2 "--letters does not work with --lod" x --font $sans --output x.glb --letters --lod 0.01

# Bevels: five parts in every format, and letters that meet become one.
expect 0 "" "Rag" --font $sans --output plain.obj
alike "no bevel is what it was" obj "Rag" --font $sans / "Rag" --font $sans --bevel 0 --profile round
bevels=(--bevel 0.02 --bevel-depth 0.03)
for kind in glb obj stl ply; do
    expect 0 "" "Rag" --font $sans --output bevelled.$kind "${bevels[@]}"
done
for part in front back side front_bevel back_bevel; do
    that "the OBJ's $part has a material" grep -qx "usemtl $part" bevelled.obj
    that "there is a material $part" grep -qx "newmtl $part" bevelled.mtl
    that "the GLB has a material $part" grep -qa "\"name\":\"$part\"" bevelled.glb
done
that "the PLY's triangles have their parts" [ "$(grep -aoE 'comment part [0-9] [a-z_]+' bevelled.ply | cut -d' ' -f3- | tr '\n' ' ')" = "0 front 1 back 2 side 3 front_bevel 4 back_bevel " ]
that "a bevel is carved into the depth" larger "$(widest bevelled.obj 4)" "$(widest plain.obj 4)" 0
that "a bevel is carved into the width" larger "$(widest bevelled.obj 2)" "$(widest plain.obj 2)" 0
expect 0 "" "Rag" --font $sans --output front.obj "${bevels[@]}" --bevel-sides front
that "the front alone" sh -c 'grep -qx "g front_bevel" front.obj && ! grep -qx "g back_bevel" front.obj'
expect 0 "" "Rag" --font $sans --output back.obj "${bevels[@]}" --bevel-sides back
that "the back alone" sh -c 'grep -qx "g back_bevel" back.obj && ! grep -qx "g front_bevel" back.obj'
# A profile is known by the heights of its vertices: of the front, in thousandths of the bevel's depth, 0 to -0.03.
heights() { awk '$1 == "v" && $4 > -0.0301 { h = sprintf("%d", 1000.5 + $4 / 0.00003); if (!(h in seen)) { seen[h] = 1; print h } }' "$1" | sort -n | tr '\n' ' '; }
profile_has() {  # profile_has PROFILE 'HEIGHTS' OPTION...
    local profile=$1 wanted=$2
    shift 2
    expect 0 "" "o" --font $sans --output profile.obj "${bevels[@]}" --bevel-sides front --profile "$profile" "$@"
    that "the heights of $profile $* are $wanted, not $(heights profile.obj)" [ "$(heights profile.obj)" = "$wanted " ]
}
profile_has chamfer "0 1000"
profile_has round "0 500 866 1000" --bevel-steps 3
profile_has concave "0 134 500 1000" --bevel-steps 3
profile_has stepped "0 500 1000"
profile_has engraved "0 1000"
profile_has "0,0;0.2,0.8;1,1" "0 800 1000"
for profile in round concave; do
    expect 0 "" "o" --font $sans --output profile.obj "${bevels[@]}" --profile $profile
    expect 0 "" "o" --font $sans --output finer.obj "${bevels[@]}" --profile $profile --quality best
    that "$profile is as fine as the quality" [ "$(heights profile.obj | wc -w)" -lt "$(heights finer.obj | wc -w)" ]
done
engraved_cap() { awk '$1 == "g" { front = $2 == "front" } $1 == "v" { z[++n] = $4 } front && $1 == "f" { split($2, i, "/"); print z[i[1]] }' "$1" | sort -u; }
expect 0 "" "o" --font $sans --output engraved.obj "${bevels[@]}" --profile engraved
that "the cap lies at the bottom of an engraved bevel" larger "$(engraved_cap engraved.obj)" 0 -0.03
expect 0 "" "o" --font $sans --output ridge.obj --bevel 0.3 --bevel-depth 0.1
that "a bevel wider than the stroke closes in a ridge" sh -c '! grep -qx "g front" ridge.obj'
expect 0 "edges of 1 of 1 glyphs have moved less" "o" --font $sans --output fits.obj --bevel 0.3 --bevel-depth 0.1 --bevel-mode fit
that "a bevel that fits leaves a cap" grep -qx "g front" fits.obj
for mode in fit fit_text; do
    expect 0 "glyphs have moved less" "Oi" --font $sans --output $mode.obj --bevel 0.3 --bevel-depth 0.1 --bevel-mode $mode
    expect 0 "edges of 1 of 1 glyphs have moved less" "i" --font $sans --output $mode-i.obj --bevel 0.3 --bevel-depth 0.1 --bevel-mode $mode
done
that "bevels of a text that fit are as narrow as the narrowest" differ <(grep -v ^mtllib fit.obj) <(grep -v ^mtllib fit_text.obj)
that "a text of one letter is that letter" cmp -s <(grep -v ^mtllib fit-i.obj) <(grep -v ^mtllib fit_text-i.obj)
expect 0 "" "o" --font $sans --output thin.obj --depth 0.3
expect 0 "" "o" --font $sans --output grown.obj --depth 0.3 "${bevels[@]}" --bevel-out
that "--bevel-out makes letters wider" larger "$(widest grown.obj 2)" "$(widest thin.obj 2)" 0.04
that "--bevel-out keeps the depth" larger "$(widest grown.obj 4)" 0 0.3
joined=("مرحبا" --font "$arabic" "${bevels[@]}")
alike "bevelled letters are merged" glb "${joined[@]}" / "${joined[@]}" --merge
unlike "--no-merge leaves bevelled letters apart" glb "${joined[@]}" / "${joined[@]}" --no-merge
expect 0 "" "banana" --font $sans --output instances.glb "${bevels[@]}" --instances
that "bevelled letters may be instances" [ "$(grep -ao '"translation"' instances.glb | wc -l)" = 6 ]
# Bold and hollow letters.
expect 0 "" "HIL" --font $sans --output upright.obj
expect 0 "" "HIL" --font $sans --output bold.obj --embolden 0.02
that "--embolden makes letters and their advances wider" larger "$(widest bold.obj 2)" "$(widest upright.obj 2)" 0.12
expect 0 "" "HIL" --font $sans --output tight.obj --embolden 0.02 --letter-spacing 0
that "--letter-spacing says otherwise" larger "$(widest bold.obj 2)" "$(widest tight.obj 2)" 0.08
expect 0 "" "HIL" --font $sans --output light.obj --embolden -0.01
that "a negative --embolden makes them thinner" larger "$(widest upright.obj 2)" "$(widest light.obj 2)" 0.06
expect 0 "1 of 2 glyphs is left out; the first is glyph [0-9]+, at byte 1 of the text: Nothing is left of the glyph" "Ii" --font $sans --output gone.obj --embolden -0.044
expect 0 "" "HIL" --font $sans --output hollow.obj --outline 0.02
that "a ring within the letter keeps its size" [ "$(widest hollow.obj 2)" = "$(widest upright.obj 2)" ]
for place in centre outer; do
    expect 0 "" "HIL" --font $sans --output $place.obj --outline 0.02 --outline-place $place
done
that "a ring half around the letter is wider" larger "$(widest centre.obj 2)" "$(widest hollow.obj 2)" 0.06
that "a ring around the letter is wider still" larger "$(widest outer.obj 2)" "$(widest centre.obj 2)" 0.06
framed=(--outline 0.02 --outline-place outer --outline-letter --bevel 0.005 --embolden 0.01)
for kind in glb obj stl ply; do
    expect 0 "" "Rag" --font $sans --output framed.$kind "${framed[@]}"
done
for part in front back side front_bevel back_bevel letter_front letter_back letter_side; do
    that "the OBJ's $part has a material" grep -qx "usemtl $part" framed.obj
    that "the GLB has a material $part" grep -qa "\"name\":\"$part\"" framed.glb
done
expect 0 "" "Rag" --font $sans --output flat_ring.obj --outline 0.02 --depth 0
expect 0 "" "banana" --font $sans --output rings.glb "${framed[@]}" --instances
expect 0 "" "Rag" --font $sans --picture framed.png "${framed[@]}"
expect 0 "" "Rag" --font $sans --picture shown.png "${bevels[@]}" --show triangles,normals,contours,points --stats
unlike "a picture shows bevels" png "Rag" --font $sans / "Rag" --font $sans "${bevels[@]}"

# Corners that touch. Two squares that do, and as they are, apart and joined.
mono=/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf
corners() { grep -qF "\"corners_moved\":$1," out; }  # corners NUMBER
for kind in stl obj ply glb; do
    for way in part join keep; do
        expect 0 "" "▚" --font $mono --touching $way --output $way.$kind --stats
        if [ $way = keep ]; then that "no corner is moved" corners 0; else that "one corner is moved" corners 1; fi
    done
    expect 0 "" "▚" --font $mono --output usual.$kind --stats
    that "a $kind has its corners parted unless it is a GLB" cmp -s <(grep -av ^mtllib usual.$kind) <(grep -av ^mtllib $([ $kind = glb ] && echo keep || echo part).$kind)
    that "joined is not parted in a $kind" differ part.$kind join.$kind
done
expect 0 "" "▚" --font $mono --stats
that "statistics alone move nothing" corners 0
expect 2 "--touching must be part, join or keep, not apart" x --font $sans --touching apart --stats
expect 0 "" "▚▚" --font $mono --touching part --output letters.glb --instances

# Curves out: .svg and .dxf.
expect 0 "" "Hello" --font $sans --output curves.svg
that "a text's curves are one path" [ "$(grep -c '<path d="M' curves.svg)" = 1 ]
that "curves stay curves" grep -q 'd="[^"]*Q' curves.svg
that "an em is ten millimetres in curves" grep -qE '<svg [^>]*width="[12][0-9](\.[0-9]+)?mm"' curves.svg
that "the program says how large a file of curves is" grep -qE '^curves\.svg: [0-9]+ curves and lines, [0-9.]+ x [0-9.]+ mm$' out
expect 0 "" "Hello" --font $sans --output curves.dxf --size 40
that "a drawing has splines" grep -q '^SPLINE' curves.dxf
that "a drawing ends" [ "$(tail -n 1 curves.dxf)" = EOF ]
expect 0 "" "مرحبا" --font $arabic --output - --format dxf
that "a drawing goes to standard output" grep -q '^EOF' out
expect 0 "" "Red" --font $sans --output curves.svg --style "0..1:colour=red" --colour "#102030"
that "curves have colours" [ "$(grep -cE '<path fill="#(d0282c|102030)"' curves.svg)" = 2 ]
expect 0 "" "Ego" --font $sans --output bold.svg --embolden 0.02 --bend arc:90
for option in "--bevel 0.01" "--carve 60" "--outline 0.02" "--inflate 1" "--refine delaunay" "--bend cylinder:2"; do
    # shellcheck disable=SC2086  # words
    expect 2 "A .svg file has the letters' outlines" "Ego" --font $sans --output no.svg $option
done
for option in "--depth 0.2" "--segments 2" "--normals cap" "--crease 30" "--uv box"; do
    # shellcheck disable=SC2086  # words
    expect 2 "^text_to_mesh: ${option% *} does not work with a \.dxf file, which contains outlines\.$" "Ego" --font $sans --output no.dxf $option
done
expect 2 "A .svg file has the letters' outlines" "Ego" --font $sans --output no.svg --tube 0.02
expect 0 "" "Ego" --font $sans --output solid.svg --depth 0.2 --picture solid.png  # the picture shows the depth
expect 2 "A .dxf file does not work with --markup" "Ego" --font $sans --output no.dxf --markup
# Letters on a circle of 20 mm go around it.
expect 0 "" "Letters on a ring" --font $sans --output ring.svg --path circle:2
that "a text on a path stands there in files of curves, too" awk '{ while (match($0, /(width|height)="[0-9.]+mm/)) { side = substr($0, RSTART, RLENGTH); gsub(/[^0-9.]/, "", side); if (side < 20 || side > 70) wrong = 1; ++sides; $0 = substr($0, RSTART + RLENGTH) } } END { exit !(sides == 2 && !wrong) }' ring.svg
expect 1 "the text is blank" " " --font $sans --output no.svg
that "no curves are half-written" [ ! -e no.svg ]

# Strokes.
expect 0 "" "Ego" --font $sans --output stroke.stl --stroke 0.03
expect 0 "" "Ego" --font $sans --output stroke.svg --stroke 0.03,round
expect 0 "" "Ego" --font $sans --output dashes.svg --stroke 0.03,bevel,square,0.05,0.08
that "dashes are pieces" [ "$(grep -o Z dashes.svg | wc -l)" -gt 20 ]
for wrong in 0 -1 11 x 0.03,flat 0.03,-1 "0.03,round,0.1;0.2" ""; do
    expect 2 "--stroke" "Ego" --font $sans --output no.glb --stroke "$wrong"
done
expect 2 "--stroke does not work with a --bend in the plane" "Ego" --font $sans --stats --stroke 0.03 --bend arc:90
expect 2 "--stroke does not work with --path" "Ego" --font $sans --stats --stroke 0.03 --path circle:2
expect 2 "--stroke does not work with --instances" "Ego" --font $sans --output no.glb --stroke 0.03 --instances

# SVG where pugixml is there, else a sentence.
printf '%s\n' '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 24 24"><style>.b, #c { fill: #0000ff }</style>' \
    '<defs><g id="dot"><circle r="2"/></g></defs><rect width="24" height="24" fill="currentColor"/>' \
    '<path class="b" d="M2 2h8v8H2z"/><use href="#dot" x="16" y="6" fill="red"/>' \
    '<g transform="translate(4 14)" stroke="#fff" stroke-width="2" fill="none"><path d="M0 2h16" stroke-dasharray="3 1"/></g>' \
    '</svg>' >drawing.svg
if "$program" --svg drawing.svg --output probe.glb >out 2>err; then
    for kind in glb obj stl ply svg dxf; do expect 0 "" --svg drawing.svg --output drawn.$kind; done
    that "colours of a drawing are parts" [ "$(grep -cE '^usemtl front_(000000|0000ff|ff0000|ffffff)' drawn.obj)" = 4 ]
    that "each colour of a drawing is a path" [ "$(grep -c '<path fill="#' drawn.svg)" = 4 ]
    that "what is covered is cut" [ "$(grep -o 'fill="#0000ff" d="[^"]*"' drawn.svg)" = 'fill="#0000ff" d="M0.8333 -5.8333L4.1667 -5.8333L4.1667 -9.1667L0.8333 -9.1667Z"' ]
    expect 0 "" --svg drawing.svg --output stacked.glb --colour-layers=stacked --picture stacked.png
    expect 0 "" --svg drawing.svg --output bevelled.stl --bevel 0.01 --colour red --size 40 --anchor centre,middle
    expect 0 "" --svg - --stats <drawing.svg
    printf '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 20 10"><path fill="red" d="M0 0h10v10h-10z"/><path fill="blue" d="M10 0h10v10h-10z"/></svg>' >icon.svg
    expect 0 "" "[box=4,1][box=2,2]" --markup --icon icon.svg --icon icon.svg --font $sans --depth 0 --output icons.obj
    that "an icon is as large as its box allows, and in the middle" grep -q "^icons.obj: 5 x 1.5" out
    that "each icon has its colours" [ "$(grep -c '^usemtl front_ff0000\|^usemtl front_0000ff' icons.obj)" = 4 ]
    expect 0 "" "a[box=2,1]b" --markup --icon icon.svg --font $sans --output icons.stl --bend cylinder:2 --picture icons.png
    expect 2 "--icon needs --markup" "ab" --icon icon.svg --font $sans --output no.glb
    expect 1 "--icon: none.svg cannot be read" "a[box=1,1]" --markup --icon none.svg --font $sans --output no.glb
    printf 'a[box=1,1]\nb[box=1,1]\n' >boxes.txt
    expect 1 "^text_to_mesh: --icon: none.svg cannot be read" --batch boxes.txt --markup --icon none.svg --font $sans --output "boxed{n}.stl"
    that "no line of a batch is made without its icon" [ ! -e boxed1.stl -a ! -e boxed2.stl ]
    printf 'a\nb[box=1,1]\n' >boxes.txt
    expect 0 "" --batch boxes.txt --markup --icon icon.svg --font $sans --output "boxed{n}.stl"
    expect 1 "--icon: there are 2 files, but the text has only 1 \\[box=W,H\\]\.$" "a[box=1,1]" --markup --icon icon.svg --icon icon.svg --font $sans --output no.glb
    expect 1 "--icon: there is 1 file, but the text has no \\[box=W,H\\]\.$" "a" --markup --icon icon.svg --font $sans --output no.glb
    expect 2 "--icon needs --discretiser certified" "a[box=1,1]" --markup --icon icon.svg --font $sans --output no.glb --discretiser adaptive
    for show in contours points control; do
        expect 2 "--show contours, points and control do not work with --icon" "a[box=1,1]" --markup --icon icon.svg --font $sans --picture no.png --show $show
    done
    expect 0 "" "a[box=1,1]" --markup --icon icon.svg --font $sans --instances --output icons.glb
    that "an icon has a name among letters" grep -aq '"icon_[0-9]' icons.glb
    expect 0 "" "[b]Hi[/b] [box=1,1]" --markup --icon icon.svg --font $sans --output icons.glb --picture icons.png
    expect 0 "" "[depth=0.5][box=1,1][/depth]a" --markup --icon icon.svg --font $sans --output solids.obj
    that "an icon is as deep as its box" [ "$(depth_of side_ff0000)" = 0.500 ]
    expect 0 "" "[style=7][box=1,1][/]" --markup --icon icon.svg --font $sans --output icons.obj
    that "a box's style is in the names of its icon's parts" grep -q '^usemtl front_ff0000-style7' icons.obj
    printf '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><path fill="red" d="M5 0a5 5 0 0 1 0 10z"/><path fill="blue" d="M5 0a5 5 0 0 0 0 10z"/></svg>' >disc.svg
    expect 0 "" "[box=10,10]" --markup --icon disc.svg --font $sans --output disc.obj --depth 0 --tolerance 0.001
    that "a large icon is as fine as the text" awk '$1 == "v" { x[++n] = $2; y[n] = $3 } $1 == "f" {
        split($2, a, "/"); split($3, b, "/"); split($4, c, "/"); i = a[1]; j = b[1]; k = c[1]
        area += ((x[j] - x[i]) * (y[k] - y[i]) - (x[k] - x[i]) * (y[j] - y[i])) / 2 }
        END { exit !(area > 78.5398 - 0.001 * 31.416 && area < 78.5398 + 0.001 * 31.416) }' disc.obj
    awk 'BEGIN { printf "<svg viewBox=\"0 0 2400 2400\"><path d=\""; for (i = 0; i < 2400; i += 2) printf "M%d 0h1v2400h-1zM0 %dh2400v1h-2400z", i, i; print "\"/></svg>" }' >woven.svg
    expect 1 "^text_to_mesh: woven.svg is too complex at this quality: choose a coarser --quality, or divide the drawing\.$" --svg woven.svg --output no.glb
    printf '<svg xmlns="http://www.w3.org/2000/svg"><text>a</text><text>b</text><path fill="url(#g)" d="M0 0h9v9z"/><linearGradient id="g"><stop stop-color="red"/></linearGradient><path d="M0 0h9v9zx"/></svg>' >lossy.svg
    expect 0 "^text_to_mesh: warning: <text> is not drawn\.$" --svg lossy.svg --output lossy.glb
    that "each kind of loss is named once" lines 3
    expect 1 "--strict: nothing is written" --svg lossy.svg --output no.glb --strict
    printf '<svg>\n<g>\n</svg>' >broken.svg
    expect 1 "^text_to_mesh: broken.svg, line 3: this is not XML: .*\.$" --svg broken.svg --output no.glb
    that "a malformed file has one sentence" lines 1
    printf '<html/>' >other.svg
    expect 1 "other.svg is not an SVG file: its root is <html>" --svg other.svg --output no.glb
    printf '<svg/>' >blank.svg
    expect 1 "the drawing is blank: nothing is written" --svg blank.svg --output no.glb
    printf '<svg xmlns="http://www.w3.org/2000/svg"><path id="a" d="M0 0h9v9z"/><g id="b"><use href="#b"/><use href="#a"/></g></svg>' >loop.svg
    expect 0 "warning: <use> of an element within itself is not drawn" --svg loop.svg --output loop.glb
    awk 'BEGIN { print "<svg><path id=\"a0\" d=\"M0 0h9v9z\"/>"; for (i = 1; i < 30; ++i) printf "<g id=\"a%d\"><use href=\"#a%d\"/><use href=\"#a%d\"/></g>\n", i, i - 1, i - 1; print "</svg>" }' >bomb.svg
    expect 1 "bomb.svg draws more than 200000 elements" --svg bomb.svg --output no.glb
    awk 'BEGIN { printf "<svg>"; for (i = 0; i < 5000; ++i) printf "<g>"; for (i = 0; i < 5000; ++i) printf "</g>"; print "</svg>" }' >deep.svg
    expect 1 "deep.svg has elements in each other.*more than 200 levels deep" --svg deep.svg --output no.glb
    awk 'BEGIN { printf "<svg>"; for (i = 0; i <= 20000; ++i) printf "<path d=\"M0 0h9v9z\" fill=\"#%06x\"/>", i; print "</svg>" }' >layers.svg
    expect 1 "layers.svg has more than 20000 layers of different colours" --svg layers.svg --output no.glb
    printf '\037\213' >packed.svg
    expect 1 "packed.svg is compressed: unpack it with gunzip" --svg packed.svg --output no.glb
    expect 1 "none.svg cannot be read: No such file" --svg none.svg --output no.glb
    { printf '<svg viewBox="0 0 9 9"><defs><path id="a" d="'; awk 'BEGIN { for (i = 0; i < 9000; ++i) printf "M0 0h9v9z" }'; printf '"/></defs>'; awk 'BEGIN { for (i = 0; i < 90000; ++i) printf "<use href=\"#a\"/>" }'; echo '</svg>'; } >curves_bomb.svg
    expect 1 "^text_to_mesh: curves_bomb.svg draws more than 1000000 curves, which is too much\.$" --svg curves_bomb.svg --output no.glb
    [ -c /dev/zero ] && expect 1 "/dev/zero contains more than 64 MB, which is too much for one mesh\.$" --svg /dev/zero --output no.glb
    expect 2 "--svg does not work with TEXT" x --svg drawing.svg --output no.glb
    expect 2 "--font does not work with --svg" --svg drawing.svg --font $sans --output no.glb
    expect 2 "--stroke does not work with --svg" --svg drawing.svg --stroke 0.1 --output no.glb
    expect 2 "--svg must be a file's name or -" --svg "" --output no.glb
    expect 2 "leave out --embolden and --bend" --svg drawing.svg --embolden 0.1 --output no.svg
    expect 2 "A .svg file has no stacked layers" --svg drawing.svg --colour-layers=stacked --output no.svg
    # A text's curves, read again: the same area. Lengths are in units of the larger side.
    expect 0 "" "Rag" --font $sans --output again.svg --quality best --stroke 0.04,round
    volume() { sed 's/.*"volume":\([0-9.e-]*\).*/\1/' out; }
    expect 0 "" "Rag" --font $sans --stats --quality best --stroke 0.04,round --merge
    text_volume=$(volume)
    expect 0 "" --svg again.svg --stats --tolerance 0.00002
    that "a text's curves cover what the text covers" awk -v text="$text_volume" -v again="$(volume)" \
        -v side="$(sed -n 's/.*width="\([0-9.]*\)mm".*/\1/p' again.svg)" \
        'BEGIN { ratio = again * side * side / 100 / text; exit !(text > 0 && ratio > 0.9995 && ratio < 1.0005) }'
    that "nothing is left of refused drawings" [ ! -e no.glb ]
else
    expect 1 "^text_to_mesh: --icon: SVG is not built in: " "[box=1,1]" --markup --icon drawing.svg --font $sans --output probe.glb
    expect 1 "^text_to_mesh: SVG is not built in: this program was built without pugixml, which reads XML\.$" --svg drawing.svg --output probe.glb
    that "nothing is left without pugixml" [ ! -e probe.glb ]
fi

# 3MF where lib3mf is there, else a sentence.
# Every directed edge is met by its reverse, and no edge by more than two triangles.
closed_3mf() {  # closed_3mf XML
    # shellcheck disable=SC2016  # awk's own $
    awk '
        match($0, /<triangle v1="[0-9]+" v2="[0-9]+" v3="[0-9]+"/) {
            split(substr($0, RSTART, RLENGTH), v, "\"")
            ++met[v[2] " " v[4]]; ++met[v[4] " " v[6]]; ++met[v[6] " " v[2]]; ++triangles
        }
        END {
            for (e in met) { split(e, ends, " "); if (met[e] != 1 || met[ends[2] " " ends[1]] != 1) bad = 1 }
            exit bad || triangles < 100
        }' "$1"
}
if "$program" x --font $sans --output probe.3mf >out 2>err; then
    expect 0 "" "Hello" --font $sans --output solid.3MF
    that "a 3MF is an archive" [ "$(head -c 2 solid.3MF)" = PK ]
    expect 0 "" "مرحبا" --font $arabic --output joined.3mf
    if command -v unzip >/dev/null 2>&1; then
        unzip -p joined.3mf 3D/3dmodel.model >joined.xml
        that "a 3MF holds closed solids" closed_3mf joined.xml
        that "an em is ten millimetres in a 3MF" grep -q 'unit="millimeter"' joined.xml
        that "a 3MF's letters are larger than a millimetre" grep -q '<vertex x="-\{0,1\}[1-9][0-9]\.' joined.xml
        that "a 3MF is painted by its parts" [ "$(grep -cE '<base name="[a-z]+" displaycolor="#[0-9A-F]{6}(FF)?" />' joined.xml)" = 3 ]
    fi
    expect 0 "" "Rag" --font $sans --output framed.3mf "${framed[@]}"
    expect 0 "" "Rag" --font $sans --output cutter.3mf --carve 60 --carve-as cutter
    expect 0 "" "مرحبا" --font $arabic --output bevelled.3mf "${bevels[@]}" --profile round
    if command -v unzip >/dev/null 2>&1; then
        unzip -p bevelled.3mf 3D/3dmodel.model >bevelled.xml
        that "a bevelled 3MF holds closed solids" closed_3mf bevelled.xml
        unzip -p framed.3mf 3D/3dmodel.model >framed.xml
        that "a ring and its letter are closed solids in a 3MF" closed_3mf framed.xml
        that "a bevelled 3MF is painted by five parts" [ "$(grep -cE '<base name="[a-z_]+" displaycolor="#[0-9A-F]{6}(FF)?" />' bevelled.xml)" = 5 ]
    fi
    [ -e disc.svg ] && expect 0 "" "[box=1,1]" --markup --icon disc.svg --font $sans --output icon.3mf --bevel 0.02
    expect 0 "" "بِ" --font $coloured --colour-layers --output ringed.3mf --outline 0.02 --outline-letter
    if command -v unzip >/dev/null 2>&1; then
        [ -e disc.svg ] && unzip -p icon.3mf 3D/3dmodel.model >icon.xml && that "an icon of two colours is two closed solids in a 3MF" closed_3mf icon.xml
        unzip -p ringed.3mf 3D/3dmodel.model >ringed.xml
        that "coloured letters and their rings are closed solids in a 3MF" closed_3mf ringed.xml
    fi
    for look in "--tube 0.02" "--inflate 1" "--plate 0.2 --bevel 0.01 --fillet 0.02"; do
        # shellcheck disable=SC2086  # words
        expect 0 "" "oi" --font $sans --output look.3mf $look
        if command -v unzip >/dev/null 2>&1; then
            unzip -p look.3mf 3D/3dmodel.model >look.xml
            that "a 3MF holds closed solids: $look" closed_3mf look.xml
        fi
    done
    expect 2 "--depth must be more than 0" x --font $sans --output x.3mf --depth 0
    for small in "--depth 1e-11" "--size 1e-9" "--depth 1e-6 --size 1e-6"; do
        # shellcheck disable=SC2086  # words
        expect 1 "^text_to_mesh: small.3mf cannot be written: --depth or --size is too small.*\.$" x --font $sans --output small.3mf $small
        that "a 3MF without a solid is not written: $small" [ ! -e small.3mf ]
    done
    expect 0 "" Ego --font $sans --output small.3mf --depth 1e-8
    if command -v unzip >/dev/null 2>&1; then
        that "what is too small for millimetres is in micrometres" sh -c 'unzip -p small.3mf 3D/3dmodel.model | grep -q "unit=\"micron\""'
    fi
else
    expect 1 "probe.3mf cannot be written: this program was built without lib3mf" x --font $sans --output probe.3mf
    that "nothing is left without lib3mf" [ ! -e probe.3mf ]
fi

# Fonts by family where fontconfig is there, else a sentence; no other family stands in.
if "$program" x --font "Liberation Sans" --output family.glb >out 2>err; then
    alike "a family's regular style is its file" glb x --font "Liberation Sans" / x --font $sans
    unlike "a style is another file" glb x --font "liberation sans:bold" / x --font $sans
    expect 0 "" x --font "Liberation Sans:oblique" --output bold.glb  # its slanted style is called italic
    alike "a style may be written as a name" glb x --font "DejaVu Sans:bold:oblique" / x --font "DejaVu Sans:Bold Oblique"
    alike "the system's Liberation Sans stands in for Arial" glb x --font Arial / x --font "Liberation Sans"
    unlike "so do its styles" glb x --font "Arial:bold" / x --font $sans
    expect 0 "" x --font monospace --output mono.glb
    expect 1 "has that (style|slant)" x --font "Liberation Sans:Semi Condensed" --output x.glb
    for words in blod zzz wght=700 weight=blod bold:zzz; do
        expect 1 "^text_to_mesh: Liberation Sans:$words: fontconfig has no .*\.$" x --font "Liberation Sans:$words" --output x.glb
    done
    for words in style=Blod light condensed; do
        expect 1 "^text_to_mesh: Liberation Sans:$words: no installed font of this family has that .*\.$" x --font "Liberation Sans:$words" --output x.glb
    done
    expect 1 "^text_to_mesh: Nobodys Sans is neither a file nor an installed family" x --font "Nobodys Sans" --output x.glb
    alike "--family is --font where nothing is lacking" glb x --family "Liberation Sans" / x --font "Liberation Sans"
    unlike "fonts that are named come before those that are found" glb "$many" --family "Comic Neue" --strict / "$many" --family "Comic Neue" --fallback $arabic --strict
    expect 1 "^text_to_mesh: --family: Nobodys Sans is neither a file nor an installed family" x --family "Nobodys Sans" --output x.glb
else
    expect 1 "--family: this program was built without fontconfig" x --family "Liberation Sans" --output x.glb
    that "why no family is found" grep -q "Liberation Sans is no file, and this program was built without fontconfig" err
fi

# What has no letters is no file.
for text in "" " " "\\n\\n" "$(printf '\t')"; do
    expect 1 "^text_to_mesh: the text is blank: nothing is written.$" "$text" --font $sans --output blank.glb --picture blank.png
done
expect 1 "no character of the text can be drawn: nothing is written" "日本" --font $sans --output blank.glb
that "what is missing comes first, by number and as it is" grep -q "no glyph for 2 of 2 characters (U+65E5 日, U+672C 本); the first is at byte 0 of the text. Give another --font, or add a font with --fallback.$" err
expect 0 "no font has a glyph for 1 of 3 characters .U\+8336 茶.; .* Add another font with --fallback\.$" "a茶b" --font $sans --fallback $arabic --stats
expect 0 "for 2 of 4 characters .U\+0915 क, U\+094D.; the first is at byte 1 " "aक्b" --font $sans --stats
that "a blank text leaves no file" [ ! -e blank.glb ]
expect 0 "" " " --font $sans --stats

# Warnings: features that the font has not, numbers too coarse for the place.
expect 0 "the font has no feature zzzz" x --font $sans --feature zzzz --output feature.glb
expect 0 "" x --font $sans --feature zzzz=0 --feature kern --stats
long=$(printf 'Hamburgefonstiv %.0s' $(seq 30))
expect 0 "[0-9]+ triangles of each face are turned over or flat.*: make the lines shorter\.$" "$long" --letter-spacing 8 --font "$awami" --touching keep --output long.ply
expect 0 "make the lines shorter, or give --instances\.$" "$long" --letter-spacing 8 --font "$awami" --output long.glb
expect 1 "--strict: nothing is written" "$long" --letter-spacing 8 --font "$awami" --touching keep --output strict.ply --strict
expect 0 "" "$long" --letter-spacing 8 --font "$awami" --output told_apart.ply --strict
expect 1 "--strict: nothing is written" x --font $sans --feature zzzz --output strict.ply --strict
that "--strict makes every warning an error" [ ! -e strict.ply ]
expect 0 "" "$long" --letter-spacing 8 --font "$awami" --output long.glb --instances
that "warnings stand in one line each" lines 0

# On a terminal each step is shown in one line that is gone at the end; nothing of it is seen elsewhere.
if command -v script >/dev/null 2>&1 && script -qec true /dev/null >/dev/null 2>&1; then
    script -qec "'$program' Hello --font $sans --output seen.glb" /dev/null >terminal </dev/null
    that "a terminal shows what goes on" grep -q "writing seen.glb" terminal
    that "the line is gone before the size is printed" grep -qE $'\033\\[Kseen.glb: [0-9.]+ x [0-9.]+ x 0.2\r?$' terminal
fi

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
expect 1 "--face 7: .* has only 1 face, counted from 0" x --font $sans --face 7 --output x.glb
expect 2 "--fallback must be a font, not an empty name" x --font $sans --fallback "" --output x.glb
expect 2 "size must be a number from 1e-30 to 1000000, not 1e-40" x --font $sans --output x.glb --size 1e-40
expect 1 "no such variation axis" x --font $sans --variation wght=700 --output x.glb
expect 1 "cannot be written" x --font $sans --output /nowhere/x.glb
that "nothing was half-written" sh -c '! ls -A | grep -F .part'

# Wrong usage, status 2.
expect 2 "TEXT" --font $sans --output x.glb
expect 2 "--font" x --output x.glb
expect 2 "nothing to do" x --font $sans
expect 2 "^text_to_mesh: two was not expected" one --font $sans --output x.glb -- two
expect 2 "must end in .*3mf, .svg or .dxf, not x.fbx" x --font $sans --output x.fbx
expect 2 "^text_to_mesh: --quality must be low, normal, high or best, not superb\.$" x --font $sans --output x.glb --quality superb
that "what to do comes after what is wrong" lines 2
expect 2 "align must be left, center, right, start, end or justify, not middle" x --font $sans --output x.glb --align middle
expect 2 "show must be .*checker, not trangles" x --font $sans --output x.glb --show points,trangles
expect 2 "excludes" x --font $sans --output x.glb --quality low --tolerance 0.1
for how in adaptive two_lines; do
    expect 2 "--tolerance needs --discretiser certified" x --font $sans --output x.glb --discretiser $how --tolerance 0.1
done
expect 2 "--quality does not work with --discretiser two_lines" x --font $sans --output x.glb --discretiser two_lines --quality low
for option in "--show points" "--shading flat" "--turn 10"; do
    # shellcheck disable=SC2086  # an option and its value
    expect 2 "${option% *} needs --picture" x --font $sans --output x.glb $option
done
expect 2 "turn must be a number from -180 to 180, not 181" x --font $sans --picture x.png --turn 181
for setting in "feature ligatures" "feature liga= 1" "variation bold" "variation wght=0x10"; do
    expect 2 "${setting%% *} must have the form .*, not ${setting#* }" x --font $sans --output x.glb "--${setting%% *}" "${setting#* }"
done
expect 2 "nonsense is not an option\.$" x --font $sans --output x.glb --nonsense
expect 2 "--fnot is not an option: did you mean --font\?" x --fnot $sans --output x.glb
expect 2 "--ouptut is not an option: did you mean --output\?" x --font $sans --ouptut=x.glb
expect 0 "" x --font $sans --output --fnot.glb  # a value may look like an option
that "a value may look like an option" test -s ./--fnot.glb
expect 2 "-q is not an option" x --font $sans --output x.glb -q
expect 2 "^text_to_mesh: y was not expected: .*quotes" x y --font $sans --output x.glb
expect 2 "output needs a value" x --font $sans --output
expect 2 "font may be given only once" x --font $sans --font $sans --output x.glb
for tolerance in -1 abc inf; do
    expect 2 "tolerance must be a positive number, not $tolerance" x --font $sans --output x.glb --tolerance $tolerance
done
for depth in nan 0x10 +1 "1 " 1e999; do
    expect 2 "depth must be a number from 0 to 1000, not ${depth/+/\\+}\.$" x --font $sans --output x.glb --depth "$depth"
done
for face in -1 0x0; do expect 2 "face must be a whole number, not $face" x --font $sans --output x.glb --face $face; done
expect 2 "size must be a number from 1e-30 to 1000000, not 0" x --font $sans --output x.glb --size 0
expect 2 "letter-spacing must be a number from -1000 to 1000, not wide" x --font $sans --output x.glb --letter-spacing wide
expect 2 "line-spacing must be a number from -1000 to 1000, not nan" x --font $sans --output x.glb --line-spacing nan
expect 2 "crease must be a number from 0 to 180, not 200" x --font $sans --output x.glb --crease 200


# Names of parts by their colours, which equal colours share; one colour for all.
expect 0 "" "abcabc" --font $sans --style 0..1:colour=red --style 2..3:colour=#d0282c --style 3..4:colour=#000001 --color blue --output named.obj
that "equal colours have one name, and each colour its own" [ "$(grep -c '^usemtl' named.obj) $(grep '^usemtl front' named.obj | sort | tr '\n' ' ')" = "9 usemtl front_000001 usemtl front_blue usemtl front_red " ]
expect 0 "" "abcabc" --font $sans --colour blue --output blue.obj
that "--colour is for all" [ "$(grep '^usemtl' blue.obj | tr '\n' ' ')" = "usemtl front_blue usemtl back_blue usemtl side_blue " ]
expect 2 "colour must be #2060c0, or black, .*, not mauve" x --font $sans --output x.glb --colour mauve
expect 0 "" "e fee" --font $sans --instances --style 0..1:colour=red --style 3..5:colour=red,underline --output styled.glb
that "instances have colours" grep -aq '"name":"front_red"' styled.glb
that "every node has a name" [ "$(grep -ao '"nodes":\[{.*}\],"scene"' styled.glb | grep -o '"name"' | wc -l)" = 6 ]
that "letters are named and counted, bars too" grep -aq '"name":"bar_5"' styled.glb
that "the text is kept" grep -aq '"extras":{"text":"e fee"}' styled.glb
that "and each letter's" [ "$(grep -ao '"extras":{"text":"e"}' styled.glb | wc -l)" = 3 ]

# Short options; standard input and output; files of texts.
expect 0 "" "a\\nb" -f $sans -o lines.glb
for way in "- -" "--text-file -" "--text-file two.txt"; do
    printf '\xEF\xBB\xBFa\r\nb\r\n' >two.txt
    # shellcheck disable=SC2086  # words
    expect 0 "" ${way#- } -f $sans --output lines2.glb <two.txt
    that "the text of $way equals the argument" cmp -s lines.glb lines2.glb
done
printf 'a\\nb' >two.txt
expect 0 "" --text-file two.txt -f $sans -o literal.glb
that "a backslash in a file is one" differ lines.glb literal.glb
for kind in glb obj stl ply; do
    expect 0 "" x -f $sans -o piped.$kind
    "$program" x -f $sans -o - --format $kind >piped 2>err
    [ $kind = obj ] && sed -i '/^mtllib\|^usemtl/d' piped.obj
    that "standard output has the same $kind" cmp -s piped piped.$kind
done
expect 0 "" x -f $sans --picture piped.png
"$program" x -f $sans --picture - >piped 2>err
that "standard output has the same picture" cmp -s piped piped.png
if [ -c /dev/full ]; then
    "$program" x -f $sans -o - --format stl >/dev/full 2>err
    that "a full standard output is reported" grep -q "^text_to_mesh: standard output cannot be written: No space left on device\.$" err
fi
expect 2 "--output - needs --format" x -f $sans -o -
expect 2 "--stats prints on standard output, which already contains the mesh" x -f $sans -o - --format stl --stats
expect 2 "--picture - is standard output, which already contains the mesh" x -f $sans -o - --format stl --picture -
expect 2 "--format is stl, but the name of --output is x.glb" x -f $sans -o x.glb --format stl
expect 2 "--output must not end in .mtl" x -f $sans -o x.mtl --format obj
expect 0 "" x -f $sans -o x.dat --format stl
that "--format makes up for a name" cmp -s x.dat piped.stl
expect 2 "^text_to_mesh: TEXT begins with @: give --text-file names.txt for a file, or .@names.txt for this text\.$" @names.txt -f $sans -o x.glb
for text in @x -; do
    printf %s "$text" >text.txt
    expect 0 "" "\\$text" -f $sans -o escaped.glb
    expect 0 "" --text-file text.txt -f $sans -o own.glb
    that "a backslash makes letters of $text" cmp -s escaped.glb own.glb
done
expect 1 "nowhere.txt cannot be read: No such file" --text-file nowhere.txt -f $sans -o x.glb
[ -c /dev/zero ] && expect 1 "/dev/zero contains more than 64 MB" --text-file /dev/zero -f $sans -o x.glb
expect 1 "taken cannot be read: Is a directory" --batch taken -f $sans -o "{n}.glb"
expect 2 "--text-file does not work with TEXT" x --text-file two.txt -f $sans -o x.glb
expect 2 "--batch does not work with --text-file" --batch two.txt --text-file two.txt -f $sans -o "{n}.glb"
expect 2 "--output must contain .n. or .text. for --batch" --batch two.txt -f $sans -o x.glb
expect 2 "there is no text: give TEXT, --text-file, --batch or --svg" -f $sans -o x.glb
mkdir tags && printf 'Anna\n\n \nB/o:b\n@c\n../d\n' >names.txt
expect 0 "" --batch names.txt -f $sans -o "tags/{n} {text}.stl" --picture "tags/{n}.png"
that "a batch makes a file a line" [ "$(cd tags && printf '%s,' *)" = "1 Anna.stl,1.png,4 B_o_b.stl,4.png,5 @c.stl,5.png,6 _._d.stl,6.png," ]
that "and says how large each is" [ "$(grep -cE '^tags/[0-9] .*\.stl: [0-9.]+ x [0-9.]+ x 2 mm$' out)" = 4 ]
expect 0 "" Anna -f $sans -o alone.stl
that "a line's file equals the file of its text" cmp -s alone.stl "tags/1 Anna.stl"
expect 1 "^text_to_mesh: --batch: lines 2 and 3 would both make x.glb\.$" --batch - -f $sans -o "{text}.glb" < <(printf 'y\nx\nx\n')
expect 1 "^text_to_mesh: --batch: every line is blank" --batch - -f $sans -o "{n}.glb" < <(printf '\n \n')
expect 1 "^text_to_mesh: line 2: --style: 0..2 ends after the text" --batch - -f $sans -o "row{n}.glb" --style 0..2:underline < <(printf 'ab\nc\nde\n')
that "one bad line leaves the others" [ "$(ls row?.glb | tr '\n' ' ')" = "row1.glb row3.glb " ]
expect 0 "^text_to_mesh: line 1: the font has no glyph for 1 of 2" --batch - -f $sans --stats < <(printf 'a茶\nb\n')
that "a batch has a line of statistics a text" [ "$(wc -l <out)" = 2 ]

# Printing: millimetres, on z = 0, in a box; --anchor and --origin.
bounds() {  # bounds FILE.obj: low and high of x, y and z
    awk '$1 == "v" { for (c = 2; c < 5; ++c) { if (!n || $c < l[c]) l[c] = $c; if (!n || $c > h[c]) h[c] = $c } n = 1 }
        END { for (c = 2; c < 5; ++c) printf "%.4f %.4f ", l[c] + (l[c] > -5e-5 && l[c] < 0 ? 5e-5 : 0), h[c] }' "$1"
}
stats_of() { grep -oE "\"$1\":[^}]*\]" out | head -1; }
expect 0 "" "HH" -f $sans -o print.stl --stats
that "an STL is in millimetres, ten an em, on z = 0" grep -qE '"bounds":\{"low":\[0.82[0-9]*,0,0\],"high":\[13.6[0-9]*,6.8[0-9]*,2\]\},"size":\[12.8[0-9]*,6.8[0-9]*,2\],"unit":"mm","volume":[0-9.]+,' out
volume=$(grep -oE '"volume":[0-9.]+' out)
expect 0 "" "HH" -f $sans -o print.stl --depth 0.4 --stats
that "twice the depth is twice the volume" awk -v a="${volume#*:}" -v b="$(grep -oE '"volume":[0-9.]+' out | cut -d: -f2)" 'BEGIN { exit !(b / a > 1.9999 && b / a < 2.0001) }'
expect 0 "" "HH" -f $sans -o instances.glb --size 10 --instances --stats
that "instances have the same volume" awk -v a="${volume#*:}" -v b="$(grep -oE '"volume":[0-9.]+' out | cut -d: -f2)" 'BEGIN { exit !(b / a > 0.9999 && b / a < 1.0001) }'
expect 2 "--depth must be more than 0 in a .stl file, which contains solids" x -f $sans -o x.stl --depth 0
expect 0 "" "HIL" -f $sans -o own.obj
that "elsewhere the front is on z = 0" [ "$(bounds own.obj | cut -d' ' -f5-)" = "-0.2000 0.0000 " ]
for place in left,bottom,base/0.0000/0.0000/0.0000 left,top,front/0.0000/-0.6880/-0.2000 base,left/0.0000/0.0000/0.0000; do
    expect 0 "" "HIL" -f $sans -o placed.obj --anchor "${place%%/*}"
    that "--anchor ${place%%/*} has its lowest corner at ${place#*/}, not $(bounds placed.obj)" [ "$(bounds placed.obj | awk '{ printf "%s/%s/%s", $1, $3, $5 }')" = "${place#*/}" ]
done
expect 0 "" "HIL" -f $sans -o placed.obj --anchor centre,middle,halfway --origin 100,-20,3 --bevel 0.01 --bevel-out
that "--origin is where that comes to" [ "$(bounds placed.obj | awk '{ printf "%.3f %.3f %.3f", ($1 + $2) / 2, ($3 + $4) / 2, ($5 + $6) / 2 }')" = "100.000 -20.000 3.000" ]
expect 0 "" "HIL" -f $sans -o placed.glb --anchor centre,base --origin 1,2 --instances --stats
that "so it is for instances" grep -qE '"bounds":\{"low":\[0.[0-9]+,2,0\],"high":\[1.[0-9]+,2.68[0-9]*,0.2\]' out
expect 2 "--anchor must be some of left, centre" x -f $sans -o x.obj --anchor leftish
expect 2 "--anchor may have only one word for each direction, not left,right" x -f $sans -o x.obj --anchor left,right
for origin in 1 a,b 1,2,3,4 1,2, 1e7,0; do expect 2 "--origin must be two or three numbers" x -f $sans -o x.obj --origin "$origin"; done
expect 2 "--anchor needs --output" x -f $sans --stats --anchor left
expect 1 "--origin: z is so large that" x -f $sans -o x.obj --depth 1e-3 --origin 0,0,1e6
filled() {  # filled WxH TEXT OPTION...: what is seen touches the box, and is not larger
    expect 0 "" "$2" -f $sans --fit "$1" -o filled.obj "${@:3}"
    that "$2 fills $1 ${*:3}: $(bounds filled.obj)" awk -v b="$(bounds filled.obj)" -v box="$1" 'BEGIN {
        split(b, p, " "); split(box, s, "x"); w = (p[2] - p[1]) / s[1]; h = (p[4] - p[3]) / s[2]
        exit !(w <= 1.0001 && h <= 1.0001 && (w > 0.9998 || h > 0.9998)) }'
}
filled 80x20 Hello
filled 80x20 "Hello world"
filled 20x80 "one two three four"
filled 80x80 "one two three four five" --align centre --bevel 0.02 --bevel-out
filled 80x30 "one two three four five" --breaker total_fit --embolden 0.01
filled 30x50 "one two three four five" --direction ttb
filled 50x50 "one two three four five" --wrap letter
filled 50x9 "x.,;" --outline 0.05 --outline-place outer
expect 0 "" "Hello" -f $sans --fit 80x20 -o filled.stl
that "how large it is is printed" grep -qx "filled.stl: [0-9.]* x 20 x [0-9.]* mm" out

# What is interrupted leaves no file.
if command -v mkfifo >/dev/null 2>&1; then
    mkfifo held.png
    for signal in TERM HUP; do
        "$program" Hello -f $sans -o held.glb --picture held.png >/dev/null 2>&1 &
        for _ in $(seq 200); do if ls -A | grep -qF .part; then break; fi; sleep 0.05; done
        that "a mesh is on its way" sh -c 'ls -A | grep -qF .part'
        kill -$signal $!
        wait $! 2>/dev/null
        that "SIG$signal leaves no part of it" sh -c '! ls -A | grep -F -e .part -e held.glb'
    done
fi

for width in nan -1 1001 wide; do
    expect 2 "^text_to_mesh: --bevel must be a number from 0 to 1000, not $width\.$" x --font $sans --output x.glb --bevel $width
    expect 2 "^text_to_mesh: --bevel-depth must be a number from 0 to 1000, not $width\.$" x --font $sans --output x.glb --bevel 0.02 --bevel-depth $width
done
expect 2 "^text_to_mesh: --bevel-depth must be at most half of --depth 0\.2, not 0\.11\.$" x --font $sans --output x.glb --bevel 0.02 --bevel-depth 0.11
expect 0 "" x --font $sans --output deep.glb --bevel 0.02 --bevel-depth 0.1
expect 0 "" x --font $sans --output deep.glb --bevel 0.02 --bevel-depth 0.2 --bevel-sides back
for profile in stepped engraved "0,0;0.5,0;1,1"; do
    expect 2 "^text_to_mesh: --bevel-depth must be less than half of --depth 0\\.2, not 0\\.1\.$" x --font $sans --output x.glb --bevel 0.02 --bevel-depth 0.1 --profile "$profile"
    expect 0 "" x --font $sans --output deep.glb --bevel 0.02 --bevel-depth 0.099 --profile "$profile"
done
expect 2 "^text_to_mesh: --bevel-depth must be at most --depth 0\.2, not 0\.21\.$" x --font $sans --output x.glb --bevel 0.02 --bevel-depth 0.21 --bevel-sides front
expect 2 "^text_to_mesh: --bevel without --bevel-depth must be at most half of --depth 0\.2, not 0\.3\.$" x --font $sans --output x.glb --bevel 0.3
for profile in "" rond "0,0;0.5;1,1" "0,0;;1,1" "0,0;nan,0;1,1" ",0;1,1" "0,0;1,1;" "0,0,0;1,1"; do
    expect 2 "^text_to_mesh: --profile must be chamfer, round, concave, stepped, engraved or points such as 0,0;0\.2,0\.8;1,1, not \"$profile\"\.$" x --font $sans --output x.glb --bevel 0.02 --profile "$profile"
done
expect 2 "^text_to_mesh: --profile must have rising t, but t falls at 0\.3,0\.7 in \"0,0;0\.5,0\.5;0\.3,0\.7;1,1\"\.$" x --font $sans --output x.glb --bevel 0.02 --profile "0,0;0.5,0.5;0.3,0.7;1,1"
expect 2 "^text_to_mesh: --profile must have each h from 0 to 1, not \"0,0;0\.5,1\.5;1,1\"\.$" x --font $sans --output x.glb --bevel 0.02 --profile "0,0;0.5,1.5;1,1"
for profile in "0,0" "0.1,0;1,1" "0,0.1;1,1" "0,0;0.5,1" "0,0;2,1"; do
    expect 2 "^text_to_mesh: --profile must begin at 0,0 and end at t = 1, not \"$profile\"\.$" x --font $sans --output x.glb --bevel 0.02 --profile "$profile"
done
expect 0 "" x --font $sans --output x64.glb --bevel 0.02 --profile "0,0;$(printf '0.5,0.5;%.0s' $(seq 62))1,1"
expect 2 "^text_to_mesh: --profile must have at most 64 points, not 65\.$" x --font $sans --output x.glb --bevel 0.02 --profile "0,0;$(printf '0.5,0.5;%.0s' $(seq 63))1,1"
expect 2 "bevel-steps must be a whole number from 0 to 63, not 64" x --font $sans --output x.glb --bevel 0.02 --profile round --bevel-steps 64
expect 2 "--bevel-steps needs --profile round or concave" x --font $sans --output x.glb --bevel 0.02 --bevel-steps 4
expect 2 "bevel-mode must be clip, fit or fit_text, not fill" x --font $sans --output x.glb --bevel 0.02 --bevel-mode fill
expect 2 "bevel-sides must be front, back or both, not top" x --font $sans --output x.glb --bevel 0.02 --bevel-sides top
for width in 1000 100; do
    rm -f wide.glb; echo kept >wide.glb
    expect 1 "^text_to_mesh: --bevel is too wide for this font: give a smaller number\.$" x --font $sans --output wide.glb --bevel $width --bevel-out --bevel-depth 0.02
    that "a bevel that is too wide leaves the old file alone" [ "$(cat wide.glb)" = kept ]
done
expect 0 "" x --font $sans --output wide.glb --bevel 200 --bevel-depth 0.02
expect 1 "^text_to_mesh: --bevel is too wide for this font: give a smaller number\.$" x --font $sans --output wide.glb --bevel 1000 --bevel-depth 0.02
expect 1 "^text_to_mesh: --outline is too narrow for this font: give a larger number\.$" x --font $sans --output thin_ring.glb --outline 1e-7
that "an outline that is too narrow writes nothing" [ ! -e thin_ring.glb ]
expect 2 "^text_to_mesh: --bevel-out takes no value\.$" x --font $sans --output x.glb --bevel 0.02 --bevel-out=wide
expect 2 "--bevel needs a solid" x --font $sans --output x.glb --bevel 0.02 --depth 0
expect 2 "--normals does not work with --bevel" x --font $sans --output x.glb --bevel 0.02 --normals cap
for width in -0.01 1.5 nan wide; do
    expect 2 "^text_to_mesh: --outline must be a number from 0 to 1, not $width\.$" x --font $sans --output x.glb --outline $width
done
for by in -1.5 2 nan bold; do
    expect 2 "^text_to_mesh: --embolden must be a number from -1 to 1, not $by\.$" x --font $sans --output x.glb --embolden $by
done
expect 2 "outline-place must be inner, center or outer, not top" x --font $sans --output x.glb --outline 0.02 --outline-place top
expect 2 "^text_to_mesh: --bevel-out does not work with --outline-letter, because the ring would grow into the letter\.$" x --font $sans --output x.glb --outline 0.02 --outline-letter --bevel 0.01 --bevel-out
expect 0 "" "ab" --font $sans --output ring.obj --outline 0.02 --outline-letter --style 0..1:colour=red --style 1..2:colour=white
that "a letter within a coloured ring has another colour" [ "$(grep '^Kd' ring.mtl | sort -u | wc -l)" = 8 ]
# Walls in segments: each wall has that many times its two triangles, and the caps are unchanged.
whole() { sed -n 's/.*"vertices":[0-9]*,"triangles":\([0-9]*\),.*/\1/p' "$1"; }
for number in 1 2 5; do
    expect 0 "" "Rag" --font $sans --output segments.stl --stats --segments $number && cp out segments$number.stats
done
one=$(whole segments1.stats) two=$(whole segments2.stats) five=$(whole segments5.stats)
that "each segment adds as many triangles: $one, $two, $five" [ $((five - one)) = $((4 * (two - one))) ]
that "a segment adds triangles" [ "$two" -gt "$one" ]
alike "one segment is the default" glb "Rag" --font $sans / "Rag" --font $sans --segments 1
for option in "--bevel 0.02" "--bevel 0.02 --bevel-out" "--outline 0.02 --outline-letter" "--refine delaunay" "--normals cap" "--normals shared"; do
    # shellcheck disable=SC2086  # words
    expect 0 "" "Rag" --font $sans --output segments.glb $option --segments 3
done
for number in 0 1025 -1 2.5 nan many; do
    expect 2 "^text_to_mesh: --segments must be a whole number from 1 to 1024, not $number\.$" x --font $sans --output x.glb --segments $number
done
expect 2 "^text_to_mesh: --segments needs a solid, but --depth 0 makes a flat mesh: give a larger --depth\.$" x --font $sans --output x.glb --depth 0 --segments 2
# Levels of detail.
expect 0 "" "Rag" --font $sans --output levels.glb --lod 0.003,0.006,0.02
that "the triangles of the levels are printed" grep -qE '^levels\.glb: [0-9.x ]+; triangles of the levels: [0-9]+, [0-9]+, [0-9]+, [0-9]+$' out
that "levels have fewer and fewer triangles: $(cat out)" awk -F'[:,]' '{ exit !($3 > $4 + 0 && $4 > $5 + 0 && $5 > $6 + 0) }' out
that "the finest level names the others" grep -aq '"MSFT_lod":{"ids":\[1,2,3\]}' levels.glb
that "only the finest level is in the scene" grep -aq '"nodes":\[0\]' levels.glb
expect 0 "" "Rag" --font $sans --output levels.glb --lod 0.02 --bevel 0.02 --anchor centre,base --stats
expect 2 "^text_to_mesh: --lod needs --output FILE\.glb\.$" x --font $sans --output x.obj --lod 0.01
expect 2 "^text_to_mesh: --lod does not work with --instances\.$" x --font $sans --output x.glb --lod 0.01 --instances
expect 2 "^text_to_mesh: --lod does not work with --embolden\.$" x --font $sans --output x.glb --lod 0.01 --embolden 0.01
expect 2 "^text_to_mesh: --lod must be rising numbers, not \"0.02,0.01\"\.$" x --font $sans --output x.glb --lod 0.02,0.01
expect 2 "^text_to_mesh: --lod must be positive numbers such as 0\.01,0\.04, not \"0.02,\"\.$" x --font $sans --output x.glb --lod 0.02,
expect 2 "^text_to_mesh: --lod must have at most 6 levels" x --font $sans --output x.glb --lod 1,2,3,4,5,6,7
expect 2 "^text_to_mesh: --lod must be above the finest distance" x --font $sans --output x.glb --lod 0.001
# Refined letters: more triangles, none with a small angle, no long edge; the solid stays closed (external/admesh.sh).
triangles() { sed -n 's/.*"triangles": *\([0-9]*\).*/\1/p' "$1"; }
expect 0 "" "Rag" --font $sans --output plain.stl --stats && cp out plain.stats
expect 0 "" "Rag" --font $sans --output refined.stl --stats --refine delaunay --max-edge 0.05 && cp out refined.stats
that "refining adds triangles: $(triangles plain.stats) to $(triangles refined.stats)" [ "$(triangles refined.stats)" -gt $((3 * $(triangles plain.stats))) ]
expect 0 "" "Rag" --font $sans --output squared.stl --stats --refine quadtree --max-edge 0.05 && cp out squared.stats
that "squares are about as many: $(triangles refined.stats) to $(triangles squared.stats)" [ "$(triangles squared.stats)" -gt "$(triangles refined.stats)" ]
that "squares are less than twice as many" [ "$(triangles squared.stats)" -lt $((2 * $(triangles refined.stats))) ]
expect 0 "" "Rag" --font $sans --output same.stl --stats --refine quadtree && cp out same.stats
that "the longest edge of a quadtree is 0.05 em by default" cmp squared.stl same.stl
expect 0 "" "Rag" --font $sans --output right.stl --stats --refine nonobtuse && cp out right.stats
that "right triangles are some times as many" [ "$(triangles right.stats)" -gt $((3 * $(triangles plain.stats))) ]
alike "any edge is the default" stl "Rag" --font $sans --refine nonobtuse / "Rag" --font $sans --refine nonobtuse --max-edge 0
expect 0 "" "Rag" --font $sans --output short.stl --stats --refine nonobtuse --max-edge 0.05 && cp out short.stats
that "shorter edges are more triangles" [ "$(triangles short.stats)" -gt "$(triangles right.stats)" ]
expect 2 "^text_to_mesh: --min-angle needs --refine delaunay\.$" x --font $sans --output x.glb --refine nonobtuse --min-angle 20
expect 2 "^text_to_mesh: --min-angle needs --refine delaunay\.$" x --font $sans --output x.glb --refine quadtree --min-angle 20
expect 2 "^text_to_mesh: --max-edge must be above 0 with --refine quadtree\.$" x --font $sans --output x.glb --refine quadtree --max-edge 0
expect 2 "^text_to_mesh: --refine must be delaunay, quadtree or nonobtuse, not squares\.$" x --font $sans --output x.glb --refine squares
expect 1 "^text_to_mesh: --max-edge is too small for this font: give a larger number\.$" x --font $sans --output x.glb --refine quadtree --max-edge 1e-6
expect 2 "^text_to_mesh: --max-edge needs --refine\.$" x --font $sans --output x.glb --max-edge 0.1
expect 2 "^text_to_mesh: --refine does not work with --bevel\.$" x --font $sans --output x.glb --refine delaunay --bevel 0.01
expect 2 "^text_to_mesh: --refine does not work with --outline\.$" x --font $sans --output x.glb --refine delaunay --outline 0.01
expect 2 "^text_to_mesh: --min-angle must be a number from 0 to 33, not 60\.$" x --font $sans --output x.glb --refine delaunay --min-angle 60
expect 1 "^text_to_mesh: --max-edge is too small for this font: give a larger number\.$" x --font $sans --output x.glb --refine delaunay --max-edge 1e-6
# Carved letters: a relief stands on its back, a groove lies below z = 0, and the slope is the tool's.
depth_of() { awk '$1 == "v" { if (!n++ || $4 < low) low = $4; if (n == 1 || $4 > high) high = $4 } END { printf "%.4f %.4f", low, high }' "$1"; }
expect 0 "" "i" --font $sans --output relief.obj --carve 90 --anchor front --origin 0,0,0
expect 0 "" "Rag" --font $sans --output relief.stl --carve 60
expect 0 "" "Rag" --font $sans --output floor.obj --carve 60 --carve-depth 0.02
expect 0 "" "Rag" --font $sans --output groove.obj --carve 60 --carve-depth 0.02 --carve-as groove
that "a relief of --carve-depth is so deep: $(depth_of floor.obj)" [ "$(depth_of floor.obj)" = "0.0000 0.0200" ]
that "a groove lies below z = 0: $(depth_of groove.obj)" [ "$(depth_of groove.obj)" = "-0.0200 0.0000" ]
that "a relief without a floor has no front" sh -c '! grep -qx "g front" relief.obj'
that "a relief with a floor has one" grep -qx "g front" floor.obj
that "a groove has no back" sh -c '! grep -qx "g back" groove.obj'
expect 2 "^text_to_mesh: --carve must be a number from 1 to 179, not 180\.$" x --font $sans --output x.glb --carve 180
expect 2 "^text_to_mesh: --carve-depth needs --carve\.$" x --font $sans --output x.glb --carve-depth 0.1
expect 2 "^text_to_mesh: --carve-as needs --carve\.$" x --font $sans --output x.glb --carve-as groove
expect 2 "^text_to_mesh: --depth does not work with --carve: give --carve-depth\.$" x --font $sans --output x.glb --carve 60 --depth 0.1
expect 2 "^text_to_mesh: --bevel does not work with --carve\.$" x --font $sans --output x.glb --carve 60 --bevel 0.01
expect 2 "^text_to_mesh: --outline does not work with --carve\.$" x --font $sans --output x.glb --carve 60 --outline 0.01
expect 2 "^text_to_mesh: --refine does not work with --carve\.$" x --font $sans --output x.glb --carve 60 --refine delaunay
expect 2 "--normals does not work with --carve" x --font $sans --output x.glb --carve 60 --normals cap
expect 2 "--carve-as groove is an open surface, but a \.stl file contains solids" x --font $sans --output x.stl --carve 60 --carve-as groove

# Text that is warped in its plane: the letters differ, bevels and outlines stay closed, and the front stays flat.
expect 0 "" "HILL" --font $sans --output flat.obj
for warp in arc:90 arch:0.3,0 flag:0.2,0 flag:0.1,1 perspective:0.5; do
    expect 0 "" "HILL" --font $sans --output warped.obj --bend $warp
    that "--bend $warp changes the letters" differ warped.obj flat.obj
    that "--bend $warp keeps the depth" larger "$(widest warped.obj 4)" "$(widest flat.obj 4)" 0
    expect 0 "" "HILL" --font $sans --output warped.stl --bend $warp --bevel 0.01
    expect 0 "" "HILL" --font $sans --output warped.stl --bend $warp --outline 0.02 --outline-letter --bevel 0.005
    expect 2 "^text_to_mesh: --bend does not work with --instances" x --font $sans --output x.glb --bend $warp --instances
done
expect 0 "" "IIII" --font $sans --output far.obj --bend perspective:0.25
that "--bend perspective lets a text recede" differ far.obj flat.obj
expect 1 "longer than the circumference" "HILL" --font $sans --output x.glb --bend arc:361
expect 1 "folds the letters" "HILL" --font $sans --output x.glb --bend arc:-350
for written in arc arc: arc:90,2 arch:0.3 flag:0.2 perspective perspective:1,2; do
    expect 2 "^text_to_mesh: --bend must be cylinder:RADIUS, .* or perspective:SCALE, not $written\.$" x --font $sans --output x.glb --bend $written
done
expect 2 "^text_to_mesh: --bend has a number that is out of range: perspective:0\.$" x --font $sans --output x.glb --bend perspective:0

# Text on a path: letters are turned, instances too; what does not fit is named.
for path in circle:2 circle:-2 arc:2,120 arc:-2,120 wave:0.2,3 "M0,0 C1,1 2,1 3,0" "M-1,0 L1,0 Q2,0 2,1 Z"; do
    expect 0 "" "HILL" --font $sans --output onpath.obj --path "$path"
    that "--path $path changes the letters" differ onpath.obj flat.obj
    that "--path $path keeps the depth" larger "$(widest onpath.obj 4)" "$(widest flat.obj 4)" 0
    expect 0 "" "HILL" --font $sans --output onpath.stl --path "$path" --bevel 0.01
    expect 0 "" "HILL" --font $sans --output onpath.glb --path "$path" --instances
done
that "instances on a path are turned" grep -q '"rotation"' onpath.glb
expect 0 "^text_to_mesh: [0-9]* of 20 glyphs have no room on the --path; the first is at byte 0 of the text\.$" "HILLHILLHILLHILLHILL" --font $sans --output onpath.glb --path arc:1,90
for written in circle circle: circle:1,2 arc:2 wave:1 M "M0,0 X1,1" "M0,0 L1"; do
    expect 2 "^text_to_mesh: --path must be circle:RADIUS, .* not $written\.$" x --font $sans --output x.glb --path "$written"
done
expect 2 "^text_to_mesh: --path has a number that is out of range: circle:0\.$" x --font $sans --output x.glb --path circle:0
expect 2 "^text_to_mesh: --path does not work with a --bend in the plane\.$" x --font $sans --output x.glb --path circle:2 --bend arc:90
expect 2 "^text_to_mesh: --path does not work with --anchor and --origin" x --font $sans --output x.glb --path circle:2 --anchor middle

# Bent letters: more triangles; a text that goes around or folds, and a shape without its numbers, are refused.
expect 0 "" "Rag" --font $sans --output bent.stl --stats --bend cylinder:1.5 && cp out bent.stats
that "bending adds triangles: $(triangles plain.stats) to $(triangles bent.stats)" [ "$(triangles bent.stats)" -gt "$(triangles plain.stats)" ]
expect 0 "" "Rag" --font $sans --output bent.stl --bend cylinder:3 --bevel 0.02 --profile round
expect 1 "^text_to_mesh: The text is longer than the circumference or curve that it follows: shorten it\.$" "Around and around" --font $sans --output x.glb --bend cylinder:0.5
expect 1 "^text_to_mesh: glyph [0-9]*, at byte 0 of the text: The deformation folds the letters: bend them less, or make them smaller\.$" x --font $sans --output x.glb --bend taper:-5
expect 2 "^text_to_mesh: --bend must be cylinder:RADIUS, sphere:RADIUS, twist:DEGREES, taper:GROWTH, wave:HEIGHT,LENGTH, arc:DEGREES, arch:TOP,BASELINE, flag:HEIGHT,LENGTH or perspective:SCALE, not tube:2\.$" x --font $sans --output x.glb --bend tube:2
expect 2 "^text_to_mesh: --bend must not have a 0 here: cylinder:0\.$" x --font $sans --output x.glb --bend cylinder:0
expect 2 "^text_to_mesh: --bend does not work with --refine, because it adds the points that it needs\.$" x --font $sans --output x.glb --bend cylinder:2 --refine delaunay

expect 2 "^text_to_mesh: --bend does not work with --carve\.$" x --font $sans --output x.glb --bend cylinder:2 --carve 60
expect 2 "^text_to_mesh: --bend does not work with --inflate\.$" x --font $sans --output x.glb --bend cylinder:2 --inflate 1

# Inflated letters.
expect 0 "" "Rag" --font $sans --output balloon.stl --stats --inflate 1 && cp out balloon.stats
that "a balloon has more triangles than a plain letter" [ "$(triangles balloon.stats)" -gt $((3 * $(triangles plain.stats))) ]
expect 0 "" "Rag" --font $sans --output dome.obj --inflate 0.5 --inflate-form dome --depth 0.1
that "a dome has walls" grep -qx "g side" dome.obj
expect 2 "^text_to_mesh: --inflate-form needs --inflate\.$" x --font $sans --output x.glb --inflate-form dome
expect 2 "^text_to_mesh: --inflate does not work with --bevel\.$" x --font $sans --output x.glb --inflate 1 --bevel 0.01
expect 2 "^text_to_mesh: --inflate does not work with --outline\.$" x --font $sans --output x.glb --inflate 1 --outline 0.01
expect 2 "^text_to_mesh: --inflate does not work with --refine\.$" x --font $sans --output x.glb --inflate 1 --refine delaunay
expect 2 "^text_to_mesh: --normals does not work with --inflate, which has normals of its own\.$" x --font $sans --output x.glb --inflate 1 --normals cap
expect 2 "^text_to_mesh: --inflate-form dome needs walls, but --depth is 0: give a larger --depth\.$" x --font $sans --output x.glb --inflate 1 --inflate-form dome --depth 0
expect 2 "^text_to_mesh: --inflate must be a number from 0 to 100, not -1\.$" x --font $sans --output x.glb --inflate -1

# Plates. Every solid of a file is closed: each of its edges is met by its reverse.
closed() {
    awk '$1 == "v" { place[++n] = $2 " " $3 " " $4 }
        $1 == "o" { solid = $2; solids[$2] = 1 }
        $1 == "f" { for (i = 2; i < 5; ++i) { split($i, a, "/"); p[i] = place[a[1]] } p[5] = p[2]
                    for (i = 2; i < 5; ++i) { ++edge[solid "|" p[i] "|" p[i + 1]]; ++faces[solid] } }
        END { for (e in edge) { split(e, k, "|"); back = k[1] "|" k[3] "|" k[2]; open += !(back in edge) || edge[e] != edge[back] }
              for (s in solids) open += faces[s] < 12
              exit open != 0 || n == 0 }' "$1"
}
plate="--plate 0.2,0.1,0.1"
for option in "" "--depth 0.2" --cut "--engrave 0.05" "--stencil 0.04" "--stencil 0.03,3" --inlay "--inlay --engrave 0.02" \
    "--inlay --cut" --stamp "--stamp --engrave 0.03" "--keyring 0.1" "--keyring 0.1,0.03 --cut --stencil 0.02"; do
    for around in "$plate" "--backing 0.12" "--backing 0.12,0.05 --open-counters"; do
        # shellcheck disable=SC2086  # words
        expect 0 "$([[ $option = *--cut* && $option != *stencil* && $option != *inlay* ]] && echo "falls into [0-9]* pieces: --stencil holds them together\.$")" \
            "Ao8" --font $sans $around $option --output plate.obj
        that "each solid of $around $option is closed" closed plate.obj
    done
done
for kind in stl ply glb; do expect 0 "" "Ao8" --font $sans --plate 0.2 --output plate.$kind; done
expect 0 "" "سلام" --font $arabic --backing 0.2 --output plate.obj
that "a backing of Arabic is closed" closed plate.obj
# shellcheck disable=SC2086  # words
expect 0 "" "Ao8" --font $sans $plate --picture plate.png
expect 0 "" --help
that "the help's lines of plates fit" sh -c '! grep -E ".{121}" out'
expect 0 "" "Ao8" --font $sans --plate 0.2 --inlay --colour blue --output inlay.obj
that "an inlay is two objects" [ "$(grep '^o ' inlay.obj | tr '\n' ' ')" = "o plate o inlay " ]
that "only the inlay has the text's colour" [ "$(grep -c "^newmtl .*_blue" inlay.mtl)" = 1 ]
expect 0 "" "Ao8" --font $sans --plate 0.2 --inlay --output inlay.glb
that "an inlay is two nodes: plate, inlay" grep -q '"name":"inlay_2"' inlay.glb
measured() { tr -d '[]{}"' <out | tr ',' '\n' | awk -F: '$1 == "size" { all = $2; n = 1; next } n && n < 3 { all *= $1; ++n } $1 == "volume" { print all, $2 }'; }
expect 0 "" "Ao8" --font $sans --plate 0.2,0 --inlay --cut --stats
that "a plate and its inlay fill the whole plate: $(measured)" awk -v all="$(measured)" 'BEGIN { split(all, v, " "); exit !(v[2] / v[1] > 0.99999 && v[2] / v[1] < 1.00001) }'
expect 0 "" "Ao8" --font $sans --plate 0.2 --stencil 0.04 --output plate.stl
that "a stencil says what its bridges hold: $(cat out)" grep -q "; 8 bridges hold 4 islands$" out
expect 0 "" "Ao8" --font $sans --plate 0.2 --fit 30x30 --output plate.obj
that "--fit counts the plate: $(widest plate.obj 2)" larger "$(widest plate.obj 2)" 30 0
expect 0 "" "Ao8" --font $sans --plate 0.2 --anchor left,bottom,base --origin 1,2,3 --output plate.obj
that "--anchor moves the plate: $(bounds plate.obj)" [ "$(bounds plate.obj | awk '{ printf "%.4f %.4f %.4f", $1, $3, $5 }')" = "1.0000 2.0000 3.0000" ]
unlike "--stamp mirrors" obj "Ao8" --font $sans --plate 0.2 --stamp / "Ao8" --font $sans --plate 0.2
expect 0 "" "HILL" --font $sans --plate 0.2 --path circle:2 --output plate.obj
that "turned letters on a plate are closed" closed plate.obj
expect 0 "^text_to_mesh: the plate has 2 pieces: give a larger --backing\.$" "I I" --font $sans --backing 0.02 --output plate.obj
expect 1 "--strict: nothing is written\.$" "I I" --font $sans --backing 0.02 --output never.obj --strict
that "nothing was" [ ! -e never.obj ]
expect 1 "^text_to_mesh: --plate: the margin is so negative that nothing is left of the plate\.$" x --font $sans --plate -1 --output x.obj
for option in --cut "--engrave 0.1" --inlay "--stencil 0.1" --stamp "--keyring 0.1" "--fillet 0.1" --open-counters; do
    # shellcheck disable=SC2086  # words
    expect 2 "^text_to_mesh: ${option% *} needs --plate or --backing\.$" x --font $sans --output x.obj $option
done
for given in abc 0.1, 0.1,-1 0.1,0.1,0 0.1,0.1,0.1,0.1 2000; do
    expect 2 "^text_to_mesh: --plate must be a margin, a radius and a thickness, such as 0\.2 or 0\.2,0\.1,0\.1, not $given\.$" x --font $sans --output x.obj --plate $given
done
expect 2 "^text_to_mesh: --backing must be a growth up to 1 and a thickness, .* not 2\.$" x --font $sans --output x.obj --backing 2
expect 2 "^text_to_mesh: --keyring must be the radius of a hole and the width of its ring, .* not 0\.$" x --font $sans --output x.obj --plate 0.2 --keyring 0
expect 2 "^text_to_mesh: --engrave must be a number from 0\.0001 to 1000, not 0\.$" x --font $sans --output x.obj --plate 0.2 --engrave 0
for given in 0 0.1,9 0.1,1.5 wide; do
    expect 2 "^text_to_mesh: --stencil must be the width of the bridges, .* not $given\.$" x --font $sans --output x.obj --plate 0.2 --stencil $given
done
expect 2 "^text_to_mesh: --backing does not work with --plate: give one of them\.$" x --font $sans --output x.obj --plate 0.2 --backing 0.1
expect 2 "^text_to_mesh: --cut does not work with --engrave: give one of them\.$" x --font $sans --output x.obj --plate 0.2 --cut --engrave 0.1
expect 2 "^text_to_mesh: --inlay does not work with --stencil\.$" x --font $sans --output x.obj --plate 0.2 --inlay --stencil 0.1
expect 2 "^text_to_mesh: --open-counters needs --backing\.$" x --font $sans --output x.obj --plate 0.2 --open-counters
expect 2 "^text_to_mesh: --depth does not work with --cut: --engrave says how deep the letters are\.$" x --font $sans --output x.obj --plate 0.2 --cut --depth 0.1
expect 2 "^text_to_mesh: --depth must be more than 0 on a plate, because the letters stand on it\.$" x --font $sans --output x.obj --plate 0.2 --depth 0
expect 2 "^text_to_mesh: --inlay needs a file that keeps its two solids apart: \.3mf, \.glb or \.obj\.$" x --font $sans --output x.stl --plate 0.2 --inlay
expect 2 "^text_to_mesh: --bevel-depth does not work with --plate\.$" x --font $sans --output x.obj --plate 0.2 --bevel 0.01 --bevel-depth 0.02
expect 2 "^text_to_mesh: --profile must be chamfer or round on a plate, not stepped\.$" x --font $sans --output x.obj --plate 0.2 --bevel 0.01 --profile stepped
expect 2 "^text_to_mesh: --profile needs --bevel\.$" x --font $sans --output x.obj --plate 0.2 --profile round
expect 2 "^text_to_mesh: --fillet must be a radius from 0 to 1000, not -1\.$" x --font $sans --output x.obj --plate 0.2 --fillet=-1
expect 2 "^text_to_mesh: --fillet needs letters that stand on the plate: leave out --engrave\.$" x --font $sans --output x.obj --plate 0.2 --engrave 0.05 --fillet 0.02
expect 0 "" "Ao8" --font $sans --plate 0.2 --bevel 0.01 --profile round --fillet 0.02 --output rims.obj
that "a plate with bevels and a fillet is closed" closed rims.obj
that "bevels of a plate have names" grep -q "plate_back_bevel" rims.obj
expect 0 "^text_to_mesh: the radius of the fillet is only [0-9.]* em: more does not fit\.$" "Ao8" --font $sans --plate 0.02,0 --fillet 0.03 --output rims.obj
expect 0 "^text_to_mesh: some bevels are only [0-9.]* em wide: more does not fit\.$" "Ao8" --font $sans --plate 0.2 --bevel 0.5 --output rims.obj
expect 0 "^text_to_mesh: some rims have no bevel: it does not fit\.$" "Ao8" --font $sans --plate=-0.1 --bevel 0.01 --output rims.obj
expect 0 "^text_to_mesh: the letters have no fillet: it does not fit\.$" "Ao8" --font $sans --plate=-0.1 --fillet 0.01 --output rims.obj
expect 2 "^text_to_mesh: --instances does not work with --backing\.$" x --font $sans --output x.glb --backing 0.2 --instances
expect 2 "^text_to_mesh: --bend works with --plate only in the plane: arc, arch, flag, perspective\.$" x --font $sans --output x.obj --plate 0.2 --bend cylinder:2
expect 2 "^text_to_mesh: --style: colours do not work with --plate, whose letters have one colour\.$" xy --font $sans --output x.obj --plate 0.2 --style 0..1:colour=red
expect 2 "^text_to_mesh: --show contours, points and control do not work with --plate\.$" x --font $sans --picture x.png --plate 0.2 --show contours

# Walls that lean.
expect 0 "" "Rag" --font $sans --output taper.obj --taper 5
that "tapered letters are closed" closed taper.obj
expect 0 "" "Rag" --font $sans --output taper.stl --taper 60 --depth 0.5
expect 0 "" "Rag" --font $sans --output taper.stl --taper 5 --bend cylinder:3
expect 0 "" "Rag" --font $sans --output taper.stl --taper 3 --outline 0.03
expect 2 "^text_to_mesh: --taper must be a number from 0 to 89, not 90\.$" x --font $sans --output x.obj --taper 90
expect 2 "^text_to_mesh: --bevel does not work with --taper\.$" x --font $sans --output x.obj --taper 5 --bevel 0.01
expect 2 "^text_to_mesh: --tube does not work with --taper\.$" x --font $sans --output x.obj --taper 5 --tube 0.02
for option in --plate --backing --fillet --tube --bend --path --anchor --picture; do  # an empty variable of a shell
    expect 2 "^text_to_mesh: $option must not be empty\.$" x --font $sans --output x.glb $option ""
done
for option in --stats --colour-layers --letters --per-letter "--anchor left" "--origin 0,0,0" "--touching part"; do
    # shellcheck disable=SC2086  # words
    expect 2 "^text_to_mesh: ${option% *} does not work with --morph\.$" x --font $inter --output x.glb --morph wght=400..700 $option
done
expect 2 "^text_to_mesh: --normals does not work with --taper, which takes all normals from the curves\.$" x --font $sans --output x.obj --taper 5 --normals cap
expect 2 "^text_to_mesh: --taper needs a solid, but --depth 0 makes a flat mesh: give a larger --depth\.$" x --font $sans --output x.obj --taper 5 --depth 0
expect 1 "^text_to_mesh: --taper is too wide for this font: give a smaller number\.$" x --font $sans --output x.obj --taper 89 --depth 1000
# Tubes along the outline: neon letters.
expect 0 "" "Rag" --font $sans --output tube.obj --stats --tube 0.01,6 --anchor halfway --origin 0,0,0 && cp out tube.stats
that "a tube of 6 sides has 12 triangles for each point: $(triangles tube.stats)" [ $(($(triangles tube.stats) % 12)) = 0 ]
that "a tube reaches its radius to both sides: $(depth_of tube.obj)" [ "$(depth_of tube.obj)" = "-0.0087 0.0087" ]
expect 0 "" "Rag" --font $sans --output tube.stl --tube 0.01
expect 0 "the edges of 3 of 3 glyphs have moved less than --bevel, --outline, --embolden or --tube request" "Rag" --font $sans --output tube.glb --tube 0.2
expect 0 "" "o" --font $sans --output inset.glb --tube 0.01 --embolden -0.02
for wrong in 0 2 0.02,2 0.02,129 0.02,7.5 0.02, x; do
    expect 2 "^text_to_mesh: --tube must be a radius from 0\.001 to 1, and with a comma 3 to 128 sides, such as 0\.02,24; not $wrong\.$" x --font $sans --output x.glb --tube $wrong
done
for option in "--bevel 0.01" "--carve 60" "--outline 0.01" "--inflate 1" "--refine delaunay" "--segments 2"; do
    # shellcheck disable=SC2086  # an option and its value
    expect 2 "^text_to_mesh: ${option% *} does not work with --tube\.$" x --font $sans --output x.glb --tube 0.01 $option
done
expect 2 "^text_to_mesh: --depth does not work with --tube: its radius is the depth\.$" x --font $sans --output x.glb --tube 0.01 --depth 0.1
expect 2 "^text_to_mesh: --normals does not work with --tube, whose normals are round\.$" x --font $sans --output x.glb --tube 0.01 --normals cap
expect 2 "^text_to_mesh: --bend does not work with --tube, unless it bends in the plane\.$" x --font $sans --output x.glb --tube 0.01 --bend cylinder:2

# A GLB that says how its mesh is a manifold.
for form in "--depth 0.2" "--bevel 0.02" "--tube 0.01"; do
    # shellcheck disable=SC2086  # an option and its value
    expect 0 "" "Rag" --font $sans --output solid.glb --manifold $form
    that "a manifold names its extension: $form" grep -q EXT_mesh_manifold solid.glb
done
expect 2 "^text_to_mesh: --manifold needs --output FILE\.glb\.$" x --font $sans --output x.obj --manifold
expect 2 "^text_to_mesh: --manifold needs one mesh: leave out --lod, --instances, --per-letter and --morph\.$" x --font $sans --output x.glb --manifold --instances
expect 2 "^text_to_mesh: --manifold needs a solid, but --depth 0 makes a flat mesh: give a larger --depth\.$" x --font $sans --output x.glb --manifold --depth 0
expect 1 "^text_to_mesh: x\.glb cannot be written with --manifold: the mesh is not closed, or solids touch in it\.$" "Rag" --font $sans --output x.glb --manifold --carve 60 --carve-as groove

for option in "--outline-place outer" --outline-letter; do
    # shellcheck disable=SC2086  # an option and its value
    expect 2 "^text_to_mesh: ${option% *} needs --outline\.$" x --font $sans --output x.glb $option
done
for option in "--bevel-depth 0.02" "--profile round" "--bevel-mode fit" "--bevel-sides front" --bevel-out; do
    # shellcheck disable=SC2086  # words
    expect 2 "^text_to_mesh: ${option% *} needs --bevel\.$" x --font $sans --output x.glb $option
done

echo "$passed passed, $failed failed"
[ "$failed" = 0 ]
