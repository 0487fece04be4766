// SPDX-License-Identifier: MIT

#include <typemesh/bend/displaced.hpp>
#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/on_sphere.hpp>
#include <typemesh/bend/taper.hpp>
#include <typemesh/bend/twist.hpp>
#include <typemesh/bend/wave.hpp>
#include <typemesh/extrude/bent.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/cap_normals.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/region_caps.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "mesh.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <algorithm>
#include <random>

using namespace typemesh;
using namespace meshes;

static_assert(extruder<bent<on_cylinder>> && extruder<bent<twist, flat>> && extruder<bent<taper, bevelled>>);
static_assert(has_heights<bent<on_cylinder>> && refuses_texts<bent<on_cylinder>> && !refuses_texts<extruded<>>);

namespace {

/// A height that is curved only near x = 0.4, and there strongly.
struct ridge {
    static constexpr double width = 0.004, curvature = 4000.0;

    surface_height operator()(double x, double) const noexcept
    {
        const double u = x - 0.4, inside = std::clamp(u, -width, width), slope = curvature * inside;
        return {0.5 * slope * inside + slope * (u - inside), slope, 0.0};
    }
    bend_bounds bend(const box3& b) const noexcept
    {
        return {.xx = b.high.x < 0.4 - width || b.low.x > 0.4 + width ? 0.0 : curvature};
    }
    error refused_options() const noexcept { return {}; }
};

/// A bent mesh, the flat mesh of the same vertices and triangles, and the plan.
struct bent_mesh : built {
    mesh<everything> flat_one;
    solid_plan plan;
    height_range heights;
};

/// Bends a shape whose origin stands at a place of the text, in em.
template <class E>
result<bent_mesh> bend(const shapes::shape& s, const E& how, plan_data_of<E>& data, point origin = {},
                       const frame& f = right_handed_y_up)
{
    static const monotone cut;
    cap_builder caps, further;
    region_caps maker{caps, further, cut, array_view<const triangle>{s.cap}, {origin, 1.0}};
    data.clear();
    const region r = s.made();
    const auto plan = plan_solid(how, r, data, maker);
    if (!plan) return plan.error();
    bent_mesh out;
    out.plan = *plan;
    out.sizes = plan->sizes;
    placement at = in_em(f);
    at.pen = at.em_pen = 512000.0 * origin;
    const solid_of<E> form{{r.points(), r.starts(), s.cap}, data.read()};
    out.heights = how.heights(form);
    if (const auto done = write_solid<E>({form, *plan}, how, at, static_cast<mesh<everything>&>(out)); !done)
        return done.error();
    auto solid = how.solid;
    if constexpr (requires { solid.segments; }) solid.segments = data.form.template of<bent_form>().view()[0].segments;
    at.frame = right_handed_y_up;
    solid_plan flat_plan = *plan;
    flat_plan.around = plan->textured;
    using solid_type = decltype(solid);
    if (const auto done = write_solid<solid_type>({data.flat.read(), flat_plan}, solid, at, out.flat_one); !done)
        return done.error();
    return out;
}

double3 wide3(vec3 v) { return {double{v.x}, double{v.y}, double{v.z}}; }

/// The greatest distance between sampled points of the mesh's triangles and their places on the bent flat solid, in em.
template <class D>
double deviation(const bent_mesh& m, const D& d, int samples)
{
    std::mt19937 random{7};
    std::uniform_real_distribution<double> any{0.0, 1.0};
    double worst = 0.0;
    for (const auto& t : m.triangles) {
        for (int k = 0; k < samples; ++k) {
            double u = any(random), v = any(random);
            if (u + v > 1.0) {
                u = 1.0 - u;
                v = 1.0 - v;
            }
            if (k == 0) u = v = 0.5;
            if (k == 1) v = 0.0, u = 0.5;
            const auto mix = [&](double3 a, double3 b, double3 c) { return (1.0 - u - v) * a + u * b + v * c; };
            const auto flat_at = [&](std::uint32_t i) { return wide3(m.flat_one.vertices[i].position); };
            const auto bent_at = [&](std::uint32_t i) { return wide3(m.vertices[i].position); };
            const double3 wanted = d(mix(flat_at(t[0]), flat_at(t[1]), flat_at(t[2]))).at,
                          made = mix(bent_at(t[0]), bent_at(t[1]), bent_at(t[2]));
            worst = (std::max)(worst, length(wanted - made));
        }
    }
    return worst;
}

/// The greatest angle between a vertex's normal and the flat one's, mapped by differences of the deformation; likewise
/// the tangent's. In degrees.
template <class D>
double normal_error(const bent_mesh& m, const D& d)
{
    double worst = 0.0;
    for (std::size_t i = 0; i < m.vertices.size(); ++i) {
        const double3 p = wide3(m.flat_one.vertices[i].position), n = wide3(m.flat_one.vertices[i].normal);
        constexpr double h = 1e-5;
        const double3 x = (0.5 / h) * (d({p.x + h, p.y, p.z}).at - d({p.x - h, p.y, p.z}).at),
                      y = (0.5 / h) * (d({p.x, p.y + h, p.z}).at - d({p.x, p.y - h, p.z}).at),
                      z = (0.5 / h) * (d({p.x, p.y, p.z + h}).at - d({p.x, p.y, p.z - h}).at);
        // The normal is perpendicular to the images of two directions that are perpendicular to the flat normal.
        const double3 other = std::abs(n.x) < 0.6 ? double3{1.0, 0.0, 0.0} : double3{0.0, 1.0, 0.0};
        const double3 s = cross(n, other), t = cross(n, s);
        const auto image = [&](double3 a) { return a.x * x + a.y * y + a.z * z; };
        double3 wanted = cross(image(s), image(t));
        wanted = (1.0 / length(wanted)) * wanted;
        const double3 is = wide3(m.vertices[i].normal);
        worst = (std::max)(worst, std::asin((std::min)(1.0, length(cross(wanted, is)))) * 57.29577951308232);
        if (dot(wanted, is) < 0.0) worst = 180.0;
        const vec4 flat_tangent = m.flat_one.vertices[i].tangent, tangent = m.vertices[i].tangent;
        const double3 along = image({double{flat_tangent.x}, double{flat_tangent.y}, double{flat_tangent.z}});
        const double3 has{double{tangent.x}, double{tangent.y}, double{tangent.z}};
        worst = (std::max)(worst,
                           std::asin((std::min)(1.0, length(cross(along, has)) / length(along))) * 57.29577951308232);
        CHECK(std::abs(length(has) - 1.0) < 1e-6);
    }
    return worst;
}

/// A drill: each plane at a height is turned. Its bounds may be withheld.
struct drill {
    double turn = 2.0;  ///< in radians per em of depth
    bool honest = true;

