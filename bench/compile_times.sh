#!/bin/bash
# SPDX-License-Identifier: MIT
#
# How long the compiler takes for what users include: seconds of its own time, the least of several runs, and as a share
# of a yardstick that is compiled in the same minute (<regex>, used once). The program is the first one of README.md.
#
#     compile_times.sh [RUNS]      3 without it; CXX names the compiler, CXXFLAGS adds to its flags (-DNDEBUG)
set -eu
case ${1:-} in
    -h | --help) sed -n '3,7s/^# \{0,1\}//p' "$0" && exit 0 ;;
esac
runs=${1:-3}
compiler=${CXX:-g++}
root=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
cd "$scratch"

sed -n '/^```cpp$/,/^```$/p' "$root/README.md" | sed '1d; /^```$/q' | sed '$d' >program.cpp
echo '#include <typemesh/typemesh.hpp>' >umbrella.cpp
# shellcheck disable=SC2086  # flags are several words
flags="-std=c++20 ${CXXFLAGS:-} -I$root/include $(pkg-config --cflags harfbuzz)"
$compiler $flags -MM umbrella.cpp | tr ' \\' '\n\n' | grep '/typemesh/' | xargs sed -nE 's/^#include <([a-z_0-9]+)>$/#include <\1>/p' |
    sort -u >standard.cpp
cat >yardstick.cpp <<'END'
#include <regex>
bool matches(const char* s) { return std::regex_match(s, std::regex{"a+b*"}); }
END

# The compiler's own time, in seconds.
seconds() {
    { { time -p "$@" >/dev/null 2>&1; } 2>&1; } | sed -n 's/^user //p'
}
# measure NAME FLAGS... : the least of all runs, and of the yardstick beside them
measure() {
    name=$1 && shift
    for _ in $(seq "$runs"); do
        echo "$(seconds "$compiler" -std=c++20 -O1 -c -o yardstick.o yardstick.cpp) $(seconds "$compiler" "$@" -c -o made.o)"
    done | awk -v name="$name" '
        NR == 1 || $1 < yardstick { yardstick = $1 }
        NR == 1 || $2 < least { least = $2 }
        END { printf "%-58s %6.2f s   %5.2f yardsticks\n", name, least, least / yardstick }'
}

# shellcheck disable=SC2086
{
    measure "the standard headers of typemesh.hpp" $flags standard.cpp
    measure "typemesh.hpp" $flags umbrella.cpp
    measure "the README's program, -O0" $flags -O0 program.cpp
    measure "the README's program, -O2" $flags -O2 program.cpp
    measure "the README's program, -O2, with typemesh::compiled" $flags -O2 -DTYPEMESH_COMPILED program.cpp
    measure "what typemesh::compiled adds to a build, once, -O2" $flags -O2 -DTYPEMESH_COMPILED "$root/include/typemesh/compiled/harfbuzz.cpp"
}
