// SPDX-License-Identifier: MIT

#include <typemesh/extrude/tubed.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/inspect/euler_count.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>

using namespace typemesh;
using namespace meshes;

static_assert(extruder<tubed>);

namespace {

/// The length of a shape's contours, in em.
double length_of_loops(const contours& c)
{
    double sum = 0.0;
    for (std::uint32_t k = 0; k < c.contour_count(); ++k)
        for (std::uint32_t i = c.starts[k], end = c.starts[k + 1]; i < end; ++i)
            sum += typemesh::length(delta(c.points[i], c.points[i + 1 == end ? c.starts[k] : i + 1]));
    return sum / 512000.0;
}

/// The area of a regular polygon in a circle.
double area_of_section(unsigned sides, double radius)
{
    return 0.5 * sides * radius * radius * std::sin(2.0 * 3.14159265358979323846 / sides);
}

/// Whether a segment passes through a triangle, away from its edges.
bool pierces(wide_vec a, wide_vec b, const wide_vec (&t)[3])
{
    const auto volume = [](wide_vec o, wide_vec p, wide_vec q, wide_vec r) {
        return meshes::dot(minus(p, o), meshes::cross(minus(q, o), minus(r, o)));
    };
    const double from = volume(a, t[0], t[1], t[2]), to = volume(b, t[0], t[1], t[2]);
    if (from * to >= 0.0) return false;
    const double x = volume(a, b, t[0], t[1]), y = volume(a, b, t[1], t[2]), z = volume(a, b, t[2], t[0]);
    constexpr double nothing = 1e-15;
    return (x > nothing && y > nothing && z > nothing) || (x < -nothing && y < -nothing && z < -nothing);
}

/// The number of edges that pierce triangles with which they share no corner.
template <class Mesh>
std::size_t pierced(const Mesh& m)
{
    std::size_t found = 0;
    for (const auto& t : m.triangles) {
        const wide_vec corners[3] = {wide(m.vertices[t[0]].position), wide(m.vertices[t[1]].position),
                                     wide(m.vertices[t[2]].position)};
        for (const auto& u : m.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const wide_vec a = wide(m.vertices[u[k]].position), b = wide(m.vertices[u[(k + 1) % 3]].position);
                bool shares = false;
                for (const wide_vec& c : corners) shares = shares || c == a || c == b;
                found += !shares && pierces(a, b, corners);
            }
    }
    return found;
}

}  // namespace

TEST_CASE("tubes are closed tori whose volume is that of their section along the outline", "[extrude]")
{
    for (const auto& s : shapes::all())
        for (const unsigned sides : {3u, 6u, 16u}) {
            INFO(s.name << " " << sides);
            const tubed how{.radius = 0.012f, .sides = sides};
            tubed_data data;
            no_caps nothing;
            const auto plan = plan_solid(how, s.made(), data, nothing);
            REQUIRE(plan);
            const built b = build(s, how);
            CHECK(b.announced == mesh_size{b.vertices.size(), b.triangles.size()});
            CHECK(b.vertices.size() == (s.points() + b.doubled()) * (sides + 1));
            CHECK(b.triangles.size() == s.points() * 2 * sides);
            CHECK(b.in_order);
            const auto indices = indices_of(b);
            const inspect::mesh_view view{b.vertices, indices};
            CHECK(inspect::check_manifoldness(view).is_manifold());
            const inspect::euler_count euler = inspect::count_euler(view);
            CHECK(euler.characteristic() == 0);
            CHECK(euler.solids == s.loops.contour_count());
            CHECK(euler.holes() == s.loops.contour_count());
            double volume = 0.0;
            for (std::uint32_t k = 0; k < s.loops.contour_count(); ++k) {
                const auto path = data.read().of<detail::tube_path>()[k];
                contours one;
                REQUIRE(one.points.append(
                    s.loops.points.view().subspan(s.loops.starts[k], s.loops.starts[k + 1] - s.loops.starts[k])));
                REQUIRE(
                    (one.starts.push_back(0) && one.starts.push_back(static_cast<std::uint32_t>(one.points.size()))));
                volume += length_of_loops(one) * area_of_section(sides, path.radius);
            }
            CHECK(inspect::measure(view).volume == Catch::Approx(volume).epsilon(1e-5));
        }
}

TEST_CASE("a tube that is too thick gets the largest radius at which no part meets another", "[extrude]")
{
    struct known {
        shapes::shape made;
        double radius;  // in em, of the thinnest tube, before 1/64 is taken off
    };
    std::vector<known> all;
    all.push_back({shapes::rectangle(), 0.2});  // both corners of its short sides
    all.push_back({shapes::letter_e(), 0.05});  // half of an arm
    all.push_back({shapes::ring(16), 0.075});   // half of the stroke
    for (const known& k : all) {
        INFO(k.made.name);
        const tubed how{.radius = 0.5f, .sides = 4};
        tubed_data data;
        no_caps nothing;
        const auto plan = plan_solid(how, k.made.made(), data, nothing);
        REQUIRE(plan);
        CHECK(plan->narrowed);
        float least = how.radius;
        const auto read = data.read();
        for (const auto& p : read.of<detail::tube_path>()) least = p.radius < least ? p.radius : least;
        CHECK(double{least} == Catch::Approx(k.radius * 63.0 / 64.0).epsilon(1e-2));
        CHECK(double{least} <= k.radius * 63.0 / 64.0 * (1.0 + 1e-9));
    }
}

