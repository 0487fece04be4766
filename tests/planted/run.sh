#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Do the tests notice? Plants one bug at a time in a copy of the tree and runs the tests of its room. A bug is NAME.patch
# beside this script:
#     Reason: what a programmer might think
#     Room: the folder of tests/ that must catch it; several are tried in turn
#     Tests: room/name ...      which files of it are run first; the changed header's own if this line is missing
# and a unified diff of one hunk, found by its text alone, which stands once in its file: line numbers do not matter.
# Each test file is compiled and linked alone. A failed test, a crash, a timeout and a static_assert catch a bug.
set -u
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"

usage() {
    cat <<'END'
usage: tests/planted/run.sh [OPTION...] [NAME...]      all bugs without a name

  --list        names, rooms and reasons
  --check       only whether each patch finds its place, and has its row in docs/planted_bugs.md
  --jobs N      so many bugs at a time; one for each processor by default
  --resume      goes on where a run was broken off: what was caught then is not tried again
  --quick       only the test files that are run first, not the rest of the room
  --sound       what catches a bug must pass without it
  --record      writes what has caught each bug into docs/planted_bugs.md
  --work DIR    for what is built; build/planted by default

Installs what is missing. Prints name, room, the test that caught the bug, seconds; the exit code is 0 if all were caught.
CXX: another g++. SECONDS_A_TEST: 120; then a test is broken off, which catches a bug if the test passes without it.
END
}

here=$typemesh_root/tests/planted
page=$typemesh_root/docs/planted_bugs.md
work=$typemesh_root/build/planted
jobs=$(processors)
quick=no sound=no record=no resume=no mode=run
names=
while [ $# -gt 0 ]; do
    case $1 in
        --quick) quick=yes ;;
        --sound) sound=yes ;;
        --record) record=yes ;;
        --resume) resume=yes ;;
        --list | --check) mode=${1#--} ;;
        --jobs | --work)
            [ -n "${2:-}" ] || stop "$1 wants a value." "$(usage)"
            if [ "$1" = --jobs ]; then jobs=$2; else work=$2; fi
            shift
            ;;
        -h | --help) usage && exit ;;
        -*) stop "$1 is not an option." "$(usage)" ;;
        *) names="$names $1" ;;
    esac
    shift
done
[ -n "$names" ] || names=$(cd "$here" && for file in *.patch; do printf ' %s' "${file%.patch}"; done)

describe() {  # describe NAME: sets its reason, room, tests, and the file that it changes
    local line
    reason='' room='' tests='' changed=''
    [ -f "$here/$1.patch" ] || { say "$1: there is no such patch" && return 1; }
    while IFS= read -r line; do
        case $line in
            'Reason: '*) reason=${line#*: } ;;
            'Room: '*) room=${line#*: } ;;
            'Tests: '*) tests=${line#*: } ;;
            '+++ b/'*) changed=${line#+++ b/} && break ;;
        esac
    done <"$here/$1.patch"
    [ -n "$reason" ] && [ -n "$room" ] || { say "$1: needs the lines 'Reason:' and 'Room:'" && return 1; }
    [ -f "$typemesh_root/$changed" ] || { say "$1: there is no file '$changed'" && return 1; }
    [ -n "$tests" ] || { tests=${changed#include/typemesh/} && tests=${tests%.hpp} && tests=${tests/\/impl\//\/}; }
}

plant() {  # plant NAME FILE: the file with the bug; a sentence and failure if it has no place
    awk -v name="$1" '
        FNR == 1 { ++file }
        file == 1 && /^@@ / { ++hunks; next }
        file == 1 && hunks {
            if (!/^\+/) old[n++] = substr($0, 2)
            if (!/^-/) new[m++] = substr($0, 2)
        }
        file == 2 { text[l++] = $0 }
        END {
            for (i = 0; i + n <= l; ++i) {
                for (k = 0; k < n && text[i + k] == old[k]; ++k) {}
                if (k == n) { at = i; ++found }
            }
            if (hunks != 1) { print name ": has " hunks + 0 " hunks, and not one"; exit 1 }
            if (found != 1) { print name ": its text stands " found + 0 " times in its file, and not once"; exit 1 }
            for (i = 0; i < at; ++i) print text[i]
            for (i = 0; i < m; ++i) print new[i]
            for (i = at + n; i < l; ++i) print text[i]
        }' "$here/$1.patch" "$2"
}

# The row of a bug in the page, up to what caught it.
row_begins() { printf '| [%s](../tests/planted/%s.patch) | %s | ' "$1" "$1" "$2"; }

if [ $mode = list ]; then
    for name in $names; do describe "$name" && printf '%-34s %-12s %s\n' "$name" "$room" "$reason"; done
    exit
fi
if [ $mode = check ]; then
    status=0
    rows=$(grep '^| \[' "$page")
    for name in $names; do
        if ! describe "$name"; then
            status=1
        elif ! planted=$(plant "$name" "$typemesh_root/$changed"); then
            say "$planted" && status=1
        fi
        case $rows in
            *"$(row_begins "$name" "$reason")"*) ;;
            *) say "$name: docs/planted_bugs.md has no row of it with this reason: run.sh --record $name" && status=1 ;;
        esac
    done
    while IFS= read -r row; do
        row=${row#*[} && row=${row%%]*}
        [ -f "$here/$row.patch" ] || { say "docs/planted_bugs.md: there is no patch $row" && status=1; }
    done <<END
$rows
END
    exit $status
fi

libraries_of() {  # libraries_of ROOM: what tests/CMakeLists.txt gives it
    case $1 in
        adapt) say harfbuzz freetype2 fontconfig icu-uc ;;
        threads | conformance | workload | plate) say harfbuzz freetype2 ;;
    esac
}
way_of() {  # way_of ROOM: as the preset gcc has it
    case $1 in unicode | discretise | fill | triangulate | glyph | conformance | workload) say -O2 ;; *) say -O0 ;; esac
}