    static constexpr bool keeps_volume = true;

    [[nodiscard]] deformed_point operator()(const double3& p) const noexcept
    {
        const double sine = std::sin(turn * p.z), cosine = std::cos(turn * p.z);
        const double x = p.x * cosine - p.y * sine, y = p.x * sine + p.y * cosine;
        return {{x, y, p.z}, {cosine, sine, 0.0}, {-sine, cosine, 0.0}, {-turn * y, turn * x, 1.0}};
    }
    [[nodiscard]] bend_bounds bend(const box3& b) const noexcept
    {
        const auto farthest = [](double low, double high) { return (std::max)(std::fabs(low), std::fabs(high)); };
        if (!honest) return {};
        const double r = std::hypot(farthest(b.low.x, b.high.x), farthest(b.low.y, b.high.y));
        return {.zz = turn * turn * r, .xz = std::fabs(turn), .yz = std::fabs(turn)};
    }
    [[nodiscard]] error refused_options() const noexcept { return {}; }
};

double volume_in(const bent_mesh& m) { return measure(inspect::mesh_view{m.vertices, indices_of(m)}).volume; }

/// The volume that a surface sweeps at most if it moves by a distance.
double skin(const bent_mesh& m, double distance)
{
    double area = 0.0;
    for (const auto& t : m.triangles) {
        const double3 a = wide3(m.vertices[t[0]].position);
        area += 0.5 * length(cross(wide3(m.vertices[t[1]].position) - a, wide3(m.vertices[t[2]].position) - a));
    }
    return 1.1 * area * distance;
}

template <class D, class Solid = extruded<>>
void check_bent(const D& d, double tolerance, bool keeps_volume, const Solid& solid = {})
{
    plan_data_of<bent<D, Solid>> data;
    for (const auto& s : shapes::all()) {
        for (const point origin : {point{}, point{0.7, 0.1}}) {
            INFO(s.name << " at " << origin.x << ", tolerance " << tolerance);
            const auto m = bend(s, bent<D, Solid>{.solid = solid, .how = d, .tolerance = tolerance}, data, origin);
            INFO(m.error().message());
            REQUIRE(m);
            CHECK(m->vertices.size() == m->announced.vertices);
            CHECK(m->triangles.size() == m->announced.triangles);
            if constexpr (requires { solid.depth; }) CHECK(open_edges(*m) == 0);
            CHECK(deviation(*m, d, 6) <= tolerance + 1e-6);
            CHECK(normal_error(*m, d) < 0.05);
            std::size_t outside = 0;
            for (const auto& v : m->vertices) {
                const double x = 512000.0 * (double{v.position.x} - origin.x),
                             y = 512000.0 * (double{v.position.y} - origin.y);
                const box& around = m->plan.around;
                outside += x < around.low.x - 0.5 || x > around.high.x + 0.5 || y < around.low.y - 0.5 ||
                           y > around.high.y + 0.5 || double{v.position.z} < m->heights.low - 1e-6 ||
                           double{v.position.z} > m->heights.high + 1e-6;
            }
            CHECK(outside == 0);
            if constexpr (requires { solid.depth; }) {
                const double flat_volume = measure(inspect::mesh_view{m->flat_one.vertices, indices_of(*m)}).volume;
                CHECK(volume_in(*m) > 0.0);
                if (keeps_volume) CHECK(std::abs(volume_in(*m) - flat_volume) < skin(*m, tolerance + 1e-6));
            }
        }
    }
}

}  // namespace

