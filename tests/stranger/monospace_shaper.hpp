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

    typemesh::error shape(typemesh::text_view text, const typemesh::text_item& item, const typemesh::shape_options&,
                          typemesh::buffer<typemesh::shaped_glyph>& glyphs) noexcept
    {
        const bool upright = item.orientation == typemesh::glyph_orientation::upright;
        for (std::uint32_t i = item.first; i < item.last; ++i) {
            const std::size_t found =
                text.unit(i) < 0x80 ? characters_.find(static_cast<char>(text.unit(i))) : std::string::npos;
            typemesh::shaped_glyph g;
            g.cluster = i;
            g.advance = upright ? units_per_em_ : cell_;
            if (found != std::string::npos)
                g.id = static_cast<typemesh::glyph_id>(found);
            else
                g.flags = typemesh::glyph_flags::missing;
            if (!glyphs.push_back(g)) return typemesh::error::out_of_memory;
        }
        return {};
    }

private:
    double units_per_em_, cell_;
    std::string characters_;
};
static_assert(typemesh::shaper<monospace_shaper>);

}  // namespace stranger
