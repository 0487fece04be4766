#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Draws the pictures of this folder anew with text_to_mesh, which is built first unless the first argument names one, but for
# three.png, which bench/three/run.sh draws. Installs what is missing.
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"
case ${1:-} in
    -h | --help) sed -n '3,5s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 0 ;;
esac
install_missing g++ cmake ninja pkg-config harfbuzz freetype fontconfig-dev icu cli11 tinygltf stb imagemagick pngquant
install_fonts fonts-liberation fonts-hosny-amiri fonts-sawarabi-mincho fonts-mplus culmus fonts-inter-variable fonts-cegui fonts-dejavu-core
if [ -n "${1:-}" ]; then
    program=$(realpath "$1")
else
    program=$typemesh_root/build/release/examples/text_to_mesh
    build_preset release text_to_mesh
fi
cd "$typemesh_root/docs/pictures"
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
sans=/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf
arabic=/usr/share/fonts/opentype/fonts-hosny-amiri/Amiri-Regular.ttf
japanese=/usr/share/fonts/truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf
serif=/usr/share/fonts/truetype/liberation/LiberationSerif
font_names=../../tests/support/font_path.hpp
. ../../tests/support/font_file.sh
hebrew=$(font_file truetype/culmus/FrankRuehlCLM-Medium.ttf)

# The README's picture: there solid, back as wires. Each view has the height that suits it; its edges go on above and below.
views=24
for ((i = 0; i < 2 * views; ++i)); do
    turn=$(awk "BEGIN { print -29 * cos(3.14159265 * $i / $views) }")
    wires=() && ((i < views)) || wires=(--quality low --show triangles)
    view=$(printf '%s/turning-%02d.png' "$scratch" $i)
    "$program" "typemesh" --font $serif-Bold.ttf --bevel 0.03 --profile round --turn "$turn" "${wires[@]}" --picture "$view"
    mogrify -resize 640x -virtual-pixel edge -set option:distort:viewport "640x296+0+%[fx:(h-296)/2]" -distort SRT 0 +repage "$view"
done
convert -delay 8 -loop 0 "$scratch"/turning-*.png +dither -layers optimize turning.gif

"$program" "Hello world!" --font $sans --picture hello.png
"$program" "مرحبا بالعالم!" --font $arabic --picture "$scratch/arabic.png"
"$program" "こんにちは、世界！" --font $japanese --picture "$scratch/japanese.png"
convert "$scratch/arabic.png" "$scratch/japanese.png" -resize x300 -gravity center +append scripts.png

# Debian has no colour font with layers: TYPEMESH_COLOUR_FONT may name Noto Color Emoji, such as the file
# noto-color-emoji-emoji-400-normal.woff2 of npm's @fontsource/noto-color-emoji after woff2_decompress.
if [ -n "${TYPEMESH_COLOUR_FONT:-}" ]; then
    "$program" "😀🎉👍🏽🇩🇪❤️🦊🏳️‍🌈" --font "$TYPEMESH_COLOUR_FONT" --colour-layers --picture emoji.png
else
    say "emoji.png stays as it is, because TYPEMESH_COLOUR_FONT names no font."
fi

text='Letters of three scripts share a page: in the beginning there was English, then comes עברית שנכתבת מימין לשמאל, 2024 in its midst, '
text+='and العربية التي تكتب من اليمين إلى اليسار وتتصل حروفها بعضها ببعض, before the line goes on as it began and is as wide as all the others.'
"$program" "$text" --font ${sans/Sans/Serif} --fallback "$hebrew" --fallback $arabic \
    --width 20 --align justify --justify kashida --picture paragraph.png

# shellcheck disable=SC1112
"$program" "2024年12月、東京の\n「Typemesh」はコード\nだけで立体の文字を作る。\nVR・AR（第3版）" \
    --font /usr/share/fonts/opentype/mplus/Mplus1-Regular.otf --direction ttb --combine-digits 2 --line-spacing 0.75 --picture columns.png

for shading in gouraud phong; do
    for normals in shared averaged creased curve; do
        "$program" "Eo" --font $sans --quality normal --normals $normals --shading $shading --picture "$scratch/$shading-$normals.png"
        convert "$scratch/$shading-$normals.png" -resize 480x "$scratch/$shading-$normals.png"
    done
done
montage -label '%t' "$scratch"/gouraud-{shared,averaged,creased,curve}.png "$scratch"/phong-{shared,averaged,creased,curve}.png \
    -tile 4x2 -geometry +6+6 -font DejaVu-Sans -pointsize 18 normals.png

"$program" "aBg" --font $sans --depth 0 --quality normal --show triangles,points,control,contours --picture stages.png

for mapping in box em cylindrical; do
    "$program" "Rag" --font $serif-Bold.ttf --depth 0.4 --uv $mapping --show checker --picture "$scratch/$mapping.png"
