# SPDX-License-Identifier: MIT
#
# What the scripts of this folder share. They get TYPEMESH_TEXT_TO_MESH (the program) and TYPEMESH_TEST_DATA (the folder
# tests/) and TYPEMESH_TEST_ENGINES (the program of tests/engines, where some preset has built it) from tests/run.sh, end with 0 when all is well, with 77 after a last line that says why they skip, else with 1.
set -u
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
failures=0

fail() {
    printf '%s\n' "$*"
    failures=$((failures + 1))
}

# Calls `$1 FONT FACE TEXT` for every text of the workload with every installed font of its script.
for_every_text() {
    local check=$1 role name package path script text
    while IFS=$'\t' read -r role _ name package path _; do
        [ "$role" != role ] || continue
        path=/$path
        if [ ! -e "$path" ]; then
            case $package in
                fonts-mplus | fonts-noto-cjk) printf 'without %s, which is not installed (%s)\n' "$name" "$package" ;;
                *) fail "$name is not installed (Debian package $package)" ;;
            esac
            continue
        fi
        for script in latin arabic chinese japanese; do
            case $role in *"$script"*) ;; *) continue ;; esac
            while IFS= read -r text; do
                [ -z "$text" ] || "$check" "$path" "$text"
            done < <(
                tr '\n' ' ' <"$TYPEMESH_TEST_DATA/workload/chars-$script.txt" && echo
                cat "$TYPEMESH_TEST_DATA/workload/phrases-$script.txt"
                [ "$script" != latin ] || cat "$TYPEMESH_TEST_DATA/workload/long-latin.txt"
            )
        done
    done <"$TYPEMESH_TEST_DATA/workload/fonts.tsv"
}

# Calls `$1 FONT TEXT OPTION...` for a Latin and an Arabic text with every profile of a bevel in both modes: narrow, and wider
# than strokes are.
for_every_bevel() {
    local check=$1 profile mode width font text
    while IFS='|' read -r font text; do
        font=/usr/share/fonts/$font
        [ -e "$font" ] || { fail "$font is not installed"; continue; }
        for profile in chamfer round concave stepped engraved; do
            for mode in clip fit; do
                for width in 0.02 0.1; do
                    "$check" "$font" "$text" --bevel $width --bevel-depth 0.04 --profile $profile --bevel-mode $mode
                done
            done
        done
    done <<'LIST'
truetype/liberation/LiberationSerif-Bold.ttf|Rag & Åé8
opentype/fonts-hosny-amiri/Amiri-Regular.ttf|السلام عليكم
LIST
}

