// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/colour/colour_glyph.hpp>
#include <typemesh/colour/colour_style.hpp>
#include <typemesh/colour/colour_tables.hpp>
#include <typemesh/colour/glyph_paint.hpp>
#include <typemesh/colour/impl/drawn_layers.hpp>
#include <typemesh/colour/layer_regions.hpp>
#include <typemesh/colour/read_colour_glyph.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/glyph_id.hpp>
#include <typemesh/core/impl/mixed_key.hpp>
#include <typemesh/core/max_pieces.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/discretise/quality.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/outline/face_source.hpp>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI {

/// The options of colour_outlines.
struct colour_options {
    layer_cut layers = layer_cut::visible;     ///< whether layers are cut or stacked
    double tolerance = quality::high;          ///< in em, as the text's own: layers are flattened before they are cut
    colour_choice choice = {};                 ///< the palette, and limits
    std::uint32_t first_style = 0x4000'0000u;  ///< paints get the styles from here on: use smaller numbers for your own
    std::uint32_t max_pieces = default_max_pieces;  ///< the limit for a glyph: see layer_regions::build()
};

/// What split() found in a run.
struct colour_report {
    std::uint32_t coloured = 0;  ///< glyphs that were replaced by their layers
    std::uint32_t refused = 0;   ///< glyphs whose colours cannot be read or cut, which stay as they were
    error first_refusal = {};    ///< the reason for the first of them, with the glyph and its cluster
    std::uint32_t blended = 0;   ///< glyphs with composites whose colours should mix (see colour_layer::blend) and do
                                 ///< not: all in layer_cut::stacked, hue and the like in layer_cut::visible
    std::uint32_t translucent = 0;  ///< glyphs with a translucent layer above others, which is mixed with them in
                                    ///< layer_cut::visible, or that cuts others
    std::uint32_t unbounded = 0;    ///< glyphs that lack a layer without bounds
    std::uint32_t pictures = 0;     ///< glyphs without layers and without an outline in a font with bitmaps or SVG
                                    ///< drawings: blanks, or pictures, which are not drawn
};

/// Draws the colour glyphs of fonts as layers: an outline source around another one, whose glyphs and faces it keeps,
/// and a change of runs.
///
///     colour_outlines colours{*font};
///     auto tables = harfbuzz_colours::of(*font);              // the bytes of 'COLR' and 'CPAL'
///     colours.use(0, tables->tables());
///     text_mesher mesher{colours};
///     auto plan = mesher.plan(text, options, colours.edit());  // or: colours.split(run); mesher.plan(run, options);
///
/// split() replaces each colour glyph of a run by a glyph for each of its layers, at the same place, of the same
/// cluster, from the lowest to the uppermost. A layer has a style for its paint, which style_of() explains. So texts
/// sort by colour as by any other style. Opaque layers of the text's own colour, at level 0, keep the style of the
/// glyph. Other glyphs stay as they are.
///
/// The layers of layer_cut::visible tile the glyph: each is a closed solid, and solids that meet have common edges.
/// They do only if the text is meshed with the discretiser `certified`, with the same tolerance, at the glyphs' own
/// scale or a power of two of it, and if touching corners are kept. For layer_cut::stacked, see colour_style::level.
///
/// The number of a layer's glyph tells glyph and layer: any colour_outlines with the same fonts and options draws it,
/// also one that has not split the run (for workers). Built layers are kept, for each variation of the source, until
/// clear(). One thread at a time.
template <outline_source Source>
class colour_outlines {
public:
    /// The source, and with it its shaper if it is one, must outlive this object.
    explicit colour_outlines(Source& source, const colour_options& options = {}, memory from = heap()) noexcept
        : source_{&source}, options_{options}, faces_{from}, glyph_{from}, regions_{from}, layers_{from}, out_{from}
    {
    }

    /// Gives the colour tables of a face, which must outlive this object. Faces without tables have no colours. Call it
    /// again after the font's variation has changed, for colour_tables::axes; built layers and styles are dropped.
    ///
    /// Fails  error::out_of_memory
    [[nodiscard]] result<void> use(std::uint32_t face, const colour_tables& tables) noexcept
    {
        while (faces_.size() <= face)
            if (!faces_.push_back({})) return error::out_of_memory;
        faces_[face] = tables;
        layers_.clear();
        return {};
    }

    [[nodiscard]] const colour_options& options() const noexcept { return options_; }
    /// Other options: the built layers and the styles are dropped.
    void use(const colour_options& options) noexcept
    {
        options_ = options;
        layers_.clear();
    }

    /// Drops built layers and styles. Memory is kept.
    void clear() noexcept { layers_.clear(); }

    /// Replaces the colour glyphs of a run by their layers. Lines, clusters and reports stay right. Bars and missing
    /// glyphs stay.
    ///
    /// Fails  error::out_of_memory, error::no_such_glyph_style; the run is then unchanged
    /// Cost   O(glyphs), and the reading and cutting of each different colour glyph once
    [[nodiscard]] result<colour_report> split(glyph_run& run) noexcept;

