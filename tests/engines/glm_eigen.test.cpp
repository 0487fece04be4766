// SPDX-License-Identifier: MIT

#include "engines/stand_in/eigen.hpp"

#include "engines/eigen.hpp"

#if __has_include(<glm/vec3.hpp>)
#include "engines/glm.hpp"
#endif

#include <type_traits>
#include <utility>

#include "recipe_laws.hpp"

using namespace recipes;

#if __has_include(<glm/vec3.hpp>)
TEMPLATE_TEST_CASE("GLM's vectors contain a right-handed mesh with counter-clockwise triangles and upward v",
                   "[engines]", bench, bevelled_bench)
{
    TestType b;
    std::vector<engines::glm_vertex> vertices;
    std::vector<std::uint32_t> indices;
    const auto plan = planned(b, engines::glm_options());
    REQUIRE(plan.write(into(vertices, indices)));
    seen mesh;
    for (const auto& v : vertices) {
        mesh.position.push_back(from_glm(v.position));
        mesh.normal.push_back(from_glm(v.normal));
        mesh.tangent.push_back({v.tangent.x, v.tangent.y, v.tangent.z, v.tangent.w});
        mesh.uv.push_back(from_glm(v.uv));
    }
    mesh.index = indices;
    obeys(mesh, plan, opengl);
}
#endif

TEMPLATE_TEST_CASE("Eigen's matrices contain a mesh with z up, one row or column per vertex and triangle", "[engines]",
                   (std::pair<std::true_type, bench>), (std::pair<std::false_type, bench>),
                   (std::pair<std::true_type, bevelled_bench>), (std::pair<std::false_type, bevelled_bench>))
{
    constexpr bool by_rows = TestType::first_type::value;
    using places_type =
        std::conditional_t<by_rows, Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>, Eigen::Matrix3Xf>;
    using triangles_type =
        std::conditional_t<by_rows, Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>, Eigen::Matrix3Xi>;
    typename TestType::second_type b;
    const auto plan = planned(b, engines::eigen::options());
    places_type places, normals;
    triangles_type triangles;
    REQUIRE(engines::eigen::write(plan, places, normals, triangles));
    const auto at = [](auto& m, std::size_t i, int k) {
        if constexpr (by_rows)
            return m(static_cast<decltype(m.rows())>(i), k);
        else
            return m(k, static_cast<decltype(m.rows())>(i));
    };
    seen mesh;
    for (std::size_t i = 0; i < plan.size().vertices; ++i) {
        mesh.position.push_back({at(places, i, 0), at(places, i, 1), at(places, i, 2)});
        mesh.normal.push_back({at(normals, i, 0), at(normals, i, 1), at(normals, i, 2)});
    }
    for (std::size_t i = 0; i < plan.size().triangles; ++i)
        for (int k = 0; k < 3; ++k) mesh.index.push_back(static_cast<std::uint32_t>(at(triangles, i, k)));
    obeys(mesh, plan, cad);
}
