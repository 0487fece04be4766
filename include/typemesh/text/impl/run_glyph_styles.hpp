// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/glyph/glyph_context.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/outline/impl/variation_key.hpp>
#include <typemesh/sweep/impl/sweep_order.hpp>
#include <typemesh/text/impl/font_ref.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// A glyph_context and its hash().
struct hashed_context {
    glyph_context context;
    std::uint64_t hash = 0;
};

/// The meaning of a run's glyph styles: the face and map of each, which of them draw alike, and the order in which
/// their styles are written. All empty for a run without a table of glyph styles.
class run_glyph_styles {
public:
    explicit run_glyph_styles(memory source) noexcept
        : drawn_{source}, keys_{source}, contexts_{source}, starts_{source}, order_{source}
    {
    }

    void clear() noexcept
    {
        drawn_.clear();
        keys_.clear();
        contexts_.clear();
        starts_.clear();
        order_.clear();
        styles_ = 0;
        units_per_em_ = 0.0;
    }

    /// Reads the glyph styles of a run that is drawn with the faces of `font`.
    ///
    /// Fails  error::no_such_face (count = the number of faces); error::bad_option: a face's units per em;
    ///        error::out_of_memory
    /// Cost   O(glyph styles log glyph styles)
    error read(const glyph_run& run, font_ref font) noexcept
    {
        units_per_em_ = font.units_per_em();
        const std::size_t count = run.glyph_styles.size();
        if (count == 0) return {};
        drawn_style* out = drawn_.append(count);
        if (out == nullptr) return error::out_of_memory;
        const std::uint32_t faces = font.face_count();
        for (std::size_t i = 0; i < count; ++i) {
            const glyph_style& l = run.glyph_styles[i];
            if (l.face >= faces && l.face != bar_face) return {error::no_such_face, faces};
            const double units = font.units_per_em(l.face);
            if (!is_finite(units) || !(units > 0.0)) return error::bad("units_per_em");
            const double factor = units_per_em_ / units;
            out[i] = {same(factor, 1.0) ? l.map : scaled_before(l.map, factor), l.style, l.face, 0, 0};
        }
        return compare();
    }

    /// The lowest glyph style that draws the same outlines as this one; numbers as in placed_glyph::glyph_style.
    [[nodiscard]] std::uint32_t outlines_of(std::uint32_t glyph_style) const noexcept
    {
        return drawn_.empty() ? 0 : drawn_[glyph_style].outlines;
    }
    [[nodiscard]] style_id style_of(std::uint32_t glyph_style) const noexcept
    {
        return drawn_.empty() ? style_id{} : drawn_[glyph_style].style;
    }

    /// The units per em of the font's first face, which are the run's units.
    [[nodiscard]] double units_per_em() const noexcept { return units_per_em_; }

    /// The source from which glyphs of this glyph style are drawn.
    [[nodiscard]] drawn_face face_of(font_ref font, std::uint32_t glyph_style) const noexcept
    {
        if (drawn_.empty()) return {font, 0, nullptr, units_per_em_};
        const drawn_style& l = drawn_[glyph_style];
        return {font, l.face, l.map == affine{} ? nullptr : &l.map, units_per_em_};
    }

    /// Finds the context of the glyphs of each glyph style, given the context of the first face without any; at least
    /// one.
    ///
    /// Fails  error::out_of_memory
    error find_contexts(const glyph_context& plain, font_ref font) noexcept
    {
        hashed_context* out = contexts_.append(drawn_.empty() ? 1 : drawn_.size());
        if (out == nullptr) return error::out_of_memory;
        if (drawn_.empty()) *out = {plain, plain.hash()};
        for (const drawn_style& l : drawn_) {
            *out = {plain, 0};
            if (!l.is_plain()) {
                std::uint64_t key = mixed_key(font.variation(l.face), l.face + std::uint64_t{1});
                key = mixed_key(key, l.map);
                out->context.variation = mixed_key(key, option_bits{units_per_em_}.words[0]);
            }
            out->hash = out->context.hash();
            ++out;
        }
        return {};
    }
    [[nodiscard]] array_view<const hashed_context> contexts() const noexcept { return contexts_.view(); }

    /// Sorts the glyphs of the run by style, and keeps their order within a style.
    ///
    /// Fails  error::out_of_memory
    /// Cost   O(glyphs + glyph styles)
    error sort(const glyph_run& run) noexcept
    {
        if (styles_ < 2) return {};
        const std::size_t count = run.glyphs.size();
        std::uint32_t* starts = starts_.append(styles_ + std::size_t{1});
        std::uint32_t* order = order_.append(count);
        if (starts == nullptr || (order == nullptr && count != 0)) return error::out_of_memory;
        for (std::size_t i = 0; i <= styles_; ++i) starts[i] = 0;
        for (const placed_glyph& g : run.glyphs) ++starts[drawn_[g.glyph_style].rank + std::size_t{1}];
        for (std::size_t i = 0; i < styles_; ++i) starts[i + 1] += starts[i];
        for (std::uint32_t i = 0; i < count; ++i) order[starts[drawn_[run.glyphs[i].glyph_style].rank]++] = i;
        return {};
    }

    /// The indices of the run's glyphs, sorted by style; empty if all have one style and are already sorted.
    [[nodiscard]] array_view<const std::uint32_t> order() const noexcept { return order_.view(); }

private:
    struct drawn_style {
        affine map;  // from the face's units to the run's
        style_id style;
        std::uint32_t face;
        std::uint32_t outlines;  // the lowest glyph style with the same face and map
        std::uint32_t rank;      // of the style, among the run's styles

        [[nodiscard]] bool is_plain() const noexcept { return face == 0 && map == affine{}; }
    };

    struct numbered {
        std::uint64_t key;
        std::uint32_t number;

        [[nodiscard]] bool before(const numbered& o) const noexcept
        {
            return key != o.key ? key < o.key : number < o.number;
        }
    };

    /// Finds the glyph styles that draw alike, and the order of their styles.
    error compare() noexcept
    {
        const std::size_t count = drawn_.size();
        numbered* keys = keys_.append(count);
        if (keys == nullptr) return error::out_of_memory;
        for (std::uint32_t i = 0; i < count; ++i) keys[i] = {mixed_key(drawn_[i].face, drawn_[i].map), i};
        detail::heap_sort(keys, count);
        for (std::size_t i = 0; i < count; ++i) {
            drawn_style& here = drawn_[keys[i].number];
            here.outlines = keys[i].number;
            if (i == 0) continue;
            const drawn_style& before = drawn_[keys[i - 1].number];
            if (here.face == before.face && here.map == before.map) here.outlines = before.outlines;
        }
        for (std::uint32_t i = 0; i < count; ++i) keys[i] = {static_cast<std::uint32_t>(drawn_[i].style), i};
        detail::heap_sort(keys, count);
        for (std::size_t i = 0; i < count; ++i) {
            if (i == 0 || keys[i - 1].key != keys[i].key) ++styles_;
            drawn_[keys[i].number].rank = styles_ - 1;
        }
        return {};
    }

    buffer<drawn_style> drawn_;
    buffer<numbered> keys_;  // scratch of compare()
    buffer<hashed_context> contexts_;
    buffer<std::uint32_t> starts_;
    buffer<std::uint32_t> order_;
    std::uint32_t styles_ = 0;  // the number of different styles
    double units_per_em_ = 0.0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