done
convert "$scratch"/{box,em,cylindrical}.png -resize 600x +append textures.png

inter=$(font_file truetype/inter-vf/Inter.var.ttf)
"$program" "A&f4" --font "$inter" --depth 0 --quality normal --show contours,triangles --picture "$scratch/before.png"
"$program" "A&f4" --font "$inter" --depth 0 --quality normal --triangulator delaunay --show triangles --picture "$scratch/after.png"
convert "$scratch/before.png" "$scratch/after.png" -resize 900x -append overlaps.png

# Of fonts-cegui, which Debian 12 and 13 have and 14 will not.
vibes=/usr/share/fonts/truetype/GreatVibes-Regular.ttf
if [ -e $vibes ]; then
    "$program" "eat" --font $vibes --depth 0 --quality normal --show triangles --picture "$scratch/apart.png"
    "$program" "eat" --font $vibes --depth 0 --quality normal --show triangles --merge --picture "$scratch/merged.png"
    convert "$scratch/apart.png" "$scratch/merged.png" -resize 600x +append merged.png
else
    say "merged.png stays as it is, because the font $vibes is not installed."
fi

for triangulator in monotone delaunay; do
    "$program" "Rag" --font $sans --depth 0 --quality normal --triangulator $triangulator --show triangles --picture "$scratch/$triangulator.png"
done
convert "$scratch"/{monotone,delaunay}.png -resize 50% +append triangulators.png

bevelled=()
for profile in chamfer round concave stepped engraved; do
    "$program" "Rag" --font $serif-Bold.ttf --bevel 0.03 --profile $profile --picture "$scratch/$profile.png"
    bevelled+=("$scratch/$profile.png")
done
"$program" "Rag" --font $serif-Bold.ttf --bevel 0.03 --profile round --show triangles --picture "$scratch/mesh.png"
montage "${bevelled[@]}" "$scratch/mesh.png" -tile 3x2 -geometry x300+0+0 bevels.png

for mode in clip fit; do
    "$program" "Rag" --font $serif-Regular.ttf --bevel 0.05 --bevel-mode $mode --picture "$scratch/$mode.png"
done
"$program" "سلام" --font ${arabic/Regular/Bold} --bevel 0.03 --profile round --picture "$scratch/arabic.png"
"$program" "永遠" --font $japanese --bevel 0.02 --profile round --picture "$scratch/han.png"
convert "$scratch"/{clip,fit,arabic,han}.png -resize x300 +append bevelled_scripts.png

"$program" "Rag" --font $serif-Bold.ttf --carve 90 --picture "$scratch/relief.png"
"$program" "Rag" --font $serif-Bold.ttf --carve 60 --carve-depth 0.04 --picture "$scratch/floor.png"
"$program" "Rag" --font $serif-Bold.ttf --carve 90 --carve-as groove --picture "$scratch/groove.png"
convert "$scratch"/{relief,floor,groove}.png -resize x300 +append carved.png

bold_and_hollow=()
draw() {  # draw FONT OPTION...
    "$program" "Rag" --font "$@" --picture "$scratch/${#bold_and_hollow[@]}.png"
    bold_and_hollow+=("$scratch/${#bold_and_hollow[@]}.png")
}
draw $serif-Regular.ttf
draw $serif-Regular.ttf --embolden 0.03
draw $serif-Bold.ttf --outline 0.025
draw $serif-Bold.ttf --outline 0.025 --outline-letter
draw $serif-Bold.ttf --outline 0.04 --bevel 0.01 --profile round
draw $serif-Bold.ttf --outline 0.03 --outline-place outer --outline-letter --bevel 0.01
mogrify -resize 550x320^ -gravity center -extent 550x320 "${bold_and_hollow[@]}"
montage "${bold_and_hollow[@]}" -tile 3x2 -geometry +0+0 bold_and_hollow.png

refined=(--font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --depth 0.15 --turn -20 --show triangles)
"$program" "Rag" "${refined[@]}" --picture "$scratch/plain.png"
"$program" "Rag" "${refined[@]}" --refine delaunay --picture "$scratch/angles.png"
"$program" "Rag" "${refined[@]}" --refine delaunay --max-edge 0.06 --picture "$scratch/edges.png"
convert "$scratch"/{plain,angles,edges}.png -resize 700x +append refined.png

# Bent letters, refined as far as they bend.
bent=(--font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --depth 0.15 --align centre)
"$program" "coffee" "${bent[@]}" --bend cylinder:1.2 --turn 25 --picture "$scratch/cup.png"
"$program" "coffee" "${bent[@]}" --bend cylinder:1.2 --turn 25 --show triangles --picture "$scratch/cup_triangles.png"
"$program" "Twisted text" "${bent[@]}" --bend twist:15 --turn 10 --picture "$scratch/twist.png"
"$program" "Waving flag" "${bent[@]}" --bend wave:0.25,2.5 --turn 30 --picture "$scratch/wave.png"
mogrify -resize 700x360 -background '#eef0f3' -gravity center -extent 700x360 "$scratch"/{cup,cup_triangles,twist,wave}.png
montage "$scratch"/{cup,cup_triangles,twist,wave}.png -tile 2x2 -geometry +0+0 bent.png

