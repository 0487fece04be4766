// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/reflex_joins.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/kinetic.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

using namespace typemesh;
using detail::fixed_vector;
using detail::join_rule;
using detail::time_one;
using test::kinetic_triangles;

namespace {

constexpr double half_turn = test::turn_once / 2;

struct joined {
    detail::wavefront front;
    std::vector<std::pair<std::uint32_t, fixed_vector>> emitted;
    error failed;

    joined(const test::shape& s, const join_rule& rule, memory source = heap()) : front{source}
    {
        test::set_up(front, s);
        detail::reflex_joins joins{front};
        failed = joins.add(rule, [&](std::uint32_t v, fixed_vector inward) {
            emitted.emplace_back(v, inward);
            return error{};
        });
    }
    [[nodiscard]] std::size_t count_at(grid_point p) const
    {
        std::size_t count = 0;
        for (const auto& [v, inward] : emitted) count += front.nodes[v].at == p;
        return count;
    }
};

/// The angle by which the boundary turns right from one line to the next: negative for left turns.
double right_turn(const detail::moving_line& before, const detail::moving_line& after)
{
    return -std::atan2(static_cast<double>(detail::cross(before.along, after.along)),
                       static_cast<double>(detail::dot(before.along, after.along)));
}
double mitre(const kinetic_triangles::vertex& v)
{
    return std::hypot(static_cast<double>(v.moves.speed.of.x), static_cast<double>(v.moves.speed.of.y)) * 0x1p-32;
}

/// The lines from the edge before a corner to the edge after it, over the joins in between.
std::vector<detail::moving_line> lines_around(const kinetic_triangles& mesh, std::uint32_t v, std::uint32_t corners)
{
    std::vector<detail::moving_line> lines{mesh.lines[mesh.segments[mesh.vertices[v].before].line]};
    std::uint32_t s = mesh.vertices[v].after;
    for (; s >= corners; s = mesh.vertices[mesh.segments[s].to].after)
        lines.push_back(mesh.lines[mesh.segments[s].line]);
    lines.push_back(mesh.lines[mesh.segments[s].line]);
    return lines;
}

/// Everything that is true of every wavefront with joins.
void check_front(const joined& j, std::uint32_t corners)
{
    const kinetic_triangles& mesh = j.front.mesh;
    const std::size_t joins = j.emitted.size();
    CHECK(test::broken_link(mesh) == "");
    CHECK(mesh.segments.size() == corners + joins);
    CHECK(mesh.lines.size() == corners + joins);
    CHECK(mesh.vertices.size() == corners + joins);
    CHECK(j.front.node_of.size() == mesh.vertices.size());
    CHECK(j.front.live[0] == mesh.segments.size());
    for (std::uint32_t s = corners; s < mesh.segments.size(); ++s) {
        const auto& [v, inward] = j.emitted[s - corners];
        const auto& one = mesh.segments[s];
        CHECK_QUICKLY(one.line == s && one.component == 0 && inward.x == mesh.lines[s].inward().x &&
                      inward.y == mesh.lines[s].inward().y);
        for (const std::uint32_t end : {one.from, one.to}) {
            const auto &start = mesh.vertices[end].moves.start, &at = mesh.vertices[v].moves.start;
            CHECK_QUICKLY(start.x == at.x && start.y == at.y && j.front.node_of[end] == v);
        }
    }
    // As soon as it moves, every triangle has area.
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto place = [&](int k) { return mesh.vertices[mesh.triangles[t].corner[k]].moves.place(time_one / 8); };
        CHECK_QUICKLY(detail::cross(place(1) - place(0), place(2) - place(0)) > 0);
    }
}

const test::shape square_hole{"square hole",
                              {test::square(0, 0, 3000), test::reversed(test::square(1000, 1000, 1000))}};

