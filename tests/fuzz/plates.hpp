// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include <typemesh/fill/fill.hpp>
#include <typemesh/inspect/manifoldness.hpp>
#include <typemesh/inspect/mesh_measure.hpp>
#include <typemesh/plate/layered_solid.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Layers -> their arrangement -> solids of slabs.
namespace fuzz {

/// Bevels and fillets of at most the size of the layers, which is an output unit; a level with rims counts as two slabs.
inline void add_rims(values& in, std::int32_t size, typemesh::layered_base& base,
                     std::vector<typemesh::layered_solid::slab>& slabs)
{
    const auto width = [&] {
        return in.below(4) == 0 ? 0.0f : 0.125f * static_cast<float>(in.below(static_cast<std::uint32_t>(size)));
    };
    base.bevel = width();
    base.round = in.flag();
    if (slabs.size() > typemesh::layered_solid::max_slabs / 2) slabs.resize(typemesh::layered_solid::max_slabs / 2);
    for (typemesh::layered_solid::slab& s : slabs) {
        s.bevel = width();
        s.fillet = width();
    }
}

inline broken_law plates(values in)
{
    using namespace typemesh;
    const std::int32_t size = in.one_of({8, 60, 2000, 1 << 22});
    layer_arrangement cells;
    workspace space;
    grid onto;  // a cell an em: rims are as wide as the layers
    onto.cells = 1.0;
    onto.units_per_em = 1.0;
    cells.begin(onto);
    for (std::uint32_t layer = 0; layer < max_layers; ++layer) {
        contours drawn;
        bool ok = drawn.starts.push_back(0);
        for (std::uint32_t k = in.below(3); k > 0; --k) {
            for (std::uint32_t n = 3 + in.below(6); n > 0; --n) {
                const auto x = static_cast<std::int32_t>(in.between(-size, size));
                const auto y = static_cast<std::int32_t>(in.between(-size, size));
                ok = ok && drawn.points.push_back({x, y}) && drawn.edges.push_back({});
            }
            ok = ok && drawn.starts.push_back(static_cast<std::uint32_t>(drawn.points.size()));
        }
        if (!ok) return "out of memory";
        if (drawn.points.empty()) continue;
        const auto filled = resolve(drawn, in.flag() ? fill_rule::even_odd : fill_rule::non_zero, space);
        if (!filled) return "contours were refused";
        if (!cells.add(*filled, layer)) return "a layer was refused";
    }
    if (const auto done = cells.cut(space); !done) return "the layers were not cut";

    contours loops;
    std::int64_t sum = 0;
    for (std::uint32_t label = 1; label < 32; ++label) {
        const std::int64_t own = cells.doubled_area({1u << label});
        if (own < 0) return "a cell has a negative area";
        sum += own;
    }
    if (sum != cells.doubled_area({~1u})) return "the cells do not add up";

    const bool nested = in.flag();
    std::vector<layered_solid::slab> slabs;
    cell_set filled{in.bits(4) & ~1u};
    for (std::uint32_t k = 1 + in.below(layered_solid::max_slabs); k > 0; --k) {
        slabs.push_back({filled, static_cast<float>(slabs.size() + 1)});
        filled = {(nested ? filled.labels & (in.bits(4) | in.bits(4)) : in.bits(4)) & ~1u};
    }
    layered_solid solid;
    const bool delaunay = in.flag();
    layered_base base{.unit_per_em = 1.0 / size};
    if (in.flag()) add_rims(in, size, base, slabs);
    const auto done = delaunay ? solid.plan(cells, base, {slabs.data(), slabs.size()}, 3, constrained_delaunay{}, space)
                               : solid.plan(cells, base, {slabs.data(), slabs.size()}, 3, monotone{}, space);
    if (!done) return "a solid was refused";
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    constexpr auto position = [](const surface_point<attribute::position>& p) noexcept { return p.position; };
    layered_placement at;
    at.mirrored = in.flag();
    if (!solid.write(into(vertices, indices, position), at)) return "a solid was not written";
    if (vertices.size() != solid.size().vertices || indices.size() != solid.size().indices())
        return "the counts are not exact";
    const inspect::mesh_view mesh{vertices, indices};
    const auto faults = inspect::check_manifoldness(mesh);
    if (faults.open_edges != 0) return "an edge is open";
    if (faults.bad_triangles != 0) return "a triangle has no area";
    if (solid.touching() == 0 && solid.hanging() == 0 && faults.crowded_edges != 0)
        return "an edge has more than two faces";
    if (nested && solid.touching() == 0 && !faults.is_manifold()) return "it is not manifold";
    const double volume = solid.volume(), is = inspect::measure(mesh).volume;
    if (!(std::fabs(is - volume) <= 1e-4 * volume + 1e-3)) return "it has another volume";
    return {};
}

}  // namespace fuzz
