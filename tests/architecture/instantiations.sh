#!/bin/sh
# SPDX-License-Identifier: MIT
#
# A unit that includes typemesh.hpp and calls nothing makes none of the large templates: no sweep, no resolver, no plan.
# What g++ has made is read from its dump of all functions.
#
#     instantiations.sh COMPILER
set -eu
include=$(cd "$(dirname "$0")/../../include" && pwd)
scratch=$(mktemp -d) && trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
echo '#include <typemesh/typemesh.hpp>' >idle.cpp
{
    cat idle.cpp
    echo 'auto cut(const typemesh::region& r, typemesh::workspace& w, typemesh::triangle_list& t) { return typemesh::monotone{}(r, w, t); }'
} >cuts.cpp
# made FILE: the functions made of large templates
made() {
    "$1" -std=c++20 -O0 -S -o made.s -I"$include" -fdump-tree-original=dump.txt "$2"
    awk '/^;; Function .*\[with / {
        name = $0
        sub(/\(.*/, "", name)
        if (name ~ /(monotone_sweep|chain_cutter|resolving|boundary_cycles|delaunay_slabs|constrained_delaunay)(<.*>)?::/ ||
            name ~ /(glyph_merger|text_mesher|text_plan|text_chunks|mesh_layout)(<.*>)?::/) print
    }' dump.txt
}
made "$1" cuts.cpp | grep -q monotone_sweep || { echo "The dump no longer shows what is made" && exit 1; }
made "$1" idle.cpp >functions
if [ -s functions ]; then
    echo "Including typemesh.hpp makes:" && cat functions
    exit 1
fi
