// SPDX-License-Identifier: MIT

// Must not compile: a policy of no kind, and one each that only nearly is what it was meant to be.

#include "../support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

using namespace typemesh;

struct nothing {};

struct throwing_discretiser {
    template <class Put>
    void operator()(const quadratic& q, double, Put&& put) const
    {
        put(q.p2, 1.0);
    }
    template <class Put>
    void operator()(const cubic& c, double, Put&& put) const
    {
        put(c.p3, 1.0);
    }
};

struct throwing_triangulator {
    error operator()(const region&, workspace&, triangle_list&) const { return {}; }
};

struct extruder_without_plan : flat {
    void plan() const noexcept {}
};

struct throwing_extruder : extruded<> {
    template <attribute Wants, class Put>
    void vertices(part p, const solid_of<extruded<>>& s, const placement& at, Put&& put) const
    {
        extruded<>::vertices<Wants>(p, s, at, put);
    }
};

struct throwing_observer {
    void operator()(stage) const {}
};

void exchange(test::toy_font& font)
{
    auto a = text_mesher{font}.with(nothing{});
    auto b = text_mesher{font}.with(throwing_discretiser{});
    auto c = text_mesher{font}.with(throwing_triangulator{});
    auto d = text_mesher{font}.with(extruder_without_plan{});
    auto e = text_mesher{font}.with(throwing_extruder{});
    auto f = text_mesher{font}.with(throwing_observer{});
}
