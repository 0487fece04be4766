// SPDX-License-Identifier: MIT

#include <typemesh/vertex/array_sink.hpp>

#include <array>
#include <vector>

#include "refusals.hpp"
#include "support/catch.hpp"
#include "support/guarded_bytes.hpp"

using namespace typemesh;

namespace {

struct corner {
    float x, y, z;
    friend bool operator==(const corner&, const corner&) = default;
};

struct untouched {};

/// Where a vertex would be: takes values, gives none back, and logs who was written.
struct slot {
    static inline std::vector<const slot*> log;
    corner held{-1, -1, -1};

    slot() = default;
    slot(const slot&) = delete;
    void operator=(const corner& c)
    {
        held = c;
        log.push_back(this);
    }
};

struct corner_writer {
    static constexpr auto wants = attribute::position;
    corner operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position.x, s.position.y, s.position.z};
    }
};

/// A writer with state that cannot be copied over: a reference.
struct tinting_writer {
    static constexpr auto wants = attribute::position;
    const float& tint;
    corner operator()(const surface_point<wants>& s) const noexcept { return {s.position.x, s.position.y, tint}; }
};

surface_point<attribute::position> at(vec3 position)
{
    surface_point<attribute::position> s;
    s.position = position;
    return s;
}

template <class Sink>
void write(Sink& sink, std::uint32_t vertices, std::uint32_t triangles)
{
    for (std::uint32_t i = 0; i < vertices; ++i)
        sink.vertex(at({static_cast<float>(i), 2.0f * static_cast<float>(i), 0.5f}));
    for (std::uint32_t i = 0; i < triangles; ++i) sink.triangle(i, i + 1, i + 2);
    sink.end();
}

}  // namespace

template <>
struct typemesh::vertex_traits<corner> : corner_writer {};

static_assert(mesh_vertex<corner>);
static_assert(!mesh_vertex<untouched>);
static_assert(mesh_sink<array_sink<corner, std::uint16_t, corner_writer>>);
static_assert(mesh_sink<array_sink<corner, std::uint32_t, tinting_writer>>);

TEST_CASE("array_sink writes every vertex once, in ascending order, and never reads", "[vertex]")
{
    slot::log.clear();
    std::array<slot, 7> slots;
    std::array<std::uint32_t, 9> indices{};
    array_sink sink{std::span<slot>{slots}, std::span<std::uint32_t>{indices}, corner_writer{}};
    REQUIRE_FALSE(sink.begin({5, 2}));
    write(sink, 5, 2);
    REQUIRE(slot::log.size() == 5);
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(slot::log[i] == &slots[i]);
        CHECK(slots[i].held == corner{static_cast<float>(i), 2.0f * static_cast<float>(i), 0.5f});
    }
    CHECK(slots[5].held == corner{-1, -1, -1});
}

TEMPLATE_TEST_CASE("array_sink writes only as much as it announced", "[vertex]", std::uint16_t, std::uint32_t,
                   std::uint64_t)
{
    std::vector<corner> vertices(12, corner{9, 9, 9});
    std::vector<TestType> indices(20, TestType{77});
    auto sink = into(std::span{vertices}.subspan(2, 6), std::span{indices}.subspan(3, 9));
    REQUIRE_FALSE(sink.begin({6, 3}));
    write(sink, 6, 3);
    for (std::size_t i = 0; i < vertices.size(); ++i) CHECK((vertices[i] == corner{9, 9, 9}) == (i < 2 || i >= 8));
    const std::vector<TestType> expected = {77, 77, 77, 0, 1, 2, 1, 2, 3, 2, 3, 4, 77, 77, 77, 77, 77, 77, 77, 77};
    CHECK(indices == expected);
}

TEST_CASE("array_sink adds the base vertex to every index", "[vertex]")
{
    std::vector<corner> vertices(3);
    std::vector<std::uint16_t> indices(3);
    auto sink = into(std::span{vertices}, std::span{indices}, 1000);
    REQUIRE_FALSE(sink.begin({3, 1}));
    write(sink, 3, 1);
    CHECK(indices == std::vector<std::uint16_t>{1000, 1001, 1002});
}

