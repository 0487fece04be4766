// SPDX-License-Identifier: MIT

#include <typemesh/fill/resolve.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

std::uint32_t most_walks = 0;

/// What is wrong with what resolve() makes of a shape under a rule; empty when nothing is.
///
/// The walks must be walks, and fill what the contours fill: at every grid point (of `samples` by `samples` round the shape)
/// farther than a cell or so from all contours. Where nothing was bent the areas are equal.
std::string mistake_on(const test::shape& s, fill_rule rule, int samples = 12)
{
    contours loops = test::contours_of(s);
    workspace space;
    std::uint32_t walks = 0;
    const result<region> made = resolve(loops, rule, space, &walks);
    most_walks = (std::max)(most_walks, walks);
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
    if ((std::adjacent_find(places.begin(), places.end()) != places.end()) != made->is_touching()) return "is_touching() is wrong";

    std::int32_t left = 1 << 29, right = -left, bottom = left, top = -left;
    for (const auto& l : s.loops) {
        for (const grid_point p : l) {
            left = (std::min)(left, p.x), right = (std::max)(right, p.x);
            bottom = (std::min)(bottom, p.y), top = (std::max)(top, p.y);
        }
    }
    const double area = test::oracle::doubled_filled_area(given, rule), mine = static_cast<double>(test::oracle::doubled_area(kept));
    double length = 0;
    for (const auto& l : s.loops)
        for (std::size_t i = 0; i < l.size(); ++i) length += std::hypot(double(l[i].x) - l[(i + 1) % l.size()].x, double(l[i].y) - l[(i + 1) % l.size()].y);
    if (walks == 1 ? std::fabs(area - mine) > 1e-9 * (area + 1) : std::fabs(area - mine) > 2 * length + 4) return "the area is not what the contours fill";
    if (right < left) return {};
    for (int i = 0; i < samples; ++i) {
        for (int k = 0; k < samples; ++k) {
            const grid_point p{left + static_cast<std::int32_t>(std::int64_t{right - left} * i / samples),
                               bottom + static_cast<std::int32_t>(std::int64_t{top - bottom} * k / samples)};
            const double far_off = test::oracle::distance(given, p);
            if (walks == 1 ? far_off == 0 : far_off < 1.5) continue;
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
            for (int n = 1 + d.roll(count == 1 ? 16 : 8); n > 0; --n) l.push_back({d.roll(width) * scale, d.roll(width) * scale});
            s.loops.push_back(l);
        }
        const std::string mistake = mistake_on(s);
        if (!mistake.empty()) {
            INFO(s);
            CHECK(mistake == "");
            ++mistakes;
        }
    }
    WARN("at most " << most_walks << " walks");
}
