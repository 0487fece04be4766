// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/layout/impl/cluster_carets.hpp>
#include <typemesh/layout/impl/column_glyphs.hpp>
#include <typemesh/layout/impl/gather_clusters.hpp>
#include <typemesh/layout/impl/item_settings.hpp>
#include <typemesh/layout/impl/itemise.hpp>
#include <typemesh/layout/impl/text_cluster.hpp>
#include <typemesh/layout/impl/text_columns.hpp>
#include <typemesh/layout/impl/text_insets.hpp>
#include <typemesh/layout/impl/white_space.hpp>
#include <typemesh/layout/impl/whole_syllables.hpp>
#include <typemesh/layout/plain_text.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/unicode/text_analysis.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// The glyphs of an item that was shaped elsewhere, or the error of its shaper.
struct shaped_item {
    array_view<const shaped_glyph> glyphs = {};
    error failure = {};
};

/// A text that is shaped once, before it has lines: items, their clusters in the order of the text, and glyphs. After
/// them come parts of items that are shaped again because a line ends there. Lengths are in font units.
///
/// Functions that shape fail with error::out_of_memory, and as the shaper does.
class shaped_text {
public:
    explicit shaped_text(memory source = heap()) noexcept
        : analysis{source},
          styles{source},
          insets{source},
          columns_{source},
          items_{source},
          settings_{source},
          first_clusters_{source},
          clusters_{source},
          glyphs_{source},
          carets_{source}
    {
    }

    text_analysis analysis;  ///< filled in before read()
    style_spans styles;      ///< filled in by read()
    text_insets insets;      ///< filled in by read()

    [[nodiscard]] text_view text() const noexcept { return text_; }
    [[nodiscard]] const shape_options& options() const noexcept { return options_; }
    [[nodiscard]] double units_per_em() const noexcept { return em_; }
    /// Whether its lines are columns: the pen moves down.
    [[nodiscard]] bool in_columns() const noexcept { return options_.direction == direction::top_to_bottom; }

    [[nodiscard]] array_view<const text_item> items() const noexcept { return items_.view(); }
    /// Clusters and glyphs by their numbers. Glyphs are in drawing order inside a cluster.
    [[nodiscard]] const text_cluster& cluster(std::size_t i) const noexcept { return clusters_[i]; }
    [[nodiscard]] const shaped_glyph& glyph(std::size_t i) const noexcept { return glyphs_[i]; }
    [[nodiscard]] const shaped_glyph* glyphs() const noexcept { return glyphs_.data(); }
    /// The number of the text's own clusters, which come first.
    [[nodiscard]] std::uint32_t cluster_count() const noexcept { return own_; }
    [[nodiscard]] std::uint32_t first_cluster(std::size_t item) const noexcept { return first_clusters_[item]; }
    [[nodiscard]] std::uint32_t end_cluster(std::size_t item) const noexcept
    {
        return item + 1 < first_clusters_.size() ? first_clusters_[item + 1] : own_;
    }
    /// The item that contains a unit of the text; 0 after the text's end.
    [[nodiscard]] std::uint32_t item_at(std::uint32_t unit) const noexcept
    {
        const auto k = first_where(0, items_.size(), [&](std::size_t i) noexcept { return items_[i].last > unit; });
        return k < items_.size() ? static_cast<std::uint32_t>(k) : 0;
    }

    /// The default orientation of Latin in this text.
    [[nodiscard]] glyph_orientation latin() const noexcept
    {
        using enum glyph_orientation;
        if (!in_columns()) return horizontal;
        return options_.columns.latin == column_latin::sideways ? sideways : upright;
    }

    /// The settings of an item, and its shape options.
    [[nodiscard]] item_setting setting_of(std::uint32_t item) const noexcept { return settings_[item]; }
    [[nodiscard]] shape_options options_of(std::uint32_t item) const noexcept { return settings_.options_of(item); }

    /// The style that paints a cluster.
    [[nodiscard]] const text_style& style_of(const text_cluster& c) const noexcept
    {
        return styles[styles.number_at(c.first)];
    }

    /// The increase of a cluster's width by letter spacing, in font units.
    [[nodiscard]] double spacing_of(const text_cluster& c) const noexcept
    {
        return has(c.flags, cluster_flags::spaced) ? setting_of(c.item).letter_spacing : 0.0;
    }

    /// The caret positions inside a ligature, along the line from the start of its cluster's pen, in font units,
    /// ascending. One fewer than the ligature's graphemes, or none if the font has none. Cost: O(log ligatures)
    [[nodiscard]] array_view<const double> carets_of(std::uint32_t cluster) const noexcept
    {
        return carets_.of(cluster);
    }

