// SPDX-License-Identifier: MIT

#include <typemesh/inspect/mesh_measure.hpp>

#include "solids.hpp"

using namespace typemesh::inspect;
using Catch::Approx;

TEST_CASE("area and volume are the solid's own, and a planted fault changes them", "[inspect]")
{
    const test::full_mesh m = solids::of("i");  // 0.1 by 0.5 by 0.2 em
    const mesh_measure right = measure(solids::seen(m));
    CHECK(right.volume == Approx(0.01).epsilon(1e-5));
    CHECK(right.area == Approx(2 * (0.05 + 0.02 + 0.1)).epsilon(1e-5));
    for (std::size_t t = 0; t < m.indices.size() / 3; ++t) {
        CHECK(measure(solids::seen(solids::without(m, t))).area < 0.99 * right.area);
    }
    test::full_mesh inside_out = m;
    for (std::size_t t = 0; t < m.indices.size() / 3; ++t) inside_out = solids::turned(inside_out, t);
    CHECK(measure(solids::seen(inside_out)).volume == Approx(-0.01).epsilon(1e-5));

    std::vector<place> far_off;
    for (const auto& v : m.vertices) far_off.push_back(to_place(v.position) - place{-1e9, 1e9, 0});
    CHECK(measure(mesh_view{far_off, m.indices}).volume == Approx(0.01).epsilon(1e-3));
    CHECK_FALSE(measure(mesh_view{std::vector<place>{}, std::vector<int>{0, 1, 2}}).area > 0);
}
