// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/face_source.hpp>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace stranger {

/// Any number of fonts of one type; each character is taken from the first that has it. Written only from the comments on
/// shaper and face_source.
template <class Font>
class fallback_list {
public:
    explicit fallback_list(std::vector<Font*> fonts) : fonts_{std::move(fonts)} {}

    std::uint32_t face_count() noexcept { return static_cast<std::uint32_t>(fonts_.size()); }
    double units_per_em() noexcept { return units_per_em(0); }
    double units_per_em(std::uint32_t face) noexcept { return fonts_[face]->units_per_em(); }
    typemesh::fill_rule fill() noexcept { return fill(0); }
    typemesh::fill_rule fill(std::uint32_t face) noexcept { return fonts_[face]->fill(); }
    typemesh::line_metrics metrics(typemesh::direction d) noexcept { return fonts_[0]->metrics(d); }

    template <typemesh::outline_sink Sink>
    typemesh::error outline(typemesh::glyph_id id, Sink& sink) noexcept
    {
        return outline(0, id, sink);
    }
    template <typemesh::outline_sink Sink>
    typemesh::error outline(std::uint32_t face, typemesh::glyph_id id, Sink& sink) noexcept
    {
        return fonts_[face]->outline(id, sink);
    }

    typemesh::error shape(typemesh::text_view text, const typemesh::text_item& item,
                          const typemesh::shape_options& options,
                          typemesh::buffer<typemesh::shaped_glyph>& glyphs) noexcept
    {
        for (std::uint32_t i = item.first; i < item.last; ++i)
            if (const auto e = shape(text, part_of(item, i), options, glyphs, 0)) return e;
        return {};
    }

private:
    static typemesh::text_item part_of(typemesh::text_item item, std::uint32_t unit)
    {
        item.first = unit;
        item.last = unit + 1;
        return item;
    }

    /// One character, by the first of these fonts, from `face` on, that has it.
    typemesh::error shape(typemesh::text_view text, const typemesh::text_item& one,
                          const typemesh::shape_options& options, typemesh::buffer<typemesh::shaped_glyph>& glyphs,
                          std::uint32_t face) noexcept
    {
        if (face == face_count()) return typemesh::error::needs_shaping;
        const std::size_t before = glyphs.size();
        if (const auto e = fonts_[face]->shape(text, one, options, glyphs)) return e;
        const double scale = units_per_em() / units_per_em(face);
        for (typemesh::shaped_glyph& g : glyphs.view().subspan(before)) {
            if (has(g.flags, typemesh::glyph_flags::missing)) {
                glyphs.truncate(before);
                return shape(text, one, options, glyphs, face + 1);
            }
            g.face = static_cast<std::uint16_t>(face);
            g.advance *= scale;
            g.offset = scale * g.offset;
        }
        return {};
    }

    std::vector<Font*> fonts_;
};

}  // namespace stranger
