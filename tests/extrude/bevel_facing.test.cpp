// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bevel_facing.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;

namespace {

/// Vertices of one strip that is 100 cells wide, or of a riser.
struct hand_made {
    bevel_data data;
    workspace space;
    workspace::scope scratch{space};

    explicit hand_made(bool riser = false)
    {
        REQUIRE(data.of<bevel_strip>().push_back({riser ? 0.0f : 100.0f, 0.0f, 1.0f}));
    }
    std::uint32_t add(grid_point at, double degrees, float share)
    {
        const double radians = degrees * 3.14159265358979323846 / 180.0;
        const point n{std::cos(radians), std::sin(radians)};
        REQUIRE(data.of<bevel_vertex>().push_back({at, rounded(n), 7.0f, share, 0}));
        REQUIRE(data.normals.push_back({n, n}));
        return static_cast<std::uint32_t>(data.of<bevel_vertex>().size() - 1);
    }
    void add(std::initializer_list<triangle> triangles)
    {
        for (const triangle t : triangles) REQUIRE(data.of<bevel_triangle>().push_back({t}));
    }
    void turn_out(std::size_t first = 0) { REQUIRE(bevel_facing{data, scratch}.turn_out(first)); }

    [[nodiscard]] std::size_t vertices() { return data.of<bevel_vertex>().size(); }
    [[nodiscard]] triangle corners(std::size_t t) { return data.of<bevel_triangle>()[t].corners; }
    /// Of a vertex's normal and a direction.
    [[nodiscard]] double degrees_off(std::uint32_t vertex, point direction)
    {
        const vec2 n = data.of<bevel_vertex>()[vertex].outward;
        return std::acos(dot({as_double(n.x), as_double(n.y)}, unit(direction))) * 180.0 / 3.14159265358979323846;
    }
};

/// A square of 1000 by 100 cells over its lower edge, which faces down, in two triangles: their corners, lit at these
/// angles.
void add_square(hand_made& m, double at_a, double at_b, double inner)
{
    const std::uint32_t a = m.add({0, 0}, at_a, 0.0f), b = m.add({1000, 0}, at_b, 0.0f),
                        c = m.add({1000, 100}, inner, 1.0f), d = m.add({0, 100}, inner, 1.0f);
    m.add({{a, b, c}, {a, c, d}});
}

constexpr point down{0.0, -1.0};

}  // namespace

TEST_CASE("normals that light their triangles stay as they are", "[bevel_facing]")
{
    hand_made m;
    add_square(m, 181.0, 359.0, 270.0);
    m.turn_out();
    CHECK(m.vertices() == 4);
    CHECK(m.degrees_off(0, down) == Approx(89.0).margin(1e-4));
    CHECK(m.degrees_off(1, down) == Approx(89.0).margin(1e-4));
}

TEST_CASE("a normal that no other triangle needs is turned in place, and no farther than necessary", "[bevel_facing]")
{
    hand_made m;
    add_square(m, 270.0, 5.0, 270.0);  // 95 degrees off, at a corner that only the first triangle has
    m.turn_out();
    CHECK(m.vertices() == 4);
    CHECK(m.degrees_off(1, down) == Approx(89.1).margin(0.05));
    CHECK(m.degrees_off(1, {1.0, 0.0}) < 1.0);
}

TEST_CASE("a triangle with a wrong normal gets a vertex of its own, and the others keep theirs", "[bevel_facing]")
{
    // A third triangle, over an edge that faces to the left, has a's normal rightly.
    hand_made m;
    add_square(m, 175.0, 270.0, 270.0);
    const std::uint32_t e = m.add({0, 1000}, 180.0, 0.0f), f = m.add({100, 500}, 180.0, 1.0f);
    m.add({{e, 0, f}});
    m.turn_out();
    CHECK(m.vertices() == 7);
    CHECK(m.corners(2) == triangle{e, 0, f});
    CHECK(m.degrees_off(0, {-1.0, 0.0}) == Approx(5.0).margin(1e-4));
    CHECK(m.corners(0).a == 6);  // both triangles of the square share the new one
    CHECK(m.corners(1).a == 6);
    CHECK(m.degrees_off(6, down) == Approx(89.1).margin(0.05));
    const bevel_vertex& made = m.data.of<bevel_vertex>()[6];
    CHECK(made.at == grid_point{0, 0});
    CHECK(same(made.along, 7.0f));
    CHECK(is_zero(made.share));
    CHECK(m.data.normals.size() == 7);
}

