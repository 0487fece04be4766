// SPDX-License-Identifier: MIT

#include <typemesh/refine/delaunay_refined.hpp>
#include <typemesh/refine/non_obtuse.hpp>
#include <typemesh/refine/quadtree_refined.hpp>
#include <typemesh/refine/refiner.hpp>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

struct no_refinement {
    struct scratch {
        explicit scratch(memory) noexcept {}
    };
    error operator()(const region&, array_view<const triangle>, scratch&, const refined_cap&) const noexcept
    {
        return {};
    }
    error refused_options() const noexcept { return {}; }
};
struct may_throw : no_refinement {
    error operator()(const region&, array_view<const triangle>, scratch&, const refined_cap&) const { return {}; }
};

}  // namespace

TEST_CASE("a refiner has a scratch and does not throw", "[refine]")
{
    STATIC_REQUIRE(refiner<no_refinement>);
    STATIC_REQUIRE(refiner<delaunay_refined>);
    STATIC_REQUIRE(refiner<quadtree_refined>);
    STATIC_REQUIRE(refiner<non_obtuse>);
    STATIC_REQUIRE_FALSE(refiner<may_throw>);
    STATIC_REQUIRE_FALSE(refiner<int>);
}
