// SPDX-License-Identifier: MIT

// Must not compile: two policies of one kind.

#include "../support/toy_font.hpp"

#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/typemesh.hpp>

using namespace typemesh;

void two_triangulators(test::toy_font& font)
{
    text_mesher mesher{font, monotone{}, constrained_delaunay{}};
    (void)mesher.plan("o");
}
