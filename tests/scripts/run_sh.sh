#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Tests examples/run.sh and tests/run.sh with stand-ins for all programs that they call: nothing is installed or built.
#
#     run_sh.sh [FOLDER]     FOLDER contains the scripts; by default this source tree
set -u
source_tree=$(cd "${1:-$(dirname "${BASH_SOURCE[0]}")/../..}" && pwd)
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
. "$(dirname "${BASH_SOURCE[0]}")/checks.bash"
says_not() { ! says "$1"; }

# The scripts are in a folder with a blank in its name, and the programs that they may call in another.
tree="$scratch/a folder"
mkdir -p "$bin" "$scratch/prefix/include" "$tree"
for file in examples/run.sh tests/run.sh cmake/setup.sh tests/workload/smoke-fonts.tsv tests/external/common.bash; do
    mkdir -p "$tree/$(dirname "$file")" && cp "$source_tree/$file" "$tree/$file"
done
for name in bash sh env awk sed grep cut sort head tail tr od cat mktemp date mkdir rm cp chmod touch sleep dirname basename tee getconf find; do
    ln -s "$(command -v $name)" "$bin/$name"
done
for header in harfbuzz/hb.h ft2build.h glm/vec3.hpp unicode/ubrk.h catch2/catch.hpp benchmark/benchmark.h CLI/CLI.hpp tiny_gltf.h stb_image_write.h; do
    mkdir -p "$scratch/prefix/include/$(dirname $header)" && touch "$scratch/prefix/include/$header"
