// SPDX-License-Identifier: MIT
#pragma once

#include "crossings.hpp"

#include "support/curved_shape.hpp"

#include <cstdint>

/// Curves -> region -> triangles whose curves a shader draws.
namespace fuzz {

inline broken_law curved(values in)
{
    using namespace typemesh;
    const double tolerance = in.one_of({0.01, 0.00625, 0.00125, 0.0005, 0.0});
    const fill_rule rule = in.flag() ? fill_rule::even_odd : fill_rule::non_zero;
    crossing_laws::drawn_outline o{in};
    if (o.failure) return o.failure.message();
    o.given.rule = o.recorded.rule = rule;
    test::curved_shape made;
    if (const error e = made.make(o.recorded, 1000.0, tolerance)) return e.message();
    if (made.filled.points().empty() || made.mesh.triangles.size() > 2000) return {};
    if (broken_law broken = test::broken_curved(made); !broken.empty()) return broken;
    const double allowed = made.filled.tolerance() + 4.5;
    return test::sample(made, o.given, 60, allowed).far_away == 0 ? "" : "the shader fills a place wrongly";
}

}  // namespace fuzz
