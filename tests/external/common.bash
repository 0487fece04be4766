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