TEST_CASE("a normal that points straight into its face becomes the face's own", "[bevel_facing]")
{
    hand_made m;
    add_square(m, 270.0, 90.0, 270.0);
    m.turn_out();
    CHECK(m.degrees_off(1, down) == Approx(0.0).margin(0.1));
}

TEST_CASE("a strip's end may be the start of the next", "[bevel_facing]")
{
    hand_made m;
    REQUIRE(m.data.of<bevel_strip>().push_back({100.0f, 1.0f, 2.0f}));
    const std::uint32_t a = m.add({0, 0}, 270.0, 1.0f), b = m.add({1000, 0}, 270.0, 1.0f),
                        c = m.add({1000, 100}, 80.0, 1.0f);
    m.data.of<bevel_vertex>()[c].strip = 1;
    m.add({{a, b, c}});
    m.turn_out();
    CHECK(m.degrees_off(a, down) < 1e-3);
    CHECK(m.degrees_off(b, down) < 1e-3);
    CHECK(m.degrees_off(c, down) < 89.2);
}

TEST_CASE("risers face out of the edge that they stand on, and keep their pairs", "[bevel_facing]")
{
    for (const bool shared : {false, true}) {
        hand_made m{true};
        const std::uint32_t a = m.add({0, 0}, 170.0, 0.0f);
        m.add({0, 0}, 170.0, 1.0f);
        const std::uint32_t b = m.add({1000, 0}, 270.0, 0.0f);
        m.add({1000, 0}, 270.0, 1.0f);
        m.add({{a, b, b + 1}, {a, b + 1, a + 1}});
        if (shared) {
            const std::uint32_t c = m.add({0, 1000}, 180.0, 0.0f);
            m.add({0, 1000}, 180.0, 1.0f);
            m.add({{c, a, a + 1}, {c, a + 1, c + 1}});
        }
        m.turn_out();
        CHECK(m.vertices() == (shared ? 8u : 4u));
        const std::uint32_t left = m.corners(0).a;
        CHECK(left == (shared ? 6u : 0u));
        CHECK(m.corners(1).a == left);
        CHECK(m.corners(1).c == left + 1);
        CHECK(is_zero(m.data.of<bevel_vertex>()[left].share));
        CHECK(same(m.data.of<bevel_vertex>()[left + 1].share, 1.0f));
        for (const std::uint32_t v : {left, left + 1}) CHECK(m.degrees_off(v, down) < 89.2);
        if (shared) CHECK(m.degrees_off(a, {-1.0, 0.0}) == Approx(10.0).margin(1e-4));
    }
}

TEST_CASE("triangles that are three cells high, level, or before the first one stay as they are", "[bevel_facing]")
{
    hand_made low;
    const std::uint32_t a = low.add({0, 0}, 90.0, 0.0f), b = low.add({1000, 0}, 90.0, 0.0f),
                        c = low.add({500, 3}, 90.0, 0.03f), d = low.add({500, 4}, 90.0, 0.04f),
                        e = low.add({500, 400}, 90.0, 0.0f);
    low.add({{a, b, c}, {a, b, e}});
    low.turn_out();
    CHECK(low.vertices() == 5);
    CHECK(low.degrees_off(a, down) > 179.0);
    CHECK(low.degrees_off(e, down) > 179.0);
    low.add({{a, b, d}});
    low.turn_out(3);
    CHECK(low.degrees_off(d, down) > 179.0);
    low.turn_out(2);
    CHECK(low.degrees_off(d, down) < 1.0);
}

TEST_CASE("turning normals reports that memory has run out", "[bevel_facing]")
{
    hand_made m;
    add_square(m, 270.0, 5.0, 270.0);
    test::counting_memory memory;
    memory.fail_at = 1;
    workspace none{memory.source()};
    workspace::scope scratch{none};
    CHECK_FALSE(bevel_facing{m.data, scratch}.turn_out(0));
}
