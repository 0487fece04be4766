// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#if __has_include(<glm/vec3.hpp>)

#include <typemesh/adapt/glm.hpp>

using namespace typemesh;

TEST_CASE("vectors go to GLM and back unchanged", "[adapt][glm]")
{
    CHECK(to_glm(vec2{1.5f, -2.0f}) == glm::vec2{1.5f, -2.0f});
    CHECK(to_glm(vec3{1.5f, -2.0f, 3.0f}) == glm::vec3{1.5f, -2.0f, 3.0f});
    CHECK(to_glm(point{0.1, 0.2}) == glm::dvec2{0.1, 0.2});
    CHECK(from_glm(glm::vec2{1.5f, -2.0f}) == vec2{1.5f, -2.0f});
    CHECK(from_glm(glm::vec3{1.5f, -2.0f, 3.0f}) == vec3{1.5f, -2.0f, 3.0f});
    CHECK(from_glm(glm::dvec2{0.1, 0.2}) == point{0.1, 0.2});
}

#endif
