#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Do the tests notice? Plants one bug at a time in a copy of the tree and runs the tests of its room.
#
#     run.sh [--quick] [--sound] [--list | --check] [NAME...]      all of them without a name
#
#     --quick   only the test files that are run first, not the rest of the room
#     --sound   what catches a bug must pass without it
#     --list    names, rooms and reasons
#     --check   only whether each patch still applies, to text that stands once in its file
#
# A bug is NAME.patch beside this script:
#     Reason: what a programmer might think.
#     Room: the folder of tests/ that must catch it; several are tried in turn
#     Tests: room/name ...      which files of it are run first; the changed header's own if this line is missing
# and a unified diff for patch -p1, whose line numbers do not matter. Each test file is compiled and linked alone.
# A failed test, a crash, a timeout and a static_assert catch a bug. The table is build/planted/table.tsv too. The exit
# code is 0 if all were caught. CXX and SECONDS_A_TEST (120) may be set. What a timeout catches must pass without it.
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source_tree=$(cd "$here/../.." && pwd)
work=$source_tree/build/planted
tree=$work/tree
quick=no sound=no mode=run
names=()
for argument in "$@"; do
    case $argument in
        --quick) quick=yes ;;
        --sound) sound=yes ;;
        --list | --check) mode=${argument#--} ;;
        -*) echo "run.sh: there is no option $argument" >&2 && exit 2 ;;
        *) names+=("$argument") ;;
    esac
done
if [ ${#names[@]} -eq 0 ]; then
    for file in "$here"/*.patch; do names+=("$(basename "$file" .patch)"); done
fi
field() { sed -n "s/^$2: //p;/^--- /q" "$here/$1.patch"; }
changed() { sed -n 's,^+++ b/,,p' "$here/$1.patch"; }

applies() {  # applies NAME TREE: there is such a bug, it is described, and its hunks are found, each in one place
    local why
    [ -f "$here/$1.patch" ] || { echo "$1: there is no such patch" && return 1; }
    for why in Reason Room; do
        [ -n "$(field "$1" $why)" ] || { echo "$1: has no line '$why:'" && return 1; }
    done
    [ "$(grep -c '^@@ ' "$here/$1.patch")" -eq 1 ] || { echo "$1: one hunk, please" && return 1; }
    why=$(patch -d "$2" -p1 -F0 -f --dry-run <"$here/$1.patch" 2>&1) || { echo "$1: applies no more: $why" && return 1; }
    [ "$(sed -n '1,/^@@ /d;s/^[- ]//p' "$here/$1.patch" | awk '
        FNR == NR { old[n++] = $0; next }
        { seen[m++] = $0 }
        END {
            for (i = 0; i + n <= m; ++i) { for (k = 0; k < n && seen[i + k] == old[k]; ++k); found += k == n }
            print found
        }' - "$2/$(changed "$1")")" -eq 1 ] || { echo "$1: its text stands more than once in $(changed "$1")" && return 1; }
}

if [ $mode = list ]; then
    for name in "${names[@]}"; do printf '%-34s %-12s %s\n' "$name" "$(field "$name" Room)" "$(field "$name" Reason)"; done
    exit
fi
if [ $mode = check ]; then
    status=0
    for name in "${names[@]}"; do applies "$name" "$source_tree" || status=1; done
    exit $status
fi

# The tools, and what all tests share: Catch2's header read once, and a main().
compiler=(${CXX:-g++} -std=c++20 -w -pthread)
command -v ccache >/dev/null && compiler=(ccache "${compiler[@]}") && export CCACHE_SLOPPINESS=pch_defines,time_macros
way_of() {  # way_of ROOM: as the preset gcc has it
    case $1 in unicode | discretise | fill | triangulate | glyph) echo -O2 ;; *) echo -O0 ;; esac
}
libraries_of() {  # libraries_of ROOM: what tests/CMakeLists.txt gives it
    case $1 in
        adapt) pkg-config --cflags --libs harfbuzz freetype2 fontconfig icu-uc ;;
        threads | conformance | workload) pkg-config --cflags --libs harfbuzz freetype2 ;;
    esac
}
rm -rf "$tree" && mkdir -p "$tree" || exit 2
cp -R "$source_tree/include" "$source_tree/tests" "$tree"
includes=("-I$tree/include" "-I$tree/tests" "-DTYPEMESH_TEST_DATA=\"$tree/tests\"")
for way in -O0 -O2; do
    read=$work/read$way/read_catch.hpp
    mkdir -p "$work/read$way" && printf '#include "support/catch.hpp"\n' >"$read"
    [ "$read.gch" -nt "$tree/tests/support/catch.hpp" ] ||
        "${compiler[@]}" $way "${includes[@]}" -x c++-header "$read" -o "$read.gch" || exit 2
done
main=("$work/main.o")
if printf '#include <catch2/catch_all.hpp>\n' | "${compiler[@]}" -E -x c++ - >/dev/null 2>&1; then
    main=(-lCatch2Main -lCatch2)
elif ! [ -e "$work/main.o" ]; then
    "${compiler[@]}" -c "$tree/tests/support/main.cpp" -o "$work/main.o" || exit 2
fi

try() {  # try ROOM/FILE: 0 and a sentence in $caught_by, if something fails; 2 if it does not compile
    local libraries test status way
    way=$(way_of "${1%%/*}")
    read -ra libraries <<<"$(libraries_of "${1%%/*}" | tr '\n' ' ')"
    if ! "${compiler[@]}" "$way" "-I$work/read$way" "${includes[@]}" -include read_catch.hpp "${libraries[@]}" \
        -c "$tree/tests/$1.test.cpp" -o "$work/test.o" 2>"$work/compiler" ||
        ! "${compiler[@]}" "$work/test.o" "${main[@]}" "${libraries[@]}" -o "$work/test" 2>>"$work/compiler"; then
        caught_by="$1: static_assert: $(grep -m1 'static assertion failed' "$work/compiler" | sed 's/.*static assertion failed: *//')"
        grep -q 'static assertion failed' "$work/compiler" && return 0
        return 2
    fi
    timeout -k 5 "${SECONDS_A_TEST:-120}" "$work/test" -a >"$work/output" 2>&1
    status=$?
    [ $status -eq 0 ] && return 1
    test=$(sed -n '/^-\{70,\}$/{n;p;q}' "$work/output")
    case $status in
        124 | 137) caught_by="$1: ${test:+$test: }timeout" && return ;;
        *) caught_by="$1: ${test:-exit code $status}" ;;
    esac
    if grep -q 'due to a fatal error condition' "$work/output"; then
        caught_by="$caught_by ($(grep -m1 -oE 'SIG[A-Z]+' "$work/output"))"
    elif [ $status -ge 128 ]; then
        caught_by="$caught_by (signal $((status - 128)))"
    fi
}

