// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/curved_boundary.hpp>

#include "shapes.hpp"
#include "support/catch.hpp"

#include <cmath>

using namespace typemesh;

namespace {

/// The pieces follow each other around their loops, and none meet.
void check_pieces(const detail::curved_boundary& made, std::uint32_t loops)
{
    const auto pieces = made.pieces();
    std::uint32_t begun = 0;
    std::size_t first = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        if (pieces[i].begins_loop) {
            first = i;
            ++begun;
        }
        const bool last = i + 1 == pieces.size() || pieces[i + 1].begins_loop;
        CHECK(pieces[i].end == pieces[last ? first : i + 1].start);
        for (std::size_t k = 0; k < i; ++k) CHECK_FALSE(pieces_meet(pieces[i], pieces[k]));
    }
    CHECK(begun == loops);
}

std::size_t arcs_in(const detail::curved_boundary& made)
{
    std::size_t arcs = 0;
    for (const auto& p : made.pieces()) arcs += !p.is_straight();
    return arcs;
}

}  // namespace

TEST_CASE("pieces of a boundary follow each other and do not meet", "[extrude][curved]")
{
    detail::curved_boundary made;
    for (const auto& s : shapes::all()) {
        INFO(s.name);
        REQUIRE_FALSE(made.find(s.made()));
        check_pieces(made, s.contour_count());
        CHECK(made.moved() == 0);
    }
}

TEST_CASE("edges of one curve become one piece, wherever their loop begins", "[extrude][curved]")
{
    for (const int pieces : {2, 4, 16}) {
        CAPTURE(pieces);
        shapes::shape s{"disc", {shapes::quadratic_circle({0, 0}, 400)}, {}, pieces};
        // The loop begins inside of a curve.
        const auto n = s.points();
        std::vector<grid_point> points(s.loops.points.begin(), s.loops.points.end());
        std::vector<contour_edge> edges(s.loops.edges.begin(), s.loops.edges.end());
        for (std::uint32_t i = 0; i < n; ++i) {
            s.loops.points[i] = points[(i + 1) % n];
            s.loops.edges[i] = edges[(i + 1) % n];
        }
        detail::curved_boundary made;
        REQUIRE_FALSE(made.find(s.made()));
        CHECK(made.pieces().size() == 8);
        CHECK(arcs_in(made) == 8);
        check_pieces(made, 1);
    }
}

TEST_CASE("arcs are not taken over points that they do not pass", "[extrude][curved]")
{
    // The boundary has been moved away from the curves, and one point farther: that one stays.
    shapes::shape s{"disc", {shapes::quadratic_circle({0, 0}, 400)}, {}, 8};
    s.loops.points[4] = {s.loops.points[4].x - 200, s.loops.points[4].y - 200};
    detail::curved_boundary made;
    REQUIRE_FALSE(made.find(s.made()));
    bool has_point = false;
    for (const auto& p : made.pieces()) has_point = has_point || p.start == s.loops.points[4];
    CHECK(has_point);
    CHECK(made.pieces().size() > 9);
    check_pieces(made, 1);
}

TEST_CASE("control triangles that meet are divided, and no more than necessary", "[extrude][curved]")
{
    // A crescent: the inner arc is so close to the outer arc that its triangle crosses it.
    const auto crescent = [](double gap) {
        return shapes::shape{
            "crescent",
            {{shapes::quad({0, 0}, {500, 600}, {1000, 0}), shapes::line({1000, 0}, {1000 - gap, 0}),
              shapes::quad({1000 - gap, 0}, {500, 600 - 2 * gap}, {gap, 0}), shapes::line({gap, 0}, {0, 0})}},
            {},
            64};
    };
    std::size_t before = 0;
    for (const double gap : {400.0, 40.0, 4.0}) {
        const auto s = crescent(gap);
        detail::curved_boundary made;
        REQUIRE_FALSE(made.find(s.made()));
        check_pieces(made, 1);
        CHECK(arcs_in(made) >= before);
        before = arcs_in(made);
    }
    CHECK(before > 8);
    CHECK(before < 100);
}

TEST_CASE("crossings of chords are moved to the crossings of their curves", "[extrude][curved]")
{
    // Two arcs over one base, which cross at the top. The chords' crossing is not the curves'.
    const auto left = shapes::quad({0, 0}, {0, 800}, {600, 800}),
               right = shapes::quad({400, 800}, {1000, 800}, {1000, 0});
    shapes::shape s{"arch", {{left, right, shapes::line({1000, 0}, {0, 0})}}, {}, 8};
    // By symmetry they cross at x = 500. Edges end 100 cells beside it.
    const auto at_500 = [](const curve& c) {
        double low = 0.0, high = 1.0;
        for (int i = 0; i < 60; ++i) (c.at(0.5 * (low + high)).x < 500.0 ? low : high) = 0.5 * (low + high);
        return low;
    };
    const double of_left = at_500(left), of_right = at_500(right);
    const point crossing = 512.0 * left.at(of_left);
    std::size_t moved = 0;
    for (std::uint32_t i = 0; i < s.points(); ++i) {
        contour_edge &e = s.loops.edges[s.previous(i)], &f = s.loops.edges[i];
        if (e.curve == f.curve) continue;
        const bool from_left = e.curve == 0 && f.curve == 1, from_right = e.curve == 1 && f.curve == 0;
        if (!from_left && !from_right) continue;
        (from_left ? e.t1 : f.t0) = static_cast<float>(of_left - 1e-4);
        (from_left ? f.t0 : e.t1) = static_cast<float>(of_right + 1e-4);
        s.loops.points[i] = {static_cast<std::int32_t>(crossing.x), static_cast<std::int32_t>(crossing.y) - 100};
        ++moved;
    }
    REQUIRE(moved == 1);
    s.loops.tolerance = 200.0;
    detail::curved_boundary made;
    REQUIRE_FALSE(made.find(s.made()));
    CHECK(made.moved() == 1);
    double nearest = 1e9;
    for (const auto& p : made.pieces())
        nearest = (std::min)(nearest, length(detail::curve_section::exact(p.start) - crossing));
    CHECK(nearest < 1.5);
    check_pieces(made, 1);
    // It stays if an edge that becomes longer for it would then lie farther from its curve than the tolerance.
    s.loops.tolerance = 150.0;
    REQUIRE_FALSE(made.find(s.made()));
    CHECK(made.moved() == 0);
}
