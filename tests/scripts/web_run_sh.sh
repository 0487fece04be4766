#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Tests examples/web/run.sh with stand-ins for all programs that it calls: nothing is installed, fetched or compiled.
#
#     web_run_sh.sh [FOLDER]     FOLDER contains the scripts; by default this source tree
set -u
source_tree=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
if [ ! -e /usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf ]; then echo "the page's first font is not installed" && exit 77; fi
scratch=$(mktemp -d)
listener=
trap '[ -z "$listener" ] || kill "$listener"; rm -rf "$scratch"' EXIT
. "$(dirname "${BASH_SOURCE[0]}")/checks.bash"

# The scripts are in a folder with a blank in its name, and the programs that they may call in another.
tree="$scratch/a folder"
real_python=
for name in /usr/bin/python3 /usr/local/bin/python3 /opt/homebrew/bin/python3; do [ ! -x $name ] || { real_python=$name && break; }; done
export real_python
mkdir -p "$bin" "$scratch/home" "$tree/examples" "$tree/cmake" "$tree/include" "$tree/examples/text_to_mesh"
cp -R "$source_tree/examples/web" "$tree/examples/" && cp "$source_tree/cmake/setup.sh" "$tree/cmake/"
touch "$tree/LICENSE" "$tree/examples/text_to_mesh/solids.cpp" "$tree/include/a.hpp"
for name in bash sh env awk sed grep cut sort head tail tr cat mktemp date mkdir rm cp mv touch sleep dirname basename find getconf wc gzip tar tee ls id; do
    ln -s "$(command -v $name)" "$bin/$name"
done
for name in dpkg-source update-ca-certificates node clang++ pkg-config; do stand_in $name </dev/null; done
stand_in em++ <<'END'
if [ -e "$scratch/broken" ] && [[ $* == *settings.cpp* ]]; then echo "settings.cpp:1: error: a stand-in's" >&2 && exit 1; fi
while [ "$1" != -o ]; do shift; done
# The last to be compiled waits until the count of those before it has been shown.
if [ -e "$scratch/wait" ] && [[ $2 == *exports.cpp* ]]; then
    for _ in 1 2 3 4 5 6 7 8 9; do ! grep -q "10 of 11" "$scratch/out" || break; sleep 1; done
fi
echo made >"$2"
END
stand_in wasm-opt </dev/null
stand_in esbuild <<'END'
for word in "$@"; do case $word in --outdir=*) to=${word#*=} ;; esac; done
echo 'import{a}from"./chunk-AB12.js";import("./downloads-CD34.js")' >"$to/page.js"
touch "$to/chunk-AB12.js" "$to/downloads-CD34.js"
END
stand_in brotli <<'END'
[ "$4" = -o ] && echo smaller >"$5"
END
stand_in fc-list <<'END'
echo a font
END
stand_in dpkg-query <<'END'
echo installed
END
stand_in apt-get <<'END'
[ ! -e "$scratch/no-network" ] || { echo "could not resolve" && exit 1; }
case " $* " in *" download npm "*) touch npm_9.deb ;; esac
END
stand_in dpkg-deb <<'END'
mkdir -p "$3/usr/npm/lib" && printf "module.exports = {\n  registry: 'https://of.debian.example/',\n}\n" >"$3/usr/npm/lib/default-opts.js"
END
mkdir -p "$scratch/package/build" "$scratch/package/examples/jsm"/{controls,exporters,utils}
touch "$scratch/package/build/three.module.js" "$scratch/package/build/three.core.js"
tar -czf "$scratch/three.tgz" -C "$scratch" package
stand_in npm <<'END'
case $1 in
    pack) cp "$scratch/three.tgz" three-0.187.0.tgz ;;
    install) mkdir -p "$3/node_modules" && cp -R "$scratch/package" "$3/node_modules/three" ;;
esac
END
mv "$bin/npm" "$scratch/npm"
stand_in python3 <<'END'
case $1 in
    -) [ ! -e "$scratch/forbidden" ] ;;  # whether it may have the port
    *fetch.py) if [ -e "$scratch/real" ]; then exec "$real_python" "$@"; else cp "$scratch/three.tgz" "$2"; fi ;;
esac
END

anew() {  # a machine without npm that has all the rest
    rm -rf "$tree/build" "$tree/examples/web/package/typemesh.wasm" "$bin/npm" "$scratch/home/.npmrc"
    rm -f "$scratch"/{wait,broken,no-network,forbidden,real}
    mkdir -p "$tree/build/web/harfbuzz/src" && touch "$tree/build/web/harfbuzz/src/harfbuzz.cc"
    again
}
again() { : >"$scratch/calls"; }
run() {  # run [NAME=VALUE...] [ARGUMENT...]
    local variables=()
    while [[ ${1:-} == *=* ]]; do
        variables+=("$1")
        shift
    done
    status=0
    : >"$scratch/out"
    env -i HOME="$scratch/home" PATH="$bin" scratch="$scratch" real_python="$real_python" TYPEMESH_PROGRESS_SECONDS=1 \
        ${variables[@]+"${variables[@]}"} bash "$tree/examples/web/run.sh" "$@" </dev/null >"$scratch/out" 2>"$scratch/err" || status=$?
}
free=18431  # a port that nothing is expected at

# --- three.js
anew && run $free
check "a machine without npm gets the page" succeeds
check "Debian's npm is not installed" called_not 'apt-get.* install .*npm'
grep -qs '^ *registry' /etc/npmrc /usr/etc/npmrc /usr/local/etc/npmrc ||
    check "the registry's address comes from Debian's package" called 'fetch.py .* https://of.debian.example/three/-/three-0.187.0.tgz$'
