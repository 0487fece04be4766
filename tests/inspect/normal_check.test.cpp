// SPDX-License-Identifier: MIT

#include <typemesh/inspect/normal_check.hpp>

#include "solids.hpp"

#include <limits>

using namespace typemesh::inspect;
using test::full_vertex;

TEST_CASE("normals of texts are right, and each planted fault is found", "[inspect]")
{
    const test::full_mesh m = solids::of("oE");
    const auto checked = [](const test::full_mesh& some, int winding = 1, double allowed = 1e-5) {
        return check_normals(solids::seen(some), &full_vertex::normal, winding, allowed);
    };
    const normal_check right = checked(m);
    CHECK(right.is_right());
    CHECK(right.vertices == m.vertices.size());
    CHECK(right.triangles == m.indices.size() / 3);
    CHECK(right.worst_length < 1e-6);
    CHECK(checked(m, -1).against_winding == right.triangles);
    CHECK(checked(m, -1).inward_corners == 3 * right.triangles);

    for (std::size_t v = 0; v < m.vertices.size(); v += 7) {
        const auto spoilt = [&](typemesh::vec3 n) {
            test::full_mesh some = m;
            some.vertices[v].normal = n;
            return some;
        };
        const typemesh::vec3 n = m.vertices[v].normal;
        const normal_check turned = checked(spoilt({-n.x, -n.y, -n.z}));
        CHECK(turned.inward_corners > 0);
        CHECK(turned.not_unit == 0);
        CHECK_FALSE(turned.is_right());
        const normal_check longer = checked(spoilt({1.01f * n.x, 1.01f * n.y, 1.01f * n.z}));
        CHECK(longer.not_unit == 1);
        CHECK(longer.worst_length > 0.009);
        CHECK(checked(spoilt({1.01f * n.x, 1.01f * n.y, 1.01f * n.z}), 1, 0.02).is_right());
        CHECK(checked(spoilt({})).not_unit == 1);
        CHECK(checked(spoilt({std::numeric_limits<float>::quiet_NaN(), 0, 1})).not_unit == 1);
    }
    for (std::size_t t = 0; t < right.triangles; ++t) CHECK(checked(solids::turned(m, t)).against_winding == 1);
}
