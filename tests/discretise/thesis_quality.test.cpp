// SPDX-License-Identifier: MIT
#include <typemesh/discretise/thesis_quality.hpp>

#include "support/catch.hpp"

#include "discretise/curves.hpp"

#include <algorithm>
#include <utility>

using namespace typemesh;
using namespace test;

namespace {

template <class A, class B>
bool alike(const A& a, const B& b, const curve& c)
{
    const auto one = points_of(a, c, 1.0), other = points_of(b, c, 1.0);
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](const emitted& x, const emitted& y) { return x.p == y.p && x.t == y.t; });
}

}  // namespace

TEST_CASE("thesis_quality is two_lines at low, and above it the thesis' halving, at any em", "[thesis_quality]")
{
    const double em = GENERATE(64.0, 1000.0, 2048.0);
    const double part = em / 64.0;
    const std::pair<thesis_quality::preset, adaptive_subdivision> halvings[] = {
        {thesis_quality::normal, {5, 0.5 * part, 0.01}},
        {thesis_quality::high, {15, 0.1 * part, 0.01}},
        {thesis_quality::best, {15, 0.005 * part, 0.01}},
    };
    const curve drawn[] = {curve::from(quadratic{{0, 0}, {20 * part, 60 * part}, {64 * part, 0}}),
                           curve::from(cubic{{0, 0}, {0, 40 * part}, {50 * part, 64 * part}, {64 * part, 0}}),
                           curve::from(cubic{{0, 0}, {part, 0}, {2 * part, 0}, {3 * part, 0}})};
    for (const curve& c : drawn) {
        CHECK(alike(thesis_quality{thesis_quality::low, em}, two_lines{}, c));
        for (const auto& [preset, halving] : halvings) CHECK(alike(thesis_quality{preset, em}, halving, c));
    }
}

TEST_CASE("a better quality of the thesis takes more points", "[thesis_quality]")
{
    const curve c = curve::from(cubic{{0, 0}, {0, 400}, {500, 640}, {640, 0}});
    std::size_t before = 0;
    for (const auto preset :
         {thesis_quality::low, thesis_quality::normal, thesis_quality::high, thesis_quality::best}) {
        const std::size_t now = points_of(thesis_quality{preset, 1000.0}, c, 1.0).size();
        CHECK(now > before);
        before = now;
    }
}
