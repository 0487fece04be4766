// SPDX-License-Identifier: MIT
//
// The memory that resolve() takes at most, and how it is limited.

#include <typemesh/fill/resolve.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

/// A star of n random points, drawn in one stroke.
test::shape random_star(int n, int reach, unsigned seed)
{
    test::dice d{seed};
    test::polyline l;
    for (int i = 0; i < n; ++i) l.push_back({d.roll(2 * reach + 1) - reach, d.roll(2 * reach + 1) - reach});
    return {"star of " + std::to_string(n) + " within " + std::to_string(reach), {l}};
}

/// Points on a circle, each joined with a nearly opposite one: every edge crosses nearly all others.
test::shape round_star(int n, double radius)
{
    test::polyline l;
    for (int i = 0; i < n; ++i) l.push_back(test::on_circle(0, 0, radius, test::turn_once * i * (n / 2) / n));
    return {"round star of " + std::to_string(n), {l}};
}

/// Long thin triangles side by side, which slant across each other.
test::shape needles(int n)
{
    test::shape s{"needles", {}};
    for (int i = 0; i < n; ++i) s.loops.push_back({{0, 3 * i}, {1000, 3 * (n - i)}, {1000, 3 * (n - i) + 2}});
    return s;
}

/// Copies of a five-pointed star, each moved a little.
test::shape stacked(int n)
{
    test::shape s{"stacked stars", {}};
    for (int i = 0; i < n; ++i) {
        test::polyline l;
        for (int k = 0; k < 5; ++k) l.push_back(test::on_circle(3 * i, 7 * i, 5000, test::turn_once * 2 * k / 5));
        s.loops.push_back(l);
    }
    return s;
}

/// Many upright teeth, and one edge that crosses them all.
test::shape comb(int n)
{
    test::polyline l;
    for (int i = 0; i < n; ++i) l.push_back({100 * i, i % 2 == 0 ? 0 : 9000});
    return {"comb", {l, {{-10, 4000}, {100 * n, 4500}, {100 * n, 4400}}}};
}

