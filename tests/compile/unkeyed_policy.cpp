// SPDX-License-Identifier: MIT

// A policy with members that does not say its options cannot go with a cache. The message must say what to write.

#include <typemesh/typemesh.hpp>

struct some_steps {
    int steps = 4;
    template <class Curve, class Put>
    void operator()(const Curve& c, double, Put&& put) const noexcept
    {
        for (int i = 1; i <= steps; ++i) put(c.at(double(i) / steps), double(i) / steps);
    }
};

bool plan(typemesh::recorded_outlines& font, const typemesh::glyph_run& run, typemesh::glyph_cache<>& cache)
{
    typemesh::text_mesher mesher{font, some_steps{}, typemesh::cached_in{cache, 1}};
    return static_cast<bool>(mesher.plan(run));
}
