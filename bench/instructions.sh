#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Counts the instructions of the kernels (instructions/kernels.cpp and writing.cpp), which hardly depend on the machine and not on its load, and
# sets them beside instructions.tsv: a kernel that needs more than 2 % more fails, so that a slip shows in review.
#
#     bench/instructions.sh                        all kernels, some minutes
#     bench/instructions.sh hello monotone_60      these
#     bench/instructions.sh --renew                writes instructions.tsv anew
#     bench/instructions.sh --beside REVISION      against another revision instead: shares of what it needs
#     bench/instructions.sh --tolerance PERCENT    another one than 2
#
# Counts belong to one compiler and one HarfBuzz: instructions.tsv names its own.
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$typemesh_root/cmake/setup.sh"
here=$typemesh_root/bench work=$typemesh_root/build/instructions table=$typemesh_root/bench/instructions.tsv
renew= beside= tolerance=2 wanted=
while [ $# -gt 0 ]; do
    case $1 in
        --renew) renew=yes ;;
        --beside) beside=$2 && shift ;;
        --tolerance) tolerance=$2 && shift ;;
        -*) sed -n '3,13s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 2 ;;
        *) wanted="$wanted $1" ;;
    esac
    shift
done
install_missing g++ pkg-config harfbuzz valgrind
install_fonts fonts-liberation fonts-comic-neue fonts-inter-variable fonts-mplus
mkdir -p "$work"

compile() {  # compile FOLDER INCLUDE_FOLDER
    local program
    mkdir -p "$1"
    for program in kernels writing; do
        # shellcheck disable=SC2046  # a list of words
        "${CXX:-g++}" -std=c++20 -O3 -DNDEBUG -I"$2" -I"$here" -DTYPEMESH_TEST_DATA="\"$typemesh_root/tests\"" \
            "$here/instructions/$program.cpp" -o "$1/$program" $(pkg-config --cflags --libs harfbuzz)
    done
}
counted() { valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 | sed -n 's/.*Collected : //p'; }
# Of one unit: what some repetitions more cost, so that opening fonts and warming up fall out.
count() {  # count PROGRAM KERNEL UNIT
    local units more=1 first second
    case $2 in hello* | lorem* | write*) more=5 ;; esac
    if [ "$3" = byte ]; then "$1" "$2" 1 && return; fi  # sizes are printed, not counted
    units=$("$1" "$2" 1) first=$(counted "$1" "$2" 1) second=$(counted "$1" "$2" $((1 + more)))
    awk -v a="$first" -v b="$second" -v n=$((more * units)) 'BEGIN { printf "%.1f", (b - a) / n }'
}

say "This builds the kernels"
compile "$work/now" "$typemesh_root/include"
if [ -n "$beside" ]; then
    other=$work/tree
    rm -rf "$other" && mkdir -p "$other"
    git -C "$typemesh_root" archive "$beside" include | tar -x -C "$other"
    compile "$work/beside" "$other/include" || stop "The kernels do not compile against $beside."
fi
made_with="$("${CXX:-g++}" --version | head -n 1), HarfBuzz $(pkg-config --modversion harfbuzz)"
for program in kernels writing; do
    "$work/now/$program" | sed "s/^/$program	/"
done >"$work/list"
[ -z "$renew" ] || printf '# Instructions a unit, by bench/instructions.sh --renew. %s\n# kernel\tunit\tinstructions\twhat\n' "$made_with" >"$work/new.tsv"
failed=0
while IFS='	' read -r program name unit what; do
    case " ${wanted:-$name} " in *" $name "*) ;; *) continue ;; esac
    now=$(count "$work/now/$program" "$name" "$unit")
    if [ -n "$renew" ]; then
        printf '%s\t%s\t%s\t%s\n' "$name" "$unit" "$now" "$what" >>"$work/new.tsv"
        before=
    elif [ -n "$beside" ]; then
        before=$(count "$work/beside/$program" "$name" "$unit")
    else
        before=$(awk -F '\t' -v name="$name" '$1 == name { print $3 }' "$table")
    fi
    awk -v name="$name" -v unit="$unit" -v now="$now" -v before="$before" -v most="$tolerance" 'BEGIN {
        printf unit == "byte" ? "%-16s %12d bytes" : "%-16s %12.1f a %s", name, now, unit
        if (before > 0) printf ", %.1f %% of %.1f", 100 * now / before, before
        slipped = before > 0 && now > before * (1 + most / 100)
        print slipped ? "   MORE" : ""
        exit slipped
    }' || failed=1
done <"$work/list"
if [ -n "$renew" ]; then
    [ -z "$wanted" ] || stop "--renew counts all kernels: none was written."
    mv "$work/new.tsv" "$table"
    say "The table is written: $table"
    exit
fi
[ -n "$beside" ] || exit $failed