/// A square with a cut from above, of this width at the top.
test::shape slit(std::int32_t width)
{
    const std::int32_t end = 60'000, half = 30'000;
    return {"slit",
            {{{0, 0}, {end, 0}, {end, end}, {half + width, end}, {half, 20'000}, {half - width, end}, {0, end}}}};
}

}  // namespace

TEST_CASE("a needle's tip is no reflex corner when its sides are opposite after rounding", "[offset]")
{
    constexpr std::int32_t end = 1 << 28;
    for (const test::polyline& l : {test::polyline{{0, -end}, {1, 0}, {1, 1}},
                                    {{0, end / 3}, {1, 0}, {1, 1}},
                                    {{1, 1}, {end - 1, -end + 1}, {end, -end}}}) {
        const test::polyline needle = test::oracle::doubled_area(l) > 0 ? l : test::reversed(l);
        for (const double limit : {0.0, 1.5, 100.0}) {
            const joined made{{"needle", {needle}}, {limit, 0.0, 1e6}};
            CHECK_FALSE(made.failed);
            CHECK(made.emitted.empty());
        }
    }
}

TEST_CASE("joins turn a corner in equal steps within the limit, and only as many as needed", "[offset][reflex_joins]")
{
    test::dice d{1};
    std::size_t joins = 0, corners_with = 0, corners_without = 0;
    for (int i = 0; i < 200; ++i) {
        const auto seed = static_cast<std::uint64_t>(i);
        const test::shape s = i % 3 == 0 ? test::circle_with_holes(8 + d.roll(40), 1 + d.roll(9))
                                         : test::shape{"star", {test::star(5 + d.roll(90), 1'000'000, seed)}};
        const double limit = i % 4 == 0 ? 1.01 + d.fraction() / 10 : 1.05 + 3 * d.fraction();
        joined j{s, {limit, 1000.0, 0.0}};
        INFO(s);
        REQUIRE(!j.failed);
        const kinetic_triangles& mesh = j.front.mesh;
        const auto corners = static_cast<std::uint32_t>(mesh.vertices.size() - j.emitted.size());
        check_front(j, corners);
        joins += j.emitted.size();
        for (std::uint32_t v = 0; v < corners; ++v) {
            const auto lines = lines_around(mesh, v, corners);
            const double all = right_turn(lines.front(), lines.back()), steps = static_cast<double>(lines.size()) - 1.0;
            const double step = all / steps;
            const auto within = [&](double turn) { return std::cos(turn / 2) * limit >= 1.0 - 1e-5; };
            bool kept = all <= 0.0 || all < 0.05 || within(step);
            for (std::size_t k = 0; k + 1 < lines.size() && steps > 1.0; ++k)
                kept = kept && std::fabs(right_turn(lines[k], lines[k + 1]) - step) < 1e-7;
            for (std::uint32_t at = v; steps > 1.0; at = mesh.segments[mesh.vertices[at].after].to) {
                kept = kept && mitre(mesh.vertices[at]) <= limit * 1.0001;
                if (mesh.vertices[at].after < corners) break;
            }
            const bool needed = steps < 1.5 || (all > 0.0 && std::cos(step) * limit < 1.0);
            if (!kept || !needed) {
                CAPTURE(v, limit, all, steps);
                CHECK((kept && needed));
            }
            ++(steps > 1.0 ? corners_with : corners_without);
        }
    }
    CHECK(joins > 1000);
    CHECK(corners_with > 500);
    CHECK(corners_without > 500);
}

TEST_CASE("joins are as round as the tolerance at the width, with up to 31 a corner", "[offset][reflex_joins]")
{
    std::size_t last = 1;
    for (const double tolerance : {100.0, 10.0, 3.0, 1.0, 0.1}) {
        const joined j{square_hole, {1.2, 400.0, tolerance}};
        REQUIRE(!j.failed);
        check_front(j, 8);
        const std::size_t joins = j.emitted.size() / 4;
        CHECK(j.emitted.size() == 4 * joins);
        const double step = half_turn / 2 / static_cast<double>(joins + 1);
        CHECK((joins == 31 || 400.0 * (1.0 - std::cos(step / 2)) <= tolerance));
        CHECK((joins == 1 || 400.0 * (1.0 - std::cos(step)) > tolerance));
        CHECK(joins >= last);
        last = joins;
    }
    CHECK(last == 31);
}

TEST_CASE("corners within the limit, flat corners and left turns get no joins", "[offset][reflex_joins]")
{
    CHECK(joined{square_hole, {0.0, 400.0, 1.0}}.emitted.empty());             // no limit
    CHECK(joined{square_hole, {std::sqrt(2.0), 400.0, 1.0}}.emitted.empty());  // exactly at it
    CHECK(joined{square_hole, {1.4, 400.0, 0.0}}.emitted.size() == 4);         // only at the hole
    CHECK(joined{{"square", {test::square(0, 0, 9)}}, {1.0, 9.0, 0.1}}.emitted.empty());
    const test::shape flat{"flat", {{{0, 0}, {40'000, 0}, {40'000, 40'000}, {20'000, 39'600}, {0, 40'000}}}};
    CHECK(joined{flat, {1.0, 400.0, 0.0}}.emitted.empty());
    CHECK(joined{flat, {0.5, 400.0, 0.0}}.emitted.empty());
}

TEST_CASE("a limit near 1 keeps corners within the tolerance of the arc, with few joins", "[offset][reflex_joins]")
{
    constexpr double width = 1000.0;
    std::size_t fewer = 0;
    for (const double limit : {1.0, 1.01, 1.1, 1.3}) {
        for (const double tolerance : {0.5, 5.0, 50.0, 300.0, 3000.0}) {
            for (const bool round : {false, true}) {
                CAPTURE(limit, tolerance, round);
                const joined j{slit(1), {limit, width, tolerance, round}};
                REQUIRE(!j.failed);
                check_front(j, 7);
                const auto mitre_of = [](std::size_t joins) {
                    return 1.0 / std::cos(half_turn / 2 / static_cast<double>(joins + 1));
                };
                const double promised = (std::max)(limit, 1.0 + tolerance / width) * 1.0001;
                const std::size_t joins = j.emitted.size();
                CHECK((joins == 31 || mitre_of(joins) <= promised));
                if (!round && joins > 1) CHECK(mitre_of(joins / 2) > (std::min)(promised, std::sqrt(2.0)));
                const joined exact{slit(1), {limit, width, 0.0}};
                if (!round) CHECK(joins <= exact.emitted.size());
                fewer += joins < exact.emitted.size();
            }
        }
    }
    CHECK(fewer > 10);
    CHECK(joined{slit(1), {1.0, width, 3000.0}}.emitted.size() == 1);  // a needle's tip is joined at any tolerance
    CHECK(joined{square_hole, {1.0, 100.0, 50.0}}.emitted.empty());    // its corners are within it without joins
    CHECK(joined{square_hole, {1.0, 100.0, 40.0}}.emitted.size() == 4);
}

TEST_CASE("slits of any width get joins", "[offset][reflex_joins]")
{
    for (const std::int32_t width : {10'000, 100, 1}) {
        for (const double limit : {1.0, 1.05, 1.5, 2.0}) {
            const joined j{slit(width), {limit, 400.0, 0.0}};
            REQUIRE(!j.failed);
            check_front(j, 7);
            const std::size_t at_end = j.count_at({30'000, 20'000});
            CHECK(at_end == j.emitted.size());
            CHECK(at_end % 2 == 1);
            const auto& middle = j.emitted[at_end / 2].second;
            CHECK(std::abs(middle.x) <= 1);
            CHECK(middle.y == -detail::unit_one);
            CHECK(at_end == (limit == 1.0 ? 31u : limit == 1.05 ? 7u : 1u));
        }
    }
}

TEST_CASE("a limit that no corner can keep gets the most joins", "[offset][reflex_joins]")
{
    const joined j{square_hole, {0.5, 400.0, 0.0}};
    CHECK(!j.failed);
    CHECK(j.emitted.size() == 4 * 31);
    check_front(j, 8);
}

TEST_CASE("joins fail when memory runs out or their callback fails", "[offset][reflex_joins]")
{
    test::counting_memory counted, before_joins;
    REQUIRE(!joined{square_hole, {1.01, 400.0, 0.01}, counted.source()}.failed);
    {
        detail::wavefront front{before_joins.source()};
        test::set_up(front, square_hole);
    }
    REQUIRE(counted.requests > before_joins.requests);
    for (std::size_t at = before_joins.requests + 1; at <= counted.requests; ++at) {
        test::counting_memory limited{.fail_at = at};
        CHECK(joined{square_hole, {1.01, 400.0, 0.01}, limited.source()}.failed == error::out_of_memory);
    }

    detail::wavefront front{heap()};
    test::set_up(front, square_hole);
    const std::size_t before = front.mesh.segments.size();
    detail::reflex_joins joins{front};
    CHECK(joins.add({1.2, 400.0, 0.0}, [](std::uint32_t, fixed_vector) { return error{error::index_overflow}; }) ==
          error::index_overflow);
    CHECK(front.mesh.segments.size() == before);
}
