// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/rim_refinement.hpp>

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/extrude/refined.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/glyph/region_caps.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_view.hpp>
#include <typemesh/refine/non_obtuse.hpp>
#include <typemesh/refine/quadtree_refined.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "mesh.hpp"
#include "support/bevel_surface.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/refined_cap.hpp"

#include <string>

using namespace typemesh;

static_assert(extruder<refined<bevelled>> && cacheable_policy<refined<bevelled, quadtree_refined>>);
static_assert(refinable_caps<bevelled> && !refinable_extruder<bevelled> && has_outline<refined<bevelled>>);
static_assert(refitting_extruder<refined<bevelled>> && !has_outline<refined<>>);

namespace {

/// A refiner of its own kind: it halves the first edge of the region so many times, each time a little off, and divides
/// the triangle there into a fan. It knows nothing of what lies beyond the edge.
struct reckless {
    std::int32_t off = 0;  ///< cells
    using scratch = buffer<triangle>;

    [[nodiscard]] error refused_options() const noexcept { return {}; }
    [[nodiscard]] option_bits cache_key() const noexcept { return {float(off)}; }
    [[nodiscard]] error operator()(const region& r, array_view<const triangle> cap, scratch&,
                                   const refined_cap& out) const noexcept
    {
        out.loops.clear();
        out.inner.clear();
        out.triangles.clear();
        const auto p = r.points();
        const grid_point a = p[0], b = p[1];
        const bool level = std::abs(b.x - a.x) > std::abs(b.y - a.y), grows = level ? b.x > a.x : b.y > a.y;
        const std::int32_t away = grows == level ? -off : off;
        grid_point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        (level ? middle.y : middle.x) += away;
        for (std::uint32_t i = 0; i < p.size(); ++i) {
            if (!out.loops.points.push_back(p[i]) || !out.loops.edges.push_back(r.edges()[i]))
                return error::out_of_memory;
            if (i == 0 && (!out.loops.points.push_back(middle) || !out.loops.edges.push_back(r.edges()[i])))
                return error::out_of_memory;
        }
        for (std::size_t k = 0; k < r.starts().size(); ++k)
            if (!out.loops.starts.push_back(r.starts()[k] + (k == 0 ? 0u : 1u))) return error::out_of_memory;
        const auto moved = [](std::uint32_t i) { return i == 0 ? 0 : i + 1; };
        for (const triangle t : cap) {
            const std::uint32_t c[] = {t.a, t.b, t.c};
            bool done = false;
            for (std::size_t k = 0; k < 3 && !done; ++k) {
                const std::uint32_t u = c[k], v = c[(k + 1) % 3], w = moved(c[(k + 2) % 3]);
                done = u == 0 && v == 1;
                if (done && (!out.triangles.push_back({0, 1, w}) || !out.triangles.push_back({1, 2, w})))
                    return error::out_of_memory;
            }
            if (!done && !out.triangles.push_back({moved(t.a), moved(t.b), moved(t.c)})) return error::out_of_memory;
        }
        out.loops.grid = r.grid();
        out.loops.tolerance = r.tolerance();
        out.loops.curves = r.curves();
        out.kept = 0;
        return {};
    }
};
static_assert(refiner<reckless>);

/// A refined solid in cells, and its plan.
template <class Refiner>
struct refined_bevel {
    plan_data_of<refined<bevelled, Refiner>> data;
    solid_plan plan;
    test::bevel_surface mesh;