    /// Whether spacing may be added after a cluster: it is visible, and not joined to the next one.
    [[nodiscard]] bool may_be_spaced(const text_cluster& c) const noexcept
    {
        const char32_t letter = decode(text_, c.first).value;
        if (c.glyph_count == 0 || is_default_ignorable(letter)) return false;
        return c.last >= text_.size() || !is_written_joined(letter) || !is_written_joined(decode(text_, c.last).value);
    }

    /// Whether a line that ends before text[place] shows a hyphen.
    [[nodiscard]] bool hyphenates(std::uint32_t place) const noexcept
    {
        if (place < text_.size() && has(analysis.marks[place], text_mark::hyphen)) return true;
        if (text_.encoding() == encoding::utf16) return place >= 1 && text_.unit(place - 1) == 0xAD;
        return place >= 2 && text_.unit(place - 1) == 0xAD && text_.unit(place - 2) == 0xC2;
    }

    /// Reads an analysed text (`analysis` belongs to it) and its styles, and cuts it into items. It shapes nothing yet,
    /// except superscripts and subscripts, to see whether the font has its own.
    ///
    ///     faces    the number of the shaper's faces
    ///
    /// Fails  also as style_spans::read() does
    template <shaper Shaper>
    error read(Shaper& shaper, std::uint32_t faces, text_view text, const shape_options& options) noexcept
    {
        text_ = text;
        options_ = options;
        em_ = shaper.units_per_em();
        own_ = 0;
        first_clusters_.clear();
        clusters_.clear();
        glyphs_.clear();
        carets_.clear();
        keep_syllables_whole(text, analysis);
        if (error e = styles.read(options.styles, analysis, faces)) return e;
        if (error e = insets.read(options, text, styles.borders(), analysis)) return e;
        if (error e = columns_.find(shaper, text, options_, styles, analysis)) return e;
        if (!columns_.runs().empty())  // combined text has become one grapheme
            if (error e = styles.move_out_of(analysis)) return e;
        if (error e = itemise(text, analysis, insets.borders(styles.borders()), columns_.runs(), items_)) return e;
        const item_settings::base plain{options, options.letter_spacing * em_};
        return settings_.read(shaper, text, analysis, styles, plain, items_.view());
    }

    /// Shapes all items, or takes their glyphs if they were shaped elsewhere: `given` then has one entry for each item.
    ///
    /// Fails  also with error::too_large, and with an item's failure
    template <shaper Shaper>
    error shape(Shaper& shaper, array_view<const shaped_item> given = {}) noexcept
    {
        for (std::uint32_t i = 0; i < items_.size(); ++i) {
            if (!first_clusters_.push_back(static_cast<std::uint32_t>(clusters_.size()))) return error::out_of_memory;
            if (error e = add_range(shaper, i, items_[i], given.empty() ? nullptr : &given[i])) return e;
        }
        own_ = static_cast<std::uint32_t>(clusters_.size());
        if (insets.empty()) return {};
        const auto spacing = [this](const text_cluster& c) noexcept { return spacing_of(c); };
        insets.widen(text_, items_.view(), {in_columns(), em_}, spacing, clusters_.view(), glyphs_.data());
        sum_up(0);
        return {};
    }

    /// Appends the clusters of text[first, last), which lies in one item. The text around it is context for shaping.
    template <shaper Shaper>
    error shape_range(Shaper& shaper, std::uint32_t item, std::uint32_t first, std::uint32_t last) noexcept
    {
        text_item part = items_[item];
        part.first = first;
        part.last = last;
        return add_range(shaper, item, part, nullptr);
    }

    void clear() noexcept
    {
        text_ = {};
        analysis.clear();
        styles.clear();
        insets.clear();
        columns_.clear();
        own_ = 0;
        items_.clear();
        settings_.clear();
        first_clusters_.clear();
        clusters_.clear();
        glyphs_.clear();
        carets_.clear();
    }

    /// Removes all clusters and glyphs from these numbers on, if they exist. A moved-from object has none.
    void truncate(std::size_t clusters, std::size_t glyphs) noexcept
    {
        if (clusters < clusters_.size()) clusters_.truncate(clusters);
        if (glyphs < glyphs_.size()) glyphs_.truncate(glyphs);
        carets_.truncate(clusters);
    }
    /// The numbers of all clusters and glyphs, including the ones shaped later.
    [[nodiscard]] std::size_t all_clusters() const noexcept { return clusters_.size(); }
    [[nodiscard]] std::size_t all_glyphs() const noexcept { return glyphs_.size(); }

