#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"

usage() {
    cat <<'END'
usage: examples/web/run.sh [--build | PORT]

This script builds the live page into build/web/site and serves it at http://localhost:PORT/ (8000) until you press Ctrl-C.
--build only builds. It installs what is missing if it may: Debian's emscripten, HarfBuzz's source, fonts, python3. It fetches
three.js from npm's registry, with npm or without. Afterwards the folder needs no network, and any file server can serve it.
END
}
port=8000
case ${1:-} in
    -h | --help) usage && exit 0 ;;
    --build) port= ;;
    '') ;;
    *[!0-9]* | ??????* | 0*) usage >&2 && exit 2 ;;
    *) port=$1 ;;
esac
[ "${port:-1}" -le 65535 ] || stop "There is no port $port: ports end at 65535."

# Whether nothing answers at a port; once python3 is there, also whether this user may have it.
is_free() {  # is_free PORT
    local host
    for host in 127.0.0.1 ::1; do
        ! (exec 3<>"/dev/tcp/$host/$1") 2>/dev/null || return 1
    done
    python3 -c '' 2>/dev/null || return 0
    python3 - "$1" 2>/dev/null <<'END'
import socket, sys
with socket.socket() as tried:
    tried.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    tried.bind(("127.0.0.1", int(sys.argv[1])))
END
}
need_port() {
    local other
    [ -n "$port" ] && ! is_free "$port" || return 0
    for other in $((port + 1)) $((port + 2)) 8080 8888; do
        [ "$other" -gt 65535 ] || ! is_free "$other" || stop "The port $port is not free, but $other is: examples/web/run.sh $other"
    done
    stop "The port $port is not free. Please name another one: examples/web/run.sh PORT"
}
need_port  # before anything that takes minutes

web=$typemesh_root/examples/web
site=$typemesh_root/build/web/site
parts=$typemesh_root/build/web/npm
install_missing python3 certificates
install_fonts fonts-dejavu-core fonts-liberation fonts-comic-neue fonts-hosny-amiri fonts-sawarabi-mincho
"$web/three.sh" "$parts"
"$web/build.sh"

rm -rf "$site" && mkdir -p "$site/three/addons" "$site/fonts"
cp "$web/page/"* "$web/package/typemesh.js" "$web/package/typemesh.wasm" "$site/"
cp "$parts/three/build/"three.{module,core}.js "$site/three/"
for folder in controls exporters utils; do cp -R "$parts/three/examples/jsm/$folder" "$site/three/addons/"; done

# The fonts that are there, the first one being what the page begins with.
names=
while IFS='|' read -r name file; do
    [ -e "/usr/share/fonts/$file" ] || { say "The page has no $name, because its Debian package is not installed." && continue; }
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
say "The page is in $site"
[ -n "$port" ] || exit 0
need_port  # again, for the minutes are over
say "It is served at http://localhost:$port/ until you press Ctrl-C"
exec python3 -m http.server --bind 127.0.0.1 --directory "$site" "$port"
