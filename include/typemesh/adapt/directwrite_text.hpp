// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/impl/directwrite_clusters.hpp>
#include <typemesh/adapt/impl/directwrite_com.hpp>
#include <typemesh/adapt/impl/directwrite_key.hpp>
#include <typemesh/adapt/impl/directwrite_outline.hpp>
#include <typemesh/adapt/impl/directwrite_renderer.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/outline/outline_source.hpp>

#include <dwrite.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// An inline object of a layout and its box, y up. Borrowed from the directwrite_text, like its glyphs.
struct directwrite_object {
    IDWriteInlineObject* object = nullptr;
    point low, high;  ///< its box, in the text's font units
    std::uint32_t line = 0;
};

/// The meaning of a glyph id of a directwrite_text.
struct directwrite_glyph {
    IDWriteFontFace* face = nullptr;  ///< null for an underline or a strike-through
    std::uint16_t index = 0;          ///< the face's own glyph number
    double em_size = 0.0;             ///< the size of an em, in device-independent pixels
    bool sideways = false;            ///< whether the glyph is rotated to lie on its side
};

/// A whole IDWriteTextLayout as shaped text with its own outlines. All results of the layout are kept: changes of font
/// and size, fallback fonts, bidirectional text, wrapping, alignment, trimming, underlines.
///
///     directwrite_text text;
///     if (auto read = text.read(layout); !read) return puts(read.error().message());
///     text_mesher mesher{text};
///     auto made = mesher.build(text.run(), into(vertices, indices));
///
/// One run holds all faces. A glyph's id is the face's own glyph number plus 65536 times the number of the pair of face
/// and size, counted by first use. In a layout with one font, the ids are therefore the font's own. glyph() decodes an
/// id. Underlines and strike-throughs are also glyphs: rectangles without a position in the text (`cluster` is
/// no_cluster). They are separate solids, which overlap the letters that they cross.
///
/// The unit is the font unit of the first face drawn, where one em is the layout's own font size. Outlines of other
/// faces and sizes are scaled. The origin is the layout's top left corner, y up: lines lie below it. Multiply by
/// dips_per_unit() to convert back to device-independent pixels.
///
/// Clusters are offsets in the layout's 16-bit units. layout->GetDrawingEffect(cluster, ...) therefore finds the data
/// that an application attached to a range, such as its drawing effect.
///
/// In a glyph_cache, one number serves all layouts, `cached_in{cache, 1}`: see variation_key().
///
/// It holds references to the faces and inline objects of the last layout that it read, but not to the layout. Memory
/// is kept for the next layout. Move-only; used by one thread at a time.
class directwrite_text {
public:
    explicit directwrite_text(memory source = heap()) noexcept
        : run_{source},
          slots_{source},
          bars_{source},
          objects_{source},
          pieces_{source},
          glyphs_{source},
          lines_{source},
          line_metrics_{source},
          units_{source}
    {
        run_.units_per_em = unread_units;
    }
    directwrite_text(directwrite_text&&) noexcept = default;
    directwrite_text& operator=(directwrite_text&&) noexcept = default;
    ~directwrite_text() { release(); }

    /// Draws a layout into this object. Inline objects are recorded, and draw themselves, with `context`. Text that
    /// they draw (the ellipsis of a trimmed line) is included, without a position in the text.
    ///
    /// Fails  error::bad_option: the layout runs in columns
    ///        error::outline_not_finite: the layout places something at NaN or infinity
    ///        error::too_large: more than 65535 pairs of face and size, underlines or strike-throughs
    ///        error::out_of_memory, font_library_failed (count = the HRESULT); it then holds nothing
    result<void> read(IDWriteTextLayout* layout, void* context = nullptr) noexcept
    {
        TYPEMESH_ASSERT(layout != nullptr, "a null IDWriteTextLayout* was read");
        release();
        read_at_ = detail::directwrite_key::now();
        error e = take_lines(layout);
        if (!e) {
            detail::directwrite_renderer<directwrite_text> draws{*this};
            const HRESULT code = layout->Draw(context, &draws, 0.0f, 0.0f);
            e = draws.first_error() ? draws.first_error() : directwrite_error(code);
        }
        if (!e) e = put_in_order();
        if (e) release();
        return e;
    }