    /// The advance of an ASCII character in the whole text, without styles.
    template <shaper Shaper>
    result<double> advance_of(Shaper& shaper, char character) noexcept
    {
        const std::size_t before = glyphs_.size();
        text_item alone{.last = 1};
        alone.orientation = latin();
        if (error e = shaper.shape(std::string_view{&character, 1}, alone, options_, glyphs_)) return e;
        double advance = 0.0;
        for (const shaped_glyph& g : glyphs_.view().subspan(before)) advance += g.advance;
        glyphs_.truncate(before);
        return advance;
    }

    /// The advance of clusters [first, last). Cost: O(1). The few clusters that are shaped later are added one by one.
    /// So earlier shaping does not affect the result, not even its rounding.
    [[nodiscard]] double advance(std::uint32_t first, std::uint32_t last) const noexcept
    {
        if (first == last) return 0.0;
        if (first < own_) return clusters_[last - 1].before + clusters_[last - 1].advance - clusters_[first].before;
        double sum = 0.0;
        for (std::uint32_t c = first; c < last; ++c) sum += clusters_[c].advance;
        return sum;
    }

    /// Appends a cluster for text[at] that shows other text, in an item's style: `parts` of `shown`, in drawing order.
    /// The cluster neither hangs nor stretches. Returns whether the font has all its glyphs.
    template <shaper Shaper>
    result<bool> append_foreign(Shaper& shaper, std::uint32_t item, std::uint32_t at, text_view shown,
                                array_view<const text_item> parts) noexcept
    {
        const std::size_t before = glyphs_.size();
        const text_item home = items_.empty() ? text_item{} : items_[item];
        for (text_item part : parts) {
            part.style = home.style;
            part.face = home.face;
            if (error e = shape_other(shaper, item, shown, part)) return e;
        }
        if (error e = make_foreign(item, at, before)) return e;
        for (const shaped_glyph& g : glyphs_.view().subspan(before))
            if (has(g.flags, glyph_flags::missing)) return false;
        return true;
    }
    /// The same in the item's script and direction. It shows `shown`, or, if the font lacks that, `instead`.
    template <shaper Shaper>
    error append_foreign(Shaper& shaper, std::uint32_t item, std::uint32_t at, text_view shown,
                         text_view instead) noexcept
    {
        text_item part = items_.empty() ? text_item{} : items_[item];
        part.first = 0;
        if (part.orientation == glyph_orientation::combined) part.orientation = glyph_orientation::upright;
        const std::size_t clusters = clusters_.size(), glyphs = glyphs_.size();
        for (const text_view wanted : {shown, instead}) {
            truncate(clusters, glyphs);
            part.last = static_cast<std::uint32_t>(wanted.size());
            const auto complete = append_foreign(shaper, item, at, wanted, std::span{&part, 1});
            if (!complete) return complete.error();
            if (*complete) break;
        }
        return {};
    }
    /// Lets a cluster that shows other text replace a range of the text. Its glyphs belong to text[at].
    void move_foreign(std::size_t cluster, text_range instead, std::uint32_t at) noexcept
    {
        text_cluster& c = clusters_[cluster];
        c.first = instead.first;
        c.last = instead.last;
        for (std::uint32_t g = c.glyph; g < c.glyph + c.glyph_count; ++g) glyphs_[g].cluster = at;
    }

