#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
. "$typemesh_root/cmake/setup.sh"

usage() {
    cat <<'END'
usage: tests/run.sh [--quick | --all] [--with TIER[,TIER...]] [--only TIER[,TIER...]] [--fail-fast]

This script installs what is missing, builds the tests and runs them: the tier gcc by default. The tiers are:
  quick      some tests of each stage with g++, in five minutes on two cores; the last lines list what is left out
  gcc        all tests of the core and its adapters with g++
  clang      the folders of tests that no sanitizer runs, with clang++; it also builds the benchmarks
  sanitize   the tests of what reads texts, fonts and files, under clang++'s address and undefined behaviour sanitizers
  slow       the tests that compute for long, under the same sanitizers, and some with g++ -ffast-math
  tsan       the tests that use threads with g++ under the thread sanitizer
  windows    the tests of the core and of DirectWrite as Windows programs (mingw-w64), run under Wine
  external   other people's tools (admesh, OpenSCAD, gltf-validator) read what text_to_mesh writes
  engines    engines draw what the recipes write: OpenGL, OpenSceneGraph, Irrlicht, OGRE, Qt, VTK;
             Godot and three.js read what text_to_mesh writes
  web        examples/web: the library as WebAssembly in node, with the meshes of a native program; the page in Chromium
  packages   the Debian packages on a bare system, the source archive, the single headers, the recipes of vcpkg and Conan
  machines   hashes of all stages and some tests with other compilers and on other processors, under qemu, Wine and node
  systems    the README's commands on bare systems of Debian 12, 13 and the next one; three hours; --all leaves it out
--with adds tiers, --only runs only these, --quick runs quick, --all runs every other tier. --fail-fast ends the run after
the first test that fails.
END
}

all_tiers="gcc clang sanitize slow tsan windows external engines web packages machines"
tiers=gcc
more=
everything=
fail_fast=

refuse() {
    say "$@" >&2
    exit 2
}

# Adds the tiers of a list to `named`.
name_tiers() {  # name_tiers OPTION TIER,TIER...
    local tier
    for tier in $(say "$2" | tr , ' '); do
        case " quick systems $all_tiers " in
            *" $tier "*) named="$named $tier" ;;
            *) refuse "There is no tier \"$tier\". The tiers are: quick $all_tiers systems" ;;
        esac
    done
    [ -n "$named" ] || refuse "$1 needs one or more tiers, with commas between them: quick $all_tiers systems"
}

only=
while [ $# -gt 0 ]; do
    named=
    case $1 in
        --all)
            everything=yes
            tiers=$all_tiers
            ;;
        --with) name_tiers "$1" "${2:-}" && more="$more$named" && shift ;;
        --with=*) name_tiers --with "${1#*=}" && more="$more$named" ;;
        --only) name_tiers "$1" "${2:-}" && only="$only$named" && shift ;;
        --only=*) name_tiers --only "${1#*=}" && only="$only$named" ;;
        --quick) tiers=quick ;;
        --fail-fast) fail_fast=yes ;;
        -h | --help) usage && exit 0 ;;
        *) refuse "$1 is not an option. $(usage)" ;;
    esac
    shift
done
tiers="${only:-$tiers}$more"

passed=0
failed=0
skipped=
report=

# Closing words, whatever happens. Only the last line of this script says that the run has come to its end.
doing="setting up"
finish() {
    if [ -n "$doing" ]; then
        failed=$((failed + 1))
        report="${report}broken off while $doing
"
    fi
    [ -z "$report" ] || printf '\n%s' "$report"
    [ -z "$skipped" ] || printf '%s' "$skipped"
    say "$passed passed, $failed failed"
}
count() {  # count PASSED FAILED
    passed=$((passed + $1)) failed=$((failed + $2))
    [ -z "$fail_fast" ] || [ "$failed" = 0 ] || { report="${report}ended by --fail-fast
" doing='' && exit 1; }
}

# How long a first build takes on two cores of 2023, without ccache.
minutes_of() {  # minutes_of PRESET
    case $1 in
        gcc) say "20 minutes" ;;
        clang | sanitize) say "7 minutes" ;;
        *) say "2 to 4 minutes" ;;
    esac
}

build() {  # build PRESET [TARGET...]; a failed build counts as a failed test
    say "This builds $1, which takes $(minutes_of "$1") on two cores the first time. Its full output goes to $typemesh_root/build/$1.log"
    build_preset "$@" || count 0 1
}

# Builds a preset and runs its tests; ctest names what a failed build has left out.
test_preset() {  # test_preset PRESET [TARGET...]
    local log=$typemesh_root/build/$1.ctest.log total bad
    build "$@"
    : >"$log"
    with_progress "$log" run_ctest "$typemesh_root/build/$1" "$log"
    total=$(sed -nE 's/.* tests? failed out of ([0-9]+)$/\1/p' "$log")
    bad=$(sed -nE 's/.* ([0-9]+) tests? failed out of [0-9]+$/\1/p' "$log")
    if [ -n "$total" ]; then
        count $((total - bad)) "$bad"
    else
        count 0 1
    fi
}

