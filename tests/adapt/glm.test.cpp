// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#if __has_include(<glm/vec3.hpp>)

#include <typemesh/adapt/glm.hpp>

using namespace typemesh;

TEST_CASE("vectors go to GLM and back unchanged", "[adapt][glm]")
{
    CHECK(to_glm(vec2{1.5f, -2.0f}) == glm::vec2{1.5f, -2.0f});
    CHECK(to_glm(vec3{1.5f, -2.0f, 3.0f}) == glm::vec3{1.5f, -2.0f, 3.0f});
    CHECK(to_glm(vec4{1.5f, -2.0f, 3.0f, -1.0f}) == glm::vec4{1.5f, -2.0f, 3.0f, -1.0f});
    CHECK(from_glm(glm::vec4{1.5f, -2.0f, 3.0f, -1.0f}) == vec4{1.5f, -2.0f, 3.0f, -1.0f});
    CHECK(to_glm(point{0.1, 0.2}) == glm::dvec2{0.1, 0.2});
    CHECK(from_glm(glm::vec2{1.5f, -2.0f}) == vec2{1.5f, -2.0f});
    CHECK(from_glm(glm::vec3{1.5f, -2.0f, 3.0f}) == vec3{1.5f, -2.0f, 3.0f});
    CHECK(from_glm(glm::dvec2{0.1, 0.2}) == point{0.1, 0.2});
}

TEST_CASE("an instance's matrix moves points by its translation and leaves directions alone", "[adapt][glm]")
{
    const glm::mat4 m = translation_matrix({1.5f, -2.0f, 3.0f});
    CHECK(m * glm::vec4{10.0f, 20.0f, 30.0f, 1.0f} == glm::vec4{11.5f, 18.0f, 33.0f, 1.0f});
    CHECK(m * glm::vec4{10.0f, 20.0f, 30.0f, 0.0f} == glm::vec4{10.0f, 20.0f, 30.0f, 0.0f});
}

TEST_CASE("a frame from a matrix maps as the matrix does", "[adapt][glm]")
{
    const glm::mat3 turned{{0.0f, 0.6f, 0.8f}, {0.0f, -0.8f, 0.6f}, {1.0f, 0.0f, 0.0f}};
    const frame f = frame_from_glm(turned);
    CHECK(f.is_orthonormal());
    CHECK_FALSE(f.mirrors());
    CHECK(to_glm(f(1.0f, 0.0f, 0.0f)) == turned[0]);
    CHECK(to_glm(f(0.0f, 1.0f, 0.0f)) == turned[1]);
    CHECK(to_glm(f(2.0f, 0.0f, -4.0f)) == turned * glm::vec3{2.0f, 0.0f, -4.0f});
    const glm::mat3 mirrored{turned[0], turned[1], -turned[2]};
    CHECK(frame_from_glm(mirrored).mirrors());
    CHECK(frame_from_glm(mirrored).turns_triangles());
}

#endif
