// SPDX-License-Identifier: MIT
#pragma once

#include "toy_texts.hpp"

#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

/// Glyphs put anywhere -> merged solids: they fill what the glyphs fill, once.
namespace fuzz {

namespace merge_laws {

using namespace typemesh;

/// In font units, 10,000 from the origin at most, often on a lattice where edges coincide.
inline glyph_run read_run(values& in)
{
    glyph_run run;
    run.units_per_em = 1000.0;
    const std::uint32_t kind = in.byte() % 3;
    for (std::uint32_t count = 1 + in.below(8), i = 0; i < count; ++i) {
        constexpr double steps[] = {50.0, 1.0, 1.0 / 2048};
        placed_glyph g{in.below(6), static_cast<cluster_id>(i), {}};
        g.origin.x =
            steps[kind] * ((kind == 0 ? in.byte() & 31u : in.bits(2)) & 2047u) + 16.0 * (kind == 2 ? in.byte() : 0);
        g.origin.y = steps[kind] * ((kind == 0 ? in.byte() & 31u : in.bits(2)) & 2047u);
        if (!run.glyphs.push_back(g)) return glyph_run{};
    }
    return run;
}

/// The triangles of a mesh's front, which lie in the plane.
struct front_cap {
    const test::full_mesh& m;
    mesh_range range;

    /// How many triangles hold a place; -1 if it is nearer than `margin` to an edge of one.
    [[nodiscard]] int count_at(double x, double y, double margin) const
    {
        int count = 0;
        for (std::size_t i = range.first_index; i < std::size_t{range.first_index} + range.index_count; i += 3) {
            bool inside = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const vec3 a = m.vertices[m.indices[i + k]].position,
                           b = m.vertices[m.indices[i + (k + 1) % 3]].position;
                const double dx = double(b.x) - a.x, dy = double(b.y) - a.y, length = std::hypot(dx, dy);
                const double off = length > 0.0 ? (dx * (y - a.y) - dy * (x - a.x)) / length : 0.0;
                const double along = length > 0.0 ? (dx * (x - a.x) + dy * (y - a.y)) / length : 0.0;
                if (std::fabs(off) < margin && along > -margin && along < length + margin) return -1;
                inside = inside && off > 0.0;
            }
            count += inside ? 1 : 0;
        }
        return count;
    }
    [[nodiscard]] double area() const
    {
        double sum = 0.0;
        for (std::size_t i = range.first_index; i < std::size_t{range.first_index} + range.index_count; i += 3) {
            const vec3 a = m.vertices[m.indices[i]].position, b = m.vertices[m.indices[i + 1]].position,
                       c = m.vertices[m.indices[i + 2]].position;
            sum += 0.5 * ((double(b.x) - a.x) * (double(c.y) - a.y) - (double(c.x) - a.x) * (double(b.y) - a.y));
        }
        return sum;
    }
};

/// At places all over, the merged front is there once where any glyph's is, and nowhere else.
inline broken_law of_fronts(const front_cap& apart, const front_cap& merged)
{
    float right = 0.0f, top = 0.0f, left = 1e9f, bottom = 1e9f;
    for (const auto& v : apart.m.vertices) {
        right = (std::max)(right, v.position.x), left = (std::min)(left, v.position.x);
        top = (std::max)(top, v.position.y), bottom = (std::min)(bottom, v.position.y);
    }
    constexpr int rows = 12;
    constexpr double margin = 0.05;  // font units: grid and floats are much finer
    for (int i = 0; i < rows; ++i)
        for (int k = 0; k < rows; ++k) {
            const double x = double(left) + (double(right) - double(left)) * (i + 0.37) / rows;
            const double y = double(bottom) + (double(top) - double(bottom)) * (k + 0.61) / rows;
            const int before = apart.count_at(x, y, margin), after = merged.count_at(x, y, margin);
            if (before >= 0 && after >= 0 && after != (before > 0 ? 1 : 0))
                return "a place is filled wrongly, or twice";
        }
    return {};
}

}  // namespace merge_laws

inline broken_law merges(values in)
{
    using namespace typemesh;
    using namespace merge_laws;
    test::toy_font font;
    const glyph_run run = read_run(in);
    text_options how;
    how.unit = output_unit::font_units;
    how.tolerance = in.one_of({quality::high, quality::low, 0.05});
    auto a = text_mesher{font}.with(extruded<>{.depth = 0.25f}), b = text_mesher{font}.with(extruded<>{.depth = 0.25f});
    const auto apart = a.plan(run, how);
    how.merge = true;
    const auto merged = b.plan(run, how);
    if (!apart || !merged) return apart ? merged.error().message() : apart.error().message();
    test::full_mesh m, n;
    if (apart->write(into(m.vertices, m.indices)) || merged->write(into(n.vertices, n.indices))) return "write failed";
    const inspect::closedness closed = test::examine(n);
    if (closed.unmatched_edges != 0 || closed.bad_corners != 0) return "the mesh is open";
    const front_cap fronts{m, apart->range(part::front)}, front{n, merged->range(part::front)};
    if (broken_law broken = of_fronts(fronts, front); !broken.empty()) return broken;
    const double area = front.area(), volume = test::volume(n.vertices, n.indices), depth = 250.0;
    if (!(area <= fronts.area() * (1.0 + 1e-5) + 1.0)) return "merging adds area";
    if (!(std::fabs(volume - area * depth) <= 1e-4 * area * depth + 1.0)) return "the volume is not area times depth";
    std::size_t members = 0;
    for (std::size_t g = 0; g < merged->glyphs().size(); ++g) members += merged->members(g).size();
    if (members != apart->glyphs().size()) return "a glyph belongs to no group, or to two";
    return {};
}

}  // namespace fuzz
