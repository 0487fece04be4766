#!/bin/bash
# SPDX-License-Identifier: MIT
#
# What the compiler needs for what users include: seconds of its own time, the least of several runs, also as a share of
# a yardstick that is compiled in the same minute (<regex>, used once); its memory (g++ only) and the size of the code
# in the object, which do not depend on the load. The program is the first one of README.md. Beside it stand small programs
# of other libraries, each with one thing that the library is taken for; those that are not installed are left out.
#
#     compile_times.sh [--rows] [RUNS]      3 runs without it; --rows writes rows as README.md says; CXX names the compiler,
#                                           CXXFLAGS adds to its flags (-DNDEBUG)
set -eu
rows=
case ${1:-} in
    -h | --help) sed -n '3,11s/^# \{0,1\}//p' "$0" && exit 0 ;;
    --rows) rows=yes && shift ;;
esac
runs=${1:-3}
compiler=${CXX:-g++}
root=$(cd "$(dirname "$0")/.." && pwd)
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
report=
! "$compiler" --version | grep -q 'Free Software' || report=-ftime-report

sed -n '/^```cpp$/,/^```$/p' "$root/README.md" | sed '1d; /^```$/q' | sed '$d' >program.cpp
# with SOLID NAME...: the same program with these policies, from the headers of these names
with() {
    policies=$1 && shift
    printf '#include <typemesh/%s.hpp>\n' "$@"
    sed "s/typemesh::text_mesher mesher{\*font}/using namespace typemesh; text_mesher mesher{*font, $policies}/" program.cpp
}
with 'constrained_delaunay{}, bevelled{}' triangulate/constrained_delaunay extrude/bevelled >bevelled.cpp
with 'embolden{.by = 0.01f}, bevelled{}' extrude/embolden extrude/bevelled >bold.cpp
with 'outlined<>{}' extrude/outlined >hollow.cpp
with 'one_of<flat, extruded<>, bevelled>{flat{}}' extrude/one_of extrude/flat extrude/bevelled >chosen.cpp
echo '#include <typemesh/typemesh.hpp>' >umbrella.cpp
# shellcheck disable=SC2086  # flags are several words
flags="-std=c++20 ${CXXFLAGS:-} -I$root/include $(pkg-config --cflags harfbuzz)"
$compiler $flags -MM umbrella.cpp | tr ' \\' '\n\n' | grep '/typemesh/' | xargs sed -nE 's/^#include <([a-z_0-9]+)>$/#include <\1>/p' |
    sort -u >standard.cpp
cat >yardstick.cpp <<'END'
#include <regex>
bool matches(const char* s) { return std::regex_match(s, std::regex{"a+b*"}); }
END

# The compiler's own time, in seconds; its report is left in report.txt.
seconds() {
    { { time -p "$@" >/dev/null 2>report.txt; } 2>&1; } | sed -n 's/^user //p'
}
# measure NAME FLAGS... : the least of all runs, and of the yardstick beside them
measure() {
    title=$1 && shift
    for _ in $(seq "$runs"); do
        echo "$(seconds "$compiler" -std=c++20 -O1 -c -o yardstick.o yardstick.cpp) $(seconds "$compiler" $report "$@" -c -o made.o)"
    done | awk -v name="$title" '
        NR == 1 || $1 < yardstick { yardstick = $1 }
        NR == 1 || $2 < least { least = $2 }
        END { print least, least / yardstick }' >times.txt
    memory=$(awk '$1 == "TOTAL" { print $NF }' report.txt)
    code=$(size made.o | awk 'NR == 2 { printf "%d", $1 / 1000 }')
    if [ -n "$rows" ]; then
        awk -v name="$title" -v memory="${memory:--}" -v code="$code" '
            { sub(/M$/, "", memory); printf "compiled\t%s\t%.2f\t%.1f\t%s\t%d\n", name, $1, $2, memory, code }' times.txt
    else
        awk -v name="$title" -v memory="${memory:-?}" -v code="$code" '
            { printf "%-66s %6.2f s %6.2f yardsticks %6s %5d kB of code\n", name, $1, $2, memory, code }' times.txt
    fi
}
# beside NAME HEADER: the program of standard input, if the compiler finds the header
beside() {
    cat >beside.cpp
    # shellcheck disable=SC2086  # flags are several words
    if printf '#include <%s>\n' "$2" | "$compiler" $flags $others -fsyntax-only -x c++ - 2>/dev/null; then
        measure "$1, -O2" $flags $others -O2 beside.cpp
    elif [ -n "$rows" ]; then
        printf 'skipped\t%s\t<%s> is not installed\n' "$1" "$2"
    else
        echo "left out: $1: <$2> is not installed"
    fi
}
others="-isystem /usr/include/eigen3 -isystem /usr/include/stb"
[ -z "$rows" ] || printf 'columns\tcompiled\tprogram\tseconds\tyardsticks\tmemory_mb\tcode_kb\n'

# shellcheck disable=SC2086
{
    measure "the standard headers of typemesh.hpp" $flags standard.cpp
    measure "typemesh.hpp" $flags umbrella.cpp
    measure "the README's program, -O0" $flags -O0 program.cpp
    for each in program bevelled bold hollow chosen; do
        case $each in
            program) name="the README's program" ;;
            bevelled) name="the same, bevelled, by constrained Delaunay" ;;
            bold) name="the same, bold and bevelled" ;;
            hollow) name="the same, hollow" ;;
            chosen) name="the same, flat, extruded or bevelled at run time" ;;
        esac
        measure "$name, -O2" $flags -O2 $each.cpp
        measure "$name, with typemesh::compiled, -O2" $flags -O2 -DTYPEMESH_COMPILED $each.cpp
    done
    measure "what typemesh::compiled adds to a build, once, -O2" $flags -O2 -DTYPEMESH_COMPILED "$root/include/typemesh/compiled/harfbuzz.cpp"
    beside "GLM: a perspective matrix" glm/glm.hpp <<'END'
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
glm::mat4 camera(glm::vec3 eye) { return glm::perspective(1.0f, 1.5f, 0.1f, 100.0f) * glm::lookAt(eye, {}, {0, 1, 0}); }
END
    beside "stb_truetype: its implementation" stb_truetype.h <<'END'
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb_truetype.h>
END
    beside "Eigen: a linear system" Eigen/Dense <<'END'
#include <Eigen/Dense>
Eigen::VectorXd solved(const Eigen::MatrixXd& a, const Eigen::VectorXd& b) { return a.ldlt().solve(b); }
END
    beside "CGAL: a constrained Delaunay triangulation" CGAL/Constrained_Delaunay_triangulation_2.h <<'END'
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
using kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
std::size_t triangles(const std::vector<kernel::Point_2>& loop)
{
    CGAL::Constrained_Delaunay_triangulation_2<kernel> of;
    of.insert_constraint(loop.begin(), loop.end(), true);
    return of.number_of_faces();
}
END
}
