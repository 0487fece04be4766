// SPDX-License-Identifier: MIT
#include "ink.hpp"

#include <typemesh/core/outline.hpp>
#include <typemesh/outline/face_source.hpp>
#include <typemesh/outline/outline_recorder.hpp>

namespace text_to_mesh {

typemesh::box ink::of(const typemesh::glyph_run& run)
{
    const double upem = font_->units_per_em();
    typemesh::box all;
    typemesh::outline shape;
    for (const typemesh::placed_glyph& g : run.glyphs) {
        if (g.missing) continue;
        const typemesh::glyph_style drawn =
            run.glyph_styles.empty() ? typemesh::glyph_style{} : run.glyph_styles[g.glyph_style];
        const auto [found, fresh] = letters_.emplace(std::pair{drawn.face, g.id}, typemesh::box{});
        if (fresh) {
            const typemesh::affine plain{};
            typemesh::mapped_face own{*font_, drawn.face, &plain, typemesh::units_per_em_of(*font_, drawn.face)};
            if (record(own, g.id, shape).has_value() && !shape.curves.empty()) found->second = shape.bounds;
        }
        const typemesh::box& b = found->second;
        if (b.empty()) continue;
        const double scale = upem / typemesh::units_per_em_of(*font_, drawn.face);
        const typemesh::affine map = typemesh::scaled_before(drawn.map, scale);
        for (const typemesh::point corner :
             {b.low, typemesh::point{b.high.x, b.low.y}, b.high, typemesh::point{b.low.x, b.high.y}})
            all.add((1.0 / upem) * (g.origin + map(corner)));
    }
    return all;
}

}  // namespace text_to_mesh
