#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# D3DXCreateTextW as Wine has it (not Microsoft's) beside typemesh, on one machine in one go: the same text, fonts,
# deviations and size; times, sizes, closedness, and how far the meshes are from the outlines. typemesh runs natively
# with HarfBuzz and, with DirectWrite, as a Windows program under the same Wine. See docs/from_d3dx.md.
#
#     bench/d3dx/run.sh                times and sizes, 2 minutes
#     bench/d3dx/run.sh --letters      also every letter of Latin-1 at seven deviations: errors, some minutes more
#     bench/d3dx/run.sh --protocol N   instead: the texts of the thesis, N runs each a round, as rows (../README.md)
#     bench/d3dx/run.sh --rounds N     so many rounds (3) of all programs in turn; the best median of each counts
#     bench/d3dx/run.sh --runs N       so many runs (1000) in a round
#
# On Windows bench_d3dx_create_text.exe measures Microsoft's implementation; D3DX9_DLL names another library than
# d3dx9_43.dll.
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"
build=$typemesh_root/build/d3dx
letters=
protocol=
rounds=3
runs=1000
while [ $# -gt 0 ]; do
    case $1 in
        --letters) letters=yes ;;
        --protocol) protocol=$2 && shift ;;
        --rounds) rounds=$2 && shift ;;
        --runs) runs=$2 && shift ;;
        *) sed -n '3,15s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 2 ;;
    esac
    shift
done

[ -z "$protocol" ] || exec 3>&1 1>&2  # rows alone go to the standard output
install_missing g++ cmake ninja pkg-config harfbuzz mingw wine xvfb
install_fonts fonts-dejavu-core fonts-liberation fonts-comic-neue
fonts=${TYPEMESH_FONT_DIR:-/usr/share/fonts}
table="$fonts/truetype/dejavu/DejaVuSans.ttf|DejaVu Sans
$fonts/truetype/liberation/LiberationSans-Regular.ttf|Liberation Sans
$fonts/opentype/comic-neue/ComicNeue-Regular.otf|Comic Neue"

