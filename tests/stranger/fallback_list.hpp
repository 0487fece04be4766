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

    typemesh::result<typemesh::point> shape(typemesh::text_view text, std::size_t first, std::size_t last,
                                            const typemesh::shape_options& options, typemesh::glyph_run& run) noexcept
    {
        typemesh::point pen;
        for (std::size_t i = first; i < last; ++i) {
            std::uint32_t face = 0;
            typemesh::point way;
            for (;; ++face) {
                one_.clear();
                const auto shaped = fonts_[face]->shape(text, i, i + 1, options, one_);
                if (!shaped) return shaped;
                way = *shaped;
                if (one_.missing == 0) break;
                if (face + 1 == face_count()) return typemesh::error::needs_shaping;
            }
            const auto look = run.number_of({.face = face});
            if (!look) return look.error();
            const double scale = units_per_em() / units_per_em(face);
            for (typemesh::placed_glyph g : one_.glyphs) {
                g.origin = pen + scale * g.origin;
                g.look = *look;
                if (!run.glyphs.push_back(g)) return typemesh::error::out_of_memory;
            }
            pen = pen + scale * way;
        }
        return pen;
    }

private:
    std::vector<Font*> fonts_;
    typemesh::glyph_run one_;
};

}  // namespace stranger
