// SPDX-License-Identifier: MIT

#include <typemesh/refine/impl/write_cap.hpp>

#include "support/counting_memory.hpp"
#include "support/refined_shape.hpp"

using namespace typemesh;
using detail::refinable_mesh;

namespace {

struct opened_mesh {
    test::filled_shape shape;
    refinable_mesh mesh;

    explicit opened_mesh(const test::shape& s) : shape{s}
    {
        workspace space;
        triangle_list given;
        REQUIRE_FALSE(constrained_delaunay{}(shape.filled, space, given));
        REQUIRE(mesh.open(shape.filled, given.view()));
    }
};

}  // namespace

TEST_CASE("a cap to which nothing was added is written as the region itself", "[refine]")
{
    for (const test::shape& s : test::generated_regions()) {
        if (!inspect::is_region(test::loops_of(s)) || s.loops[0].size() > 1000) continue;
        INFO(s.name);
        opened_mesh opened{s};
        buffer<std::uint32_t> numbers;
        test::refined_result out;
        REQUIRE_FALSE(write_cap(opened.mesh, opened.shape.filled, numbers, out.out()));
        CHECK(test::broken_refinement(opened.shape.filled, out) == "");
        CHECK(out.inner.empty());
        const region& r = opened.shape.filled;
        CHECK(std::equal(out.loops.points.begin(), out.loops.points.end(), r.points().begin(), r.points().end()));
        CHECK(std::equal(out.loops.starts.begin(), out.loops.starts.end(), r.starts().begin(), r.starts().end()));
    }
}

TEST_CASE("a cap is written with the points inside behind those on the boundary, whatever was added first", "[refine]")
{
    opened_mesh opened{test::square_with_holes(2, 8, 100'000)};
    test::dice d{3};
    std::size_t inside = 0, split = 0;
    for (int round = 0; round < 300; ++round) {
        const auto t = static_cast<std::uint32_t>(d.roll(static_cast<std::int32_t>(opened.mesh.triangle_count())));
        const std::uint32_t h = 4 * t + static_cast<std::uint32_t>(d.roll(3));
        const grid_point a = opened.mesh.start(h), b = opened.mesh.place(opened.mesh.target(h)),
                         c = opened.mesh.place(opened.mesh.apex(h));
        if (opened.mesh.is_boundary(h)) {
            const grid_point middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
            if (orientation(a, b, middle) < 0 || orientation(a, middle, c) <= 0 || orientation(middle, b, c) <= 0)
                continue;
            REQUIRE(opened.mesh.split(opened.mesh.origin(h), middle, 0.5f) != refinable_mesh::none);
            ++split;
        } else {
            const grid_point third{(a.x + b.x + c.x) / 3, (a.y + b.y + c.y) / 3};
            if (orientation(a, b, third) <= 0 || orientation(b, c, third) <= 0 || orientation(c, a, third) <= 0)
                continue;
            REQUIRE(opened.mesh.insert(t, third) != refinable_mesh::none);
            ++inside;
        }
    }
    REQUIRE(inside > 50);
    REQUIRE(split > 10);
    const region& r = opened.shape.filled;
    buffer<std::uint32_t> numbers;
    test::refined_result out;
    REQUIRE_FALSE(write_cap(opened.mesh, r, numbers, out.out()));
    CHECK(test::broken_refinement(r, out) == "");
    CHECK(out.inner.size() == inside);
    CHECK(out.loops.points.size() == r.points().size() + split);
    CHECK(out.loops.curves.data() == r.curves().data());
    CHECK(out.loops.tolerance == r.tolerance());
    // Points that lie on one edge of the region follow each other in the order of their parameters.
    for (std::size_t i = 0; i + 1 < out.loops.points.size(); ++i)
        if (out.loops.edges[i].curve == out.loops.edges[i + 1].curve)
            CHECK_QUICKLY(out.loops.edges[i].t1 == out.loops.edges[i + 1].t0);

    // Written once more, and into memory that held another cap, it is the same.
    test::refined_result again;
    opened_mesh other{{"triangle", {{{0, 0}, {5000, 1}, {2, 7000}}}}};
    REQUIRE_FALSE(write_cap(other.mesh, other.shape.filled, numbers, again.out()));
    REQUIRE_FALSE(write_cap(opened.mesh, r, numbers, again.out()));
    CHECK(again.points() == out.points());
    CHECK(std::equal(again.triangles.begin(), again.triangles.end(), out.triangles.begin(), out.triangles.end()));
}

TEST_CASE("a cap that is written without memory says so", "[refine]")
{
    opened_mesh opened{test::square_with_holes(2, 8)};
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        buffer<std::uint32_t> numbers{memory.source()};
        test::refined_result out{memory.source()};
        const error e = write_cap(opened.mesh, opened.shape.filled, numbers, out.out());
        was_asked = memory.requests >= nth;
        CHECK((e == error::out_of_memory) == was_asked);
    }
}
