// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/discretise/discretiser.hpp>

#include <cmath>

namespace stranger {

/// Equal steps of t, more of them for a bent control polygon. Written only from the comment on discretiser.
struct equal_steps {
    template <class Put>
    void operator()(const typemesh::quadratic& q, double tolerance, Put&& put) const noexcept
    {
        flatten(q, typemesh::length(q.p0 - 2.0 * q.p1 + q.p2) / 4.0, tolerance, put);
    }
    template <class Put>
    void operator()(const typemesh::cubic& c, double tolerance, Put&& put) const noexcept
    {
        const double a = typemesh::length(c.p0 - 2.0 * c.p1 + c.p2), b = typemesh::length(c.p1 - 2.0 * c.p2 + c.p3);
        flatten(c, 0.75 * (a > b ? a : b), tolerance, put);
    }

private:
    /// Wang's bound: the error of n steps is at most `bend` / n^2.
    template <class Curve, class Put>
    static void flatten(const Curve& c, double bend, double tolerance, Put& put) noexcept
    {
        const double wanted = std::ceil(std::sqrt(bend / tolerance));
        const int n = wanted < 1.0 ? 1 : wanted < 1000.0 ? static_cast<int>(wanted) : 1000;
        for (int i = 1; i <= n; ++i) put(c.at(double(i) / n), double(i) / n);
    }
};
static_assert(typemesh::discretiser<equal_steps>);

}  // namespace stranger