done
for name in g++ clang++ clang-format-19 ninja pkg-config wine x86_64-w64-mingw32-g++-posix; do stand_in $name </dev/null; done
stand_in cmake <<'END'
if [ "$1" = --preset ]; then mkdir -p "build/$2" && exit; fi
echo "[1/2] Building CXX object a.o"
[ ! -e "$scratch/wait" ] || for _ in 1 2 3 4 5 6 7 8 9; do grep -q "1 of 2" "$scratch/out" && break || sleep 1; done
mkdir -p "$2/examples" "$2/tests"
printf '#!/bin/sh\nprintf "<%%s>" text_to_mesh "$@" >>"$scratch/calls"\n' >"$2/examples/text_to_mesh"
printf '#!/bin/sh\n' >"$2/tests/typemesh_reference_outlines"
chmod +x "$2"/*/*
END
stand_in ctest <<'END'
pid=$(cat "$scratch/pid")
case $(cat "$scratch/kill") in
    INT) kill -s INT -- "-$pid" ;;  # Ctrl-C reaches all of them
    ?*) kill -s "$(cat "$scratch/kill")" "$pid" ;;
esac
echo " 3/5 Test #3: a name ........***Failed  0.01 sec"
echo " 4/5 Test #4: another name ..***Skipped 0.01 sec"
[ ! -e "$scratch/wait" ] || for _ in 1 2 3 4 5 6 7 8 9; do grep -q "4 of 5, 1 failed" "$scratch/out" && break || sleep 1; done
if [ -e "$scratch/bad" ]; then echo "80% tests passed, 1 tests failed out of 5"; else echo "100% tests passed, 0 tests failed out of 5"; fi
END
# fonts: FILE|FAMILY|FIRST CODE POINT|LAST
stand_in fc-list <<'END'
codes=${1#:charset=} && codes=${codes%%:*}
while IFS='|' read -r file family first last; do
    for code in $codes; do
        [ $((16#$code)) -ge $((16#$first)) ] && [ $((16#$code)) -le $((16#$last)) ] || continue 2
    done
    printf '%s\t0\t%s\tTrueType\t80\t0\tFalse\t100\n' "$file" "$family"
done <"$scratch/fonts"
END
stand_in id <<'END'
if [ "$1" = -u ]; then cat "$scratch/user"; else echo somebody; fi
END
stand_in apt-get <<'END'
[ ! -e "$scratch/wait" ] || for _ in 1 2 3 4 5 6 7 8 9; do grep -q "Setting up" "$scratch/out" && break || sleep 1; done
case " $* " in *" install "*) for package in "$@"; do echo "Setting up $package" && echo "$package" >>"$scratch/installed"; done ;; esac
[ ! -e "$scratch/ninja" ] || cp "$scratch/ninja" "$bin/ninja"
END
stand_in apt-cache </dev/null
stand_in dpkg-query <<'END'
for package in "$@"; do :; done
! grep -qx "$package" "$scratch/installed" || echo installed
END

anew() {  # a machine with a Latin font, used by the administrator
    rm -rf "$tree/build" "$scratch/wait" "$scratch/bad"
    : >"$scratch/kill"
    echo 0 >"$scratch/user"
    echo "/fonts/sans.ttf|DejaVu Sans|20|52f" >"$scratch/fonts"
    awk 'NR > 1 { print $1 }' "$tree/tests/workload/smoke-fonts.tsv" >"$scratch/installed"
    again
}
again() { : >"$scratch/calls"; }
run() {  # run SCRIPT ARGUMENT...   from a folder of its own
    local script=$1
    shift
    rm -rf "$scratch/elsewhere" && mkdir "$scratch/elsewhere"
    : >"$scratch/out"
    status=0
    set -m  # as a process group of its own, as on a terminal
    (
        cd "$scratch/elsewhere" || exit
        # shellcheck disable=SC2016  # for the inner shell
        exec env -u CMAKE_GENERATOR PATH="$bin" TYPEMESH_UNICODE_DATA="$scratch" CMAKE_PREFIX_PATH="$scratch/prefix" TYPEMESH_PROGRESS_SECONDS=1 bin="$bin" \
            bash -c 'echo $$ >"$scratch/pid" && exec bash "$@"' - "$tree/$script" "$@" </dev/null >"$scratch/out" 2>"$scratch/err"
    ) &
    wait $! || status=$?
    set +m
} 2>/dev/null

# --- examples/run.sh: the text
anew && run examples/run.sh "Hello world!"
check "a text in quotes is meshed with an installed font" succeeds
check "the text comes after --, the font before" called '<text_to_mesh>.*<--font></fonts/sans.ttf>.*<--><Hello world!>$'
again && run examples/run.sh "Hello world!"
check "the second run does as the first" called '<--><Hello world!>$'
check "the second run does not report another build" says_not 'This builds'
anew && run examples/run.sh Hello World --depth 0.3
check "words without quotes are one text" called '<--depth><0.3><--><Hello World>$'
check "it reports that they are joined" says 'The text is "Hello World"'
anew && run examples/run.sh -- --not-an-option
check "after -- anything is text" called '<--><--not-an-option>$'
for words in "--depth 0.3 Hello" "Hello --depth 0.3 World" "--strict Hello" "Hello --depth=0.3 World" "Hello --depth 0.3 -- World"; do
    # shellcheck disable=SC2086  # words
    anew && run examples/run.sh $words
    check "$words: text after an option is an error" fails
    check "$words: it says what to do" grep -q 'The text stands before all options' "$scratch/err"
    check "$words: it says so in one line" [ "$(grep -c . "$scratch/err")" = 1 ]
    check "$words: nothing starts" called_not 'text_to_mesh|cmake'
done
anew && run examples/run.sh Hello --feature -kern --strict --depth 0.3
check "values and flags are not part of the text" called '<--feature><-kern><--strict><--depth><0.3><--><Hello>$'

# --- examples/run.sh: what it wrote
anew && run examples/run.sh Hello
check "it says what it wrote" says "^text_to_mesh has written $scratch/elsewhere/hello.glb"
check "the picture too" says "^text_to_mesh has written $scratch/elsewhere/hello.png"
again && run examples/run.sh Hello --output "my word.obj" --picture=/tmp/word.png
check "also by names of one's own" says "^text_to_mesh has written $scratch/elsewhere/my word.obj"
check "and absolute ones" says '^text_to_mesh has written /tmp/word.png'
check "nothing else is written" says_not 'hello'
check "names are passed on once" called '<--output><my word.obj><--picture=/tmp/word.png><--><Hello>$'
again && run examples/run.sh Hello --help
check "help writes nothing" says_not '^text_to_mesh has written'

# --- examples/run.sh: fonts
anew && run examples/run.sh "བོད"
check "a script without a font is an error" fails
check "the script is named" says 'Tibetan'
check "no other script is named" says_not 'Latin'
check "its letters are named" says 'U\+0F56'
check "its Debian package is named" says 'apt-get install fonts-noto-core$'
for text in "ሰላም" "ខ្មែរ" "မြန်မာ" "සිංහල" "ᠮᠣᠩᠭᠣᠯ"; do
    anew && run examples/run.sh "$text"
    check "$text: the package of its script is named" says 'apt-get install fonts-noto-core$'
done
anew && echo fonts-noto-core >>"$scratch/installed" && run examples/run.sh "བོད"
check "an installed package is not advised" says_not 'apt-get install.* fonts-noto-core( |$)'
check "the next package is advised" says 'apt-get install fonts-unifont$'
echo fonts-unifont >>"$scratch/installed" && again && run examples/run.sh "བོད"
check "if all are installed, none is advised" says_not 'apt-get'
check "it still shows a way" says '--font FILE'
again && run examples/run.sh "A བོད ሰላም"
check "that all packages are installed is said once" [ "$(grep -c "packages of this script's list" "$scratch/out" "$scratch/err" | awk -F : '{ n += $2 } END { print n }')" = 1 ]
check "for all scripts that it is true of" says 'packages of this .*: .*Tibetan, .*Ethiopic|packages of this .*: .*Ethiopic, .*Tibetan'
check "several texts are not advised where one part has no font" says_not 'several texts'
for text in $'\U10FFFF' $'A\U1FFFE' $'\uFDD0'; do
    anew && run examples/run.sh "$text"
    check "a noncharacter is an error" fails
    check "no font has it, it is said" says 'U\+(10FFFF|1FFFE|FDD0) is not a character, and no font has it'
    check "nothing is to be installed for it" says_not 'apt-get|packages|No installed font'
done
anew && run examples/run.sh $'\uFFFF བོད'
check "what else is missing is still named" says 'No font has these: Tibetan'
anew && echo "/fonts/tibetan.ttf|Noto Serif Tibetan|f00|fff" >>"$scratch/fonts" && run examples/run.sh "བོད"
check "an installed font is found by its characters" called '<--font></fonts/tibetan.ttf>'
again && run examples/run.sh "Tibet བོད"
check "if no font has all scripts, it says where each is" says 'Latin.* in DejaVu Sans'
check "it advises no package for them" says_not 'apt-get'
anew && : >"$scratch/installed" && run examples/run.sh "日本です！"
check "Han letters beside kana are Japanese" says 'apt-get install fonts-sawarabi-mincho$'
anew && run examples/run.sh "བོད ሰላም ไทย"
check "each package is named once" says 'apt-get install fonts-tlwg-garuda-ttf fonts-noto-core$'

# --- examples/run.sh: setting up
anew && touch "$scratch/wait" && run examples/run.sh
check "it says what it builds and how long that takes" says 'This builds text_to_mesh.*minute'
check "it tells how far the build is" says '0:0[0-9]  1 of 2'
anew && mv "$bin/ninja" "$scratch/ninja" && touch "$scratch/wait"
run examples/run.sh
check "what is missing is installed" called 'apt-get .*install .*ninja-build'
check "how long installing takes is said" says 'apt-get installs these packages.*minute.*: ninja-build'
mv "$scratch/ninja" "$bin/ninja"
anew && mv "$bin/ninja" "$scratch/ninja" && echo 1000 >"$scratch/user" && run examples/run.sh
check "without root and sudo it stops" fails
check "it names the packages" says 'sudo apt-get install ninja-build'
check "it installs nothing" called_not 'apt-get'
check "it says which names are tried" says 'names for Debian are tested. The other names .* untested'
mv "$scratch/ninja" "$bin/ninja"
mv "$bin/apt-get" "$scratch/apt-get" && stand_in dnf <<<'cp "$scratch/ninja" "$bin/ninja"'
anew && mv "$bin/ninja" "$scratch/ninja" && run examples/run.sh
check "a package manager that was never tried is said to be" says '^The names for dnf are untested'
check "it is used" called 'dnf install -y ninja-build'
mv "$scratch/apt-get" "$bin/apt-get" && rm "$bin/dnf"
for script in examples/run.sh tests/run.sh; do
    anew && touch "$tree/build" && run $script
    check "$script: a build folder that cannot be written is an error" fails
    check "$script: it is reported in one sentence" [ "$(grep -c . "$scratch/err")" = 1 ]
    check "$script: the sentence names the folder" grep -q "a folder/build cannot be written" "$scratch/err"
    check "$script: nothing starts" called_not 'apt-get|cmake'
    rm -f "$tree/build"
done

anew && run examples/run.sh
rm -f "$tree/build/release.log" && mkdir "$tree/build/release.log" && again && run examples/run.sh
check "an earlier build is used if the build folder cannot be written" called '<--><Hello world!>$'
check "nothing is built in that case" called_not 'cmake'
touch -t 200001010000 "$tree/build/release/examples/text_to_mesh" && again && run examples/run.sh
check "an earlier build is not used if a source is newer" fails

# --- tests/run.sh
anew && run tests/run.sh
check "the tests of g++ are the default" succeeds
check "ctest's sums are added" says '^5 passed, 0 failed$'
check "no other preset is tested" called_not 'build/(clang|sanitize|tsan|windows)'
again && run tests/run.sh
check "the second run does the same" says '^5 passed, 0 failed$'
anew && run tests/run.sh --only windows
check "a single tier can be run" says '^5 passed, 0 failed$'
check "it is the named tier" called 'ctest .*build/windows'
check "no other tier is run" called_not 'ctest .*build/(gcc|fast-math|clang|sanitize|tsan)'
anew && run tests/run.sh --only gcc,clang
check "some tiers can be run" says '^10 passed, 0 failed$'
anew && run tests/run.sh --only slow
check "a tier may have several presets" says '^15 passed, 0 failed$'
anew && run tests/run.sh --only clang --with tsan
check "--with adds to --only" says '^10 passed, 0 failed$'
anew && run tests/run.sh --with clang,clnag
check "an unknown tier is an error of usage" [ $status = 2 ]
check "the unknown tier is named" says '"clnag"'
check "nothing starts" called_not .
anew && run tests/run.sh --only
check "--only without a tier is an error of usage" [ $status = 2 ]
for signal in TERM INT HUP; do
    anew && echo $signal >"$scratch/kill" && run tests/run.sh
    check "$signal: a killed run fails" fails
    check "$signal: it says where it was broken off" says 'broken off while .*gcc'
    check "$signal: that counts as a failure" says ' [1-9][0-9]* failed$'
done
anew && mv "$bin/ninja" "$scratch/ninja" && echo 1000 >"$scratch/user" && run tests/run.sh
check "a run that cannot set up fails" says '^0 passed, 1 failed$'
check "it says that it stopped there" says 'broken off while setting up'
mv "$scratch/ninja" "$bin/ninja"

anew && touch "$scratch/wait" && run tests/run.sh --only clang
check "it tells how many tests are done, and how many of them failed" says '0:0[0-9]  4 of 5, 1 failed'
check "it says how long the first build takes" says 'This builds clang, which takes [0-9]+ minutes'
anew && touch "$scratch/bad" && run tests/run.sh --only clang,tsan
check "without --fail-fast all tiers are run" says '^8 passed, 2 failed$'
again && run tests/run.sh --only clang,tsan --fail-fast
check "with --fail-fast the first failure ends the run" says '^4 passed, 1 failed$'
check "the run fails" fails
check "it says why it ended" says '^ended by --fail-fast$'
check "ctest also stops at its first failure" called 'ctest .*--stop-on-failure'
check "no other preset is tested" called_not 'build/tsan'
anew && run tests/run.sh --fail-fast
check "without a failure --fail-fast changes nothing" says '^5 passed, 0 failed$'
anew && mkdir -p "$tree/tests/core" "$tree/tests/workload" && touch "$tree/tests/core/a.test.cpp" "$tree/tests/workload/a.test.cpp"
cp "$source_tree/CMakePresets.json" "$tree/" && run tests/run.sh --quick
check "--quick tests a preset of its own" called 'ctest .*build/quick'
check "it tests no other" says '^5 passed, 0 failed$'
check "it says what it leaves out" says '^left out by --quick, of tests/: .*workload'
check "it does not list what it runs" says_not '^left out by --quick.* core'
rm -r "$tree/tests/core" "$tree/tests/workload/a.test.cpp" "$tree/CMakePresets.json"

# --- tests/run.sh: the tiers that are scripts
for tier in external:external:gcc engines:engines_run:release; do
    IFS=: read -r tier folder preset <<<"$tier"
    mkdir -p "$tree/tests/$folder"
    # shellcheck disable=SC2016  # for the script
    printf 'echo "$TYPEMESH_TEXT_TO_MESH|$TYPEMESH_TEST_DATA|$PWD" >>"$scratch/calls"\n' >"$tree/tests/$folder/a.sh"
    printf 'echo "of no interest"\necho "there is no such engine"\nexit 77\n' >"$tree/tests/$folder/b.sh"
    anew && run tests/run.sh --only $tier
    check "$tier: passed scripts are counted, and skipped ones are not" says '^1 passed, 0 failed$'
    check "$tier: the reason of a skipped script is repeated at the end" [ "$(grep -c "skipped: $folder/b: there is no such engine" "$scratch/out")" = 2 ]
    check "$tier: a skipped script is no failure" succeeds
    check "$tier: scripts find the tool and the tests' files, and run in their own folder" \
        called "^$tree/build/$preset/examples/text_to_mesh\|$tree/tests\|$tree/build/$folder\$"
    check "$tier: the tool is built first" called "cmake --build .*build/$preset"
    check "$tier: what cannot be installed does not stop the others" says 'The run continues without'
    printf 'echo "a pixel of a back face"\nexit 1\n' >"$tree/tests/$folder/c.sh"
    again && run tests/run.sh --only $tier
    check "$tier: a failed script is counted" says '^1 passed, 1 failed$'
    check "$tier: its whole output is shown" says 'a pixel of a back face'
    check "$tier: the run fails" fails
    rm "$tree/tests/$folder"/[abc].sh
done
stand_in npm <<<'exit 1'
anew && run tests/run.sh --only engines
check "a failure of npm is a failure" says '^0 passed, 1 failed$'
check "the package is named" says 'npm could not install three'
rm "$bin/npm"
anew && echo 'exit 0' >"$tree/tests/engines_run/a.sh" && run tests/run.sh
check "engines are not run by default" says_not 'engines_run'
run tests/run.sh --all
check "--all runs them" says '^passed: engines_run/a'
rm -r "$tree/tests/engines_run"

# --- machines; each counts as a test
mkdir -p "$tree/tests/machines"
machines() { cat >"$tree/tests/machines/run.sh" && anew && run tests/run.sh --only machines; }
machines <<'END'
echo "s390x            good: all 22; tests: 6 rooms passed"
echo "x87              BAD: 3 of 22, not 19 of \"grid\"; tests: -"
echo "wasm             NOT COMPILED: no such header"
echo "riscv64          skipped: riscv64 qemu is missing and cannot be installed"
echo "The table is written: table.md"
END
check "machines that differ or do not compile are failures" says '^1 passed, 2 failed$'
check "a missing machine is named at the end" says '^skipped: machines/riscv64: riscv64 qemu is missing'
check "the run fails" fails
machines <<<'echo "s390x            good: all 22; tests: 6 rooms passed"; exit 1'
check "machines whose run breaks off are a failure" says '^1 passed, 1 failed$'
machines <<<'echo "s390x            good: all 22; tests: -"; echo "The table is written: table.md"'
check "machines that are the same are none" says '^1 passed, 0 failed$'
check "nothing is skipped then" says_not 'skipped'
rm -r "$tree/tests/machines"

# --- continuous integration
check "continuous integration names its tiers" grep -qE 'run\.sh --with [a-z,]+$' "$source_tree/.ci/run"
check "engines are not among them" [ "$(grep -c engines "$source_tree/.ci/run")" = 0 ]

echo "$passed passed, $failed failed"
[ $failed = 0 ]