# Six ways to mesh a letter.
ways=(--font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --depth 0 --show triangles)
"$program" "Rg" "${ways[@]}" --triangulator monotone --picture "$scratch/way1.png"
"$program" "Rg" "${ways[@]}" --triangulator delaunay --picture "$scratch/way2.png"
"$program" "Rg" "${ways[@]}" --refine delaunay --picture "$scratch/way3.png"
"$program" "Rg" "${ways[@]}" --refine delaunay --max-edge 0.06 --picture "$scratch/way4.png"
"$program" "Rg" "${ways[@]}" --refine quadtree --max-edge 0.06 --picture "$scratch/way5.png"
"$program" "Rg" "${ways[@]}" --refine nonobtuse --picture "$scratch/way6.png"
montage "$scratch"/way[1-6].png -tile 3x2 -geometry 640x440+2+2 meshing.png

# Letters like balloons; outlines that are warped.
"$program" "Balloon" --font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --inflate 1 --turn -25 --picture "$scratch/balloon1.png"
"$program" "سلام" --font $arabic --inflate 1 --turn 20 --picture "$scratch/balloon2.png"
"$program" "永和" --font $japanese --inflate 1 --turn 15 --picture "$scratch/balloon3.png"
montage "$scratch"/balloon[1-3].png -tile 3x1 -geometry 560x400+2+2 -background '#eef0f3' inflated.png
# A neon sign.
"$program" "OPEN\n24 hours" --font /usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf --tube 0.025,24 --align centre --style 0..4:colour=#ff2d8a,size=1.4 \
    --style 5..13:colour=#1d8ff2 --turn -14 --picture "$scratch/neon.png"
convert "$scratch/neon.png" -resize x400 neon.png
"$program" "Rainbow text" --font /usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf --bend arc:120 --bevel 0.02 --picture "$scratch/arc.png"
"$program" "perspective" --font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --bend perspective:0.4 --picture "$scratch/perspective.png"
montage "$scratch"/{arc,perspective}.png -tile 2x1 -geometry 700x420+2+2 -background '#eef0f3' warped.png

# Letters that stand on a path.
"$program" "a ring of letters, each of them turned, " --font /usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf --path circle:3.45 --bevel 0.02 --turn -15 --picture "$scratch/ring.png"
"$program" "بسم الله الرحمن الرحيم" --font $arabic --path arc:5,110 --bevel 0.01 --turn -10 --picture "$scratch/bow.png"
montage "$scratch"/{ring,bow}.png -tile 2x1 -geometry 700x560+2+2 -background '#eef0f3' path.png

# Plates, and walls that lean.
bold=/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf
"$program" "Anna" --font $bold --plate 0.2,0.15,0.12 --picture "$scratch/standing.png"
"$program" "Marin" --font $serif-Bold.ttf --plate 0.25,0.1,0.1 --inlay --colour '#2060a0' --picture "$scratch/inlay.png"
"$program" "ABO8" --font $bold --plate 0.2,0.1,0.08 --stencil 0.05 --picture "$scratch/stencil.png"
"$program" "Opal" --font $bold --backing 0.1,0.12 --keyring 0.08 --picture "$scratch/keyring.png"
mogrify -resize 540x272^ -gravity center -extent 540x272 "$scratch"/{standing,inlay,stencil,keyring}.png
montage "$scratch"/{standing,inlay,stencil,keyring}.png -tile 2x2 -geometry +0+0 plates.png
"$program" "Anna" --font $bold --plate 0.2,0.15,0.12 --depth 0.08 --bevel 0.015 --fillet 0.05 --colour '#c03a2b' --turn -32 --picture "$scratch/fillet.png"
"$program" "Oslo" --font $serif-Bold.ttf --plate 0.2,0.1,0.1 --engrave 0.06 --bevel 0.025 --turn 24 --picture "$scratch/chamfer.png"
mogrify -resize 540x -gravity center -background '#eef0f3' -extent 540x320 "$scratch"/{fillet,chamfer}.png
montage "$scratch"/{fillet,chamfer}.png -tile 2x1 -geometry +0+0 rims.png
"$program" "CAD" --font $bold --depth 0.25 --taper 10 --turn -18 --picture "$scratch/headline.png"
"$program" "Roofs" --font $serif-Bold.ttf --depth 0.3 --taper 40 --turn 22 --picture "$scratch/roofs.png"
mogrify -resize 560x270^ -gravity center -extent 560x270 "$scratch"/{headline,roofs}.png
montage "$scratch"/{headline,roofs}.png -tile 2x1 -geometry +0+0 tapered.png

