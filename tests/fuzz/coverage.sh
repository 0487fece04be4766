#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Says which lines of include/typemesh the inputs reach that tests/fuzz/run.sh has kept, all targets together:
#
#     tests/fuzz/coverage.sh [TARGET...]      all targets unless some are named
#
# Prints the share of each folder's lines, and the functions that no input reaches go to build/fuzz/unreached.txt. Needs
# clang++ and, of the same version, llvm-profdata and llvm-cov. TYPEMESH_FUZZ_BUILD, CXX: as for run.sh.
set -eu
typemesh_root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
. "$typemesh_root/cmake/setup.sh"
build=${TYPEMESH_FUZZ_BUILD:-$typemesh_root/build/fuzz}
compiler=${CXX:-clang++}
version=$("$compiler" -dumpversion | cut -d . -f 1)
tool() { command -v "$1-$version" || command -v "$1" || stop "$1 $version is missing: it comes with clang's package llvm-$version"; }
profdata=$(tool llvm-profdata)
cov=$(tool llvm-cov)
[ $# -ne 0 ] || set -- $(cd "$typemesh_root/tests/fuzz" && for test in *.test.cpp; do basename "$test" .test.cpp; done)

mkdir -p "$build/coverage"
objects=()
for target in "$@"; do
    libraries=
    if grep -q 'typemesh/adapt/' "$typemesh_root/tests/fuzz/$target.hpp"; then
        libraries=$(pkg-config --cflags --libs harfbuzz freetype2)
    fi
    # shellcheck disable=SC2086  # several words
    "$compiler" -std=c++20 -O1 -g0 -fsanitize=fuzzer -fprofile-instr-generate -fcoverage-mapping \
        -I"$typemesh_root/include" -I"$typemesh_root/tests" "-DTYPEMESH_FUZZ_TARGET=$target" \
        -include "$typemesh_root/tests/fuzz/$target.hpp" "$typemesh_root/tests/fuzz/fuzzer.cpp" \
        -o "$build/coverage/$target" $libraries
    mkdir -p "$build/corpus/$target"
    (cd "$build" && LLVM_PROFILE_FILE="$build/coverage/$target.profraw" "./coverage/$target" -runs=0 -timeout=600 "corpus/$target") \
        >"$build/coverage/$target.log" 2>&1 || stop "$target fails with an input that was kept: see $build/coverage/$target.log"
    objects+=(-object "$build/coverage/$target")
done
"$profdata" merge -sparse -o "$build/coverage/all" "$build"/coverage/*.profraw
report=("${objects[@]:1}" "-instr-profile=$build/coverage/all" -ignore-filename-regex='^(/usr|.*/tests)/')
"$cov" export "${report[@]}" -skip-expansions >"$build/coverage/all.json"
python3 - "$build" "$typemesh_root/include/typemesh/" <<'EOF'
import collections, json, subprocess, sys
build, root = sys.argv[1:3]
data = json.load(open(build + "/coverage/all.json"))["data"][0]
rooms = collections.defaultdict(lambda: [0, 0])
for file in data["files"]:
    if not file["filename"].startswith(root): continue
    name = file["filename"][len(root):]
    room = name.split("/")[0] if "/" in name else "."
    for key in (room, "all"):
        rooms[key][0] += file["summary"]["lines"]["covered"]
        rooms[key][1] += file["summary"]["lines"]["count"]
for room in sorted(rooms, key=lambda r: (r == "all", r)):
    covered, count = rooms[room]
    print(f"{room:12} {covered:6} of {count:6} lines  {100.0 * covered / count:5.1f} %")
reached, places = collections.Counter(), {}
for function in data["functions"]:
    file, line = function["filenames"][0], function["regions"][0][0]
    if not file.startswith(root): continue
    reached[file[len(root):], line] += function["count"]
    places.setdefault((file[len(root):], line), function["name"].split(":")[-1])
never = sorted(place for place, count in reached.items() if count == 0)
names = subprocess.run(["c++filt"], input="\n".join(places[p] for p in never), capture_output=True, text=True).stdout.split("\n")
with open(build + "/unreached.txt", "w") as out:
    for (file, line), name in zip(never, names): out.write(f"{file}:{line} {name[:160]}\n")
print(f"{len(never)} of {len(reached)} functions are reached by no input: {build}/unreached.txt")
EOF
