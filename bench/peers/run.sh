#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Other libraries beside typemesh: times of whole texts, chord errors and faults of their meshes, triangulation alone. Prints rows
# (../README.md); what it is at goes to standard error. A peer that cannot be installed, built or run is skipped.
#
#     bench/peers/run.sh             all of it: within 20 minutes on 2 cores
#     bench/peers/run.sh --quick     two texts, ASCII, one round: within a minute
#
# What cannot run in one process is run in turn, typemesh before each peer, in several rounds. Needs a network for the packages
# that are not there yet: Debian's, and npm's three, three-text, opentype.js, earcut and libtess.
#
# shellcheck disable=SC2046  # flags are lists of words
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"
here=$typemesh_root/bench/peers build=$typemesh_root/build/peers
rounds=3 seconds=0.1 node_seconds=0.4 quick=  # node's compiler takes its time
case ${1:-} in
    --quick) rounds=1 seconds=0.03 node_seconds=0.1 quick=quick ;;
    '') ;;
    *) sed -n '3,11s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 2 ;;
esac
tab=$(printf '\t')
tell() { printf '  peers: %s\n' "$*" >&2; }
skip() { printf 'skipped\t%s\t%s\n' "$1" "$2"; }
mkdir -p "$build/programs" "$build/node"
rm -rf "$build/meshes" "$build/times" && mkdir -p "$build/meshes" "$build/times"

# --- what there is -----------------------------------------------------------------------------------------------------------

has() { (install_missing "$@") >>"$build/install.log" 2>&1; }
has g++ pkg-config harfbuzz freetype fontconfig python3 || stop "g++, HarfBuzz and python3 are needed: see $build/install.log"
(install_fonts fonts-liberation fonts-inter-variable fonts-comic-neue fonts-hosny-amiri fonts-sawarabi-mincho fonts-wqy-microhei \
    fonts-mplus) >&2
fonts=${TYPEMESH_FONT_DIR:-/usr/share/fonts}
sans=$fonts/truetype/liberation/LiberationSans-Regular.ttf
font_names=$typemesh_root/tests/support/font_path.hpp
. "$typemesh_root/tests/support/font_file.sh"
variable=$(font_file truetype/inter-vf/Inter-roman.var.ttf)

newer() { find "$@" -newer "$binary" -print -quit; }
compile() {  # compile PROGRAM FLAG...; anew where what it is made of is newer
    local program=$1 binary=$build/programs/$1 sources
    shift
    case $program in
        typemesh | triangulators) sources="$typemesh_root/include $typemesh_root/bench/*.hpp" ;;
        *) sources= ;;
    esac
    # shellcheck disable=SC2086  # a list of words
    [ ! -x "$binary" ] || [ -n "$(newer "$here/$program.cpp" "$here"/*.hpp $sources)" ] || return 0
    tell "building $program"
    "${CXX:-g++}" -std=c++20 -O3 -DNDEBUG -w -I"$typemesh_root/include" -I"$typemesh_root/bench" "$here/$program.cpp" \
        -o "$binary" "$@" >"$build/$program.log" 2>&1
}
flags() { pkg-config --cflags --libs "$@"; }

