// SPDX-License-Identifier: MIT
#include "gradient_ramps.hpp"

#include "colour_layers.hpp"

#include <typemesh/colour/gradient_ramp.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace text_to_mesh {
namespace {

constexpr std::uint32_t texels = 256;

rgb_colour plain(const typemesh::palette_colour& c)
{
    return {{c.red, c.green, c.blue}, static_cast<unsigned char>(std::lround(255.0f * c.alpha))};
}

}  // namespace

const typemesh::colour_style* gradient_ramps::gradient_of(typemesh::style_id style) const
{
    const bool moves = o_.bend.is_on || o_.path.curve || o_.bend.warp.index() != 0 || o_.per_letter;
    if (!o_.layers || o_.kind != file_kind::glb || moves) return nullptr;
    const typemesh::colour_style* const own = o_.layers->source().style_of(style);
    return own == nullptr || own->paint.kind == typemesh::paint_kind::solid || own->paint.stop_count == 0 ? nullptr
                                                                                                          : own;
}

std::optional<std::size_t> gradient_ramps::ramp_of(typemesh::style_id style)
{
    const typemesh::colour_style* const own = gradient_of(style);
    if (own == nullptr) return {};
    if (styles_.empty()) first_ = out_.ramps.size();
    const auto known = std::find(styles_.begin(), styles_.end(), style);
    const auto number = static_cast<std::size_t>(known - styles_.begin());
    if (known != styles_.end()) return first_ + number;
    styles_.push_back(style);
    const auto stops = o_.layers->source().stops_of(*own);
    model::ramp made{{}, model::ramp::wrap::clamp};
    if (own->paint.extend == typemesh::gradient_extend::repeat) made.beyond = model::ramp::wrap::repeat;
    if (own->paint.extend == typemesh::gradient_extend::reflect) made.beyond = model::ramp::wrap::mirror;
    for (std::uint32_t i = 0; i < texels; ++i) made.texels.push_back(plain(ramp_colour(stops, i, texels)));
    out_.ramps.push_back(std::move(made));
    return out_.ramps.size() - 1;
}

void gradient_ramps::place_vertices()
{
    const typemesh::glyph_run& run = plan_.run();
    for (std::size_t g = 0; g < plan_.glyphs().size() && !run.glyph_styles.empty(); ++g) {
        const typemesh::placed_glyph& placed = run.glyphs[plan_.glyphs()[g].glyph];
        const typemesh::glyph_style& look = run.glyph_styles[placed.glyph_style];
        const typemesh::colour_style* const own = gradient_of(look.style);
        if (own == nullptr) continue;
        const auto stops = o_.layers->source().stops_of(*own);
        const typemesh::affine& m = look.map;
        const double own_per_unit = o_.layers->source().units_per_em(look.face) / run.units_per_em;
        const double scale = (m.xx * m.yy - m.xy * m.yx) / own_per_unit;
        if (scale == 0.0) continue;  // it has no area
        for (const typemesh::part p : plan_.parts()) {
            const typemesh::mesh_range r = plan_.range(g, p);
            for (std::uint32_t v = r.first_vertex; v < r.first_vertex + r.vertex_count; ++v) {
                model_vertex& to = out_.vertices[v];
                const typemesh::point at = run.units_per_em * plan_.place_of({to.position[0], to.position[1], 0.0f}) -
                                           placed.origin - typemesh::point{m.dx, m.dy};
                const typemesh::point own_units{(m.yy * at.x - m.xy * at.y) / scale,
                                                (m.xx * at.y - m.yx * at.x) / scale};
                to.uv[0] = static_cast<float>(ramp_coordinate(own->paint, stops, own_units).value_or(0.0));
                to.uv[1] = 0.5f;
            }
        }
    }
}

}  // namespace text_to_mesh
