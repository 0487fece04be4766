// SPDX-License-Identifier: MIT

// Tapered solids of shapes built by hand: closed, with walls that lean by the draft angle, and as large as the sum of
// their sections.

#include <typemesh/extrude/tapered.hpp>
#include <typemesh/inspect/manifoldness.hpp>

#include "capped.hpp"
#include "support/catch.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

using namespace typemesh;
using namespace meshes;

static_assert(extruder<tapered> && capping_extruder<tapered> && cacheable_policy<tapered>);
static_assert(has_heights<tapered> && has_front_triangles<tapered> && has_hard_edges<tapered>);
static_assert(part_count_of<tapered> == 5 && !refitting_extruder<tapered>);

namespace {

constexpr double tapered_cells = 512000.0;  // per em

double tangent_of(float degrees) { return std::tan(static_cast<double>(degrees) * std::numbers::pi / 180.0); }

std::vector<shapes::shape> tapered_shapes()
{
    return shapes::several(shapes::rectangle(), shapes::letter_e(), shapes::ring(8), shapes::letter_d(8),
                           shapes::star(), shapes::notch());
}

/// The area of a shape moved inwards by a distance, in square em: Steiner's formula for polygons with mitred corners,
/// which is exact as long as nothing meets.
double section(const shapes::shape& s, double distance)
{
    double area = 0.0;
    for (std::uint32_t i = 0; i < s.points(); ++i) {
        const grid_point a = s.loops.points[s.previous(i)], b = s.loops.points[i], c = s.loops.points[s.next(i)];
        const point in{double(b.x) - a.x, double(b.y) - a.y}, out{double(c.x) - b.x, double(c.y) - b.y};
        const double turn = std::atan2(typemesh::cross(in, out), typemesh::dot(in, out));
        area += 0.5 * (double(b.x) * c.y - double(c.x) * b.y) / tapered_cells / tapered_cells -
                distance * std::hypot(out.x, out.y) / tapered_cells + distance * distance * std::tan(turn / 2.0);
    }
    return area;
}

}  // namespace

TEST_CASE("tapered solids are closed, strictly 2-manifold, and lit from outside", "[extrude][tapered]")
{
    for (const auto& s : tapered_shapes())
        for (const float degrees : {0.0f, 1.0f, 15.0f, 60.0f, 89.0f})
            for (const float depth : {0.05f, 0.5f}) {
                INFO(s.name << ", " << degrees << " degrees, " << depth << " em deep");
                const auto m = capped(s, tapered{.depth = depth, .degrees = degrees});
                check_laws(m);
                const auto indices = indices_of(m);
                CHECK(inspect::check_manifoldness(inspect::mesh_view{m.vertices, indices}).is_manifold());
                CHECK(m.sizes().triangles[part::back] != 0);
                CHECK(m.sizes().triangles[part::side] == 0);
                CHECK(m.sizes().triangles[part::front_bevel] != 0);
            }
}

TEST_CASE("a tapered solid is as large as the sum of its sections", "[extrude][tapered]")
{
    for (const auto& s : shapes::several(shapes::rectangle(), shapes::letter_e(), shapes::ring(8), shapes::letter_d(8)))
        for (const float degrees : {0.0f, 2.0f, 5.0f, 10.0f}) {
            INFO(s.name << ", " << degrees << " degrees");
            const tapered how{.depth = 0.1f, .degrees = degrees, .mitre_limit = 0.0f};
            const auto m = capped(s, how);
            const double inset = 0.1 * tangent_of(degrees);
            // The area is a polynomial of the second degree in the height, for which Simpson's rule is exact.
            const double exact = 0.1 * (section(s, 0.0) + 4.0 * section(s, 0.5 * inset) + section(s, inset)) / 6.0;
            CHECK(volume_of(m) == Catch::Approx(exact).epsilon(2e-5));
            double front = 0.0;
            for (const auto& t : triangles_of(m, part::front)) {
                const vec3 a = m.vertices[t[0]].position, b = m.vertices[t[1]].position, c = m.vertices[t[2]].position;
                front += 0.5 * ((double(b.x) - a.x) * (double(c.y) - a.y) - (double(c.x) - a.x) * (double(b.y) - a.y));
            }
            CHECK(front == Catch::Approx(section(s, inset)).epsilon(4e-5));
        }
}

