// SPDX-License-Identifier: MIT

#include <typemesh/vertex/growing_sink.hpp>

#include <new>
#include <vector>

#include "refusals.hpp"
#include "support/catch.hpp"

using namespace typemesh;

namespace {

struct texture_corner {
    float x, y;
};

/// A container that has memory for so many elements and then throws.
template <class T, bool HasReserve>
struct scarce {
    using value_type = T;
    std::vector<T> held;
    std::size_t most = 0;

    void resize(std::size_t n)
    {
        if (n > most) throw std::bad_alloc{};
        held.resize(n);
    }
    void reserve(std::size_t n)
        requires HasReserve
    {
        if (n > most) throw std::bad_alloc{};
    }
    T* data() { return held.data(); }
};

struct referring_writer {
    static constexpr auto wants = attribute::uv;
    const float& scale;
    texture_corner operator()(const surface_point<wants>& s) const noexcept { return {s.uv.x * scale, s.uv.y * scale}; }
};

template <class Sink>
void write_some(Sink& sink, std::uint32_t vertices, std::uint32_t triangles)
{
    for (std::uint32_t i = 0; i < vertices; ++i) {
        surface_point<Sink::wants> s;
        if constexpr (has(Sink::wants, attribute::uv)) s.uv = {static_cast<float>(i), 1.0f};
        sink.vertex(s);
    }
    for (std::uint32_t i = 0; i < triangles; ++i) sink.triangle(0, i, i + 1);
    sink.end();
}

}  // namespace

template <>
struct typemesh::vertex_traits<texture_corner> {
    static constexpr auto wants = attribute::uv;
    texture_corner operator()(const surface_point<wants>& s) const noexcept { return {s.uv.x, s.uv.y}; }
};

static_assert(mesh_sink<decltype(into(std::declval<std::vector<texture_corner>&>(),
                                      std::declval<std::vector<std::uint32_t>&>()))>);

TEST_CASE("growing_sink makes containers exactly as large as the mesh, whatever they contained", "[vertex]")
{
    for (const std::size_t held : {0u, 3u, 100u}) {
        std::vector<texture_corner> vertices(held, texture_corner{-1, -1});
        std::vector<std::uint16_t> indices(held, 77);
        auto sink = into(vertices, indices);
        REQUIRE_FALSE(sink.begin({10, 4}));
        write_some(sink, 10, 4);
        REQUIRE(vertices.size() == 10);
        CHECK(indices == std::vector<std::uint16_t>{0, 0, 1, 0, 1, 2, 0, 2, 3, 0, 3, 4});
        for (std::size_t i = 0; i < 10; ++i) CHECK(vertices[i].x == static_cast<float>(i));
        REQUIRE_FALSE(sink.begin({0, 0}));
        CHECK(vertices.empty());
        CHECK(indices.empty());
    }
}

TEST_CASE("growing_sink takes a writer that contains a reference", "[vertex]")
{
    const float scale = 3.0f;
    std::vector<texture_corner> vertices;
    std::vector<std::uint32_t> indices;
    auto sink = into(vertices, indices, referring_writer{scale});
    REQUIRE_FALSE(sink.begin({2, 0}));
    write_some(sink, 2, 0);
    CHECK(vertices[1].x == 3.0f);
}

TEST_CASE("growing_sink refuses more vertices than its indices can number, and leaves the containers unchanged",
          "[vertex]")
{
    std::vector<texture_corner> vertices(3);
    std::vector<std::uint16_t> indices(5);
    test::check_refused(into(vertices, indices).begin({65536, 1}), error::index_overflow, 65536);
    CHECK(vertices.size() == 3);
    CHECK(indices.size() == 5);
    CHECK_FALSE(into(vertices, indices).begin({65535, 1}));
}

TEST_CASE("a container that throws becomes error::out_of_memory", "[vertex]")
{
    scarce<texture_corner, true> vertices{{}, 10};
    scarce<std::uint32_t, true> indices{{}, 5};
    vertices.held.resize(2);
    CHECK(into(vertices, indices).begin({8, 2}) ==
          error::out_of_memory);  // the indices fail, the vertices would not have
    CHECK(vertices.held.size() == 2);
    CHECK(indices.held.empty());
    CHECK(into(vertices, indices).begin({11, 1}) == error::out_of_memory);
    CHECK_FALSE(into(vertices, indices).begin({8, 1}));

    scarce<texture_corner, false> without{{}, 4};
    scarce<std::uint32_t, false> indices_without{{}, 100};
    CHECK(into(without, indices_without).begin({5, 1}) == error::out_of_memory);
    CHECK_FALSE(into(without, indices_without).begin({4, 1}));
}

TEST_CASE("growing_sink adds the base vertex to every index, and counts it towards the index limit", "[vertex]")
{
    std::vector<texture_corner> vertices;
    std::vector<std::uint16_t> indices;
    auto sink = into(vertices, indices, 500);
    REQUIRE_FALSE(sink.begin({3, 1}));
    write_some(sink, 3, 1);
    CHECK(indices == std::vector<std::uint16_t>{500, 500, 501});
    CHECK_FALSE(into(vertices, indices, 65000).begin({535, 1}));
    test::check_refused(into(vertices, indices, 65000).begin({536, 1}), error::index_overflow, 65536);
    CHECK(vertices.size() == 535);
}