files_of() {  # files_of NAME: room/file, in the order in which they are tried
    local first room
    first=$(field "$1" Tests)
    [ -n "$first" ] || first=$(changed "$1" | sed -n 's,^include/typemesh/\(.*\)\.hpp$,\1,p')
    for file in $first; do [ -e "$tree/tests/$file.test.cpp" ] && echo "$file"; done
    [ $quick = yes ] && return
    for room in $(field "$1" Room); do
        (cd "$tree/tests" && ls "$room"/*.test.cpp) | sed 's/\.test\.cpp$//' | grep -vxF "$(tr ' ' '\n' <<<"$first")"
    done
}

caught=0 done=0 started=$(date +%s)
: >"$work/table.tsv"
row() { printf '%s\t%s\t%s\n' "$name" "$room" "$1" >>"$work/table.tsv" && printf '%-34s %-10s %s\n' "$name" "$room" "$1"; }
for name in "${names[@]}"; do
    if [ $done -gt 0 ]; then
        left=$(((($(date +%s) - started) * (${#names[@]} - done) / done + 59) / 60))
        printf '[%s of %s, about %s min left]\n' $done ${#names[@]} $left >&2
    fi
    done=$((done + 1))
    room=$(field "$name" Room 2>/dev/null)
    why=$(applies "$name" "$tree") || { row "ERROR: $why" && continue; }
    patch -d "$tree" -p1 -F0 -f -s --no-backup-if-mismatch <"$here/$name.patch"
    answer="NOT CAUGHT"
    for file in $(files_of "$name"); do
        caught_by=
        try "$file"
        case $? in
            0) answer=$caught_by ;;
            1) continue ;;
            2) answer="ERROR: $file does not compile: $(grep -m1 error "$work/compiler")" ;;
        esac
        break
    done
    cp "$source_tree/$(changed "$name")" "$tree/$(changed "$name")"
    if [[ $sound = yes || $caught_by = *timeout ]] && [ -n "$caught_by" ] && ! [ -e "$work/sound-$$-${file//\//-}" ]; then
        try "$file"
        [ $? -eq 1 ] && touch "$work/sound-$$-${file//\//-}" || { answer="ERROR: $file fails without the bug" && caught_by=; }
    fi
    [ -n "$caught_by" ] && caught=$((caught + 1))
    row "$answer"
done
rm -f "$work/sound-$$-"*
echo "$caught of ${#names[@]} caught"
[ $caught -eq ${#names[@]} ]