# Calls `$1 NAME FONT TEXT OPTION...` for every kind of solid beside plain and bevelled letters. Without FONT and TEXT, both
# empty: the shapes of an SVG file, if the program can read one. NAME is a word that no other kind has.
for_every_kind() {
    local check=$1 name options font=/usr/share/fonts/truetype/liberation/LiberationSerif-Bold.ttf
    local arabic=/usr/share/fonts/opentype/fonts-hosny-amiri
    [ -e "$font" ] || { fail "$font is not installed"; return; }
    while read -r name options; do
        # shellcheck disable=SC2086  # words
        "$check" "$name" "$font" "Rag 8&" $options
    done <<'LIST'
standing --plate 0.2
filleted --plate 0.2 --bevel 0.01 --fillet 0.03
rounded --plate 0.2 --bevel 0.02 --profile round --fillet 0.01
engraved --plate 0.2 --engrave 0.05
chamfered --plate 0.2 --engrave 0.05 --bevel 0.02
cut --plate 0.2 --cut
cut-bevelled --plate 0.2 --cut --bevel 0.01
stencil --plate 0.2 --stencil 0.05
stencil-bevelled --plate 0.2 --stencil 0.05 --bevel 0.01
stamp --plate 0.2 --stamp --fillet 0.02
backing --backing 0.12
keyring --backing 0.12 --keyring 0.1 --bevel 0.02 --fillet 0.02
open-backing --backing 0.12 --open-counters
tapered --taper 5
tube --tube 0.02
inflated --inflate 1
dome --inflate 1 --inflate-form dome
relief --carve 90
cutter --carve 60 --carve-depth 0.02 --carve-as cutter
outline --outline 0.02
stroke --stroke 0.03,round,0.1,0.05
bent --bend cylinder:2
refined --refine delaunay
LIST
    if [ -e "$arabic/Amiri-Regular.ttf" ]; then
        "$check" arabic "$arabic/Amiri-Regular.ttf" "السلام عليكم" --plate 0.2 --bevel 0.005 --fillet 0.02
        "$check" arabic-engraved "$arabic/Amiri-Regular.ttf" "السلام عليكم" --plate 0.2 --bevel 0.01 --engrave 0.05
    else
        fail "$arabic/Amiri-Regular.ttf is not installed"
    fi
    if [ -e "$arabic/AmiriQuranColored.ttf" ]; then
        "$check" colour "$arabic/AmiriQuranColored.ttf" "بِسْمِ"
    else
        echo "without letters in layers of colours: $arabic/AmiriQuranColored.ttf is not installed"
    fi
    cat >"$scratch/drawing.svg" <<'SVG'
<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 60">
  <path d="M10 50 L30 10 L50 50 Z M25 40 L35 40 L30 28 Z" fill="#c03030" fill-rule="evenodd"/>
  <circle cx="72" cy="30" r="18" fill="none" stroke="#3050c0" stroke-width="6"/>
  <rect x="40" y="24" width="40" height="8" rx="3" fill="#30a050"/>
</svg>
SVG
    if "$TYPEMESH_TEXT_TO_MESH" --svg "$scratch/drawing.svg" --output "$scratch/drawing.stl" >/dev/null 2>"$scratch/losses"; then
        "$check" svg "" "" --svg "$scratch/drawing.svg"
        "$check" svg-bevelled "" "" --svg "$scratch/drawing.svg" --bevel 0.01
    else
        echo "without SVG: $(head -n 1 "$scratch/losses")"
    fi
}

# Writes a file of a kind; the arguments of for_every_kind's check, after the file.
write_kind() {  # write_kind FILE NAME FONT TEXT OPTION...
    local file=$1 font=$3 text=$4
    set -- "$2" "${@:5}"
    if [ -n "$font" ]; then
        "$TYPEMESH_TEXT_TO_MESH" --font "$font" --output "$file" "${@:2}" -- "$text" >/dev/null 2>"$scratch/losses"
    else
        "$TYPEMESH_TEXT_TO_MESH" --output "$file" "${@:2}" >/dev/null 2>"$scratch/losses"
    fi || { fail "text_to_mesh failed: $1: $(cat "$scratch/losses")"; return 1; }
}

# Whether the program writes 3MF.
writes_3mf() {
    "$TYPEMESH_TEXT_TO_MESH" --font /usr/share/fonts/truetype/liberation/LiberationSerif-Bold.ttf --output "$scratch/probe.3mf" a >/dev/null 2>&1
}

# The corners of a binary STL, nine numbers a line. Halves of 32-bit floats are put together: no tool that reads them is
# on every machine.
binary_corners() {  # binary_corners FILE
    od -An -v -j84 -w50 -tu2 "$1" | awk '
        function number(low, high,   sign, exponent, fraction) {
            sign = high >= 32768 ? -1 : 1
            exponent = int(high / 128) % 256
            fraction = (high % 128) * 65536 + low
            return exponent ? sign * (fraction + 8388608) * 2 ^ (exponent - 150) : sign * fraction * 2 ^ -149
        }
        { for (i = 7; i < 25; i += 2) printf "%.17g%s", number($i, $(i + 1)), i < 23 ? " " : "\n" }'
}

# Six times the volume is the sum of the determinants of all triangles. Volume, then lowest and highest x, y and z.
measure() {
    awk '
        {
            six += $1 * ($5 * $9 - $6 * $8) - $2 * ($4 * $9 - $6 * $7) + $3 * ($4 * $8 - $5 * $7)
            for (i = 1; i <= 9; ++i) {
                c = (i - 1) % 3
                if (!(c in low) || $i < low[c]) low[c] = $i
                if (!(c in high) || $i > high[c]) high[c] = $i
            }
        }
        END {
            printf "%.17g", six / 6
            for (c = 0; c < 3; ++c) printf " %.17g %.17g", low[c], high[c]
            print ""
        }'
}