mkdir -p "$build"
build_in() {  # build_in FOLDER TARGET... -- CMAKE_OPTION...
    local folder=$build/$1 targets=
    shift
    while [ "$1" != -- ]; do targets="$targets $1" && shift; done
    shift
    # shellcheck disable=SC2086  # a list of words
    { cmake -S "$typemesh_root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release -DTYPEMESH_BUILD_TESTS=OFF \
        -DTYPEMESH_BUILD_EXAMPLES=OFF "$@" && cmake --build "$folder" --target $targets; } >"$folder.log" 2>&1 ||
        { cat "$folder.log" >&2 && exit 1; }
}
[ -n "$protocol" ] || build_in native bench_d3dx_typemesh_text bench_d3dx_examine --
build_in windows bench_d3dx_typemesh_text bench_d3dx_create_text -- \
    -DCMAKE_TOOLCHAIN_FILE="$typemesh_root/cmake/mingw-w64.cmake"
native=$build/native/bench/d3dx windows=$build/windows/bench/d3dx

export WINEPREFIX=$build/wine WINEDEBUG=-all WINEDLLOVERRIDES=mscoree,mshtml=
export LIBGL_ALWAYS_SOFTWARE=1
unset DISPLAY
rm -f "$build"/*.meshes
display=$(mktemp)
Xvfb -displayfd 4 -screen 0 640x480x24 -nolisten tcp 4>"$display" 3>&- >/dev/null 2>&1 &
xvfb=$!
trap 'kill $xvfb; wineserver -k 2>/dev/null || true; rm -f "$display"' EXIT
for _ in $(seq 50); do [ -s "$display" ] || sleep 0.1; done
DISPLAY=:$(cat "$display")
export DISPLAY
wine wineboot -i >/dev/null 2>&1
under_wine() { wine "$@" 2>/dev/null; }

each_font() {  # each_font FUNCTION: called with the file, the same as Windows names it, and the family
    local file family
    while IFS='|' read -r file family; do
        # shellcheck disable=SC1003  # a backslash for tr
        [ ! -e "$file" ] || "$1" "$file" "Z:$(say "$file" | tr / '\\')" "$family" </dev/null
    done <<END
$table
END
}
time_all() {
    "$native/bench_d3dx_typemesh_text" text "$build/native.meshes" "$runs" "$1"
    under_wine "$windows/bench_d3dx_create_text.exe" text "Z:$build/d3dx.meshes" "$runs" "$2" "$3"
    under_wine "$windows/bench_d3dx_typemesh_text.exe" text "Z:$build/windows.meshes" "$runs" "$2"
}
# Wine's D3DXCreateTextW crashes on some letters: it is started again behind them.
mesh_letters() {
    local first=0 crash status
    case $1 in *.otf) return ;; esac  # its mesh of a CFF font is inside out and open: nothing to measure against
    "$native/bench_d3dx_typemesh_text" letters "$build/native.meshes" "$1"
    while :; do
        status=0
        crash=$(under_wine "$windows/bench_d3dx_create_text.exe" letters "Z:$build/d3dx.meshes" "$first" "$2" "$3") ||
            status=$?
        [ $status = 3 ] || break
        say "D3DXCreateTextW crashes: $3, letter ${crash#* }"
        first=$((${crash%% *} + 1))
    done
    [ $status = 0 ] || stop "bench_d3dx_create_text has failed ($status)"
}
# Into a file: processes that Wine starts in the background would keep a pipe open. A program that crashes may leave threads that
# never end, and a text may never come to an end: both are ended here.
one_protocol() {
    local pid size=0 last=0 still=0
    : >"$build/protocol.out"
    wine "$windows/bench_d3dx_create_text.exe" protocol "Z:$build/texts.tsv" "$1" "$2" "$3" "$protocol" \
        >"$build/protocol.out" 2>/dev/null 3>&- &
    pid=$!
    while sleep 1 && [ $still -lt 70 ]; do
        case $(ps -o stat= -p $pid) in Z* | '') break ;; esac
        size=$(wc -c <"$build/protocol.out")
        if [ "$size" = "$last" ]; then still=$((still + 1)); else still=0; fi
        last=$size
    done
    kill -9 $pid 2>/dev/null || true
    wait $pid 2>/dev/null || true
}
# The texts that a font stands in for, in a file; a crash is printed, and the next mesh begins anew.
time_protocol() {
    local first=0 crashes=0 crash
    texts_of "$(script_of "$3")" >"$build/texts.tsv"
    while :; do
        one_protocol "$first" "$2" "$3"
        tr -d '\r' <"$build/protocol.out" >"$build/protocol.rows"
        grep '^d3dx' "$build/protocol.rows" >&3 || true
        if tail -n 1 "$build/protocol.rows" | grep -qx end; then break; fi
        crash=$(sed -n 's/^try //p' "$build/protocol.rows" | tail -n 1)
        [ -n "$crash" ] || break
        first=$((crash + 1)) crashes=$((crashes + 1))
    done
    say "d3dx_crashes	$3	$crashes" >&3
}
texts_of() {
    local kind
    for kind in chars:character phrases:phrase long:long; do
        [ ! -e "$typemesh_root/tests/workload/${kind%:*}-$1.txt" ] || awk -v script="$1" -v kind="${kind#*:}" -v OFS='\t' \
            '{ print script, kind, FNR, $0 }' "$typemesh_root/tests/workload/${kind%:*}-$1.txt"
    done
}
script_of() {
    case $1 in Amiri) say arabic ;; WenQuanYi*) say chinese ;; Sawarabi*) say japanese ;; *) say latin ;; esac
}
if [ -n "$protocol" ]; then
    say "columns	d3dx	font	script	category	text	deviation	runs	mean_us	median_us	shortest_us	vertices	triangles" >&3
    say "columns	d3dx_crashes	font	crashes" >&3
    table="$table
$fonts/truetype/liberation/LiberationSerif-Regular.ttf|Liberation Serif
$fonts/truetype/liberation/LiberationMono-Regular.ttf|Liberation Mono
$fonts/opentype/fonts-hosny-amiri/Amiri-Regular.ttf|Amiri
$fonts/truetype/wqy/wqy-microhei.ttc|WenQuanYi Micro Hei
$fonts/truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf|Sawarabi Mincho"
    for _ in $(seq "$rounds"); do each_font time_protocol; done
    exit
fi
for _ in $(seq "$rounds"); do each_font time_all; done
[ -z "$letters" ] || each_font mesh_letters
"$native/bench_d3dx_examine" "$fonts" "$build/d3dx.meshes" "$build/native.meshes" "$build/windows.meshes"