TEMPLATE_TEST_CASE("a bent solid is closed, keeps its tolerance, and its normals follow the deformation",
                   "[extrude][bent]", curve_normals, creased_normals, averaged_normals, shared_normals, cap_normals)
{
    const extruded<TestType> solid{.depth = 0.2f};
    check_bent(on_cylinder{1.5}, 1.0 / 400, false, solid);
    check_bent(twist{40.0}, 1.0 / 800, true, solid);
}

TEST_CASE("each deformation keeps its tolerance, fine or coarse", "[extrude][bent]")
{
    for (const double tolerance : {1.0 / 100, 1.0 / 3000}) {
        check_bent(on_cylinder{0.9}, tolerance, false);
        check_bent(on_cylinder{-0.9, text_axis::along}, tolerance, false);
        check_bent(on_sphere{2.0}, tolerance, false);
        check_bent(twist{-30.0, text_axis::up, 0.3, -0.1}, tolerance, true);
        check_bent(taper{-0.3}, tolerance, false);
        check_bent(taper{0.5, text_axis::up}, tolerance, false);
        check_bent(displaced<wave>{{.height = 0.2, .length = 1.0, .direction = 30.0, .phase = 90.0}}, tolerance, true);
    }
    check_bent(on_cylinder{1.0}, 1.0 / 800, false, flat{});
}

TEST_CASE("bevelled letters are bent with their bevels", "[extrude][bent]")
{
    for (const bevel_sides sides : {bevel_sides::both, bevel_sides::front}) {
        bevelled solid{.depth = 0.2f, .width = 0.02f, .bevel_depth = 0.02f, .sides = sides};
        check_bent(on_cylinder{1.2}, 1.0 / 400, false, solid);
        solid.profile = round_profile(4);
        check_bent(twist{30.0}, 1.0 / 800, true, solid);
        solid.outward = true;
        check_bent(displaced<wave>{{.height = 0.15, .length = 1.5}}, 1.0 / 800, true, solid);
    }
    // Too fine a tolerance for any number of points.
    {
        plan_data_of<bent<on_cylinder>> data;
        CHECK(bend(shapes::letter_e(), bent<on_cylinder>{.tolerance = 1e-12, .max_points = 1000}, data).error() ==
              error::too_many_points);
    }
    // The cap within the bevels gets points of its own.
    const shapes::shape sheet{"sheet", {shapes::polygon({{0, 0}, {900, 0}, {900, 900}, {0, 900}})}, {}, 1};
    plan_data_of<bent<on_sphere, bevelled>> data;
    const auto m = bend(sheet, bent<on_sphere, bevelled>{.how = {1.2}, .tolerance = 1.0 / 800}, data);
    REQUIRE(m);
    CHECK(m->sizes.triangles[part::front] > m->sizes.vertices[part::front]);
    CHECK(open_edges(*m) == 0);
}

