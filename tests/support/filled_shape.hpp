// SPDX-License-Identifier: MIT
#pragma once

// A shape that fill() made a region of.

#include "support/catch.hpp"
#include "support/regions.hpp"

#include <typemesh/fill/fill.hpp>

namespace test {

struct filled_shape {
    typemesh::contours loops;
    typemesh::workspace space;
    typemesh::region filled;

    explicit filled_shape(const shape& s, typemesh::fill_rule rule = typemesh::fill_rule::non_zero,
                          const typemesh::grid& cells = {})
        : loops{contours_of(s)}
    {
        loops.grid = cells;
        const auto made = fill(loops, rule, space);
        REQUIRE(made);
        filled = *made;
    }
};

}  // namespace test
