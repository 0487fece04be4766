// SPDX-License-Identifier: MIT

#include <typemesh/fill/impl/arrangement.hpp>

#include "fill/taken_apart.hpp"

#include <map>

using namespace typemesh;

namespace {

test::shape random_shape(test::dice& d)
{
    return test::random_polylines(d, 1 + d.roll(3), 1, 9, [&](const test::polyline&, int) {
        const std::int32_t x = d.roll(7) - 3;
        return grid_point{x, d.roll(7) - 3};
    });
}

/// Whether the turns into every point equal the turns out of it, as in closed contours.
bool is_closed(const detail::arrangement& a)
{
    std::map<std::int64_t, int> sum;
    for (std::uint32_t i = 0; i < a.count; ++i) {
        sum[detail::sweep_place(a.segments[i].from)] += a.segments[i].winding_delta;
        sum[detail::sweep_place(a.segments[i].to)] -= a.segments[i].winding_delta;
    }
    for (const auto& [place, turns] : sum)
        if (turns != 0) return false;
    return true;
}

bool is_in_order(const detail::arrangement& a)
{
    for (std::uint32_t i = 1; i < a.point_count; ++i)
        if (!lexicographic_less(a.points[i - 1], a.points[i])) return false;
    std::vector<int> listed(a.count, 0);
    for (std::uint32_t v = 0; v < a.point_count; ++v) {
        for (std::uint32_t i = a.first[v]; i != detail::no_number; i = a.segments[i].next) {
            const detail::segment& s = a.segments[i];
            if (s.start != v || !(s.from == a.points[v]) || !(s.to == a.points[s.end])) return false;
            if (!lexicographic_less(s.from, s.to)) return false;
            ++listed[i];
        }
    }
    return std::count(listed.begin(), listed.end(), 1) == static_cast<std::ptrdiff_t>(listed.size());
}

}  // namespace

TEST_CASE("Contours taken apart are closed and in order, with one segment for each edge", "[fill][arrangement]")
{
    test::dice d{61};
    for (int i = 0; i < 2000; ++i) {
        const test::shape s = random_shape(d);
        const taken_apart apart{s.loops, 64};
        const detail::arrangement& a = apart.a;
        std::uint32_t edges = 0;
        for (const auto& l : s.loops)
            for (std::size_t k = 0; k < l.size(); ++k) edges += !(l[k] == l[(k + 1) % l.size()]);
        INFO(s);
        REQUIRE(a.count == edges);
        REQUIRE(is_in_order(a));
        CHECK(is_closed(a));
        for (std::uint32_t k = 0; k < a.count; ++k) {
            const detail::segment& segment = a.segments[k];
            const auto [from, to] = a.home(segment);
            CHECK((segment.winding_delta == 1 ? from : to) == segment.from);
            CHECK((segment.winding_delta == 1 ? to : from) == segment.to);
            CHECK(segment.source.t0 == (segment.winding_delta == 1 ? 0.25f : 0.75f));
        }
    }
}

TEST_CASE("Segments flipped at random are in order again after put_in_order()", "[fill][arrangement]")
{
    test::dice d{62};
    for (int i = 0; i < 1000; ++i) {
        taken_apart apart{random_shape(d).loops, 64};
        detail::arrangement& a = apart.a;
        std::uint32_t cancelled = 0;
        if (a.count != 0 && d.roll(2) == 0) {  // an edge and its reverse
            a.segments[a.count] = a.segments[0];
            a.segments[0].winding_delta = 0;
            a.segments[a.count].winding_delta = 0;
            ++a.count;
            cancelled = 2;
        }
        const std::uint32_t before = a.count;
        for (std::uint32_t k = 0; k < a.count; ++k)
            if (d.roll(2) == 0) a.segments[k].flip();
        REQUIRE(a.reserve(apart.scratch, 100));  // keeps what is there
        REQUIRE(a.put_in_order(apart.space));
        CHECK(a.count == before - cancelled);
        CHECK(is_in_order(a));
    }
}

TEST_CASE("t_at() is linear along the longer side, and point_at() undoes sweep_place()", "[fill][arrangement]")
{
    detail::segment s{{-4, 8}, {4, -8}, 0, 1, 1, 0, {5, 0.0f, 1.0f}, 0, 0, 0, 0, 0};
    CHECK(s.t_at({-4, 8}) == 0.0f);
    CHECK(s.t_at({0, 0}) == 0.5f);
    CHECK(s.t_at({4, -8}) == 1.0f);
    s.flip();
    CHECK(s.from == grid_point{4, -8});
    CHECK(s.t_at({2, -4}) == 0.75f);
    CHECK(s.winding_delta == -1);
    test::dice d{63};
    for (int i = 0; i < 1000; ++i) {
        const grid_point p{d.roll(1 << 29) - (1 << 28), d.roll(1 << 29) - (1 << 28)};
        const grid_point q{p.x + d.roll(3) - 1, p.y + d.roll(3) - 1};
        CHECK(detail::point_at(detail::sweep_place(p)) == p);
        CHECK((detail::sweep_place(p) < detail::sweep_place(q)) == lexicographic_less(p, q));
    }
}
