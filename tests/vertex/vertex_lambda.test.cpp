// SPDX-License-Identifier: MIT

#include <typemesh/vertex/vertex_lambda.hpp>

#include <typemesh/typemesh.hpp>

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "support/catch.hpp"
#include "support/toy_font.hpp"

using namespace typemesh;

namespace {

constexpr auto lit = attribute::position | attribute::normal;

struct lit_vertex {
    vec3 position, normal;
};

}  // namespace

template <>
struct typemesh::vertex_traits<lit_vertex> {
    static constexpr auto wants = lit;
    lit_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal}; }
};

namespace {

template <class Sink>
void build_into(Sink&& sink)
{
    test::toy_font font;
    text_mesher mesher{font};
    REQUIRE(mesher.build("ooo", sink));
}

bool same_bytes(const std::vector<lit_vertex>& a, const std::vector<lit_vertex>& b)
{
    return a.size() == b.size() && !a.empty() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

}  // namespace

TEST_CASE("a lambda makes the same vertices as a trait", "[vertex][vertex_lambda]")
{
    std::vector<lit_vertex> by_trait, by_lambda, by_value;
    std::vector<std::uint32_t> indices, of_lambda, of_value;
    build_into(into(by_trait, indices));
    const auto make = [](const surface_point<lit>& s) noexcept { return lit_vertex{s.position, s.normal}; };
    static_assert(vertex_lambda<decltype(make)> && !vertex_writer<decltype(make)>);
    static_assert(lambda_writer<decltype(make)>::wants == lit);
    build_into(into(by_lambda, of_lambda, make));
    CHECK(same_bytes(by_trait, by_lambda));
    CHECK(indices == of_lambda);
    build_into(
        into(by_value, of_value, [](surface_point<lit> s) noexcept { return lit_vertex{s.position, s.normal}; }));
    CHECK(same_bytes(by_trait, by_value));

    std::vector<lit_vertex> held(by_trait.size());
    std::vector<std::uint32_t> numbers(indices.size());
    build_into(into(std::span{held}, std::span{numbers}, make, 7));
    CHECK(same_bytes(by_trait, held));
    for (std::size_t i = 0; i < indices.size(); ++i) REQUIRE(numbers[i] == indices[i] + 7);
}

TEST_CASE("a lambda can contain state, and its vertices need no trait", "[vertex][vertex_lambda]")
{
    std::vector<std::array<float, 4>> vertices;
    std::vector<std::uint16_t> indices;
    const float layer = 3.0f;
    build_into(into(vertices, indices, [layer](const surface_point<attribute::position>& s) noexcept {
        return std::array{s.position.x, s.position.y, s.position.z, layer};
    }));
    REQUIRE_FALSE(vertices.empty());
    for (const auto& v : vertices) CHECK(v[3] == layer);
}

TEST_CASE("only a lambda's attributes are computed", "[vertex][vertex_lambda]")
{
    const auto flat = [](const surface_point<attribute::uv>& s) noexcept { return s.uv; };
    static_assert(lambda_writer<decltype(flat)>::wants == attribute::uv);
    static_assert(vertex_writer<lambda_writer<decltype(flat)>>);
    const auto throwing = [](const surface_point<attribute::uv>& s) { return s.uv; };
    static_assert(detail::call_of<decltype(flat)>::is_noexcept && !detail::call_of<decltype(throwing)>::is_noexcept);
    static_assert(!vertex_lambda<int> && !vertex_lambda<vertex_traits<lit_vertex>>);
    std::vector<vec2> vertices;
    std::vector<std::uint32_t> indices;
    build_into(into(vertices, indices, flat));
    CHECK_FALSE(vertices.empty());
}
