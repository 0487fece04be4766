#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"

usage() {
    cat <<'END'
usage: examples/web/run.sh [--build | PORT]

Builds the live page into build/web/site, and serves it at http://localhost:PORT/ (8000) until you press Ctrl-C; --build only builds.
Installs what is missing if it may: Debian's emscripten, HarfBuzz's source, fonts, node; npm's three. The folder needs no network
afterwards, and any server of files will do.
END
}
port=8000
case ${1:-} in
    -h | --help) usage && exit 0 ;;
    --build) port= ;;
    '') ;;
    *[!0-9]*) usage >&2 && exit 2 ;;
    *) port=$1 ;;
esac

web=$typemesh_root/examples/web
site=$typemesh_root/build/web/site
npm=$typemesh_root/build/web/npm
three=0.187.0  # the page is tested with this one
install_missing node npm python3 font
install_fonts fonts-dejavu-core fonts-liberation fonts-comic-neue fonts-hosny-amiri fonts-sawarabi-mincho
"$web/build.sh"
if [ ! -d "$npm/node_modules/three" ]; then
    mkdir -p "$npm"
    say "Getting three.js from npm"
    npm install --prefix "$npm" --no-save --no-audit --no-fund "three@$three" >"$npm.log" 2>&1 ||
        stop "npm could not install three; what it said: $npm.log"
fi

rm -rf "$site" && mkdir -p "$site/three/addons" "$site/fonts"
cp "$web/page/"* "$web/package/typemesh.js" "$web/package/typemesh.wasm" "$site/"
cp "$npm/node_modules/three/build/"three.{module,core}.js "$site/three/"
for folder in controls exporters utils; do cp -R "$npm/node_modules/three/examples/jsm/$folder" "$site/three/addons/"; done

# The fonts that are there, the first one being what the page begins with.
names=
while IFS='|' read -r name file; do
    [ -e "/usr/share/fonts/$file" ] || { say "Without $name: Debian's package of it is missing." && continue; }
    cp "/usr/share/fonts/$file" "$site/fonts/"
    names="$names${names:+,}\"$name\":\"fonts/$(basename "$file")\""
done <<'END'
DejaVu Sans Bold|truetype/dejavu/DejaVuSans-Bold.ttf
DejaVu Sans|truetype/dejavu/DejaVuSans.ttf
DejaVu Serif Bold|truetype/dejavu/DejaVuSerif-Bold.ttf
Liberation Serif Italic|truetype/liberation/LiberationSerif-Italic.ttf
Comic Neue|opentype/comic-neue/ComicNeue-Regular.otf
Amiri (Arabic)|opentype/fonts-hosny-amiri/Amiri-Regular.ttf
Sawarabi Mincho (Japanese)|truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf
END
[ -n "$names" ] || stop "None of the fonts is there."
printf '{%s}\n' "$names" >"$site/fonts.json"
say "The page: $site"
[ -n "$port" ] || exit 0
say "Serving it at http://localhost:$port/  (Ctrl-C ends)"
exec python3 -m http.server --bind 127.0.0.1 --directory "$site" "$port"