    error make(const shapes::shape& s, const refined<bevelled, Refiner>& how)
    {
        static const monotone cut;
        cap_builder caps, further;
        region_caps maker{caps, further, cut, array_view<const triangle>{s.cap}};
        data.clear();
        const region r = s.made();
        const auto made = plan_solid(how, r, data, maker);
        if (!made) return made.error();
        plan = *made;
        mesh.sizes = plan.sizes;
        placement at;
        at.unit_per_depth = r.grid().cells * r.grid().units_per_em;
        at.em_per_cell = 1.0 / at.unit_per_depth;
        const solid_of<refined<bevelled, Refiner>> form{{r.points(), r.starts(), s.cap}, data.read()};
        return write_solid<refined<bevelled, Refiner>>({form, plan}, how, at, mesh).error();
    }
    [[nodiscard]] bool is_closed() const
    {
        return inspect::check_closedness(inspect::mesh_view{mesh.vertices, mesh.indices}).is_closed();
    }
    /// The laws of a bevel that is not outward: both sides cover the refined region once.
    [[nodiscard]] std::string broken()
    {
        contours boundary;
        const std::size_t own = data.loops.starts.back();
        REQUIRE(boundary.points.append(data.loops.points.view().first(own)));
        REQUIRE(boundary.edges.append(own));
        REQUIRE(boundary.starts.append(data.loops.starts.view()));
        return test::surface_laws{mesh, region::proven(boundary, 0, 0), false}.broken();
    }
    /// The cap within the bevel.
    test::refined_result cap()
    {
        test::refined_result out;
        bevel_data& bevel = data.data;
        const auto all = bevel.template of<grid_point>().view();
        const std::size_t count = bevel.template of<std::uint32_t>().back();
        REQUIRE(out.loops.points.append(all.first(count)));
        REQUIRE(out.loops.starts.append(bevel.template of<std::uint32_t>().view()));
        REQUIRE(out.loops.edges.append(count));
        REQUIRE(out.inner.append(all.subspan(count)));
        REQUIRE(out.triangles.append(bevel.template of<triangle>().view()));
        return out;
    }
    [[nodiscard]] region swept() const
    {
        std::uint32_t holes = 0, outers = 0;
        for (const auto& loop : inspect::loops_of(region::proven(data.data.swept.cap, 0, 0)))
            ++(inspect::doubled_area(loop) > 0 ? outers : holes);
        return region::proven(data.data.swept.cap, holes, outers);
    }
};

template <class Refiner>
void check_bevels(const Refiner& how, std::size_t& added)
{
    for (const auto& s : shapes::all())
        for (const bevel_sides sides : {bevel_sides::both, bevel_sides::front, bevel_sides::back})
            for (const bool outward : {false, true}) {
                INFO(s.name << (outward ? ", outward" : "") << ", sides " << int(sides));
                bevelled bevel{.width = 0.01f, .bevel_depth = 0.02f, .sides = sides, .outward = outward};
                bevel.profile = round_profile(2);
                refined_bevel<Refiner> made;
                REQUIRE_FALSE(made.make(s, {bevel, how}));
                CHECK(made.is_closed());
                if (!outward) CHECK(made.broken() == "");
                if (made.data.data.template of<triangle>().empty()) continue;
                const auto cap = made.cap();
                CHECK(test::broken_refinement(made.swept(), cap) == "");
                added += cap.loops.points.size() - made.swept().points().size() + cap.inner.size();
                const double longest = double(how.max_edge) * s.made().grid().cells * s.made().grid().units_per_em;
                const auto p = cap.points();
                std::size_t too_long = 0;
                for (const auto& [edge, apex] : test::edges_of(cap))
                    too_long += double(squared_distance(p[edge.first], p[edge.second])) > longest * longest;
                CHECK(too_long == 0);
            }
}

}  // namespace

TEST_CASE("bevelled solids of every refiner are closed, and caps, slopes and walls share every point",
          "[extrude][rim_refinement]")
{
    std::size_t by_delaunay = 0, by_squares = 0, right = 0;
    check_bevels(delaunay_refined{.max_edge = 0.05f}, by_delaunay);
    check_bevels(quadtree_refined{.max_edge = 0.05f}, by_squares);
    check_bevels(non_obtuse{.max_edge = 0.1f}, right);
    CHECK(by_delaunay > 1000);
    CHECK(by_squares > 1000);
    CHECK(right > 1000);
}

TEST_CASE("caps within bevels reach the least angle", "[extrude][rim_refinement]")
{
    std::size_t triangles = 0, below = 0;
    for (const auto& s : {shapes::letter_d(), shapes::letter_e(), shapes::rectangle()}) {
        INFO(s.name);
        refined_bevel<delaunay_refined> made;
        REQUIRE_FALSE(made.make(s, {{.width = 0.01f}, {.min_angle = 26.0f}}));
        const auto cap = made.cap();
        CHECK(test::is_delaunay(cap));
        triangles += cap.triangles.size();
        below += test::corners_below(cap, 25.999);
    }
    CHECK(triangles > 30);
    CHECK(below == 0);
}

TEST_CASE("a refiner that turns a bevel's triangles gets a narrower bevel, which is closed",
          "[extrude][rim_refinement]")
{
    const auto s = shapes::rectangle();
    for (const std::int32_t off : {0, 3, 400'000}) {
        CAPTURE(off);
        refined_bevel<reckless> made;
        REQUIRE_FALSE(made.make(s, {{.width = 0.02f}, {.off = off}}));
        CHECK(made.plan.narrowed == (off == 400'000));
        if (off != 400'000) {
            CHECK(made.is_closed());
            CHECK(made.broken() == "");
        }
    }
}

TEST_CASE("a refined bevelled solid without memory says so, and asks for none once it is warm",
          "[extrude][rim_refinement]")
{
    const auto letter = shapes::letter_d();
    const refined<bevelled> how{{.width = 0.01f, .sides = bevel_sides::front}, {.max_edge = 0.1f}};
    static const monotone cut;
    cap_builder caps, further;
    region_caps maker{caps, further, cut, array_view<const triangle>{letter.cap}};
    const auto plan = [&](plan_data_of<refined<bevelled>>& data) {
        data.clear();
        return plan_solid(how, letter.made(), data, maker);
    };
    plan_data_of<refined<bevelled>> plain;
    const auto wanted = plan(plain);
    REQUIRE(wanted);
    std::size_t refused = 0;
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        INFO("request " << nth);
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        plan_data_of<refined<bevelled>> data{memory.source()};
        const auto made = plan(data);
        was_asked = memory.requests >= nth;
        CHECK((was_asked || made));
        if (!made) CHECK(made.error() == error::out_of_memory);
        // The order of the points can be done without.
        if (made) CHECK(made->sizes.triangles.of[0] == wanted->sizes.triangles.of[0]);
        if (made) CHECK_FALSE(made->narrowed);
        refused += !made;
        memory.fail_at = 0;
        REQUIRE(plan(data));
        const std::size_t warm = memory.requests;
        REQUIRE(plan(data));
        CHECK(memory.requests == warm);
    }
    CHECK(refused > 30);
}