    /// split() as the edit of text_mesher::plan(); report() gives the result.
    [[nodiscard]] auto edit() noexcept
    {
        return [this](glyph_run& run) noexcept { last_ = split(run); };
    }
    [[nodiscard]] const result<colour_report>& report() const noexcept { return last_; }

    /// The styles that split() has given, from options().first_style on.
    [[nodiscard]] array_view<const colour_style> styles() const noexcept { return layers_.styles(); }

    /// The paint behind a style of split(); null for all other styles.
    [[nodiscard]] const colour_style* style_of(style_id style) const noexcept
    {
        const std::uint32_t number = static_cast<std::uint32_t>(style) - options_.first_style;
        return number < layers_.styles().size() ? &layers_.styles()[number] : nullptr;
    }
    /// The stops of a style's gradient.
    [[nodiscard]] array_view<const gradient_stop> stops_of(const colour_style& style) const noexcept
    {
        return layers_.stops().subspan(style.paint.first_stop, style.paint.stop_count);
    }
    /// The height of a style's layers in a stack: see colour_style::level. 0 for all other styles.
    [[nodiscard]] std::uint32_t level_of(style_id style) const noexcept
    {
        const colour_style* const own = style_of(style);
        return own == nullptr ? 0 : own->level;
    }
    /// One more than the highest level of any style.
    [[nodiscard]] std::uint32_t level_count() const noexcept
    {
        std::uint32_t most = 0;
        for (const colour_style& s : layers_.styles()) most = s.level > most ? s.level : most;
        return most + 1;
    }

    // ---- an outline source, of all faces ----

    [[nodiscard]] double units_per_em() const noexcept { return source_->units_per_em(); }
    [[nodiscard]] fill_rule fill() const noexcept { return drew_layer_ ? fill_rule::non_zero : source_->fill(); }
    [[nodiscard]] std::uint32_t face_count() noexcept { return face_count_of(*source_); }
    [[nodiscard]] double units_per_em(std::uint32_t face) noexcept { return units_per_em_of(*source_, face); }
    [[nodiscard]] fill_rule fill(std::uint32_t face) noexcept
    {
        return drew_layer_ ? fill_rule::non_zero : fill_of(*source_, face);
    }
    [[nodiscard]] std::uint64_t variation_key() const noexcept
    {
        std::uint64_t key = mixed(variation_of(*source_));
        for (const colour_tables& face : faces_) key = with_axes(key, face);
        return key;
    }
    [[nodiscard]] std::uint64_t variation_key(std::uint32_t face) const noexcept
    {
        const std::uint64_t key = mixed(variation_of(*source_, face));
        return face < faces_.size() ? with_axes(key, faces_[face]) : key;
    }

    template <outline_sink Sink>
    error outline(std::uint32_t face, glyph_id id, Sink& sink) noexcept
    {
        drew_layer_ = detail::is_layer(id);
        if (!drew_layer_) return outline_of(*source_, face, id, sink);
        const auto found = built(face, detail::glyph_of_layer(id));
        if (!found) return found.error();
        return layers_.draw(*found, detail::number_of_layer(id), sink) ? error{}
                                                                       : error{error::unknown_glyph}.at(id, no_cluster);
    }
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        return outline(0, id, sink);
    }

    // ---- a shaper, if the source is one ----

    [[nodiscard]] line_metrics metrics(direction d) noexcept
        requires shaper<Source>
    {
        return source_->metrics(d);
    }
    error shape(text_view text, const text_item& item, const shape_options& how, buffer<shaped_glyph>& glyphs) noexcept
        requires shaper<Source>
    {
        return source_->shape(text, item, how, glyphs);
    }
    [[nodiscard]] bool has_vertical_form(char32_t c) noexcept
        requires shaper<Source>
    {
        return vertical_form_of(*source_, c);
    }
    [[nodiscard]] double column_middle() noexcept
        requires shaper<Source>
    {
        return column_middle_of(*source_);
    }