std::vector<test::shape> hostile()
{
    return {random_star(700, 200, 1),
            random_star(1000, 100'000, 2),
            round_star(301, 1000),
            round_star(301, 2e8),
            needles(120),
            stacked(40),
            comb(999),
            round_star(101, 20),
            {"one crossing", {test::circle(800, 100'000, 0, 0), test::circle(5, 2000, 100'000, 0)}},
            {"one crossing, rounded", {test::circle(6000, 100'000, 0, 0), test::circle(5, 2000, 100'000, 0)}}};
}

/// Needles side by side, and one that lies across the first of them: each crossing is one more piece.
test::shape crossed_needles(int n, int crossed)
{
    test::shape s{"needles crossed by one", {}};
    for (int i = 0; i < n; ++i)
        s.loops.push_back({{1000 * i, -100'000}, {1000 * i + 1, 100'001}, {1000 * i + 3, 100'000}});
    s.loops.push_back({{-5, 0}, {1000 * crossed, 333}, {1000 * crossed, 340}});
    return s;
}

}  // namespace

TEST_CASE("resolve() and a triangulation after it take 200 bytes a piece, 210 if it rounds", "[fill][resolve]")
{
    for (const test::shape& s : hostile()) {
        test::counting_memory memory;
        workspace space{memory.source()};
        for (int pass = 0; pass < 2; ++pass) {
            contours loops = test::contours_of(s);
            triangle_list out;
            resolve_effort effort;
            const auto made = resolve(loops, fill_rule::even_odd, space, {.effort = &effort});
            REQUIRE(made);
            REQUIRE_FALSE(monotone{}(*made, space, out));
            INFO(s.name << ": " << memory.peak << " bytes for " << effort.pieces << " pieces, rounds "
                        << effort.rounds);
            const std::size_t bytes_a_piece = effort.rounds == 0 ? 200 : 210;  // of the first pass, which is cold
            CHECK(memory.peak <= bytes_a_piece * effort.pieces + 16 * 1024);   // a block is never smaller
        }
        space.trim();
        CHECK(memory.bytes_held == 0);
        CHECK(space.capacity() == 0);
    }
}

TEST_CASE("resolve() takes 210 bytes a piece before it joins its blocks, however much it rounds", "[fill][resolve]")
{
    for (const int n : {30, 250, 450, 2000}) {
        for (int crossed = n / 5; crossed <= n; crossed += n / 5) {
            const test::shape s = crossed_needles(n, crossed);
            test::counting_memory memory;
            workspace space{memory.source()};
            for (int pass = 0; pass < 2; ++pass) {
                memory.peak = memory.bytes_held;
                contours loops = test::contours_of(s);
                resolve_effort effort;
                REQUIRE(resolve(loops, fill_rule::non_zero, space, {.effort = &effort}));
                INFO(n << " needles, " << crossed << " crossed: " << memory.peak << " bytes for " << effort.pieces
                       << " pieces, pass " << pass);
                const std::size_t blocks = (pass == 0 ? 2 : 1) * std::size_t{16 * 1024};
                CHECK(memory.peak <= (pass == 0 ? 210 : 200) * std::size_t{effort.pieces} + blocks);
            }
        }
    }
}

TEST_CASE("Contours of too many pieces are refused before they take memory", "[fill][resolve]")
{
    for (const test::shape& s : hostile()) {
        INFO(s.name);
        test::counting_memory memory;
        workspace space{memory.source()};
        contours loops = test::contours_of(s);
        const std::size_t n = loops.points.size();
        resolve_effort effort;
        {
            contours whole = test::contours_of(s);
            workspace other;
            REQUIRE(resolve(whole, fill_rule::non_zero, other, {.effort = &effort}));
        }
        const auto most = static_cast<std::uint32_t>(n + n / 2);
        const auto made = resolve(loops, fill_rule::non_zero, space, {.max_pieces = most});
        if (effort.pieces <= most) {
            CHECK(made);
            continue;
        }
        REQUIRE_FALSE(made);
        CHECK(made.error() == error::too_many_pieces);
        CHECK(made.error().count == most);
        CHECK(memory.peak <= 200 * std::size_t{most} + 16 * 1024);
        CHECK(std::ranges::equal(loops.points, test::contours_of(s).points));
        const auto all = resolve(loops, fill_rule::non_zero, space);
        CHECK(all);
    }
}

TEST_CASE("Random points crowded on a small grid are rounded once", "[fill][resolve]")
{
    for (const auto& [n, reach] : {std::pair{700, 200}, std::pair{2000, 1000}, std::pair{300, 10}}) {
        for (unsigned seed = 1; seed <= 2; ++seed) {
            const test::shape s = random_star(n, reach, seed);
            INFO(s.name);
            contours loops = test::contours_of(s);
            workspace space;
            resolve_effort effort;
            REQUIRE(resolve(loops, fill_rule::non_zero, space, {.effort = &effort}));
            CHECK(effort.rounds == 1);
            CHECK(effort.sweeps <= 4);
        }
    }
}

TEST_CASE("A limit of one piece less than needed is refused", "[fill][resolve]")
{
    std::vector<test::shape> shapes = hostile();
    shapes.push_back({"two crossings", {test::circle(400, 100'000, 0, 0), test::circle(400, 100'000, 150'000, 0)}});
    for (const test::shape& s : shapes) {
        INFO(s.name);
        workspace space;
        resolve_effort effort;
        contours loops = test::contours_of(s);
        REQUIRE(resolve(loops, fill_rule::non_zero, space, {.effort = &effort}));
        loops = test::contours_of(s);
        const auto made = resolve(loops, fill_rule::non_zero, space, {.max_pieces = effort.pieces - 1});
        REQUIRE_FALSE(made);
        CHECK(made.error() == error::too_many_pieces);
        CHECK(loops.points.size() == test::contours_of(s).points.size());
    }
}
