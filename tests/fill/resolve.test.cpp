// SPDX-License-Identifier: MIT

#include <typemesh/fill/resolve.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

std::uint32_t most_walks = 0, rounded = 0, all_shapes = 0;

/// Whether contours of small coordinates cross in grid points only, so that nothing needs to be bent.
bool is_exact(const std::vector<test::oracle::loop>& loops)
{
    std::vector<std::pair<grid_point, grid_point>> edges;
    for (const auto l : loops)
        for (std::size_t i = 0; i < l.size(); ++i) edges.emplace_back(l[i], l[(i + 1) % l.size()]);
    for (const auto& [a, b] : edges) {
        if (std::abs(a.x) > 5000 || std::abs(a.y) > 5000) return false;
        for (const auto& [c, d] : edges) {
            grid_point x;
            if (crossing_of(a, b, c, d, x) && test::oracle::side(a, b, x) != 0) return false;
        }
    }
    return true;
}

/// What is wrong with what resolve() makes of a shape under a rule; empty when nothing is.
///
/// The walks must be walks, and fill what the contours fill: at every grid point (of `samples` by `samples` round the shape)
/// farther than a cell or so from all contours. Where nothing was bent the areas are equal.
std::string mistake_on(const test::shape& s, fill_rule rule, int samples = 12)
{
    contours loops = test::contours_of(s);
    workspace space;
    resolve_effort effort;
    const result<region> made = resolve(loops, rule, space, &effort);
    most_walks = (std::max)(most_walks, effort.walks);
    rounded += effort.rounded;
    ++all_shapes;
    if (!made) return made.error().message();
    const auto given = test::loops_of(s), kept = test::oracle::loops_of(*made);
    if (std::string broken = test::oracle::broken_walk(kept); !broken.empty()) return broken;
    std::uint32_t holes = 0, outers = 0;
    for (const auto l : kept) ++(test::oracle::doubled_area(l) > 0 ? outers : holes);
    if (holes != made->holes() || outers != made->outers()) return "holes and outer loops are miscounted";
    if (made->edges().size() != made->points().size()) return "not an edge a point";

    std::vector<std::uint64_t> places;
    for (const grid_point p : made->points()) places.push_back(detail::sweep_place(p));
    std::sort(places.begin(), places.end());
    if ((std::adjacent_find(places.begin(), places.end()) != places.end()) != made->is_touching())
        return "is_touching() is wrong";

    triangle_list triangles;
    if (const error e = monotone{}(*made, space, triangles)) return e.message();
    if (std::string law = test::oracle::broken_law(*made, triangles.view()); !law.empty()) return law;

    std::int32_t left = 1 << 29, right = -left, bottom = left, top = -left;
    for (const auto& l : s.loops) {
        for (const grid_point p : l) {
            left = (std::min)(left, p.x), right = (std::max)(right, p.x);
            bottom = (std::min)(bottom, p.y), top = (std::max)(top, p.y);
        }
    }
    const double area = test::oracle::doubled_filled_area(given, rule),
                 mine = static_cast<double>(test::oracle::doubled_area(kept));
    double length = 0;
    for (const auto& l : s.loops)
        for (std::size_t i = 0; i < l.size(); ++i)
            length += std::hypot(double(l[i].x) - l[(i + 1) % l.size()].x, double(l[i].y) - l[(i + 1) % l.size()].y);
    const bool exact = is_exact(given);
    if (exact ? std::fabs(area - mine) > 1e-9 * (area + 1) : std::fabs(area - mine) > 2 * length + 4)
        return "the area is not what the contours fill";
    if (right < left) return {};
    for (int i = 0; i < samples; ++i) {
        for (int k = 0; k < samples; ++k) {
            const grid_point p{left + static_cast<std::int32_t>(std::int64_t{right - left} * i / samples),
                               bottom + static_cast<std::int32_t>(std::int64_t{top - bottom} * k / samples)};
            const double far_off = test::oracle::distance(given, p);
            if (exact ? far_off == 0 : far_off < 1.5) continue;
            const std::int32_t w = test::oracle::winding(kept, p);
            if (w != (is_filled(rule, test::oracle::winding(given, p)) ? 1 : 0)) return "a place is filled wrongly";
        }
    }
    return {};
}

std::string mistake_on(const test::shape& s)
{
    const std::string m = mistake_on(s, fill_rule::non_zero);
    return m.empty() ? mistake_on(s, fill_rule::even_odd) : "even_odd: " + m;
}

}  // namespace

TEST_CASE("resolve() makes regions of random polylines on tiny grids", "[fill][resolve]")
{
    test::dice d{21};
    int mistakes = 0;
    for (int i = 0; i < 40'000 && mistakes < 3; ++i) {
        const int width = 2 + d.roll(8), scale = 1 << d.roll(7), count = 1 + d.roll(4);
        test::shape s{"polylines " + std::to_string(i), {}};
        for (int c = 0; c < count; ++c) {
            test::polyline l;
            for (int n = 1 + d.roll(count == 1 ? 16 : 8); n > 0; --n)
                l.push_back({d.roll(width) * scale, d.roll(width) * scale});
            s.loops.push_back(l);
        }
        const std::string mistake = mistake_on(s);
        if (!mistake.empty()) {
            INFO(s);
            CHECK(mistake == "");
            ++mistakes;
        }
    }
    CHECK(most_walks <= 12);
}