TEST_CASE("bevels are divided across where they bend, so wide ones need few triangles", "[extrude][bent]")
{
    const auto triangles = [](const auto& s, const auto& how) {
        plan_data_of<std::decay_t<decltype(how)>> data;
        const auto m = bend(s, how, data);
        INFO(s.name << ", " << how.solid.width << " em wide: " << m.error().message());
        REQUIRE(m);
        CHECK(open_edges(*m) == 0);
        CHECK(deviation(*m, how.how, 4) <= how.tolerance + 1e-6);
        return m->triangles.size();
    };
    for (const float width : {0.02f, 0.05f, 0.1f, 0.15f})
        for (const auto& s : {shapes::letter_e(), shapes::letter_d(), shapes::star()}) {
            bevelled solid{.depth = 0.3f, .width = width, .bevel_depth = (std::min)(width, 0.1f)};
            CHECK(triangles(s, bent<on_cylinder, bevelled>{.solid = solid, .how = {0.5}}) < 4'000);
            CHECK(triangles(s, bent<twist, bevelled>{.solid = solid, .how = {90.0}}) < 5'000);
            // A steep wave, across all edges.
            const displaced<wave> flag{{.height = 0.1, .length = 0.5, .direction = 30.0}};
            CHECK(triangles(s, bent<displaced<wave>, bevelled>{.solid = solid, .how = flag}) < 16'000);
            solid.outward = true;
            solid.mitre_limit = 4.0f;
            CHECK(triangles(s, bent<on_cylinder, bevelled>{.solid = solid, .how = {0.5}}) < 8'000);
        }
}

TEST_CASE("of a million points of bent solids none is farther away than is promised", "[extrude][bent]")
{
    const auto check = [](const auto& s, const auto& how, double stretch) {
        plan_data_of<std::decay_t<decltype(how)>> data;
        const auto m = bend(s, how, data, {0.2, -0.1});
        REQUIRE(m);
        constexpr double floats = 1e-6;
        const int samples = static_cast<int>(200'000 / m->triangles.size()) + 1;
        const double off = deviation(*m, how.how, samples);
        CHECK(off <= how.tolerance + floats);
        CHECK(off > 0.3 * how.tolerance);
        // The curves themselves, along the boundary: the certificate, and the chord's distance times the stretch.
        const contours& loops = data.flat.loops;
        std::size_t above = 0;
        for (std::uint32_t k = 0; k < loops.contour_count(); ++k)
            for (std::uint32_t i = loops.starts[k]; i < loops.starts[k + 1]; ++i) {
                const std::uint32_t next = i + 1 == loops.starts[k + 1] ? loops.starts[k] : i + 1;
                const auto in_text = [](point p) { return 0.001 * p + point{0.2, -0.1}; };
                const auto placed = [&](grid_point p) { return in_text((1.0 / 512.0) * placement::exact(p)); };
                const point a = placed(loops.points[i]), b = placed(loops.points[next]);
                const contour_edge& e = loops.edges[i];
                for (const double z : {0.0, -0.2})
                    for (double u = 0.0; u <= 1.0; u += 1.0 / 64.0) {
                        const point on = in_text(loops.curves[e.curve].at((1.0 - u) * double{e.t0} + u * double{e.t1})),
                                    flat = lerp(a, b, u);
                        const double3 made = (1.0 - u) * how.how({a.x, a.y, z}).at + u * how.how({b.x, b.y, z}).at;
                        above += length(made - how.how({on.x, on.y, z}).at) >
                                 how.tolerance + stretch * length(on - flat) + floats;
                    }
            }
        CHECK(above == 0);
    };
    check(shapes::ring(8), bent<on_cylinder>{.solid = {.depth = 0.2f}, .how = {0.6}, .tolerance = 1.0 / 500}, 1.0);
    check(shapes::letter_d(8), bent<twist>{.solid = {.depth = 0.2f}, .how = {60.0}, .tolerance = 1.0 / 2000}, 1.7);
    const bevelled solid{.depth = 0.2f, .width = 0.05f, .bevel_depth = 0.05f};
    check(shapes::ring(8), bent<on_cylinder, bevelled>{.solid = solid, .how = {0.6}}, 1.0);
    check(shapes::letter_e(), bent<twist, bevelled>{.solid = solid, .how = {60.0}}, 1.7);
    const displaced<wave> flag{{.height = 0.1, .length = 0.7, .direction = 30.0}};
    check(shapes::letter_d(8), bent<displaced<wave>, bevelled>{.solid = solid, .how = flag}, 2.4);
}

TEST_CASE("what is bent and unbent again lies on its points of the grid", "[extrude][bent]")
{
    const auto check = [](const auto& d, const auto& back) {
        const point origin{0.7, -0.3};
        plan_data_of<bent<std::decay_t<decltype(d)>>> data;
        for (const auto& s : shapes::all()) {
            REQUIRE(bend(s, bent<std::decay_t<decltype(d)>>{.solid = {.depth = 0.2f}, .how = d}, data, origin));
            std::size_t moved = 0;
            for (const grid_point p : data.flat.loops.points)
                for (const double z : {0.0, -0.2}) {
                    const double3 flat{double(p.x) / 512000.0 + origin.x, double(p.y) / 512000.0 + origin.y, z};
                    const double3 again = back(d(flat).at);
                    moved += std::lround(512000.0 * (again.x - origin.x)) != p.x ||
                             std::lround(512000.0 * (again.y - origin.y)) != p.y || std::fabs(again.z - z) > 1e-11;
                }
            CHECK(moved == 0);
        }
    };
    constexpr double radius = 0.9, turn = 40.0;
    check(on_cylinder{radius}, [](double3 q) {
        return double3{radius * std::atan2(q.x, q.z + radius), q.y, std::hypot(q.x, q.z + radius) - radius};
    });
    check(twist{turn}, [](double3 q) {
        const double angle = turn / 57.29577951308232 * q.x, sine = std::sin(angle), cosine = std::cos(angle);
        return double3{q.x, q.y * cosine + q.z * sine, q.z * cosine - q.y * sine};
    });
}

TEST_CASE("a triangle whose image turns is refused, however small the errors are said to be", "[extrude][bent]")
{
    // The caps are only turned in their planes. A wall between planes half a turn apart is inside out.
    const bent<drill> honest{.solid = {.depth = 0.2f}, .how = {15.0}};
    plan_data_of<bent<drill>> data;
    const auto m = bend(shapes::letter_e(), honest, data);
    REQUIRE(m);
    CHECK(m->triangles.size() > 1000);
    CHECK(deviation(*m, honest.how, 4) <= honest.tolerance + 1e-6);
    bent<drill> withheld = honest;
    withheld.how.honest = false;
    CHECK(bend(shapes::letter_e(), withheld, data).error() == error::folds_over);
    withheld.how.turn = 1.0;
    CHECK(bend(shapes::letter_e(), withheld, data));
}

TEST_CASE("a bar once around a cylinder has the volume of a tube", "[extrude][bent]")
{
    const double radius = 0.5, depth = 0.2, height = 0.3, around = 6.283185307179586 * radius;
    const double width = std::floor(1000.0 * around);  // in font units: a gap of less than one is left
    const shapes::shape bar{"bar", {shapes::polygon({{0, 0}, {width, 0}, {width, 300}, {0, 300}})}, {}, 1};
    plan_data_of<bent<on_cylinder>> data;
    for (const double tolerance : {1.0 / 100, 1.0 / 1000, 1.0 / 10000}) {
        const auto m = bend(
            bar,
            bent<on_cylinder>{.solid = {.depth = static_cast<float>(depth)}, .how = {radius}, .tolerance = tolerance},
            data);
        REQUIRE(m);
        // Pappus: the area of the section times the way of its centre.
        const double tube = height * depth * (width / 1000.0) * (radius - 0.5 * depth) / radius;
        CHECK(std::abs(volume_in(*m) - tube) < skin(*m, tolerance));
        CHECK(std::abs(volume_in(*m) - tube) > 0.0);
        CHECK(open_edges(*m) == 0);
    }
}

TEST_CASE("only edges across the bend are halved", "[extrude][bent]")
{
    // A tall bar around an upright cylinder needs no point along its height; around a lying one it needs many.
    const shapes::shape bar{"bar", {shapes::polygon({{0, 0}, {50, 0}, {50, 2000}, {0, 2000}})}, {}, 1};
    plan_data_of<bent<on_cylinder>> data;
    const auto up = bend(bar, bent<on_cylinder>{.how = {1.0}}, data);
    REQUIRE(up);
    CHECK(up->sizes.triangles[part::front] <= 8);
    const auto lying = bend(bar, bent<on_cylinder>{.how = {1.0, text_axis::along}}, data);
    REQUIRE(lying);
    CHECK(lying->sizes.triangles[part::front] > 30);
}

TEST_CASE("frames map bent letters like flat ones", "[extrude][bent]")
{
    const auto letter = shapes::letter_e();
    const bent<on_cylinder> how{.how = {0.8}};
    plan_data_of<bent<on_cylinder>> data;
    const auto plain = bend(letter, how, data, {0.4, 0.0});
    REQUIRE(plain);
    for (const frame& f : {left_handed_y_up, right_handed_z_up, left_handed_z_up}) {
        const auto m = bend(letter, how, data, {0.4, 0.0}, f);
        REQUIRE(m);
        REQUIRE(m->vertices.size() == plain->vertices.size());
        std::size_t unlike = 0;
        for (std::size_t i = 0; i < m->vertices.size(); ++i) {
            const auto &v = plain->vertices[i], &w = m->vertices[i];
            unlike += !(f(v.position.x, v.position.y, v.position.z) == w.position);
            unlike += !(f(v.normal.x, v.normal.y, v.normal.z) == w.normal);
            unlike += !(f(v.tangent.x, v.tangent.y, v.tangent.z) == vec3{w.tangent.x, w.tangent.y, w.tangent.z});
            unlike += (v.tangent.w == w.tangent.w) == f.mirrors();
            unlike += !(v.uv == w.uv);
        }
        CHECK(unlike == 0);
        CHECK(open_edges(*m) == 0);
    }
}

TEST_CASE("a ridge that is narrow beside a letter needs few points", "[extrude][bent]")
{
    const shapes::shape square{"square",
                               {{shapes::line({0, 0}, {1000, 0}), shapes::line({1000, 0}, {1000, 1000}),
                                 shapes::line({1000, 1000}, {0, 1000}), shapes::line({0, 1000}, {0, 0})}},
                               {},
                               1};
    plan_data_of<bent<displaced<ridge>, flat>> data;
    const auto made = bend(square, bent<displaced<ridge>, flat>{.max_points = 100}, data);
    REQUIRE(made);
    CHECK(made->sizes.total().vertices < 100);
    CHECK(bend(square, bent<displaced<ridge>, flat>{.max_points = 20}, data).error() == error::too_many_points);
}

TEST_CASE("bent letters that fold, and options out of range, are refused", "[extrude][bent]")
{
    const auto letter = shapes::letter_e();
    const auto refused = [&](const auto& how) {
        plan_data_of<std::decay_t<decltype(how)>> data;
        return bend(letter, how, data).error();
    };
    CHECK(refused(bent<on_cylinder>{.solid = {.depth = 1.0f}, .how = {0.9}}) == error::folds_over);
    CHECK(refused(bent<on_sphere>{.how = {0.4}}) == error::folds_over);
    CHECK(refused(bent<taper>{.how = {-5.0}}) == error::folds_over);
    const auto names = [&](const auto& how, const std::string& name) {
        const error e = refused(how);
        CHECK(e == error::bad_option);
        CHECK(std::string{e.option == nullptr ? "" : e.option} == name);
    };
    names(bent<on_cylinder>{.how = {0.0}}, "radius");
    names(bent<on_cylinder>{.tolerance = 0.0}, "tolerance");
    names(bent<on_cylinder>{.tolerance = -1.0}, "tolerance");
    names(bent<on_cylinder>{.solid = {.depth = 0.0f}}, "depth");
    CHECK(refused(bent<on_cylinder>{.how = {0.5}, .tolerance = 1e-7, .max_points = 1000}) == error::too_many_points);
    CHECK_FALSE(bent<on_cylinder>{}.refused_text({{0.0, 0.0}, {6.0, 1.0}}));
    CHECK(bent<on_cylinder>{}.refused_text({{0.0, 0.0}, {13.0, 1.0}}) == error::goes_around);
    CHECK(refused_options(bent<on_cylinder>{.how = {0.0}}) == error::bad_option);
}

TEST_CASE("bending fails cleanly without memory, and needs no more once it is warm", "[extrude][bent]")
{
    const auto letter = shapes::letter_e();
    const bent<on_cylinder> how{.how = {0.5}, .tolerance = 1.0 / 3000};
    std::size_t fails = 1;
    for (;; ++fails) {
        test::counting_memory scarce;
        scarce.fail_at = fails;
        plan_data_of<bent<on_cylinder>> data{scarce.source()};
        const auto m = bend(letter, how, data);
        if (m) break;
        REQUIRE(m.error() == error::out_of_memory);
        REQUIRE(fails < 1000);
    }
    CHECK(fails > 10);
    test::counting_memory counted;
    plan_data_of<bent<on_cylinder>> data{counted.source()};
    REQUIRE(bend(letter, how, data));
    const auto before = counted.requests;
    REQUIRE(bend(letter, how, data, {0.3, 0.0}));
    REQUIRE(bend(shapes::rectangle(), how, data));
    CHECK(counted.requests == before);
}
