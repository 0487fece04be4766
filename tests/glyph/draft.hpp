// SPDX-License-Identifier: MIT
#pragma once

// Glyph drafts of any numbers, to see that they are kept as they are.

#include <typemesh/extrude/extruded.hpp>
#include <typemesh/glyph/built_glyph.hpp>

#include "support/regions.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <vector>

namespace test {

/// Arrays of random lengths, 0 too, and what a glyph_draft refers to.
struct draft {
    std::vector<grid_point> points;
    std::vector<std::uint32_t> starts;
    std::vector<typemesh::triangle> triangles;
    std::vector<typemesh::side_point> sides;  // as extruded<> plans them
    double cells;
    bool narrowed;
    std::shared_ptr<typemesh::plan_scratch> scratch =
        std::make_shared<typemesh::plan_scratch>();  // filled anew by parts()

    explicit draft(dice& d) : cells{static_cast<double>(1 << d.roll(10))}
    {
        narrowed = d.roll(2) == 0;
        for (int n = d.roll(40); n > 0; --n) points.push_back({d.roll(1 << 20) - 1000, d.roll(1 << 20) - 1000});
        for (int n = d.roll(5); n > 0; --n) starts.push_back(static_cast<std::uint32_t>(d.roll(1000)));
        for (int n = d.roll(40); n > 0; --n)
            triangles.push_back({static_cast<std::uint32_t>(d.roll(1000)), static_cast<std::uint32_t>(d.roll(1000)),
                                 static_cast<std::uint32_t>(d.roll(1000))});
        for (int n = d.roll(40); n > 0; --n) {
            typemesh::side_point s;
            s.along = static_cast<float>(d.fraction());
            s.before.x = static_cast<float>(d.fraction());
            s.after.y = static_cast<float>(d.fraction());
            s.doubled = d.roll(2) == 0;
            sides.push_back(s);
        }
    }

    [[nodiscard]] typemesh::glyph_draft parts() const
    {
        typemesh::glyph_draft made;
        made.form.points = points;
        made.form.starts = starts;
        made.form.triangles = triangles;
        auto* data = scratch->fresh<typemesh::extruded<>::plan_data>();
        if (data == nullptr || !data->of<typemesh::side_point>().append(std::span{sides})) std::abort();
        made.data = scratch.get();
        made.plan.sizes.vertices[typemesh::part::front] = static_cast<std::uint32_t>(points.size());
        made.plan.sizes.triangles[typemesh::part::side] = static_cast<std::uint32_t>(triangles.size());
        made.plan.narrowed = narrowed;
        made.cells = cells;
        return made;
    }

    void overwrite()
    {
        std::fill(points.begin(), points.end(), grid_point{-1, -1});
        std::fill(starts.begin(), starts.end(), ~0u);
        std::fill(triangles.begin(), triangles.end(), typemesh::triangle{~0u, ~0u, ~0u});
        std::fill(sides.begin(), sides.end(), typemesh::side_point{});
    }

    /// Whether a glyph holds all of this.
    [[nodiscard]] bool is(const typemesh::built_glyph& g) const
    {
        const auto same = [](const auto& mine, const auto& its, auto equal) {
            return std::equal(mine.begin(), mine.end(), its.begin(), its.end(), equal);
        };
        const auto plain = [](const auto& a, const auto& b) { return a == b; };
        const auto side = [](const typemesh::side_point& a, const typemesh::side_point& b) {
            return a.before == b.before && a.after == b.after && typemesh::same(a.along, b.along) &&
                   a.doubled == b.doubled && a.seam == b.seam;
        };
        const typemesh::glyph_draft wanted = parts();
        return same(points, g.form().points, plain) && same(starts, g.form().starts, plain) &&
               same(triangles, g.form().triangles, plain) &&
               same(sides, g.planned<typemesh::extruded<>>().form.data.of<typemesh::side_point>(), side) &&
               g.sizes().total() == wanted.plan.sizes.total() && typemesh::same(g.cells(), cells) &&
               g.is_narrowed() == narrowed && !g.refusal();
    }
};

}  // namespace test