# A headline of three styles in three fonts; the styled range of a line of both directions is two stretches.
"$program" "Type سلام 活字" --font $serif-Bold.ttf --fallback ${arabic/Regular/Bold} --fallback $japanese --bevel 0.015 --profile round \
    --style 0..4:colour=blue,underline --style 5..9:colour=red,size=1.25 --style 10..12:colour=green,overline --picture "$scratch/headline.png"
"$program" "one שתיים three" --font /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf --style 1..7:colour=blue,underline --picture "$scratch/range.png"
convert "$scratch"/{headline,range}.png -resize 900x -append styles.png

# What tags do to a text.
"$program" 'plain, [b]bold[/b], [i]slanted[/i], [u]underlined[/u],\n[s]struck[/s], E = mc[sup]2[/sup], [colour=#c33]red[/], [colour=#36c][size=1.5]large[/][/],\n[colour=#484][depth=0.6]deep[/][/] and [bevel=0.03][colour=#c83]bevelled[/][/]' \
    --markup --font /usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf --align centre --turn -14 --picture "$scratch/markup.png"
"$program" '[ruby=とうきょう]東京[/]は[ruby=くも]曇[/]り、[colour=#c33][ruby=あめ]雨[/][/]です。' --markup --font $japanese --turn 0 --picture "$scratch/ruby.png"
convert "$scratch"/{markup,ruby}.png -resize 900x -append markup.png

g++ -std=c++20 -I../../include beside.cpp -o "$scratch/beside" $(pkg-config --cflags --libs harfbuzz)
draw_beside() {  # draw_beside NAME SIZE FONT WIDTH MARKUP
    convert -size "$2" xc:white -draw "$("$scratch/beside" "$3" "$4" "$5")" "$scratch/$1.png"
}
mplus=/usr/share/fonts/opentype/mplus/Mplus1-Regular.otf
draw_beside rubies 600x380 $mplus 9 \
    '[ruby=こころざし]志[/]は[ruby=とうきょう]東京[/]で[ruby=まこと]信[/]と[ruby=internationalization]国際化[/]を[ruby=と]図書[/]る。'
draw_beside columns 500x380 $mplus -5 \
    '[ruby=こころざし]志[/]は[mark=#ffe08a][ruby=とうきょう]東京[/]で[/]、[box=0.8,0.8]と[ruby=いっ]一[/][ruby=しょ]緒[/]。'
draw_beside boxes 640x380 /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf 10 \
    'Collect [mark=#bcd6ff]three [box=0.9,0.75,0.1] of them, [size=1.5]then[/] go on[/] to [mark=#ffe08a]the שלום [box=1.4,1.2,0.2] עולם gate[/], or rest.'
convert "$scratch"/{rubies,columns,boxes}.png +append beside.png

g++ -std=c++20 -I../../include selection.cpp -o "$scratch/selection" $(pkg-config --cflags --libs harfbuzz)
convert -size 910x160 xc:white -draw "$("$scratch/selection" /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf)" selection.png
g++ -std=c++20 -O2 -I../../include curved.cpp -o "$scratch/curved" $(pkg-config --cflags --libs harfbuzz)
"$scratch/curved" /usr/share/fonts/truetype/dejavu/DejaVuSerif.ttf 'g&' | convert ppm:- curved.png

# One word at five weights: its triangles stay the same.
g++ -std=c++20 -O2 -I../../include morphing.cpp -o "$scratch/morphing" $(pkg-config --cflags --libs harfbuzz)
convert -size 960x890 xc:white -draw "$("$scratch/morphing" "$inter")" morph.png

# Letters that move, drawn by a program of their own.
g++ -std=c++20 -O2 -I../../include -I../../examples/text_to_mesh -I../../examples moving.cpp "$typemesh_root"/examples/text_to_mesh/picture/*.cpp \
    -o "$scratch/moving" $(pkg-config --cflags --libs harfbuzz)
for motion in wave ring score breathe; do
    mkdir "$scratch/$motion"
    font=$serif-Bold.ttf
    [ $motion != breathe ] || font=$inter
    "$scratch/moving" $motion "$font" "$scratch/$motion"
    convert -delay 6 -loop 0 "$scratch/$motion"/*.ppm +dither -colors 96 -layers optimize $motion.gif
done

pngquant --quality 90-100 --speed 1 --force --ext .png beside.png paragraph.png normals.png bevels.png bevelled_scripts.png bent.png carved.png inflated.png markup.png meshing.png morph.png neon.png path.png warped.png bold_and_hollow.png refined.png styles.png textures.png
pngquant --quality 60-92 --speed 1 --force --ext .png plates.png rims.png tapered.png
