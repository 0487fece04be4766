// SPDX-License-Identifier: MIT

#include <typemesh/vertex/growing_sink.hpp>
#include <typemesh/vertex/uninitialised_allocator.hpp>

#include <cstdint>
#include <numeric>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

namespace uninitialised_allocator_test {

struct spot {
    float x = 7.0f;
    float y = 7.0f;
};

struct make_spot {
    static constexpr auto wants = attribute::uv;
    spot operator()(const surface_point<wants>& s) const noexcept { return {s.uv.x, s.uv.y}; }
};

template <class T>
using fresh_vector = std::vector<T, uninitialised_allocator<T>>;

}  // namespace uninitialised_allocator_test

using namespace uninitialised_allocator_test;

TEST_CASE("resize() with an uninitialised_allocator leaves memory as it is", "[vertex]")
{
    fresh_vector<spot> spots(3, spot{1.0f, 2.0f});
    spots.clear();
    spots.resize(3);  // the elements' lifetimes began anew, their bytes did not change
    for (const spot& d : spots) CHECK(d.y == 2.0f);
    spots.emplace_back();
    spots.back() = {3.0f, 4.0f};
    CHECK(spots.back().y == 4.0f);
}

TEST_CASE("a vector with an uninitialised_allocator copies, moves and grows like others", "[vertex]")
{
    fresh_vector<int> a;
    for (int i = 0; i < 1000; ++i) a.push_back(i);
    const fresh_vector<int> copy = a, moved = std::move(a);
    CHECK(copy == moved);
    CHECK(std::accumulate(copy.begin(), copy.end(), 0) == 499500);
    CHECK(uninitialised_allocator<int>{} == uninitialised_allocator<spot>{});
}

TEST_CASE("growing_sink fills vectors with an uninitialised_allocator", "[vertex]")
{
    fresh_vector<spot> vertices;
    fresh_vector<std::uint16_t> indices;
    auto sink = into(vertices, indices, make_spot{});
    REQUIRE_FALSE(sink.begin({4, 1}));
    for (const float v : {0.0f, 1.0f, 2.0f, 3.0f}) {
        surface_point<attribute::uv> s;
        s.uv = {v, -v};
        sink.vertex(s);
    }
    sink.triangle(1, 2, 3);
    sink.end();
    REQUIRE(vertices.size() == 4);
    CHECK(vertices[3].y == -3.0f);
    CHECK(indices == fresh_vector<std::uint16_t>{1, 2, 3});
}