private:
    /// What of the options decides how a layer is drawn.
    [[nodiscard]] std::uint64_t mixed(std::uint64_t key) const noexcept
    {
        std::uint64_t tolerance = 0;
        std::memcpy(&tolerance, &options_.tolerance, sizeof tolerance);
        key = mixed_key(mixed_key(key, tolerance), static_cast<std::uint64_t>(options_.layers));
        return mixed_key(key, mixed_key(options_.choice.max_layers, options_.choice.max_paints));
    }

    [[nodiscard]] static std::uint64_t with_axes(std::uint64_t key, const colour_tables& face) noexcept
    {
        for (const std::int32_t place : face.axes) key = mixed_key(key, static_cast<std::uint32_t>(place));
        return key;
    }

    /// The number of a glyph's built layers, which are built if they are not there. Without layers if the font has no
    /// colours for it, or if they are refused.
    [[nodiscard]] result<std::size_t> built(std::uint32_t face, glyph_id id) noexcept
    {
        const detail::drawn_layers::glyph wanted{.face = face, .id = id, .variation = variation_of(*source_, face)};
        if (const std::size_t known = layers_.find(wanted); known != detail::drawn_layers::none) return known;
        bool coloured = false;
        error refusal;
        if (face < faces_.size()) {
            const auto found = read_colour_glyph(faces_[face], id, options_.choice, glyph_);
            if (found)
                coloured = *found;
            else
                refusal = found.error();
            if (coloured) {
                const auto cut =
                    regions_.build(*source_, face, glyph_, options_.tolerance, options_.layers, options_.max_pieces);
                if (!cut) refusal = cut.error();
            }
        } else {
            glyph_.clear();
        }
        if (refusal == error::out_of_memory) return refusal;
        detail::drawn_layers::glyph made = wanted;
        made.coloured = coloured && !refusal;
        made.refusal = refusal;
        return layers_.add(made, glyph_, regions_, options_.layers == layer_cut::stacked);
    }

    /// Whether a glyph of a face has no outline.
    [[nodiscard]] bool is_blank(std::uint32_t face, glyph_id id) noexcept
    {
        detail::blank_pen pen;
        return !outline_of(*source_, face, id, pen) && pen.is_blank;
    }

    [[nodiscard]] error split_glyph(glyph_run& run, const placed_glyph& g, colour_report& report) noexcept;

    Source* source_;
    colour_options options_;
    buffer<colour_tables> faces_;
    colour_glyph glyph_;
    layer_regions regions_;
    detail::drawn_layers layers_;
    buffer<placed_glyph> out_;
    bool drew_layer_ = false;
    result<colour_report> last_ = colour_report{};
};

template <outline_source Source>
error colour_outlines<Source>::split_glyph(glyph_run& run, const placed_glyph& g, colour_report& report) noexcept
{
    const std::size_t styles = run.glyph_styles.size();
    if (styles != 0 && g.glyph_style >= styles) return {error::no_such_glyph_style, styles};
    glyph_style look = styles == 0 ? glyph_style{} : run.glyph_styles[g.glyph_style];
    const bool has_tables = look.face < faces_.size() && g.cluster != no_cluster && !g.missing;
    if (!has_tables || detail::is_layer(g.id)) return out_.push_back(g) ? error{} : error::out_of_memory;
    const auto found = built(look.face, g.id);
    if (!found) return found.error();
    const detail::drawn_layers::glyph& drawn = layers_[*found];
    const colour_tables& tables = faces_[look.face];
    if (drawn.refusal) {
        if (report.refused++ == 0) report.first_refusal = drawn.refusal.at(g.id, g.cluster);
    } else if (!drawn.coloured && (tables.has_bitmaps || tables.has_drawings) && is_blank(look.face, g.id)) {
        ++report.pictures;
    }
    if (!drawn.coloured) return out_.push_back(g) ? error{} : error::out_of_memory;
    ++report.coloured;
    report.blended += drawn.blended ? 1u : 0u;
    report.translucent += drawn.translucent ? 1u : 0u;
    report.unbounded += drawn.unbounded ? 1u : 0u;
    const style_id own = look.style;
    for (std::uint32_t i = 0; i < drawn.count; ++i) {
        if (layers_.is_empty(*found, i)) continue;
        const auto style = layers_.style(*found, i, own);
        if (!style) return style.error();
        look.style = *style == detail::drawn_layers::own_style ? own : style_id{options_.first_style + *style};
        const auto number = run.number_of(look);
        if (!number) return number.error();
        placed_glyph layer = g;
        layer.id = detail::layer_of(g.id, i);
        layer.glyph_style = *number;
        if (!out_.push_back(layer)) return error::out_of_memory;
    }
    return {};
}

template <outline_source Source>
result<colour_report> colour_outlines<Source>::split(glyph_run& run) noexcept
{
    colour_report report;
    out_.clear();
    const std::size_t styles = run.glyph_styles.size();
    std::size_t line = 0;
    bool ok = true;
    buffer<std::uint32_t>& firsts = layers_.scratch();  // the first glyph of each line in the new run, and its end
    firsts.clear();
    error e;
    for (std::size_t i = 0; i <= run.glyphs.size() && !e && ok; ++i) {
        for (; line < run.lines.size() && run.lines[line].first_glyph == i && ok; ++line)
            ok = firsts.push_back(static_cast<std::uint32_t>(out_.size()));
        if (i < run.glyphs.size() && ok) e = split_glyph(run, run.glyphs[i], report);
    }
    if (!ok) e = error::out_of_memory;
    if (e) {
        run.glyph_styles.truncate(styles);
        return e;
    }
    TYPEMESH_ASSERT(firsts.size() == run.lines.size(), "the lines of a run do not follow each other");
    for (std::size_t i = 0; i < firsts.size(); ++i) {
        const std::uint32_t end = i + 1 < firsts.size() ? firsts[i + 1] : static_cast<std::uint32_t>(out_.size());
        run.lines[i].first_glyph = firsts[i];
        run.lines[i].glyph_count = end - firsts[i];
    }
    run.glyphs.swap(out_);
    return report;
}

}  // namespace typemesh::inline TYPEMESH_ABI