TEST_CASE("no edge of a tube pierces a triangle of it, however thick it was wanted", "[extrude]")
{
    for (const auto& s :
         shapes::several(shapes::rectangle(), shapes::letter_e(), shapes::ring(2), shapes::ribbon(4), shapes::drop(5),
                         shapes::pair(2), shapes::star(), shapes::spike(), shapes::notch()))
        for (const float radius : {0.01f, 0.06f, 0.7f}) {
            INFO(s.name << " " << radius);
            const built b = build(s, tubed{.radius = radius, .sides = 4});
            CHECK(pierced(b) == 0);
            const auto indices = indices_of(b);
            CHECK(inspect::check_manifoldness(inspect::mesh_view{b.vertices, indices}).is_manifold());
        }
}

TEST_CASE("normals of tubes are unit vectors within the angle of a side and of the crease", "[extrude]")
{
    for (const auto& s : shapes::several(shapes::letter_e(), shapes::ring(6), shapes::letter_d(6)))
        for (const frame& f : frames()) {
            INFO(s.name);
            const built b = build(s, tubed{.radius = 0.01f, .sides = 12, .texture = texture_mapping::em}, in_em(f));
            double least = 1.0, length_error = 0.0;
            for (const auto& v : b.vertices) {
                length_error = std::fmax(length_error, std::fabs(meshes::length(v.normal) - 1.0));
                length_error = std::fmax(length_error, std::fabs(meshes::dot(wide(v.normal), wide(v.tangent))));
            }
            for (const auto& t : b.triangles)
                for (const std::uint32_t k : t)
                    least = std::fmin(least, f.winding * meshes::dot(face_normal(b, t), wide(b.vertices[k].normal)));
            CHECK(length_error < 1e-6);
            CHECK(least > std::cos((15.0 + 15.0 + 7.5) * 3.14159265 / 180.0));
            check_tangent(b.vertices.front(), 1e-6);
        }
}

TEST_CASE("texture coordinates of tubes run along and around", "[extrude]")
{
    const built em = build(shapes::rectangle(), tubed{.radius = 0.01f, .sides = 8});
    const built whole =
        build(shapes::rectangle(), tubed{.radius = 0.01f, .sides = 8, .texture = texture_mapping::cylindrical});
    float u = 0.0f, v = 1.0f;  // v grows downwards from 1
    for (const auto& p : em.vertices) {
        u = (std::max)(u, p.uv.x);
        v = (std::min)(v, p.uv.y);
    }
    CHECK(u == Catch::Approx(2.2));
    CHECK(1.0f - v == Catch::Approx(2.0 * 3.14159265 * 0.01));
    for (const auto& p : whole.vertices) {
        CHECK((p.uv.x >= 0.0f && p.uv.x <= 1.0f));
        CHECK((p.uv.y >= 0.0f && p.uv.y <= 1.0f));
    }
    // The tangent is the direction in which u grows, the bitangent that in which v grows.
    for (const built* b : {&em, &whole})
        for (const auto& t : b->triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto &p = b->vertices[t[k]], &q = b->vertices[t[(k + 1) % 3]];
                const wide_vec way = minus(wide(q.position), wide(p.position));
                if (q.uv.y == p.uv.y) CHECK((q.uv.x - p.uv.x) * meshes::dot(way, wide(p.tangent)) > 0.0);  // NOLINT
                if (q.uv.x == p.uv.x) CHECK((q.uv.y - p.uv.y) * meshes::dot(way, bitangent(p)) > 0.0);     // NOLINT
            }
}

TEST_CASE("tubes refuse options out of range", "[extrude]")
{
    const auto option = [](const tubed& how) { return std::string{refused_options(how).option}; };
    CHECK(option({.radius = 0.0f}) == "radius");
    CHECK(option({.radius = -1.0f}) == "radius");
    CHECK(option({.sides = 2}) == "sides");
    CHECK(option({.sides = 129}) == "sides");
    CHECK(option({.crease_degrees = 181.0f}) == "crease_degrees");
    CHECK(option({.corner_cut = 1.5f}) == "corner_cut");
    CHECK(option({.corner_cut = std::nanf("")}) == "corner_cut");
    CHECK_FALSE(refused_options(tubed{}));
    check_different_keys(
        tubed{}, {{.radius = 0.03f}, {.sides = 17}, {.crease_degrees = 16.0f}, {.texture = texture_mapping::box}});
}

TEST_CASE("tubes are planned without allocations the second time, and say when memory runs out", "[extrude]")
{
    const shapes::shape s = shapes::letter_d(6);
    const region r = s.made();
    const tubed how{.radius = 0.05f, .sides = 6};
    no_caps nothing;
    test::counting_memory counted;
    tubed_data data{counted.source()};
    REQUIRE(plan_solid(how, r, data, nothing));
    const std::size_t warm = counted.requests;
    data.clear();
    REQUIRE(plan_solid(how, r, data, nothing));
    CHECK(counted.requests == warm);
    for (std::size_t n = 1; n <= warm; ++n) {
        test::counting_memory failing{.fail_at = n};
        tubed_data poor{failing.source()};
        CHECK(plan_solid(how, r, poor, nothing).error() == error::out_of_memory);
        failing.fail_at = 0;
        poor.clear();
        CHECK(plan_solid(how, r, poor, nothing));
    }
}