# The tools and the data, and what all tests share: Catch2's header read once, and a main().
tried=
for name in $names; do
    describe "$name" || exit 2
    for file in $tests $room; do tried="$tried ${file%%/*}"; done
done
[ -n "${CXX:-}" ] || install_missing g++
install_missing catch2
case $tried in *adapt* | *threads* | *conformance* | *workload* | *plate*) install_missing pkg-config harfbuzz freetype fontconfig-dev icu fontconfig font ;; esac
case $tried in *plate*) install_fonts fonts-dejavu-core fonts-liberation fonts-hosny-amiri fonts-sawarabi-mincho ;; esac
case $tried in
    *adapt* | *threads* | *conformance* | *workload* | *unicode*)
        fonts=$(awk -F '\t' 'NR > 1 && $2 < 20000000 { print $1 }' "$typemesh_root/tests/workload/smoke-fonts.tsv")
        # shellcheck disable=SC2086  # a list of words
        install_fonts $fonts
        install_unicode_data
        ;;
esac
compiler=(${CXX:-g++} -std=c++20 -w -pthread)
if command -v ccache >/dev/null; then
    compiler=(ccache "${compiler[@]}")
    export CCACHE_SLOPPINESS=pch_defines,time_macros CCACHE_NOHASHDIR=1
fi
includes=(-Iinclude -Itests '-DTYPEMESH_TEST_DATA="tests"')  # in a tree, so that all trees share what ccache keeps
mkdir -p "$work" && work=$(cd "$work" && pwd) || exit 2

make_tree() {  # make_tree TREE
    rm -rf "$1" && mkdir -p "$1" && cp -R "$typemesh_root/include" "$typemesh_root/tests" "$1"
}
make_tree "$work/tree-1" || exit 2
cd "$work/tree-1" || exit 2
for room in $tried; do
    read=$work/read$(way_of "$room")
    [ ! "$read/read_catch.hpp.gch" -nt tests/support/catch.hpp ] || continue
    mkdir -p "$read" && printf '#include "support/catch.hpp"\n' >"$read/read_catch.hpp"
    # shellcheck disable=SC2046  # several words
    "${compiler[@]}" "$(way_of "$room")" "${includes[@]}" -x c++-header "$read/read_catch.hpp" -o "$read/read_catch.hpp.gch" || exit 2
done
main=("$work/main.o")
if printf '#include <catch2/catch_all.hpp>\n' | "${compiler[@]}" -E -x c++ - >/dev/null 2>&1; then
    main=(-lCatch2Main -lCatch2)
elif ! [ "$work/main.o" -nt tests/support/main.cpp ]; then
    "${compiler[@]}" "${includes[@]}" -c tests/support/main.cpp -o "$work/main.o" || exit 2
fi
limit=
for name in timeout gtimeout; do
    [ -n "$limit" ] || ! command -v $name >/dev/null || limit="$name -k 5 ${SECONDS_A_TEST:-120}"
done

compile() {  # compile ROOM/FILE OBJECTS: $objects/test, in the current folder's tree
    local libraries='' way object=$2/test.o
    way=$(way_of "${1%%/*}")
    # shellcheck disable=SC2046  # several words
    libraries=$(libraries_of "${1%%/*}") && libraries=${libraries:+$(pkg-config --cflags --libs $libraries)}
    # shellcheck disable=SC2086  # lists of words
    "${compiler[@]}" "$way" "-I$work/read$way" "${includes[@]}" -include read_catch.hpp $libraries \
        -c "tests/$1.test.cpp" -o "$object" && "${compiler[@]}" "$object" "${main[@]}" $libraries -o "$2/test"
}

# The name of the last test case in Catch2's XML.
last_test() {
    sed -n 's/.*<TestCase name="\([^"]*\)".*/\1/p' "$1" | tail -n 1 |
        sed 's/&lt;/</g;s/&gt;/>/g;s/&quot;/"/g;s/&apos;/'\''/g;s/&amp;/\&/g'
}

