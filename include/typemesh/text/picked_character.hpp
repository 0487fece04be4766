// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/layout/face_metrics.hpp>
#include <typemesh/layout/impl/line_break.hpp>
#include <typemesh/layout/ligature_carets.hpp>
#include <typemesh/text/impl/place_glyphs.hpp>
#include <typemesh/text/text_plan.hpp>
#include <typemesh/unicode/impl/character.hpp>
#include <typemesh/unicode/impl/grapheme_boundaries.hpp>
#include <typemesh/unicode/text_range.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The character of a text that a ray hit.
struct picked_character {
    text_range text = {};  ///< a grapheme, in units of the text; empty for an underline or another bar
    box where = {};        ///< the box from caret to caret and from descender to ascender, in em; also empty for bars
};

namespace detail {

/// The extent of the letters of one cluster of a plain line, in font units of the run.
struct picked_cluster {
    std::uint32_t line = 0, glyph = 0;  // glyph: the first glyph of the cluster in drawing order
    std::uint32_t glyphs = 0;
    text_range text = {};
    double left = 0.0, right = 0.0;  // along the line; downwards in columns
};

/// The coordinate of a place along its line.
[[nodiscard]] inline double along(point p, bool down) noexcept { return down ? 0.0 - p.y : p.x; }

/// The text of a cluster ends at the end of the line or at the start of the line's next cluster.
[[nodiscard]] inline std::uint32_t end_of_cluster(array_view<const placed_glyph> line, text_view text,
                                                  std::uint32_t first) noexcept
{
    auto last = static_cast<std::uint32_t>(text.size());
    for (const placed_glyph& g : line)
        if (g.cluster > first && g.cluster < last) last = g.cluster;
    for (std::uint32_t i = first; i < last; i = static_cast<std::uint32_t>(decode(text, i, last).next))
        if (line_break_at(text, i) != 0) return i;
    return last;
}

[[nodiscard]] inline picked_cluster find_cluster(const glyph_run& run, std::uint32_t glyph, text_view text,
                                                 bool down) noexcept
{
    picked_cluster found;
    const auto size = static_cast<std::uint32_t>(run.glyphs.size());
    text_line line{.glyph_count = size};
    if (!run.lines.empty()) line = run.lines[found.line = line_of(run, glyph)];
    const array_view<const placed_glyph> all = run.letters_of(line);
    const auto begin = static_cast<std::uint32_t>(all.data() - run.glyphs.data());  // behind the backgrounds
    std::uint32_t first = glyph - begin, last = first;
    const cluster_id cluster = all[first].cluster;
    while (first > 0 && all[first - 1].cluster == cluster) --first;
    while (last < all.size() && all[last].cluster == cluster) ++last;
    const auto least = [&](std::uint32_t from, std::uint32_t to) noexcept {
        double low = along(all[from].origin, down);
        for (std::uint32_t i = from + 1; i < to; ++i) low = std::fmin(low, along(all[i].origin, down));
        return low;
    };
    std::uint32_t next = last;
    while (next < all.size() && all[next].cluster == all[last].cluster) ++next;
    found.glyph = begin + first;
    found.glyphs = last - first;
    found.left = first == 0 && line.advance > 0.0 ? along(line.origin, down) : least(first, last);
    found.right = last < all.size() ? least(last, next) : along(line.origin, down) + line.advance;
    found.text = {cluster, end_of_cluster(all, text, cluster)};
    return found;
}

/// The edges between the graphemes of a cluster, from its left, if its font supplies all of them.
template <class Font>
[[nodiscard]] bool find_carets(const Font& font, const glyph_run& run, const picked_cluster& c, std::size_t wanted,
                               bool down, buffer<double>& carets) noexcept
{
    if constexpr (has_ligature_carets<Font>) {
        if (c.glyphs != 1) return false;
        const placed_glyph& g = run.glyphs[c.glyph];
        const glyph_style drawn = run.glyph_styles.empty() ? glyph_style{} : run.glyph_styles[g.glyph_style];
        if (font.ligature_carets(drawn.face, g.id, down, carets) || carets.size() != wanted) return false;
        double before = 0.0;
        for (double& place : carets) {
            place *= down ? 1.0 : drawn.map.xx;
            if (!(place > before)) return false;
            before = place;
        }
        return before < c.right - c.left;
    }
    return false;
}

/// The start of the n-th grapheme of a text, or the end of the text.
[[nodiscard]] inline std::uint32_t nth_grapheme(text_view text, text_range in, std::size_t n) noexcept
{
    grapheme_boundaries begins;
    std::size_t count = 0;
    for (std::uint32_t i = in.first; i < in.last;) {
        const code_point c = decode(text, i, in.last);
        if (begins(character_of(c.value).grapheme) && count++ == n) return i;
        i = static_cast<std::uint32_t>(c.next);
    }
    return in.last;
}

/// The glyph of the run that was hit. If merged glyphs share the triangle, it is the glyph nearest to `at`.
template <class Plan>
[[nodiscard]] std::uint32_t glyph_hit(const Plan& plan, const mesh_hit& hit, double at, bool down) noexcept
{
    if (hit.of_run != shared_glyph) return hit.of_run;
    const auto members = plan.members(hit.glyph);
    std::uint32_t best = members.front();
    double least = 0.0;
    for (const std::uint32_t m : members) {
        const picked_cluster c = find_cluster(plan.run(), m, {}, down);
        const double gap = at < c.left ? c.left - at : at > c.right ? at - c.right : 0.0;
        if (m != best && !(gap < least)) continue;
        best = m;
        least = gap;
    }
    return best;
}

}  // namespace detail

