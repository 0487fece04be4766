// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/shaper.hpp>

#include <cstddef>
#include <string>
#include <utility>

namespace stranger {

/// Every character in a cell of its own. It has some ASCII characters, in the order of their glyphs; all others are missing,
/// and drawn as glyph 0 if at all. Written only from the comment on shaper.
class monospace_shaper {
public:
    monospace_shaper(double units_per_em, double cell, std::string characters)
        : units_per_em_{units_per_em}, cell_{cell}, characters_{std::move(characters)}
    {
    }

    double units_per_em() noexcept { return units_per_em_; }
    typemesh::line_metrics metrics(typemesh::direction) noexcept
    {
        return {0.8 * units_per_em_, -0.2 * units_per_em_, 0.0};
    }

    typemesh::result<typemesh::point> shape(typemesh::text_view text, std::size_t first, std::size_t last,
                                            const typemesh::shape_options& options, typemesh::glyph_run& run) noexcept
    {
        const bool down = options.direction == typemesh::direction::top_to_bottom;
        typemesh::point pen;
        for (std::size_t i = first; i < last; ++i) {
            const std::size_t found =
                text.unit(i) < 0x80 ? characters_.find(static_cast<char>(text.unit(i))) : std::string::npos;
            typemesh::placed_glyph g;
            g.cluster = static_cast<typemesh::cluster_id>(i);
            g.origin = pen;
            g.missing = found == std::string::npos;
            g.id = g.missing ? 0 : static_cast<typemesh::glyph_id>(found);
            if (g.missing) run.note_missing(g.cluster);
            if (!run.glyphs.push_back(g)) return typemesh::error::out_of_memory;
            pen = pen + (down ? typemesh::point{0.0, -units_per_em_} : typemesh::point{cell_, 0.0});
        }
        return pen;
    }

private:
    double units_per_em_, cell_;
    std::string characters_;
};
static_assert(typemesh::shaper<monospace_shaper>);

}  // namespace stranger