    /// Appends a cluster for text[at] that shows a part of other text. The part looks as it does in the whole other
    /// text, in the item's script and direction.
    template <shaper Shaper>
    error append_part(Shaper& shaper, std::uint32_t item, std::uint32_t at, text_view whole, text_range part) noexcept
    {
        text_item all = items_[item];
        all.first = 0;
        all.last = static_cast<std::uint32_t>(whole.size());
        const std::size_t before = glyphs_.size();
        if (error e = shape_other(shaper, item, whole, all)) return e;
        std::size_t kept = before;
        for (std::size_t g = before; g < glyphs_.size(); ++g)
            if (part.holds(glyphs_[g].cluster)) glyphs_[kept++] = glyphs_[g];
        glyphs_.truncate(kept);
        return make_foreign(item, at, before);
    }
    /// Scales the advances of a cluster that shows other text, and of its glyphs.
    void scale_foreign(std::size_t cluster, double scale) noexcept
    {
        text_cluster& c = clusters_[cluster];
        c.advance *= scale;
        for (std::uint32_t g = c.glyph; g < c.glyph + c.glyph_count; ++g) glyphs_[g].advance *= scale;
    }

private:
    /// Appends the clusters of a part of an item, or of a whole item whose glyphs are given.
    template <shaper Shaper>
    error add_range(Shaper& shaper, std::uint32_t item, const text_item& part, const shaped_item* given) noexcept
    {
        const std::uint32_t first = part.first, last = part.last;
        if (first < last && silent_at(text_, first) != 0) {
            const bool tab = text_.unit(first) == 0x09;
            const cluster_flags flags =
                cluster_flags::hangs | cluster_flags::silent | (tab ? cluster_flags::tab : cluster_flags::none);
            const auto none = static_cast<std::uint32_t>(glyphs_.size());
            if (!clusters_.push_back({first, last, none, 0, 0.0, item, flags})) return error::out_of_memory;
            sum_up(clusters_.size() - 1);
            return {};
        }
        if (const auto* box = insets.empty() ? nullptr : insets.box_at(first); box != nullptr) {
            const double wide = em_ * insets.advance_of(*box, in_columns());
            if (error e = insets.append(*box, {first, last}, item, wide, glyphs_, clusters_)) return e;
            sum_up(clusters_.size() - 1);
            return {};
        }
        const std::size_t before = glyphs_.size(), first_cluster = clusters_.size();
        if (first < last) {
            error e = given != nullptr ? given->failure : shaper.shape(text_, part, options_of(item), glyphs_);
            if (!e && given != nullptr && !glyphs_.append(given->glyphs)) e = error::out_of_memory;
            if (e) return e;
        }
        TYPEMESH_ASSERT(come_from(glyphs_.view().subspan(before), part),
                        "a shaper gave a glyph a cluster outside the range of text that it had to shape");
        TYPEMESH_ASSERT(are_in_order(glyphs_.view().subspan(before), part),
                        "a shaper gave clusters that are not in the order of its item");
        if (glyphs_.size() > 0xFFFF'FFFFu) return error::too_large;
        if (part.orientation != glyph_orientation::horizontal)
            if (const affine map = place_in_column(glyphs_.view().subspan(before), part, columns_.metrics());
                part.orientation == glyph_orientation::combined)
                items_[item].squeeze = map.xx;
        scale_glyphs(item, before);
        if (error e = cluster_glyphs(item, part, before)) return e;
        return find_carets(shaper, first_cluster);
    }

    /// Whether glyphs have their clusters in an item. For TYPEMESH_ASSERT.
    [[nodiscard]] static bool come_from(array_view<const shaped_glyph> glyphs, const text_item& item) noexcept
    {
        for (const shaped_glyph& g : glyphs)
            if (g.cluster < item.first || g.cluster >= item.last) return false;
        return true;
    }
    /// Whether the clusters of glyphs ascend, or descend from right to left. For TYPEMESH_ASSERT.
    [[nodiscard]] static bool are_in_order(array_view<const shaped_glyph> glyphs, const text_item& item) noexcept
    {
        for (std::size_t i = 1; i < glyphs.size(); ++i) {
            const cluster_id a = glyphs[i - 1].cluster, b = glyphs[i].cluster;
            if (item.to_the_left() ? a < b : b < a) return false;
        }
        return true;
    }

    /// Appends the glyphs of other text with an item's settings, scaled, and on their side if `part` is sideways.
    template <shaper Shaper>
    error shape_other(Shaper& shaper, std::uint32_t item, text_view other, const text_item& part) noexcept
    {
        const std::size_t before = glyphs_.size();
        if (error e = shaper.shape(other, part, options_of(item), glyphs_)) return e;
        if (part.orientation == glyph_orientation::sideways)
            turn_glyphs(glyphs_.view().subspan(before), columns_.metrics());
        scale_glyphs(item, before);
        return {};
    }

    /// Makes the glyphs from `before` on a cluster for text[at], which shows other text.
    error make_foreign(std::uint32_t item, std::uint32_t at, std::size_t before) noexcept
    {
        text_cluster c{.first = at,
                       .last = at + 1,
                       .glyph = static_cast<std::uint32_t>(before),
                       .glyph_count = static_cast<std::uint32_t>(glyphs_.size() - before),
                       .item = item,
                       .flags = cluster_flags::foreign};
        for (shaped_glyph& g : glyphs_.view().subspan(before)) {
            g.cluster = at;
            c.advance += g.advance;
        }
        if (!clusters_.push_back(c)) return error::out_of_memory;
        sum_up(clusters_.size() - 1);
        return {};
    }

    /// Sums the advances before clusters from `first` on.
    void sum_up(std::size_t first) noexcept
    {
        for (std::size_t i = first; i < clusters_.size(); ++i)
            clusters_[i].before = i == 0 ? 0.0 : clusters_[i - 1].before + clusters_[i - 1].advance;
    }

    /// Gathers the glyphs from `before` on into clusters, and adds the spacing of their item and styles.
    error cluster_glyphs(std::uint32_t item, const text_item& part, std::size_t before) noexcept
    {
        const std::size_t first_cluster = clusters_.size();
        const array_view<const shaped_glyph> glyphs = glyphs_.view().subspan(before);
        if (error e = gather_clusters(text_, analysis.marks.view(), glyphs, {part, item, before}, clusters_)) return e;
        if (is_zero(setting_of(item).letter_spacing) && styles.empty()) return {};
        if (!is_zero(setting_of(item).letter_spacing)) space_clusters(first_cluster, item);
        if (!styles.empty()) widen_spaces(first_cluster);
        sum_up(first_cluster);
        return {};
    }

    /// Adds the spacing after every letter, except letters that are joined to the next one.
    void space_clusters(std::size_t first, std::uint32_t item) noexcept
    {
        const double distance = setting_of(item).letter_spacing;
        for (std::size_t i = first; i < clusters_.size(); ++i) {
            text_cluster& c = clusters_[i];
            if (!may_be_spaced(c)) continue;
            c.flags = c.flags | cluster_flags::spaced;
            widen(c, distance);
            if (!items_[item].to_the_left()) continue;
            for (std::uint32_t g = 0; g < c.glyph_count; ++g)
                glyphs_[c.glyph + g].offset = glyphs_[c.glyph + g].offset + along(distance);
        }
    }

    /// Adds the styles' spacing to spaces.
    void widen_spaces(std::size_t first) noexcept
    {
        for (std::size_t i = first; i < clusters_.size(); ++i) {
            text_cluster& c = clusters_[i];
            if (!has(c.flags, cluster_flags::stretches) || c.glyph_count == 0) continue;
            const double distance = style_of(c).word_spacing * em_;
            if (!is_zero(distance)) widen(c, distance);
        }
    }

    void widen(text_cluster& c, double distance) noexcept
    {
        c.advance += distance;
        glyphs_[c.glyph + c.glyph_count - 1].advance += distance;
    }

    /// Scales the glyphs from `before` on by their item's style.
    void scale_glyphs(std::uint32_t item, std::size_t before) noexcept
    {
        const double scale = setting_of(item).scale;
        for (std::size_t g = before; !same(scale, 1.0) && g < glyphs_.size(); ++g) {
            glyphs_[g].advance *= scale;
            glyphs_[g].offset = scale * glyphs_[g].offset;
        }
    }

    /// Finds the carets inside the clusters from `first` on.
    template <shaper Shaper>
    error find_carets([[maybe_unused]] Shaper& shaper, [[maybe_unused]] std::size_t first) noexcept
    {
        if constexpr (has_ligature_carets<Shaper>) {
            for (std::size_t i = first; i < clusters_.size(); ++i) {
                const text_cluster& c = clusters_[i];
                std::uint32_t inner = 0;  // graphemes after the first
                for (std::uint32_t u = c.first + 1; u < c.last; ++u)
                    inner += has(analysis.marks[u], text_mark::grapheme) ? 1u : 0u;
                if (inner == 0) continue;
                const array_view<const shaped_glyph> own = glyphs_.view().subspan(c.glyph, c.glyph_count);
                const glyph_orientation as = items_[c.item].orientation;
                const cluster_carets::wanted which{.cluster = static_cast<std::uint32_t>(i),
                                                   .count = inner,
                                                   .scale = setting_of(c.item).scale,
                                                   .down = as != glyph_orientation::horizontal,
                                                   .turned = as == glyph_orientation::sideways};
                if (error e = carets_.find(shaper, own, which)) return e;
            }
        }
        return {};
    }

    [[nodiscard]] point along(double distance) const noexcept
    {
        return in_columns() ? point{0.0, 0.0 - distance} : point{distance, 0.0};
    }

    text_view text_;
    shape_options options_;
    double em_ = 0.0;
    std::uint32_t own_ = 0;
    text_columns columns_;
    buffer<text_item> items_;
    item_settings settings_;
    buffer<std::uint32_t> first_clusters_;  // of the items
    buffer<text_cluster> clusters_;
    buffer<shaped_glyph> glyphs_;
    cluster_carets carets_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
