#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"

usage() {
    cat <<'EOF'
usage: examples/web/build.sh [FLAG...]

This script compiles typemesh and HarfBuzz to WebAssembly, into examples/web/package/typemesh.wasm, with Debian's emscripten. It
compiles HarfBuzz from its source package. Each FLAG goes to the compiler for all sources. The default flags make a small and fast
module. TYPEMESH_WEB_BUILD is the folder to work in (build/web). TYPEMESH_WEB_OUTPUT is another output file. If
TYPEMESH_WEB_NAMES is any word, the functions keep their names.
EOF
}
case ${1:-} in -h | --help) usage && exit 0 ;; esac

web=$typemesh_root/examples/web
work=${TYPEMESH_WEB_BUILD:-$typemesh_root/build/web}
output=${TYPEMESH_WEB_OUTPUT:-$web/package/typemesh.wasm}
install_missing emcc dpkg-source
mkdir -p "$work"
"$web/harfbuzz.sh" "$work" || stop "HarfBuzz's source package could not be fetched; what apt-get said: $work/harfbuzz.log"

# Objects of other flags stay for the next time.
objects=$work/objects$(say "$*" | tr -c 'A-Za-z0-9\n' _)
mkdir -p "$objects" "$(dirname "$output")"
# What every browser has had since 2021. Not -mbulk-memory: its memory.copy is slow to start, and most copies are small.
features=(-msign-ext -mnontrapping-fptoint)
compiler=("${features[@]}" -std=c++20 -fno-exceptions -fno-rtti -DNDEBUG -DHB_CONFIG_OVERRIDE_H='"harfbuzz_config.h"')
folders=(-I"$typemesh_root/include" -I"$typemesh_root/examples" -I"$typemesh_root/examples/text_to_mesh" -I"$web"
    -isystem "$work/harfbuzz/src")
sources=("$work/harfbuzz/src/harfbuzz.cc" "$typemesh_root/examples/text_to_mesh/solids.cpp" "$web"/{bends,settings,marked_words,text_maker,text_writer,weight_morph,session,mesh_checks,exports}.cpp)

# emscripten forbids inlining where size counts, and the library's loops are then ten times as slow.
flags_for() {  # flags_for SOURCE FLAG...
    local source=$1
    shift
    case $#$source in
        0*text_writer.cpp) say "-O2 -fno-unroll-loops" ;;
        0*text_maker.cpp) say "-Os -finline-functions -fno-unroll-loops" ;;
        0*) say "-Oz -finline-functions" ;;
        *) say "$*" ;;
    esac
}

object_of() { say "$objects/$(basename "$1").o"; }
is_compiled() {  # is_compiled SOURCE: its object is newer than all that it is made of
    [ -e "$(object_of "$1")" ] && [ -z "$(find "$1" "$typemesh_root/include" "$web" "$typemesh_root/examples/text_to_mesh" \
        "${BASH_SOURCE[0]}" \( -samefile "$1" -o -name '*.hpp' -o -name '*.h' -o -name build.sh \) -newer "$(object_of "$1")" -print -quit)" ]
}
compile() {  # compile SOURCE FLAG...
    local source=$1 object
    object=$(object_of "$1")
    shift
    # shellcheck disable=SC2046  # a list of words
    em++ $(flags_for "$source" "$@") "${compiler[@]}" "${folders[@]}" -c "$source" -o "$object.part" && mv "$object.part" "$object"
}
# Takes one source after the other that nobody else has taken, and counts them: "[2/8] settings.cpp".
compile_further() {  # compile_further FLAG...
    local source
    for source in "${changed[@]}"; do
        mkdir "$taken/$(basename "$source")" 2>/dev/null || continue
        compile "$source" "$@" || return 1
        basename "$source" >>"$taken/done"
        say "[$(grep -nxF "$(basename "$source")" "$taken/done" | cut -d : -f 1)/${#changed[@]}] $(basename "$source")"
    done
}
# As many at a time as there are processors.
compile_changed() {  # compile_changed FLAG...
    local job jobs=() status=0
    while [ ${#jobs[@]} -lt "${TYPEMESH_WEB_JOBS:-$(processors)}" ]; do
        compile_further "$@" &
        jobs+=($!)
    done
    for job in "${jobs[@]}"; do wait "$job" || status=1; done
    return $status
}
changed=()
for source in "${sources[@]}"; do is_compiled "$source" || changed+=("$source"); done
if [ ${#changed[@]} -gt 0 ]; then
    say "This compiles to WebAssembly${*:+ with $*}, which takes some minutes: ${#changed[@]} files"
    log=$objects/log taken=$objects/taken
    rm -rf "$taken" && mkdir "$taken" && : >"$log"
    with_progress "$log" logged "$log" compile_changed "$@" || {
        grep -vE '^\[[0-9]+/[0-9]+\] ' "$log" | head -n 60 >&2 || true
        stop "The build has failed: read its full output in $log"
    }
    rm -rf "$taken"
    say "  ${#changed[@]} of ${#changed[@]} are compiled"
fi

# Nothing to do where the module was linked of these objects, by this script, with these flags.
as_linked="$output ${TYPEMESH_WEB_NAMES:-} $*"
if [ -e "$output" ] && [ "$(cat "$objects/linked" 2>/dev/null)" = "$as_linked" ] && [ -e "$web/package/LICENSE" ] &&
    [ -z "$(find "$objects" "${BASH_SOURCE[0]}" \( -name '*.o' -o -name build.sh \) -newer "$output" -print -quit)" ]; then
    exit 0
fi
say "This links the module, usually in half a minute"
exports=$(sed -nE 's/^TYPEMESH_WEB_EXPORT [^(]*[ *](web_[a-z_]+)\(.*/_\1/p' "$web/exports.cpp" | tr '\n' ,)
smaller=  # linked for speed and then optimised for size: both alone are larger or slower
[ $# -gt 0 ] || { set -- -O3 && smaller=yes; }
[ -z "${TYPEMESH_WEB_NAMES:-}" ] || set -- "$@" --profiling-funcs
em++ "$@" "${features[@]}" --no-entry -fno-exceptions -fno-rtti "$objects"/*.o -o "$work/typemesh.part.wasm" -s STANDALONE_WASM=1 \
    -s "EXPORTED_FUNCTIONS=${exports}_malloc,_free" -s ALLOW_MEMORY_GROWTH=1 -s MAXIMUM_MEMORY=4GB -s INITIAL_MEMORY=16MB \
    -s TOTAL_STACK=1MB -s ABORTING_MALLOC=0 -s FILESYSTEM=0 -s ERROR_ON_UNDEFINED_SYMBOLS=1
[ -z "$smaller" ] || wasm-opt -Oz ${TYPEMESH_WEB_NAMES:+-g} --enable-sign-ext --enable-nontrapping-float-to-int --enable-bulk-memory \
    "$work/typemesh.part.wasm" -o "$work/typemesh.part.wasm"
mv "$work/typemesh.part.wasm" "$output"
say "$as_linked" >"$objects/linked"
cp "$typemesh_root/LICENSE" "$web/package/"  # for npm pack
say "$output: $(wc -c <"$output") bytes, $(gzip -9c "$output" | wc -c) compressed by gzip"