/// The character of a plain text that a ray hit; within a ligature, the letter that it hit.
///
///     auto what = plan->hit(part::front, triangle);
///     auto letter = character_at(*plan, what, point, text, font);      the text and the font of mesher.plan(text)
///
///     at      where the ray hit the mesh, in the mesh's coordinates; for an instance, in the whole text's coordinates
///     down    whether the text was set in columns
///
/// The font divides a ligature into letters (ligature_carets.hpp); without the font's caret positions, the letters get
/// equal shares. Cost: O(glyphs of the line); may allocate where a cluster is several letters
template <class Plan, class Font>
[[nodiscard]] picked_character character_at(const Plan& plan, const mesh_hit& hit, vec3 at, text_view text, Font& font,
                                            bool down = false) noexcept
{
    if (hit.cluster == no_cluster) return {};
    const glyph_run& run = plan.run();
    const double em = run.units_per_em > 0.0 ? run.units_per_em : static_cast<double>(font.units_per_em());
    const double pen = em * detail::along(plan.place_of(at, hit), down);
    const std::uint32_t glyph = detail::glyph_hit(plan, hit, pen, down);
    const detail::picked_cluster c = detail::find_cluster(run, glyph, text, down);
    std::size_t count = 0;
    while (detail::nth_grapheme(text, c.text, count) < c.text.last) ++count;
    if (count == 0) return {};

    buffer<double> carets;
    const bool own = count > 1 && detail::find_carets(font, run, c, count - 1, down, carets);
    const auto edge = [&](std::size_t k) noexcept {  // from the left
        if (own && k > 0 && k < count) return c.left + carets[k - 1];
        return k == count ? c.right : c.left + (c.right - c.left) * static_cast<double>(k) / static_cast<double>(count);
    };
    std::size_t k = 0;
    while (k + 1 < count && pen >= edge(k + 1)) ++k;
    const bidi_class bidi = character_of(decode(text, c.text.first, c.text.last).value).bidi;
    const bool back = !down && (bidi == bidi_class::r || bidi == bidi_class::al);
    const std::size_t number = back ? count - 1 - k : k;
    const line_metrics reach = line_reach_of(font, down ? direction::top_to_bottom : direction::left_to_right);
    const point base = run.lines.empty() ? point{} : run.lines[c.line].origin;
    picked_character found;
    found.text = {detail::nth_grapheme(text, c.text, number), detail::nth_grapheme(text, c.text, number + 1)};
    found.where = down ? box{{base.x + reach.descender, -edge(k + 1)}, {base.x + reach.ascender, -edge(k)}}
                       : box{{edge(k), base.y + reach.descender}, {edge(k + 1), base.y + reach.ascender}};
    found.where = {(1.0 / em) * found.where.low, (1.0 / em) * found.where.high};
    return found;
}

/// The character of a paragraph that a ray hit. `laid` is the paragraph's laid(), and the plan was made from the run
/// into which the paragraph was laid out.
///
///     auto letter = character_at(*plan, plan->hit(part::front, triangle), point, words.laid());
///
/// For a hyphen or an ellipsis, `text` is the text that the hyphen or ellipsis stands for. Cost: O(clusters of the
/// line)
template <class Plan, class Laid>
    requires requires(const Laid& laid) { laid.grapheme_at(std::uint32_t{}, point{}); }
[[nodiscard]] picked_character character_at(const Plan& plan, const mesh_hit& hit, vec3 at, const Laid& laid) noexcept
{
    if (hit.cluster == no_cluster) return {};
    const point p = plan.place_of(at, hit);
    cluster_id cluster = hit.cluster;
    if (hit.of_run == shared_glyph) {
        const bool down = laid.in_columns();
        const double em = plan.run().units_per_em;
        cluster = plan.run().glyphs[detail::glyph_hit(plan, hit, em * detail::along(p, down), down)].cluster;
    }
    picked_character found;
    found.text = laid.grapheme_at(cluster, p);
    double least = 0.0;
    laid.boxes_of(found.text.first, found.text.last, [&](const box& b) noexcept {
        const double x = std::fmax(std::fmax(b.low.x - p.x, p.x - b.high.x), 0.0);
        const double y = std::fmax(std::fmax(b.low.y - p.y, p.y - b.high.y), 0.0);
        if (!found.where.empty() && !(x + y < least)) return;
        found.where = b;
        least = x + y;
    });
    return found;
}

}  // namespace typemesh::inline TYPEMESH_ABI
