#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# three.js' TextGeometry beside bevelled: how many letters' meshes have faults, and docs/pictures/three.png. Bevels are 3 % of
# the em wide, carved in (TextGeometry's bevelOffset is -bevelSize) or put on (its default). Needs text_to_mesh, which
# examples/run.sh builds, node, npm, ImageMagick, pngquant, CGAL (GPL), GMP and MPFR.
#
#     bench/three/run.sh [FONT]         LiberationSerif-Regular.ttf by default
set -eu
case ${1:-} in
    -h | --help) sed -n '3,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 0 ;;
esac
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
here=$typemesh_root/bench/three build=$typemesh_root/build/three
tool=$typemesh_root/build/release/examples/text_to_mesh
font=${1:-/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf}
width=0.03

rm -rf "$build/meshes" && mkdir -p "$build/meshes"
npm install --prefix "$build" --no-save --no-audit --no-fund three@0.187.0 opentype.js@1.3.4 >"$build/npm.log"
# three's loader of fonts fetches its parser from a network address: it gets the package instead.
sed "s|'https:[^']*opentype[^']*'|'opentype.js'|" "$build/node_modules/three/examples/jsm/loaders/TTFLoader.js" >"$build/TTFLoader.mjs"
cp "$here/text_geometry.mjs" "$build"

tool_sources=$typemesh_root/examples/text_to_mesh
compile="${CXX:-g++} -std=c++20 -O2 -I$typemesh_root/examples -I$tool_sources"
$compile "$here/count_faults.cpp" -o "$build/count_faults" -lgmp -lmpfr
$compile -I"${STB:-/usr/include/stb}" "$here/draw_obj.cpp" "$tool_sources"/picture/*.cpp "$tool_sources"/{write_png,atomic_file}.cpp \
    -o "$build/draw_obj"

texts=({A..Z} {a..z} {0..9})
(cd "$build" && node text_geometry.mjs "$font" $width meshes "${texts[@]}" Rag)
for i in "${!texts[@]}"; do
    "$tool" "${texts[i]}" --font "$font" --bevel $width --output "$build/meshes/$i.typemesh-in.obj"
    "$tool" "${texts[i]}" --font "$font" --bevel $width --bevel-out --output "$build/meshes/$i.typemesh-out.obj"
done
for kind in three-in typemesh-in three-out typemesh-out; do
    echo "$kind: $("$build/count_faults" $(seq -f "$build/meshes/%g.$kind.obj" 0 $((${#texts[@]} - 1))))"
done

"$build/draw_obj" "$build/meshes/${#texts[@]}.three-in.obj" "$build/three.png"
"$tool" Rag --font "$font" --bevel $width --picture "$build/typemesh.png"
convert "$build/three.png" "$build/typemesh.png" -resize 800x +append "$typemesh_root/docs/pictures/three.png"
pngquant --quality 90-100 --speed 1 --force --ext .png "$typemesh_root/docs/pictures/three.png"