TEST_CASE("resolve() makes regions of random polylines of all sizes and slants", "[fill][resolve]")
{
    test::dice d{22};
    int mistakes = 0;
    for (int i = 0; i < 3000 && mistakes < 3; ++i) {
        const int wide = d.roll(29), high = d.roll(29), count = 1 + d.roll(3);
        test::shape s{"polylines " + std::to_string(i), {}};
        for (int c = 0; c < count; ++c) {
            test::polyline l;
            for (int n = 1 + d.roll(40); n > 0; --n) {
                if (l.size() > 3 && d.roll(4) == 0)
                    l.push_back(
                        {l[l.size() - 3].x + d.roll(3) - 1, l[l.size() - 3].y + d.roll(3) - 1});  // all but back again
                else
                    l.push_back({d.roll(1 << wide) - (1 << wide) / 2, d.roll(1 << high) - (1 << high) / 2});
            }
            s.loops.push_back(l);
        }
        const std::string mistake = mistake_on(s);
        if (!mistake.empty()) {
            INFO(s);
            CHECK(mistake == "");
            ++mistakes;
        }
    }
    CHECK(most_walks <= 12);
}

TEST_CASE("resolve() makes regions of the corpus in every position", "[fill][resolve]")
{
    for (const test::corpus_shape& c : test::corpus("regions.txt")) {
        INFO(c);
        for (const double degrees : {0.0, 90.0, 180.0, 270.0, 33.0}) {
            const test::shape s = test::turned(c.shape, degrees);
            CHECK(mistake_on(s) == "");
            CHECK(mistake_on(test::mirrored(s)) == "");
            CHECK(mistake_on(test::reversed(s)) == "");
        }
    }
}

namespace {

test::shape doubled(test::shape s, grid_point by, bool turned_round)
{
    s.name += ", doubled";
    const std::size_t n = s.loops.size();
    for (std::size_t i = 0; i < n; ++i) {
        test::polyline l = s.loops[i];
        for (grid_point& p : l) p = {p.x + by.x, p.y + by.y};
        if (turned_round) std::reverse(l.begin(), l.end());
        s.loops.push_back(l);
    }
    return s;
}

/// A star drawn in one go: every point joined with the one `skip` further on.
test::polyline pentagram(int n, int skip, double radius)
{
    test::polyline l;
    for (int i = 0; i < n; ++i) l.push_back(test::on_circle(0, 0, radius, test::turn_once * i * skip / n));
    return l;
}

}  // namespace

TEST_CASE("resolve() makes regions of doubled, shifted and wound-up shapes", "[fill][resolve]")
{
    for (const test::shape& s : test::generated_regions()) {
        if (s.loops.size() > 30 || s.loops[0].size() > 300 || s.name.find("largest") == 0) continue;
        INFO(s.name);
        for (const bool round : {false, true}) {
            for (const grid_point by :
                 {grid_point{0, 0}, grid_point{1, 0}, grid_point{0, -1}, grid_point{3, 7}, grid_point{1234, 567}}) {
                CHECK(mistake_on(doubled(s, by, round)) == "");
                CHECK(mistake_on(test::turned(doubled(s, by, round), 90.0)) == "");
            }
        }
        CHECK(mistake_on(doubled(doubled(doubled(s, {5, 5}, false), {5, 5}, false), {-30, 2}, false)) == "");
    }
    for (const int n : {5, 7, 11, 31, 101}) {
        for (int skip = 2; skip < n / 2; skip += 1 + n / 10) {
            for (const double radius : {3.0, 20.0, 1000.0, 2e8}) {
                const test::shape s{"pentagram " + std::to_string(n) + " by " + std::to_string(skip),
                                    {pentagram(n, skip, radius)}};
                INFO(s);
                CHECK(mistake_on(s, fill_rule::non_zero, n > 50 ? 4 : 12) == "");
                CHECK(mistake_on(s, fill_rule::even_odd, n > 50 ? 4 : 12) == "");
            }
        }
    }
    for (int depth = 1; depth < 12; ++depth) {
        CHECK(mistake_on(test::nested_squares(depth, false)) == "");
        CHECK(mistake_on(test::nested_squares(depth, true)) == "");
    }
}

TEST_CASE("An edge that is bent by rounding does not cross another one", "[fill][resolve]")
{
    // Even-odd left (5, 3) to (5, 5) and (3, 8) to (6, 3), which cross at (5, 4.67).
    const test::shape s{"three bent loops",
                        {{{3, 5}, {3, 2}, {5, 5}, {1, 2}, {0, 7}},
                         {{8, 4}, {5, 3}, {3, 5}, {1, 4}, {3, 8}},
                         {{9, 0}, {6, 1}, {3, 8}}}};
    CHECK(mistake_on(s, fill_rule::even_odd) == "");
    CHECK(mistake_on(test::shape{"one bent loop", {{{5, 30}, {30, 8}, {18, 38}, {25, 40}, {9, 4}, {16, 20}}}}) == "");
}