try() {  # try ROOM/FILE OBJECTS: 0 and what $caught_by, if something fails; 1 if all passes; 2 if it does not compile
    local status test failed_at
    if ! compile "$1" "$2" 2>"$2/compiler"; then
        failed_at=$(grep -m1 'static assertion failed' "$2/compiler") || return 2
        caught_by="$1: static_assert in $(say "$failed_at" | sed -E 's,:.*,,;s,^(tests|include/typemesh)/,,')"
        return 0
    fi
    # shellcheck disable=SC2086  # a list of words
    { $limit "$2/test" -a -r xml; } >"$2/output" 2>&1
    status=$?
    [ $status -ne 0 ] || return 1
    test=$(last_test "$2/output")
    caught_by="$1: ${test:-ends with $status}"
    case $status in
        124 | 137) caught_by="$caught_by (timeout)" ;;
        *) if grep -q '<FatalErrorCondition' "$2/output" || [ $status -gt 128 ]; then caught_by="$caught_by (crash)"; fi ;;
    esac
}

files_of() {  # files_of: room/file of the bug described, in the order in which they are tried
    local name
    for name in $tests; do [ ! -e "tests/$name.test.cpp" ] || say "$name"; done
    [ $quick = no ] || return
    for name in $room; do
        (cd tests && ls "$name"/*.test.cpp) | sed 's/\.test\.cpp$//' | grep -vxF "$(say "$tests" | tr ' ' '\n')"
    done
}

passes_without() {  # passes_without ROOM/FILE OBJECTS; remembered
    [ ! -e "$rows/sound-${1//\//-}" ] || return 0
    try "$1" "$2"
    [ $? -eq 1 ] && touch "$rows/sound-${1//\//-}"
}

plant_and_try() {  # plant_and_try NAME OBJECTS: writes its row, "caught TAB name TAB room TAB by TAB seconds TAB reason"
    local file begun=$SECONDS verdict=no caught_by='' answer='NOT CAUGHT'
    describe "$1"
    if ! plant "$1" "$typemesh_root/$changed" >"$2/changed"; then
        answer="ERROR: $(cat "$2/changed")"
    else
        cp "$2/changed" "$changed"
        for file in $(files_of); do
            try "$file" "$2"
            case $? in
                0) verdict=caught answer=$caught_by ;;
                1) continue ;;
                2) answer="ERROR: $file does not compile: $(grep -m1 error "$2/compiler")" ;;
            esac
            break
        done
        cp "$typemesh_root/$changed" "$changed"
        case $verdict$sound$answer in
            caughtyes* | caught*'(timeout)')
                passes_without "$file" "$2" || { verdict=no answer="ERROR: $file fails without the bug, too"; }
                ;;
        esac
    fi
    printf '%s\t%s\t%s\t%s\t%s\t%s\n' $verdict "$1" "$room" "$answer" $((SECONDS - begun)) "$reason" >"$2/row"
    mv "$2/row" "$rows/$1.row"
    printf '%-34s %-12s %4d s  %s\n' "$1" "$room" $((SECONDS - begun)) "$answer"
}

worker() {  # worker NUMBER: takes one bug after the other
    local name done
    [ "$1" = 1 ] || make_tree "$work/tree-$1" || return 2
    cd "$work/tree-$1" && mkdir -p "$work/objects-$1" || return 2
    for name in $names; do
        mkdir "$rows/$name.taken" 2>/dev/null || continue
        plant_and_try "$name" "$work/objects-$1"
        done=$(ls "$rows" | grep -c '\.row$')
        [ $((done % 10)) -ne 0 ] || say "  [$done of $total]"
    done
}

# A row of what has been caught stays for --resume; everything else of former runs goes.
rows=$work/rows
mkdir -p "$rows" && rm -rf "$rows"/*.taken "$rows"/sound-* || exit 2
[ $resume = yes ] || rm -f "$rows"/*.row
total=0
for name in $names; do
    total=$((total + 1))
    if grep -q '^caught' "$rows/$name.row" 2>/dev/null; then mkdir "$rows/$name.taken"; else rm -f "$rows/$name.row"; fi
done
trap 'kill $(jobs -p); exit 130' INT TERM
for ((i = 1; i <= jobs; ++i)); do worker $i & done
wait
all=$(for name in $names; do cat "$rows/$name.row"; done)
caught=$(say "$all" | grep -c '^caught')

# The rows of the page are ordered by name; the rows of other bugs stay, unless their patch has gone.
record_rows() {
    local name why by rest
    sed '/^| \[/d' "$page"
    {
        say "$all" | while IFS=$'\t' read -r rest name rest by rest why; do
            [ -z "$by" ] || say "$(row_begins "$name" "$why")${by//|/\\|} |"
        done
        grep '^| \[' "$page" | while IFS= read -r rest; do
            name=${rest#*[} && name=${name%%]*}
            say "$all" | cut -f 2 | grep -qx -- "$name" || [ ! -f "$here/$name.patch" ] || say "$rest"
        done
    } | LC_ALL=C sort
}
if [ $record = yes ]; then
    [ "$caught" -eq $total ] || stop "$caught of $total caught: nothing is recorded."
    record_rows >"$work/page" && cp "$work/page" "$page"
fi
say "$caught of $total caught"
[ "$caught" -eq $total ]