# A peer's name, the needs it has (cmake/setup.sh), and the program that runs it.
peers=
native() {  # native NAME PROGRAM NEED... -- FLAG...
    local name=$1 program=$2 needs=
    shift 2
    while [ "$1" != -- ]; do needs="$needs $1" && shift; done
    shift
    # shellcheck disable=SC2086,SC2068  # lists of words
    if ! has $needs; then
        skip "$name" "its packages could not be installed"
    elif ! compile "$program" $(eval "$*" 2>/dev/null); then
        skip "$name" "it could not be built: build/peers/$program.log"
    else
        peers="$peers $program"
    fi
}
compile typemesh $(flags harfbuzz) || stop "typemesh.cpp could not be built: $build/typemesh.log"
compile judge $(flags harfbuzz) || stop "judge.cpp could not be built: $build/judge.log"
native FTGL ftgl ftgl glu -- flags ftgl glu
native 'osgText 3D' osgtext openscenegraph -- flags openscenegraph
native 'Qt 3D' qt3d qt3d -- 'flags Qt53DExtras && say -fPIC'
vtk() {
    local folder version
    folder=$(printf '%s\n' /usr/include/vtk-9* | tail -n 1) && version=${folder##*vtk-}
    say "-isystem $folder"
    printf -- "-lvtk%s-$version " RenderingFreeType FiltersModeling FiltersCore CommonDataModel CommonExecutionModel CommonCore sys
}
native VTK vtk vtk -- vtk
native Coin coin coin fontconfig-dev -- 'say -lCoin -lfontconfig'
occt='-isystem /usr/include/opencascade -lTKV3d -lTKService -lTKPrim -lTKMesh -lTKTopAlgo -lTKBRep -lTKG3d -lTKMath -lTKernel'
native OCCT occt occt occt-modeling -- "say $occt"
if has blender; then peers="$peers blender"; else skip Blender "it could not be installed"; fi
if has openscad; then peers="$peers openscad"; else skip OpenSCAD "it could not be installed"; fi
node_packages="three@0.187.0 opentype.js@1.3.4 three-text@0.6.5 earcut@3.2.4 libtess@1.2.2"
# shellcheck disable=SC2086  # a list of words
if has node npm && npm install --prefix "$build/node" --no-save --no-audit --no-fund $node_packages >"$build/npm.log" 2>&1; then
    # three's loader of fonts fetches its parser from a network address: it gets the package instead.
    loader=$build/node/node_modules/three/examples/jsm/loaders/TTFLoader.js
    sed "s|'https:[^']*opentype[^']*'|'opentype.js'|" "$loader" >"$build/node/TTFLoader.mjs"
    cp "$here"/*.mjs "$build/node"
    peers="$peers three three_text"
else
    skip "three.js, three-text, earcut, libtess" "node or its packages could not be installed"
fi

# --- running them ------------------------------------------------------------------------------------------------------------

of_peer() {  # of_peer PEER ARGUMENT...
    local peer=$1 start='timeout 300'
    shift
    case $peer in
        blender)
            HOME=$build $start blender --background --factory-startup --python "$here/blender.py" -- "$@" |
                { grep -a "^time$tab" || true; }
            ;;
        openscad) $start python3 "$here/openscad.py" "$@" ;;
        three*) (cd "$build/node" && $start node "$peer.mjs" "$@") ;;
        *) $start "$build/programs/$peer" "$@" ;;
    esac 2>>"$build/run.log"
}

texts=$build/texts.tsv
line_of() { sed -n "$2p" "$typemesh_root/tests/workload/$1"; }
{
    printf 'hello\t%s\t%s\n' "$sans" "$(line_of phrases-latin.txt 1)"
    [ -n "$quick" ] || printf 'name\t%s\t%s\n' "$sans" "$(line_of phrases-latin.txt 7)"
    printf 'lorem\t%s\t%s\n' "$sans" "$(line_of long-latin.txt 1)"
    printf 'hello, cubics\t%s\t%s\n' "$fonts/opentype/comic-neue/ComicNeue-Regular.otf" "$(line_of phrases-latin.txt 1)"
    printf 'hello, overlaps\t%s\t%s\n' "$variable" "$(line_of phrases-latin.txt 1)"
    printf 'Arabic\t%s\t%s\n' "$fonts/opentype/fonts-hosny-amiri/Amiri-Regular.ttf" "$(line_of phrases-arabic.txt 1)"
    printf 'Japanese\t%s\t%s\n' "$fonts/truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf" "$(line_of phrases-japanese.txt 1)"
    printf 'Chinese\t%s\t%s\n' "$fonts/truetype/wqy/wqy-microhei.ttc" "$(line_of phrases-chinese.txt 1)"
} | while IFS= read -r line; do
    file=$(say "$line" | cut -f 2)
    if [ -n "$quick" ] && [ "$file" != "$sans" ]; then continue; fi
    if [ -e "$file" ]; then say "$line"; else skip "$file" "no such font" >&2; fi
done >"$texts"

ladder="0.02 0.01 0.005 0.0025 0.0017 0.0009 0.0006 0.0003 0.00015 0.00008 0.00004"
[ -z "$quick" ] || ladder="0.005 0.0025 0.0006 0.0003 0.0001"
judged="$sans $variable"
[ -z "$quick" ] || judged=$sans
for font in $judged; do
    if [ ! -e "$font" ]; then
        skip "$font" "no such font"
        continue
    fi
    tell "meshes of single letters, ${font##*/}"
    # shellcheck disable=SC2086  # a list of words
    of_peer typemesh meshes "$build/meshes" "$font" $ladder
    for peer in $peers; do
        case $quick$peer in quickopenscad | quickocct | *vtk) continue ;; esac
        of_peer "$peer" meshes "$build/meshes" "$font" >/dev/null || skip "$peer" "it broke while it made meshes of ${font##*/}"
    done
done
tell "judging them"
"$build/programs/judge" ${quick:+ascii} "$build"/meshes/*.meshes | awk '!seen[$0]++' >"$build/judged.tsv"
cat "$build/judged.tsv"

for round in $(seq "$rounds"); do
    for peer in $peers; do
        case $quick$peer in quickocct) continue ;; esac
        tell "round $round of $rounds, $peer"
        case $peer in three*) each=$node_seconds ;; *) each=$seconds ;; esac
        # shellcheck disable=SC2086  # a list of words
        of_peer typemesh time "$texts" 0.02 >"$build/times/$round.$peer.typemesh.tsv"
        { of_peer "$peer" time "$texts" "$each" >"$build/times/$round.$peer.peer.tsv" &&
            [ -s "$build/times/$round.$peer.peer.tsv" ]; } ||
            skip "$peer" "it broke while it was timed, round $round"
    done
    # shellcheck disable=SC2086  # a list of words
    of_peer typemesh time "$texts" 0.02 $ladder >"$build/times/$round.ladder.typemesh.tsv"
done
python3 "$here/summary.py" "$build/times" "$build/judged.tsv"

versions=$(dpkg-query -W -f '${Package} ${Version}, ' libftgl2 libopenscenegraph161 libqt53dextras5 libvtk9.1 libcoin80c \
    libocct-visualization-7.6 blender openscad libglu1-mesa libcgal-dev libpolyclipping22 2>/dev/null || true)
printf 'note\tVersions of the peers: %s%s\n' "$versions" "$(say "$node_packages" | tr '@ ' ' ,' | sed 's/,/, /g')"

tell "triangulation alone"
if has glu cgal polyclipping && compile triangulators $(flags harfbuzz glu) -I/usr/include/polyclipping -lpolyclipping -lmpfr -lgmp; then
    "$build/programs/triangulators" "$build/polygons.jsonl" $quick
    case $peers in
        *three*) (cd "$build/node" && node triangulators.mjs "$build/polygons.jsonl" $quick) || skip "earcut, libtess" "they broke" ;;
    esac
else
    skip "GLU, CGAL, Clipper" "they could not be installed or built: build/peers/triangulators.log"
fi
