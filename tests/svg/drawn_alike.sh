#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Does a browser draw the outlines in .svg files as it draws the font? Writes some hundred letters as SVG, each alone,
# and has headless Chromium draw each file and the same letter of the font itself: drawn_alike.html. At 300 pixels an em no
# pixel may differ by more than 0.6 of its cover, and the pixels of an outline by no more than 0.08 on average in a letter:
# Chromium takes outlines of that size from FreeType at 64 pixels an em, rounded to 1/64 of such a pixel, or 0.07 of
# these. (Fonts of 2048 units an em are not rounded, and differ by 0.01.) Takes a minute; no part of tests/run.sh.
#
#     tests/svg/drawn_alike.sh PROGRAM     text_to_mesh; python3 and Chromium are installed
set -eu
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1")
browser=
for name in chromium chromium-browser google-chrome; do
    [ -n "$browser" ] || browser=$(command -v $name) || true
done
[ -n "$browser" ] || { echo "Chromium is not installed" && exit 77; }
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
mkdir "$scratch/home" "$scratch/site"
cp "$here/drawn_alike.html" "$scratch/site/index.html"

latin='A..Z a..z 0..9 !..~ À..ÿ Α..ώ А..я'
sets="DejaVu Sans|/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf|$latin
Liberation Serif Italic|/usr/share/fonts/truetype/liberation/LiberationSerif-Italic.ttf|$latin
Inter (variable, overlaps)|/usr/share/fonts/truetype/inter-vf/Inter-roman.var.ttf|$latin
Comic Neue (CFF)|/usr/share/fonts/opentype/comic-neue/ComicNeue-Bold.otf|A..Z a..z !..@
Amiri (overlaps)|/usr/share/fonts/opentype/fonts-hosny-amiri/Amiri-Regular.ttf|ء..غ ف..ي
Sawarabi Mincho|/usr/share/fonts/truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf|一..丿 語..諱"
echo "const fonts = [" >"$scratch/site/letters.js"
number=0
while IFS='|' read -r name font ranges; do
    [ -e "$font" ] || { echo "$font is not installed" && continue; }
    number=$((number + 1)) out=$scratch/$number
    mkdir "$out"
    python3 - "$ranges" "$out/letters.txt" <<'PY'
import sys, unicodedata
letters = []
for part in sys.argv[1].split(' '):
    first, last = (part.split('..') + [part])[:2]
    letters += [chr(c) for c in range(ord(first), ord(last) + 1)]
keep = [c for c in dict.fromkeys(letters) if unicodedata.category(c)[0] in 'LNPS' and c not in '@\\-']
open(sys.argv[2], 'w', encoding='utf-8').write('\n'.join(keep) + '\n')
PY
    "$program" --batch "$out/letters.txt" --font "$font" --direction ltr --output "$out/{n}.svg" >"$out/said" 2>&1 || true
    python3 - "$name" "$font" "$out" "$scratch/site" "$number" <<'PY'
import json, os, re, shutil, sys
name, font, out, site, number = sys.argv[1:]
shutil.copy(font, f'{site}/{number}')
letters = open(f'{out}/letters.txt', encoding='utf-8').read().split()
files = {int(re.search(r'\d+', f)[0]): f'{out}/{f}' for f in os.listdir(out) if f.endswith('.svg')}
made = [{'text': c, 'svg': open(files[i], encoding='utf-8').read()} for i, c in enumerate(letters, 1) if i in files]
with open(f'{site}/letters.js', 'a', encoding='utf-8') as to:
    to.write(json.dumps({'name': name, 'url': number, 'letters': made}) + ',\n')
PY
done <<<"$sets"
echo "];" >>"$scratch/site/letters.js"

node "$here/../engines_run/three_serve.js" "$scratch/site" >"$scratch/port" &
# shellcheck disable=SC2064  # this process
trap "kill $! 2>/dev/null; rm -rf '$scratch'" EXIT
for _ in $(seq 40); do
    [ ! -s "$scratch/port" ] || break
    sleep 0.25
done
HOME=$scratch/home timeout 600 "$browser" --headless=new --no-sandbox --disable-gpu --font-render-hinting=none --user-data-dir="$scratch/profile" \
    --virtual-time-budget=600000 --dump-dom "http://127.0.0.1:$(cat "$scratch/port")/index.html" >"$scratch/page" 2>"$scratch/chromium"
sed -n '/<pre id/,/<\/pre>/p' "$scratch/page" | sed 's/<[^>]*>//g'
grep -q 'WRONG: 0<' "$scratch/page" || { tail -n 5 "$scratch/chromium" >&2 && exit 1; }