    /// The text, glyph by glyph and line by line, in drawing order; a line's underlines follow its letters.
    [[nodiscard]] const glyph_run& run() const noexcept { return run_; }

    /// The inline objects, in the order in which the layout drew them.
    [[nodiscard]] std::span<const directwrite_object> objects() const noexcept { return objects_.view(); }

    /// Device-independent pixels per unit of run() and objects().
    [[nodiscard]] double dips_per_unit() const noexcept { return em_size_ / run_.units_per_em; }

    [[nodiscard]] double units_per_em() const noexcept { return run_.units_per_em; }
    [[nodiscard]] fill_rule fill() const noexcept { return rule_; }

    /// See outline_source. Covers everything that the ids of run() represent. Texts share the contents of a glyph_cache
    /// exactly if three conditions hold: they have equal faces (by file, face index, simulations and axes) and sizes
    /// (relative to the layout's own), they first use these in one order, and their underlines and strike-throughs have
    /// equal sizes. If a face comes from memory or a caller's loader, not from a system file, or if its axes cannot be
    /// read, the layout shares nothing with other layouts, nor with itself when it is read again.
    ///
    /// Cost  a few calls of DirectWrite per face and size; a mesher calls it once per text
    [[nodiscard]] std::uint64_t variation_key() const noexcept
    {
        detail::directwrite_key key;
        key.mix(run_.units_per_em);
        key.mix(std::uint64_t{slots_.size()});
        for (const font_slot& l : slots_.view()) {
            key.mix_files(l.face);
            key.mix_state(l.face);
            key.mix(l.scale);
            key.mix(std::uint64_t{l.sideways});
        }
        key.mix(std::uint64_t{bars_.size()});
        for (const point& size : bars_.view()) {
            key.mix(size.x);
            key.mix(size.y);
        }
        return key.value(this, read_at_);
    }

    /// The face and glyph that an id of run() represents. Any other id gives a null face.
    [[nodiscard]] directwrite_glyph glyph(glyph_id id) const noexcept
    {
        const std::size_t slot = id >> 16;
        if (slot >= slots_.size()) return {};
        const font_slot& l = slots_[slot];
        return {l.face, static_cast<std::uint16_t>(id & 0xFFFF), l.em_size, l.sideways};
    }

    /// See outline_source; curves are as directwrite_font draws them.
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        const std::size_t slot = id >> 16, index = id & 0xFFFF;
        rule_ = fill_rule::non_zero;
        if (slot == bar_slot && index < bars_.size()) {
            const point size = bars_[index];
            sink.move({0.0, 0.0});
            sink.line({size.x, 0.0});
            sink.line(size);
            sink.line({0.0, size.y});
            sink.close();
            return {};
        }
        if (slot >= slots_.size()) return error{error::unknown_glyph}.at(id, no_cluster);
        const font_slot& l = slots_[slot];
        if (index >= l.face->GetGlyphCount()) return error{error::unknown_glyph}.at(id, no_cluster);
        const error e = detail::draw_glyph(l.face, l.units_per_em, l.scale, l.lowers, l.sideways,
                                           static_cast<glyph_id>(index), sink, rule_);
        return e ? e.at(id, no_cluster) : e;
    }