TEST_CASE("array_sink reports how much is missing before it writes anything", "[vertex]")
{
    std::vector<corner> vertices(4, corner{9, 9, 9});
    std::vector<std::uint32_t> indices(6, 77u);
    auto sink = into(std::span{vertices}, std::span{indices});
    test::check_refused(sink.begin({5, 2}), error::buffer_too_small, 5);
    test::check_refused(sink.begin({4, 3}), error::buffer_too_small, 9);
    CHECK(vertices == std::vector<corner>(4, corner{9, 9, 9}));
    CHECK(indices == std::vector<std::uint32_t>(6, 77u));
    CHECK_FALSE(sink.begin({4, 2}));
}

TEST_CASE("16-bit indices number at most 65,535 vertices, including the base", "[vertex]")
{
    std::vector<corner> vertices(70000);
    std::vector<std::uint16_t> indices(3);
    CHECK_FALSE(into(std::span{vertices}, std::span{indices}).begin({65535, 1}));
    test::check_refused(into(std::span{vertices}, std::span{indices}).begin({65536, 1}), error::index_overflow, 65536);
    CHECK_FALSE(into(std::span{vertices}, std::span{indices}, 65000).begin({535, 1}));
    CHECK(into(std::span{vertices}, std::span{indices}, 65000).begin({536, 1}) == error::index_overflow);
}

TEST_CASE("a writer's state belongs to the caller", "[vertex]")
{
    float tint = 0.25f;
    std::vector<corner> vertices(2);
    std::vector<std::uint32_t> indices(3);
    auto sink = into(std::span{vertices}, std::span{indices}, tinting_writer{tint});
    REQUIRE_FALSE(sink.begin({2, 0}));
    sink.vertex({});
    tint = 0.75f;
    sink.vertex({});
    CHECK(vertices[0].z == 0.25f);
    CHECK(vertices[1].z == 0.75f);
}

TEST_CASE("an empty mesh needs no memory", "[vertex]")
{
    auto sink = into(std::span<corner>{}, std::span<std::uint32_t>{});
    CHECK_FALSE(sink.begin({0, 0}));
    sink.end();
}

TEST_CASE("arrays of a fixed size are written like spans of any size", "[vertex]")
{
    std::array<corner, 3> vertices{};
    std::array<std::uint16_t, 3> indices{};
    auto sink = into(std::span{vertices}, std::span{indices}, corner_writer{});
    REQUIRE_FALSE(sink.begin({3, 1}));
    for (int i = 0; i < 3; ++i) sink.vertex(at({static_cast<float>(i), 0.0f, 0.0f}));
    sink.triangle(0, 1, 2);
    sink.end();
    CHECK(vertices[2] == corner{2, 0, 0});
    CHECK(indices == std::array<std::uint16_t, 3>{0, 1, 2});
    CHECK(into(std::span{vertices}, std::span{indices}, corner_writer{}).begin({4, 1}) == error::buffer_too_small);
}

TEST_CASE("array_sink fills memory to exactly its last byte, and writes nothing if it refuses", "[vertex]")
{
    const test::guarded_bytes vertices{5 * sizeof(corner)}, indices{6 * sizeof(std::uint16_t)};
    auto sink = into(vertices.as<corner>(), indices.as<std::uint16_t>(), 7);
    CHECK(sink.begin({6, 2}) == error::buffer_too_small);
    CHECK(sink.begin({5, 3}) == error::buffer_too_small);
    CHECK(sink.begin({65530, 2}) == error::index_overflow);
    CHECK(vertices.untouched());
    CHECK(indices.untouched());
    REQUIRE_FALSE(sink.begin({5, 2}));
    write(sink, 5, 2);
    CHECK(vertices.as<corner>()[4] == corner{4.0f, 8.0f, 0.5f});
    CHECK(indices.as<std::uint16_t>()[5] == 10);
}