site=$tree/build/web/site
check "the page is one small module" called '^esbuild .*/page/page.js --bundle --minify'
check "its parts are fetched early" grep -q 'modulepreload" href="chunk-AB12.js"' "$site/index.html"
check "what is needed later is not" [ "$(grep -c 'href="downloads' "$site/index.html")" = 0 ]
check "the first font is fetched early" grep -qE 'fetch\("fonts/[A-Za-z.-]+"\)' "$site/index.html"
check "files lie there compressed" [ -s "$site/page.js.br" -a -s "$site/typemesh.wasm.gz" -a -s "$site/index.html.br" ]
check "it is served at the named port" called "^python3 .*/serve.py .*/site $free$"
again && run $free
check "the second run fetches nothing" called_not 'fetch.py|apt-get'
check "the second run compiles nothing" called_not 'em\+\+ .* -c '
anew && mv "$bin/esbuild" "$bin/brotli" "$scratch/" && run --build
mv "$scratch/esbuild" "$scratch/brotli" "$bin/"
check "without esbuild and brotli there is a page" succeeds
check "it says that it is larger" says 'larger files'
check "its modules are as they are" [ -e "$site/three/three.core.js" -a -e "$site/stage.js" -a ! -e "$site/page.js.br" ]
check "the browser knows where they are" grep -q importmap "$site/index.html"
anew && run --static "$scratch/a static folder"
check "a static folder is made" [ -s "$scratch/a static folder/page.js.br" ]
check "it prints its sizes" says ' typemesh.wasm$'
check "nothing is served" called_not 'serve.py'
touch "$scratch/file" && run --static "$scratch/file"
check "a file is no folder" fails
anew && run NPM_CONFIG_REGISTRY=https://of.variable.example/npm --build
check "a registry from a variable is used" called 'fetch.py .* https://of.variable.example/npm/three/-/three-'
check "nothing else is searched" called_not 'apt-get'
check "--build serves nothing" called_not 'serve.py'
anew && printf '; mine\nregistry = https://of.file.example/\n' >"$scratch/home/.npmrc" && run --build
check "a registry from .npmrc is used" called 'fetch.py .* https://of.file.example/three/-/three-'
anew && cp "$scratch/npm" "$bin/npm" && run --build
check "npm is called if it is installed" called '^npm pack three@0.187.0'
check "the page is made" succeeds
anew && touch "$scratch/no-network" && run --build
check "an unknown registry is an error" fails
check "it says what to do" says 'set NPM_CONFIG_REGISTRY to it, or install npm'
check "nothing is compiled" called_not 'em\+\+'
if [ -n "$real_python" ]; then
    mkdir -p "$scratch/registry/three/-" && echo other >"$scratch/registry/three/-/three-0.187.0.tgz"
    anew && touch "$scratch/real" && run NPM_CONFIG_REGISTRY="file://$scratch/registry" --build
    check "a file that differs from the tested one is refused" fails
    check "it says so in a sentence" says '^What has arrived is another file than the page is tested with[.]$'
    check "the file is not kept" [ ! -e "$tree/build/web/npm/three" ]
    anew && touch "$scratch/real" && run NPM_CONFIG_REGISTRY="file://$scratch/nowhere" --build
    check "a registry without the file is an error" fails
    check "it says so in one line" [ "$(grep -c . "$scratch/err")" = 1 ]
fi

# --- the port
anew && touch "$scratch/forbidden" && run $free
check "a port that is not available is an error" fails
check "it says that the port is not free" says "^The port $free is not free"
check "nothing is fetched, installed or compiled" called_not 'apt-get|fetch.py|npm|em\+\+'
for word in 0 65536 99999999999999999999 80a -1; do
    anew && run "$word"
    check "$word is no port" fails
    check "$word: nothing starts" called_not 'apt-get|fetch.py|npm|em\+\+'
done
if [ -n "$real_python" ]; then
    "$real_python" -c 'import socket, sys, time
s = socket.socket(); s.bind(("127.0.0.1", 0)); s.listen(); print(s.getsockname()[1], flush=True); time.sleep(60)' >"$scratch/port" &
    listener=$!
    for _ in 1 2 3 4 5 6 7 8 9; do [ -s "$scratch/port" ] && break || sleep 0.3; done
    anew && mv "$bin/python3" "$scratch/python3" && run "$(cat "$scratch/port")"
    mv "$scratch/python3" "$bin/python3"
    check "a port that is in use is an error, even without python3" fails
    check "another port is named" says "^The port $(cat "$scratch/port") is not free, but [0-9]+ is: examples/web/run.sh [0-9]+$"
    check "nothing starts" called_not 'apt-get|fetch.py|npm|em\+\+'
fi

# --- compiling
anew && touch "$scratch/wait" && run --build
check "it shows its progress while it compiles" says ' 10 of 11$'
check "eleven files are compiled" [ "$(grep -cE 'em\+\+ .* -c ' "$scratch/calls")" = 11 ]
again && touch "$tree/examples/web/page/page.css" "$tree/examples/web/run.sh" "$tree/examples/web/README.md" && run --build
check "a changed page is no reason to compile" called_not 'em\+\+ .* -c '
again && touch "$tree/include/a.hpp" && run --build
check "a changed header is a reason to compile" [ "$(grep -cE 'em\+\+ .* -c ' "$scratch/calls")" = 11 ]
again && touch "$tree/include/a.hpp" "$scratch/broken" && echo before >"$tree/examples/web/package/typemesh.wasm" && run --build
check "a compiler's error ends the run" fails
check "the error is shown" says "settings.cpp:1: error: a stand-in's"
check "the module stays unchanged" grep -q before "$tree/examples/web/package/typemesh.wasm"

printf '%s passed, %s failed\n' $passed $failed
[ $failed = 0 ] && [ $passed != 0 ]