private:
    friend class detail::directwrite_renderer<directwrite_text>;

    static constexpr std::size_t bar_slot = 0xFFFF;
    static constexpr double unread_units = 1000.0;  // before a face is drawn

    /// A face at a size.
    struct font_slot {
        IDWriteFontFace* face;
        double em_size;
        double units_per_em;
        double scale;  // the scale of its outlines
        bool lowers;
        bool sideways;
    };

    /// A subrange of glyphs_ as DirectWrite drew it.
    struct piece {
        std::uint32_t first, count;
        std::uint32_t line;
        bool bar;
        double left, right;
    };

    /// A line as the layout reports it.
    struct layout_line {
        std::uint32_t end;  // the end of the line, in units of the text
        double baseline;    // y up
    };

    void release() noexcept
    {
        for (font_slot& l : slots_.view()) l.face->Release();
        for (directwrite_object& o : objects_.view()) o.object->Release();
        run_.clear();
        run_.units_per_em = unread_units;
        slots_.clear();
        bars_.clear();
        objects_.clear();
        pieces_.clear();
        glyphs_.clear();
        lines_.clear();
    }

    [[nodiscard]] double to_units(double dips) const noexcept { return dips * run_.units_per_em / em_size_; }

    /// Finds the end and the baseline of each line.
    error take_lines(IDWriteTextLayout* layout) noexcept
    {
        const DWRITE_READING_DIRECTION reading = layout->GetReadingDirection();
        if (reading != DWRITE_READING_DIRECTION_LEFT_TO_RIGHT && reading != DWRITE_READING_DIRECTION_RIGHT_TO_LEFT)
            return error::bad("reading direction");
        if (layout->GetFlowDirection() != DWRITE_FLOW_DIRECTION_TOP_TO_BOTTOM) return error::bad("flow direction");
        em_size_ = double{static_cast<IDWriteTextFormat*>(layout)->GetFontSize()};
        if (!is_finite(em_size_) || !(em_size_ > 0.0)) return error::bad("font size");

        UINT32 count = 0;
        constexpr auto too_little_room = static_cast<HRESULT>(0x8007'007Au);  // ERROR_INSUFFICIENT_BUFFER
        HRESULT code = layout->GetLineMetrics(nullptr, 0, &count);
        if (code != too_little_room)
            if (error e = directwrite_error(code)) return e;
        buffer<DWRITE_LINE_METRICS>& metrics = line_metrics_;
        metrics.clear();
        if (count != 0 && metrics.append(count) == nullptr) return error::out_of_memory;
        if (count != 0) {
            code = layout->GetLineMetrics(metrics.data(), count, &count);
            if (error e = directwrite_error(code)) return e;
        }
        DWRITE_TEXT_METRICS all = {};
        if (error e = directwrite_error(layout->GetMetrics(&all))) return e;
        double top = double{all.top};
        std::uint32_t end = 0;
        for (const DWRITE_LINE_METRICS& m : metrics.view()) {
            end += m.length;
            if (!lines_.push_back({end, 0.0 - (top + double{m.baseline})})) return error::out_of_memory;
            top += double{m.height};
        }
        return {};
    }

    /// The line of a unit of the text; if `of` is null, the line with the nearest baseline (y up, pixels).
    [[nodiscard]] std::uint32_t line_of(const DWRITE_GLYPH_RUN_DESCRIPTION* of, double y) const noexcept
    {
        std::uint32_t found = 0;
        if (of != nullptr) {
            while (found + 1 < lines_.size() && of->textPosition >= lines_[found].end) ++found;
            return found;
        }
        for (std::uint32_t i = 1; i < lines_.size(); ++i)
            if (std::fabs(lines_[i].baseline - y) < std::fabs(lines_[found].baseline - y)) found = i;
        return found;
    }

    /// The number of a face at a size; holds a reference to the face from its first use.
    result<std::uint32_t> slot_of(const DWRITE_GLYPH_RUN& run) noexcept
    {
        const double em_size = double{run.fontEmSize};
        const bool sideways = run.isSideways != FALSE;
        for (std::size_t i = slots_.size(); i-- > 0;) {
            const font_slot& l = slots_[i];
            if (l.face == run.fontFace && same(l.em_size, em_size) && l.sideways == sideways)
                return static_cast<std::uint32_t>(i);
        }
        if (slots_.size() == bar_slot) return error::too_large;
        DWRITE_FONT_METRICS m = {};
        run.fontFace->GetMetrics(&m);
        if (m.designUnitsPerEm == 0) return error::not_a_font;
        const double units = m.designUnitsPerEm;
        if (slots_.empty()) run_.units_per_em = units;
        const double scale = (em_size / em_size_) * (run_.units_per_em / units);
        if (!slots_.push_back({run.fontFace, em_size, units, scale, detail::has_table(run.fontFace, "glyf"), sideways}))
            return error::out_of_memory;
        run.fontFace->AddRef();
        return static_cast<std::uint32_t>(slots_.size() - 1);
    }

    /// Stores a run of glyphs, still in pixels. `of` gives its position in the text; null if it has none.
    error add_glyphs(FLOAT x, FLOAT y, const DWRITE_GLYPH_RUN& run, const DWRITE_GLYPH_RUN_DESCRIPTION* of) noexcept
    {
        const UINT32 count = run.glyphCount;
        if (count == 0 || run.fontFace == nullptr) return {};
        if (!is_finite(double{run.fontEmSize}) || !(run.fontEmSize > 0.0f)) return error::outline_not_finite;
        const auto slot = slot_of(run);
        if (!slot) return slot.error();
        if (units_.size() < count && units_.append(count - units_.size()) == nullptr) return error::out_of_memory;
        const bool placed = of != nullptr && of->clusterMap != nullptr && of->string != nullptr;
        if (placed) detail::invert_cluster_map({of->clusterMap, of->stringLength}, {units_.data(), count});

        const bool to_the_left = (run.bidiLevel & 1) != 0;
        const auto first = static_cast<std::uint32_t>(glyphs_.size());
        placed_glyph* out = glyphs_.append(count);
        if (out == nullptr) return error::out_of_memory;
        double pen = double{x};
        for (UINT32 i = 0; i < count; ++i) {
            double advance = 0.0;
            if (run.glyphAdvances != nullptr)
                advance = double{run.glyphAdvances[i]};
            else if (error e = own_advance(run, i, advance))
                return e;
            const DWRITE_GLYPH_OFFSET offset =
                run.glyphOffsets != nullptr ? run.glyphOffsets[i] : DWRITE_GLYPH_OFFSET{};
            if (to_the_left) pen -= advance;
            const double along = double{offset.advanceOffset};
            placed_glyph& g = out[to_the_left ? count - 1 - i : i];  // in drawing order
            g = {};
            g.id = *slot << 16 | run.glyphIndices[i];
            g.cluster = placed ? of->textPosition + units_[i] : no_cluster;
            g.origin = {to_the_left ? pen - along : pen + along, double{offset.ascenderOffset} - double{y}};
            g.missing = run.glyphIndices[i] == 0 && !(placed && detail::draws_nothing(of->string[units_[i]]));
            if (!to_the_left) pen += advance;
            if (!is_finite(g.origin.x) || !is_finite(g.origin.y) || !is_finite(pen)) return error::outline_not_finite;
        }
        if (placed) find_invalid_units(*of);
        const double begin = double{x};
        const piece whole{
            first, count, line_of(of, 0.0 - double{y}), false, (std::min)(begin, pen), (std::max)(begin, pen)};
        return pieces_.push_back(whole) ? error{} : error{error::out_of_memory};
    }

    /// A face's own advance for a glyph, for runs without advances.
    static error own_advance(const DWRITE_GLYPH_RUN& run, UINT32 i, double& advance) noexcept
    {
        DWRITE_FONT_METRICS face = {};
        DWRITE_GLYPH_METRICS glyph = {};
        run.fontFace->GetMetrics(&face);
        if (error e =
                directwrite_error(run.fontFace->GetDesignGlyphMetrics(&run.glyphIndices[i], 1, &glyph, run.isSideways)))
            return e;
        const UINT32 units = run.isSideways != FALSE ? glyph.advanceHeight : glyph.advanceWidth;
        advance = static_cast<double>(units) * double{run.fontEmSize} / static_cast<double>(face.designUnitsPerEm);
        return {};
    }

    /// Counts unpaired surrogates.
    void find_invalid_units(const DWRITE_GLYPH_RUN_DESCRIPTION& of) noexcept
    {
        const auto at = [&](UINT32 i) noexcept { return static_cast<std::uint32_t>(of.string[i]) & 0xFC00u; };
        for (UINT32 i = 0; i < of.stringLength; ++i) {
            if (at(i) != 0xD800 && at(i) != 0xDC00) continue;
            if (at(i) == 0xD800 && i + 1 < of.stringLength && at(i + 1) == 0xDC00) {
                ++i;
                continue;
            }
            run_.note_invalid_units(of.textPosition + i);
        }
    }

    /// Stores an underline or strike-through whose upper edge lies `offset` below the baseline.
    error add_bar(FLOAT x, FLOAT y, FLOAT width, FLOAT thickness, FLOAT offset) noexcept
    {
        const point low{double{x}, 0.0 - (double{y} + double{offset} + double{thickness})},
            size{double{width}, double{thickness}};
        if (!is_finite(low.x) || !is_finite(low.y) || !is_finite(size.x) || !is_finite(size.y))
            return error::outline_not_finite;
        if (bars_.size() > 0xFFFF) return error::too_large;
        placed_glyph g;
        g.id = static_cast<glyph_id>(bar_slot << 16 | bars_.size());
        g.cluster = no_cluster;
        g.origin = low;
        const piece whole{static_cast<std::uint32_t>(glyphs_.size()),
                          1,
                          line_of(nullptr, 0.0 - double{y}),
                          true,
                          low.x,
                          low.x + size.x};
        if (!bars_.push_back(size) || !glyphs_.push_back(g) || !pieces_.push_back(whole)) return error::out_of_memory;
        return {};
    }

    error add_object(FLOAT x, FLOAT y, IDWriteInlineObject* object) noexcept
    {
        DWRITE_INLINE_OBJECT_METRICS m = {};
        if (error e = directwrite_error(object->GetMetrics(&m))) return e;
        directwrite_object o;
        o.object = object;
        o.low = {double{x}, 0.0 - (double{y} + double{m.height})};
        o.high = {double{x} + double{m.width}, 0.0 - double{y}};
        o.line = line_of(nullptr, 0.0 - (double{y} + double{m.baseline}));
        if (!objects_.push_back(o)) return error::out_of_memory;
        object->AddRef();
        return {};
    }

    /// Sorts the pieces by line and position, letters first, and converts pixels to font units.
    error put_in_order() noexcept
    {
        std::sort(pieces_.begin(), pieces_.end(), [](const piece& a, const piece& b) noexcept {
            if (a.line != b.line) return a.line < b.line;
            if (a.bar != b.bar) return b.bar;
            return !same(a.left, b.left) ? a.left < b.left : a.first < b.first;
        });
        for (point& size : bars_.view()) size = {to_units(size.x), to_units(size.y)};
        for (directwrite_object& o : objects_.view())
            for (point* p : {&o.low, &o.high}) *p = {to_units(p->x), to_units(p->y)};
        if (!run_.glyphs.reserve(glyphs_.size()) || !run_.lines.reserve(lines_.size() + 1)) return error::out_of_memory;

        std::size_t next = 0;
        for (std::uint32_t k = 0; k < lines_.size() || next < pieces_.size(); ++k) {
            text_line line;
            line.first_glyph = static_cast<std::uint32_t>(run_.glyphs.size());
            const double baseline = k < lines_.size() ? lines_[k].baseline : 0.0;
            bool empty = true;
            double left = 0.0, right = 0.0;
            for (; next < pieces_.size() && pieces_[next].line <= k; ++next) {
                const piece& p = pieces_[next];
                if (!p.bar) {
                    left = empty ? p.left : (std::min)(left, p.left);
                    right = empty ? p.right : (std::max)(right, p.right);
                    empty = false;
                }
                for (placed_glyph g : glyphs_.view().subspan(p.first, p.count)) {
                    if ((g.id & 0xFFFF) == 0 && !g.missing && !p.bar) continue;  // a line break, or the like
                    g.origin = {to_units(g.origin.x), to_units(g.origin.y)};
                    if (g.missing) run_.note_missing(g.cluster);
                    run_.glyphs.push_back_unchecked(g);
                }
            }
            line.glyph_count = static_cast<std::uint32_t>(run_.glyphs.size()) - line.first_glyph;
            line.origin = {to_units(left), to_units(baseline)};
            line.advance = to_units(right - left);
            if (!run_.lines.push_back(line)) return error::out_of_memory;
        }
        return {};
    }

    glyph_run run_;
    double em_size_ = 1.0;
    std::uint64_t read_at_ = 0;
    fill_rule rule_ = fill_rule::non_zero;
    buffer<font_slot> slots_;
    buffer<point> bars_;  // the sizes of the bars
    buffer<directwrite_object> objects_;
    buffer<piece> pieces_;
    buffer<placed_glyph> glyphs_;  // in pixels, y up
    buffer<layout_line> lines_;
    buffer<DWRITE_LINE_METRICS> line_metrics_;
    buffer<std::uint32_t> units_;
};

static_assert(outline_source<directwrite_text>);

}  // namespace typemesh::inline TYPEMESH_ABI
