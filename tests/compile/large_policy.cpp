// SPDX-License-Identifier: MIT

// Must not compile: a policy that is too large to lie in the mesher.

#include "../support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

using namespace typemesh;

struct large_steps {
    char options[65] = {};

    template <class Curve, class Put>
    void operator()(const Curve& curve, double, Put&& put) const noexcept
    {
        put(curve.at(1.0), 1.0);
    }
};
static_assert(discretiser<large_steps>);

void take(test::toy_font& font) { text_mesher mesher{font, large_steps{}}; }
