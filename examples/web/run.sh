#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"

usage() {
    cat <<'END'
usage: examples/web/run.sh [--build | --static DIR | PORT]

This script builds the live page into build/web/site and serves it at http://localhost:PORT/ (8000) until you press Ctrl-C.
--build only builds. --static copies the page to DIR, which any host can serve, and prints its sizes. The script installs what is
missing if it may: Debian's emscripten, HarfBuzz's source, fonts, python3, esbuild, brotli. It fetches three.js from npm's registry,
with npm or without. Afterwards the folder needs no network.
END
}
port=8000
target=
case ${1:-} in
    -h | --help) usage && exit 0 ;;
    --build) port= ;;
    --static)
        [ -n "${2:-}" ] || { usage >&2 && exit 2; }
        port= target=$2
        [ ! -e "$target" ] || [ -d "$target" ] || stop "$target is a file: name a folder."
        ;;
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
(install_missing esbuild brotli) || say "The run continues without them: the page arrives in larger files."
install_fonts fonts-inter-variable fonts-dejavu-core fonts-liberation fonts-comic-neue fonts-hosny-amiri fonts-sawarabi-mincho \
    fonts-lohit-deva culmus fonts-symbola
"$web/three.sh" "$parts"
"$web/build.sh"

rm -rf "$site" && mkdir -p "$site/fonts"
cp "$web/page/index.html" "$web/page/page.css" "$web/package/typemesh.wasm" "$site/"

# One small module, and a second one for the formats of files; without esbuild the modules as they are.
if command -v esbuild >/dev/null 2>&1; then
    NODE_PATH=$parts esbuild "$web/page/page.js" --bundle --minify --splitting --format=esm --target=es2022 --outdir="$site" \
        --chunk-names='[name]-[hash]' "--alias:typemesh=$web/package/typemesh.js" '--external:node:*' --log-level=error
    modules='<link rel="modulepreload" href="page.js">'
    for file in $(grep -oE 'from *"\./chunk-[A-Za-z0-9-]+\.js"' "$site/page.js" | grep -oE 'chunk-[A-Za-z0-9-]+\.js' | sort -u); do
        modules="$modules<link rel=\"modulepreload\" href=\"$file\">"
    done
else
    mkdir -p "$site/three/addons"
    cp "$web/page/"*.js "$web/package/typemesh.js" "$site/"
    cp "$parts/three/build/"three.{module,core}.js "$site/three/"
    for folder in controls exporters utils; do cp -R "$parts/three/examples/jsm/$folder" "$site/three/addons/"; done
    modules='<script type="importmap">{"imports": {"three": "./three/three.module.js", "three/addons/": "./three/addons/", "typemesh": "./typemesh.js"}}</script>'
fi

# The fonts that are there, the first one being what the page begins with. Files stand in for each other, the first that is there.
# Those with scripts are fetched when a text has letters of them. Emoji means all that Unicode draws as pictures.
names= first=
while IFS='|' read -r name files scripts; do
    file=
    for one in $files; do [ -n "$file" ] || [ ! -e "/usr/share/fonts/$one" ] || file=$one; done
    [ -n "$file" ] || { say "The page has no $name, because its Debian package is not installed." && continue; }
    cp "/usr/share/fonts/$file" "$site/fonts/"
    file=fonts/$(basename "$file")
    [ -z "$scripts" ] || scripts=",\"scripts\":[\"${scripts// /\",\"}\"]"
    names="$names${names:+,}{\"name\":\"$name\",\"file\":\"$file\"$scripts}"
    : "${first:=$file}"
done <<'END'
Inter (any weight)|truetype/inter-vf/Inter-roman.var.ttf truetype/inter-vf/InterVariable.ttf
DejaVu Sans Bold|truetype/dejavu/DejaVuSans-Bold.ttf
DejaVu Sans|truetype/dejavu/DejaVuSans.ttf
DejaVu Serif Bold|truetype/dejavu/DejaVuSerif-Bold.ttf
Liberation Serif Italic|truetype/liberation/LiberationSerif-Italic.ttf
Comic Neue|opentype/comic-neue/ComicNeue-Regular.otf
Amiri (Arabic)|opentype/fonts-hosny-amiri/Amiri-Regular.ttf|Arabic
Frank Ruehl (Hebrew)|truetype/culmus/FrankRuehlCLM-Bold.ttf|Hebrew
Lohit (Devanagari)|truetype/lohit-devanagari/Lohit-Devanagari.ttf|Devanagari
Sawarabi Mincho (Japanese)|truetype/sawarabi-mincho/sawarabi-mincho-medium.ttf|Hiragana Katakana Han
Symbola (emoji)|truetype/ancient-scripts/Symbola_hint.ttf|Emoji
END
[ -n "$names" ] || stop "None of the fonts is there."
printf '[%s]\n' "$names" >"$site/fonts.json"
early="<script>if (!/[#\&]font=/.test(location.hash)) globalThis.early = { url: \"$first\", answer: fetch(\"$first\") };</script>"
sed -e "s|<!-- modules -->|$modules|" -e "s|<!-- first font -->|$early|" "$web/page/index.html" >"$site/index.html"

# Beside each file what servers send instead of it; files that stay are compressed once.
packed=$typemesh_root/build/web/packed
mkdir -p "$packed"
while IFS= read -r file; do
    once=$packed/$(basename "$file")
    if ! cmp -s "$file" "$once" || { command -v brotli >/dev/null 2>&1 && [ ! -e "$once.br" ]; }; then
        gzip -9 -n -c "$file" >"$once.gz"
        ! command -v brotli >/dev/null 2>&1 || brotli -q 11 -f -o "$once.br" "$file"
        cp "$file" "$once"
    fi
    for ending in gz br; do [ ! -e "$once.$ending" ] || cp "$once.$ending" "$file.$ending"; done
done <<END
$(find "$site" -type f \( -name '*.html' -o -name '*.css' -o -name '*.js' -o -name '*.json' -o -name '*.wasm' -o -name '*.?tf' \))
END
if [ -n "$target" ]; then
    mkdir -p "$target" && cp -R "$site/." "$target/"
    cat <<END
The page is in $target, for any host. What stands beside a file as .br or .gz is the same file compressed: let the host send it with
"Content-Encoding: br" or "gzip" to browsers that accept that; hosts that compress by themselves need neither. The names of chunk-*.js
change with their content, so they may be cached for a year; the other files may be cached for as long as visitors may see an old page.
Bytes, and as sent, of what comes before the first letter:
END
    for file in "$target"/{index.html,page.css,page.js,chunk-*.js,typemesh.wasm,fonts.json} "$target/$first"; do
        [ ! -e "$file" ] || { sent=$file && [ ! -e "$file.gz" ] || sent=$file.gz && [ ! -e "$file.br" ] || sent=$file.br &&
            printf '%9s %9s  %s\n' "$(wc -c <"$file")" "$(wc -c <"$sent")" "${file#"$target"/}"; }
    done
    exit 0
fi
say "The page is in $site"
[ -n "$port" ] || exit 0
need_port  # again, for the minutes are over
say "It is served at http://localhost:$port/ until you press Ctrl-C"
exec python3 "$web/serve.py" "$site" "$port"