TEST_CASE("walls that meet below the front make a roof", "[extrude][tapered]")
{
    // A rectangle of 0.4 by 0.7 em: its walls of 45 degrees meet at a height of 0.2 em, with a ridge 0.3 em long.
    const tapered how{.depth = 0.5f, .degrees = 45.0f};
    const auto s = shapes::rectangle();
    const auto m = capped(s, how);
    CHECK(m.sizes().triangles[part::front] == 0);
    CHECK(volume_of(m) == Catch::Approx(0.4 * 0.2 * (2.0 * 0.7 + 0.3) / 6.0).epsilon(1e-4));
    const height_range all = how.heights(form_of<tapered>(s, m.data));
    CHECK(all.low == -0.5);
    CHECK(all.high == Catch::Approx(-0.3).margin(1e-5));
    double high = -1.0;
    for (const auto& v : m.vertices) high = (std::max)(high, static_cast<double>(v.position.z));
    CHECK(high == Catch::Approx(-0.3).margin(1e-5));
}

TEST_CASE("every wall's normal leans by the draft angle", "[extrude][tapered]")
{
    for (const auto& s : tapered_shapes())
        for (const float degrees : {1.0f, 5.0f, 30.0f}) {
            const auto m = capped(s, tapered{.depth = 0.02f, .degrees = degrees});
            const double up = std::sin(static_cast<double>(degrees) * std::numbers::pi / 180.0);
            double farthest = 0.0;
            for (const auto& v : vertices_of(m, part::front_bevel))
                farthest = (std::max)(farthest, std::fabs(static_cast<double>(v.normal.z) - up));
            INFO(s.name << ", " << degrees << " degrees");
            CHECK(farthest < 1e-6);
            for (const auto& v : vertices_of(m, part::back)) CHECK(v.normal.z == -1.0f);
            for (const auto& v : vertices_of(m, part::front)) CHECK(v.normal.z == 1.0f);
        }
}

TEST_CASE("tapered options are refused by name, and have keys", "[extrude][tapered]")
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    for (const float degrees : {-1.0f, 89.5f, 90.0f, 180.0f, nan, infinite})
        check_refused("degrees", tapered{.degrees = degrees});
    for (const float depth : {0.0f, -1.0f, nan, infinite}) check_refused("depth", tapered{.depth = depth});
    for (const float crease : {-1.0f, 180.5f, nan}) check_refused("crease_degrees", tapered{.crease_degrees = crease});
    for (const float limit : {-1.0f, 0.5f, nan}) check_refused("mitre_limit", tapered{.mitre_limit = limit});
    check_refused_size("degrees", tapered{.depth = 1000.0f, .degrees = 89.0f});
    check_unknown_em<tapered>();
    check_empty_region(tapered{});
    const tapered plain;
    const std::vector<tapered> others{{.depth = 0.3f},
                                      {.degrees = 6.0f},
                                      {.mitre_limit = 3.0f},
                                      {.crease_degrees = 20.0f},
                                      {.front = false},
                                      {.back = false},
                                      {.texture = texture_mapping::box}};
    check_different_keys(plain, others);
}

TEST_CASE("a tapered solid stands as its options say, and its own memory is kept", "[extrude][tapered]")
{
    const auto s = shapes::letter_e();
    const height_range middle = tapered{.centred = true}.heights();
    CHECK(middle.low == -middle.high);
    for (const bool front : {true, false}) {
        const auto m = capped(s, tapered{.front = front, .back = !front});
        CHECK((m.sizes().triangles[part::front] != 0) == front);
        CHECK((m.sizes().triangles[part::back] != 0) == !front);
    }
    check_scarce_memory(tapered{}, 200);
    check_planned_anew(tapered{});
}
