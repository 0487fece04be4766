#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# usage: examples/web/measure.sh [--default-flags] [MILLISECONDS]
#
# Writes docs/benchmarks/web.md: how large the module is, built in several ways and by feature, and how long it takes for texts
# beside the native program, both in turns. MILLISECONDS: for each text and each module, 1500 by default. With --default-flags only the
# module as it comes is built and measured, in minutes instead of an hour, and the page has no other.
set -eu
case ${1:-} in
    -h | --help) sed -n '3,8s/^# \{0,1\}//p' "${BASH_SOURCE[0]}" && exit 0 ;;
esac
all_flags=yes
[ "${1:-}" != --default-flags ] || { all_flags= && shift; }
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"
web=$typemesh_root/examples/web
work=$typemesh_root/build/web
install_missing g++ cmake ninja pkg-config harfbuzz emcc dpkg-source node fontconfig font
build_preset release mesh_hash
native=$typemesh_root/build/release/examples/mesh_hash
mkdir -p "$work"

modules=()
sizes=
build() {  # build FLAG...
    local name=${*:-as it comes} output
    output=$work/measured$(say "$*" | tr -c 'A-Za-z0-9\n' _).wasm
    TYPEMESH_WEB_OUTPUT=$output "$web/build.sh" "$@" || exit 1
    modules+=("$name=$output")
    sizes="$sizes| ${*:-as it comes} | $(wc -c <"$output") | $(gzip -9c "$output" | wc -c) |
"
}
build
if [ -n "$all_flags" ]; then
    build -O3
    build -O3 -msimd128
    build -Oz
fi
TYPEMESH_WEB_NAMES=yes TYPEMESH_WEB_OUTPUT=$work/named.wasm "$web/build.sh"

page=$typemesh_root/docs/benchmarks/web.md
{
    cat <<'EOF'
# In WebAssembly

Written by [`examples/web/measure.sh`](../../examples/web/measure.sh): [examples/web](../../examples/web/README.md) beside the native
program of the same sources (g++, the preset `release`, HarfBuzz from Debian's package), in turns, the least of all times. The module's
times run from the string to the finished arrays in JavaScript, the native program's from UTF-16 on. Every mesh was compared with
the native one: to the bit. node optimises the module before it runs, as browsers do after some calls.

EOF
    node --no-liftoff --no-wasm-lazy-compilation "$web/measure.mjs" "$native" "${1:-1500}" "${modules[@]}"
    printf '\n%s, %s, node %s.\n' "$(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -n 1)" \
        "$(em++ --version | head -n 1 | sed -E 's/ \(Emscripten.*\) / /; s/ \(\)//')" "$(node --version)"
    [ -z "$all_flags" ] || cat <<'EOF'

"As it comes" (see [build.sh](../../examples/web/build.sh)) is the smallest of those that inline; `examples/web/build.sh -O3` is half as
large again and up to a third faster. With emscripten's plain `-Oz` nothing is inlined. SIMD gains little: the work is branches and integers.
EOF
    printf '\n## Size\n\nBytes without fonts, and compressed as servers send it (gzip).\n\n| flags | bytes | compressed |\n|---|---:|---:|\n%s' "$sizes"
    printf '\n## Size by feature\n\nOf the module as it comes, by the names of its functions; what is inlined counts where it is.\n\n'
    node "$web/sizes.mjs" "$work/named.wasm"
    [ ! -e "$work/figures.txt" ] || printf '\n## The page\n\nFrom its last test, in headless %s without a graphics card:\n\n```\n%s\n```\n' \
        "$(chromium --version 2>/dev/null | cut -d ' ' -f 1,2 | cut -d . -f 1)" "$(cat "$work/figures.txt")"
} >"$page.part"
mv "$page.part" "$page"
say "The page is written: $page"