run_ctest() {  # run_ctest FOLDER LOG
    ctest --test-dir "$1" --output-on-failure ${fail_fast:+--stop-on-failure} --parallel "$(processors)" 2>&1 | tee "$2" |
        grep -vE '^ *(Start +[0-9]+:|[0-9]+/[0-9]+ Test .* Passed )' || true
}

tier_gcc() {
    (install_missing clang-format) || say "The run continues without it: the format of the sources is not checked."
    (install_missing doxygen) || say "The run continues without it: the reference is not built."
    test_preset gcc
}
tier_quick() {
    local room test left=
    test_preset quick typemesh_tests
    for room in "$typemesh_root"/tests/*/; do
        room=$(basename "$room")
        for test in "$typemesh_root/tests/$room"/*.test.cpp; do [ -e "$test" ] || continue 2; done
        grep '"name": "quick"' -A 6 "$typemesh_root/CMakePresets.json" | grep -q "[;\"]$room[;\"]" || left="$left $room"
    done
    report="${report}left out by --quick, of tests/:$left; and examples, headers alone, sanitizers, clang++, Windows
"
}
tier_clang() {
    install_missing clang++ benchmark
    test_preset clang
}
tier_sanitize() {
    install_missing clang++ asan
    test_preset sanitize typemesh_tests
}
tier_slow() {
    install_missing clang++ asan
    test_preset sanitize-geometry typemesh_tests
    test_preset sanitize-optimised typemesh_tests
    test_preset fast-math typemesh_tests
}
tier_tsan() { test_preset tsan typemesh_tests; }

# Windows programs are built here and run under Wine, with a prefix of their own and without a display. What they draw is
# compared with outlines that HarfBuzz and FreeType have drawn natively.
tier_windows() {
    install_missing mingw wine clang++
    local reference=$typemesh_root/build/windows/reference
    mkdir -p "$reference"
    if ! build_preset gcc typemesh_reference_outlines ||
        ! "$typemesh_root/build/gcc/tests/typemesh_reference_outlines" "$reference"; then
        count 0 1
    fi
    test_preset windows
}

# Runs the scripts of a folder of tests/, each with build/FOLDER as its own: 0 passed, 77 skipped with the reason on the last
# line, anything else failed. They find the tool in TYPEMESH_TEXT_TO_MESH, tests/ in TYPEMESH_TEST_DATA, the program of
# tests/engines in TYPEMESH_TEST_ENGINES, npm's packages by NODE_PATH.
run_scripts() {  # run_scripts FOLDER [PRESET, which has built the tool: release by default]
    local script name status output work=$typemesh_root/build/$1
    export TYPEMESH_TEXT_TO_MESH=$typemesh_root/build/${2:-release}/examples/text_to_mesh
    export TYPEMESH_TEST_DATA=$typemesh_root/tests
    for script in gcc clang; do  # the first that has built it
        TYPEMESH_TEST_ENGINES=$typemesh_root/build/$script/tests/typemesh_test_engines
        [ ! -x "$TYPEMESH_TEST_ENGINES" ] || break
    done
    export TYPEMESH_TEST_ENGINES NODE_PATH=$work/node_modules
    for script in "$typemesh_root/tests/$1"/*.sh; do
        [ -e "$script" ] || continue
        name=$1/$(basename "$script" .sh)
        status=0
        output=$(cd "$work" && bash "$script" 2>&1) || status=$?
        case $status in
            0) say "passed: $name" && count 1 0 ;;
            77)
                skipped="${skipped}skipped: $name: $(say "$output" | tail -n 1)
"
                say "skipped: $name: $(say "$output" | tail -n 1)"
                ;;
            *) say "$output" "failed: $name" && count 0 1 ;;
        esac
    done
}

# One of npm's packages, in the folder of run_scripts.
install_npm() {  # install_npm FOLDER PACKAGE VERSION [PACKAGE@VERSION...]
    local work=$typemesh_root/build/$1 name is_missing=
    for name in "$2" "${@:4}"; do [ -d "$work/node_modules/${name%@[0-9]*}" ] || is_missing=yes; done
    command -v npm >/dev/null 2>&1 && [ -n "$is_missing" ] || return 0
    if ! npm install --prefix "$work" --no-save --no-audit --no-fund --fetch-retries=1 "$2@$3" "${@:4}" >"$work/npm.log" 2>&1; then
        explain_failure "$work/npm.log" "npm's registry"
        say "failed: npm could not install $2"
        count 0 1
    fi
}

tier_external() {
    (install_missing admesh openscad node npm) || say "The run continues without them: the tests that need them are skipped."
    (install_missing lib3mf) || say "The run continues without it: text_to_mesh writes no 3MF."
    (install_missing pugixml) || say "The run continues without it: text_to_mesh reads no SVG."
    mkdir -p "$typemesh_root/build/external"
    build gcc text_to_mesh  # which is there already, if that tier has run
    install_npm external gltf-validator 2.0.0-dev.3.10
    run_scripts external gcc
}

# VTK, 750 MB with all that it needs, is taken where it is there already.
tier_engines() {
    (install_missing xvfb opengl openscenegraph irrlicht ogre qt-quick3d qt-qml qt-shaders) ||
        say "The run continues without them: the tests that need them are skipped."
    (install_missing glslang spirv-cross) || say "The run continues without them: the HLSL shader of docs/curves.md is not tested."
    (install_missing godot3 node npm chromium) || say "The run continues without them: the tests that need them are skipped."
    mkdir -p "$typemesh_root/build/engines_run"
    build release text_to_mesh
    install_npm engines_run three 0.187.0
    run_scripts engines_run
}

# Scripts find the native program in TYPEMESH_MESH_HASH.
tier_web() {
    install_missing emcc dpkg-source node npm
    (install_missing chromium) || say "The run continues without it: the page is not tested."
    install_fonts fonts-inter-variable fonts-dejavu-core fonts-liberation
    mkdir -p "$typemesh_root/build/web"
    build release mesh_hash text_to_mesh
    export TYPEMESH_MESH_HASH=$typemesh_root/build/release/examples/mesh_hash
    say "This builds the module. Its full output goes to $typemesh_root/build/web/build.log"
    if ! with_progress "$typemesh_root/build/web/build.log" logged "$typemesh_root/build/web/build.log" \
        "$typemesh_root/examples/web/build.sh"; then
        tail -n 20 "$typemesh_root/build/web/build.log"
        count 0 1
    fi
    (install_missing esbuild) || say "The run continues without it: the examples for other engines are not tested."
    install_npm web puppeteer-core 24.43.1 axe-core@4.10.3 three@0.187.0 react@19.3.1 react-dom@19.3.1 @react-three/fiber@9.8.2 \
        @babylonjs/core@9.31.0 typescript@5.9.3 @types/react@19.3.0 @types/react-dom@19.3.0 @types/three@0.187.0
    run_scripts web
}

tier_packages() {
    (install_missing debootstrap dpkg-shlibdeps pyflakes) || say "The run continues without them: the tests that need them are skipped."
    mkdir -p "$typemesh_root/build/packages"
    build release text_to_mesh typemesh_man_page
    if ! logged "$typemesh_root/build/packages/cpack.log" make_packages; then
        tail -n 20 "$typemesh_root/build/packages/cpack.log"
        count 0 1
    fi
    run_scripts packages
}
make_packages() (
    cd "$typemesh_root/build/release" && rm -rf packages && cpack -G DEB && cpack -G TGZ && cpack --config CPackSourceConfig.cmake
)

# Each machine counts as one test. What is missing there installs or names the script itself.
tier_machines() {
    local log=$typemesh_root/build/machines.log words
    bash "$typemesh_root/tests/machines/run.sh" 2>&1 | tee "$log" || true
    count "$(grep -cE '^[^ ]+ +good: ' "$log")" "$(grep -cE '^[^ ]+ +(BAD|NOT COMPILED): ' "$log")"
    grep -q '^The table is written: ' "$log" || count 0 1  # it has not come to its end
    words=$(sed -nE 's,^([^ ]+) +(skipped: )(.*),\2machines/\1: \3,p' "$log")
    [ -z "$words" ] || skipped="$skipped$words
"
}

# Each command on each system counts as one test; on the next Debian none counts.
tier_systems() {
    local log=$typemesh_root/build/systems.log
    bash "$typemesh_root/tests/systems/run.sh" 2>&1 | tee "$log" || true
    count "$(grep -cE '^(passed|[0-9]+ passed, 0 failed)$' "$log")" "$(grep -cE '^failed: (bookworm|trixie)' "$log")"
    grep -q '^The table is written: ' "$log" || count 0 1  # it has not come to its end
}

trap finish EXIT
need_build_folder gcc
begun=$(date +%s)
# The fonts of tests/workload/smoke-fonts.tsv but the largest.
fonts=$(awk -F '\t' 'NR > 1 && $2 < 20000000 { print $1 }' "$typemesh_root/tests/workload/smoke-fonts.tsv")
install_missing g++ cmake ninja pkg-config harfbuzz freetype fontconfig-dev icu glm catch2 cli11 tinygltf stb fontconfig font
# shellcheck disable=SC2086  # a list of words
install_fonts $fonts
install_unicode_data
[ -z "$everything" ] || install_fonts fonts-mplus fonts-noto-cjk  # the large ones of tests/workload/fonts.tsv
report="set up: $(($(date +%s) - begun)) s
"

for tier in $tiers; do
    case " ${done_tiers:-} " in *" $tier "*) continue ;; esac
    done_tiers="${done_tiers:-} $tier"
    say "== $tier"
    doing="running the tier $tier"
    begun=$(date +%s) passed_before=$passed failed_before=$failed
    "tier_$tier"
    report="$report$tier: $((passed - passed_before)) passed, $((failed - failed_before)) failed, $(($(date +%s) - begun)) s
"
done
doing=
[ "$failed" = 0 ]
