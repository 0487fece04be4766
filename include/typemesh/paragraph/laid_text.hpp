// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/box.hpp>
#include <typemesh/core/impl/first_where.hpp>
#include <typemesh/layout/impl/line_slices.hpp>
#include <typemesh/layout/laid_line.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh::inline TYPEMESH_ABI {

/// The side to which a place between two graphemes belongs. It matters at line ends, and where the direction changes.
enum class affinity : std::uint8_t {
    downstream,  ///< the place belongs to the grapheme after it
    upstream,    ///< the place belongs to the grapheme before it
};

/// The position of a caret.
struct caret {
    std::uint32_t line = 0;
    point at = {};             ///< the caret's position on the baseline, in em
    bool to_the_left = false;  ///< the direction of the grapheme that it belongs to
};

/// A place in the text.
struct text_place {
    std::uint32_t unit = 0;
    affinity side = affinity::downstream;
    bool inside = false;  ///< whether the point was in a line, between its beginning and its end
};

/// A text that a paragraph has laid out, for placing carets, showing selections and finding the text under a mouse
/// pointer. All lengths are in em; text_options::size converts them to output units. It is a view, valid until the
/// paragraph's next call.
///
/// Places are between graphemes. If a cluster has several graphemes (a ligature), the font decides the caret positions;
/// if the font does not say, each grapheme has an equal share of the cluster.
class laid_text {
public:
    laid_text(const shaped_text& shaped, std::span<const laid_line> lines, std::span<const line_slice> slices,
              double units_per_em) noexcept
        : shaped_{&shaped}, lines_{lines}, slices_{slices}, em_{units_per_em}
    {
    }

    /// The box of a line: as wide as its visible part, from descender to ascender. The box is empty if there is no such
    /// line.
    [[nodiscard]] box line_box(std::size_t line) const noexcept
    {
        if (line >= lines_.size()) return {};
        return box_of(lines_[line], lines_[line].left, lines_[line].right());
    }

    /// The line that contains a unit of the text; after the text's end, the last line. Cost: O(log lines)
    [[nodiscard]] std::uint32_t line_of(std::uint32_t unit) const noexcept
    {
        const auto begins_behind = [&](std::size_t k) noexcept { return lines_[k].first > unit; };
        return static_cast<std::uint32_t>(first_where(1, lines_.size(), begins_behind) - 1);
    }

    /// The caret before text[unit], which is moved to the beginning of its grapheme. With affinity::upstream the caret
    /// is at the end of the previous grapheme, unless that is a line break. Without lines it is at (0, 0), in line 0.
    /// Cost: O(log lines), and O(clusters of the line)
    [[nodiscard]] caret caret_at(std::uint32_t unit, affinity side = affinity::downstream) const noexcept
    {
        if (lines_.empty()) return {};
        const auto size = static_cast<std::uint32_t>(shaped_->text().size());
        unit = unit < size ? grapheme_at(unit) : size;
        const bool behind_break = unit > 0 && is_break(grapheme_at(unit - 1));
        const bool back = unit > 0 && !behind_break && (side == affinity::upstream || unit == size);
        const std::uint32_t grapheme = back ? grapheme_at(unit - 1) : unit, line = line_of(grapheme);
        const edges found = edges_of(lines_[line], grapheme);
        return {line, point_of(lines_[line], back ? found.trailing : found.leading), found.to_the_left};
    }

    /// The place nearest to a point; without lines, the text's beginning. Cost: O(lines), and O(clusters of the line)
    [[nodiscard]] text_place caret_from(point p) const noexcept
    {
        if (lines_.empty()) return {};
        const std::size_t k = line_near(p);
        const laid_line& line = lines_[k];
        const bool down = shaped_->in_columns();
        const double along = em_ * (down ? 0.0 - p.y : p.x);
        text_place best{line.first, affinity::downstream, false};
        double beside = 0.0, distance = 0.0;  // distances from the best place: to its grapheme, to its edge
        bool any = false;
        const auto offer = [&](double gap, double edge, text_place place) noexcept {
            if (any && (gap > beside || (gap >= beside && edge >= distance))) return;
            best = place;
            beside = gap;
            distance = edge;
            any = true;
        };
        each_grapheme(line, [&](std::uint32_t unit, const edges& e) noexcept {
            const double low = e.to_the_left ? e.trailing : e.leading, high = e.to_the_left ? e.leading : e.trailing;
            const double gap = along < low ? low - along : along > high ? along - high : 0.0;
            offer(gap, std::fabs(along - e.leading), {unit, affinity::downstream, false});
            if (!is_break(unit))
                offer(gap, std::fabs(along - e.trailing), {next_grapheme(unit), affinity::upstream, false});
        });
        const box all = line_box(k);
        best.inside = p.x >= all.low.x && p.x <= all.high.x && p.y >= all.low.y && p.y <= all.high.y;
        return best;
    }

    /// The grapheme below a point, among the graphemes of the cluster that contains text[unit]; in a ligature, one of
    /// its letters. If the cluster shows other text (an ellipsis), the result is the text that the cluster replaces.
    /// The range is empty without lines, or if the text is not visible there. Cost: O(log lines), and O(clusters of the
    /// line)
    [[nodiscard]] text_range grapheme_at(std::uint32_t unit, point p) const noexcept
    {
        if (lines_.empty() || unit >= shaped_->text().size()) return {};
        const laid_line& line = lines_[line_of(unit)];
        const double along = em_ * (in_columns() ? 0.0 - p.y : p.x);
        text_range found;
        double least = 0.0;
        const auto offer = [&](text_range grapheme, const edges& e) noexcept {
            const double low = e.to_the_left ? e.trailing : e.leading, high = e.to_the_left ? e.leading : e.trailing;
            const double gap = along < low ? low - along : along > high ? along - high : 0.0;
            if (found.last != 0 && !(gap < least)) return;
            found = grapheme;
            least = gap;
        };
        for (const line_slice& s : slices_of(line))
            each_cluster(s, [&](std::uint32_t k, double pen, double width) noexcept {
                const text_cluster& c = shaped_->cluster(k);
                if (unit < c.first || unit >= c.last) return;
                const bool back = s.level % 2 != 0;
                if (has(c.flags, cluster_flags::foreign))
                    return offer({c.first, c.last}, {pen, back ? pen - width : pen + width, back});
                each_part(k, pen, width, back, [&](std::uint32_t at, const edges& e) noexcept {
                    const std::uint32_t next = next_grapheme(at);
                    offer({at, next < c.last ? next : c.last}, e);
                });
            });
        return found;
    }

    /// Whether the text is set in columns.
    [[nodiscard]] bool in_columns() const noexcept { return shaped_->in_columns(); }

    /// Calls put(box) for each part of text[first, last), line by line, from left to right in each line. A line of
    /// mixed directions may have several parts. The box of a grapheme includes a hyphen or kashida that the line adds
    /// to it. The box of dropped text is its ellipsis. Cost: O(clusters of these lines)
    template <class Put>
    void boxes_of(std::uint32_t first, std::uint32_t last, const Put& put) const noexcept
    {
        if (lines_.empty() || first >= last) return;
        for (std::size_t k = line_of(first); k < lines_.size() && lines_[k].first < last; ++k) {
            double left = 0.0, right = 0.0;
            bool open = false;  // a box from left to right, which the next slice may continue
            for (const line_slice& s : slices_of(lines_[k])) {
                const selection chosen = select(s, first, last);
                if (open && !chosen.from_left) put(box_of(lines_[k], left, right)), open = false;
                if (chosen.empty) continue;
                if (!open) left = chosen.left;
                right = chosen.right;
                open = chosen.to_right;
                if (!open) put(box_of(lines_[k], left, right));
            }
            if (open) put(box_of(lines_[k], left, right));
        }
    }

    /// The text, its lines and the slices of a line, from left to right: for code that needs the details.
    [[nodiscard]] const shaped_text& shaped() const noexcept { return *shaped_; }
    [[nodiscard]] std::span<const laid_line> lines() const noexcept { return lines_; }
    /// The slices of one of these lines.
    [[nodiscard]] std::span<const line_slice> slices_of(const laid_line& line) const noexcept
    {
        return slices_.subspan(line.first_slice, line.slices);
    }

    /// Calls with(cluster, pen, width) for each cluster of a slice, in reading order; `pen` is the cluster's start.
    template <class With>
    void each_cluster(const line_slice& s, const With& with) const noexcept
    {
        const bool back = s.level % 2 != 0;
        const double end = back ? s.at : s.at + s.width;
        double pen = back ? s.at + s.width : s.at;
        for (std::uint32_t k = s.first; k < s.last; ++k) {
            double width = width_of(*shaped_, s, k);
            if (k + 1 == s.last) width = std::fabs(end - pen);  // a tab, or a cluster without the spacing after it
            with(k, pen, width);
            pen += back ? -width : width;
        }
    }

private:
    /// The start and the end of a grapheme along its line, in reading order; in font units.
    struct edges {
        double leading = 0.0, trailing = 0.0;
        bool to_the_left = false;
    };

    /// The part of a slice in a range of the text, and whether it reaches the slice's ends.
    struct selection {
        double left = 0.0, right = 0.0;
        bool empty = true, from_left = false, to_right = false;
    };
    [[nodiscard]] selection select(const line_slice& s, std::uint32_t first, std::uint32_t last) const noexcept
    {
        selection found;
        bool begins = false, ends = false, any = false;
        const auto offer = [&](bool chosen, const edges& e) noexcept {
            ends = chosen;
            if (!any) begins = ends;
            any = true;
            if (!ends) return;
            const double left = e.to_the_left ? e.trailing : e.leading, right = e.to_the_left ? e.leading : e.trailing;
            found.left = found.empty || left < found.left ? left : found.left;
            found.right = found.empty || right > found.right ? right : found.right;
            found.empty = false;
        };
        const auto own = [&](std::uint32_t unit, const edges& e) noexcept {
            offer(unit >= first && unit < last && !is_break(unit), e);
        };
        each_grapheme(s, own, [&](text_range instead, const edges& e) noexcept {
            offer(instead.first < last && first < instead.last, e);
        });
        const bool back = s.level % 2 != 0;
        found.from_left = back ? ends : begins;
        found.to_right = back ? begins : ends;
        return found;
    }

    [[nodiscard]] point point_of(const laid_line& line, double along) const noexcept
    {
        const point at = shaped_->in_columns() ? point{line.origin.x, line.origin.y - along}
                                               : point{line.origin.x + along, line.origin.y};
        return (1.0 / em_) * at;
    }
    [[nodiscard]] box box_of(const laid_line& line, double from, double to) const noexcept
    {
        const point a = point_of(line, from), b = point_of(line, to);
        const double low = line.metrics.descender / em_, high = line.metrics.ascender / em_;
        if (shaped_->in_columns()) return {{a.x + low, b.y}, {a.x + high, a.y}};
        return {{a.x, a.y + low}, {b.x, a.y + high}};
    }

    /// The line with the nearest box. If several boxes contain the point, it is the line with the nearest middle.
    [[nodiscard]] std::size_t line_near(point p) const noexcept
    {
        std::size_t best = 0;
        double least = 0.0, beside = 0.0;  // distances from the best line: to its middle, to its box
        for (std::size_t k = 0; k < lines_.size(); ++k) {
            const box b = line_box(k);
            const bool down = shaped_->in_columns();
            const double low = down ? b.low.x - p.x : b.low.y - p.y, high = down ? b.high.x - p.x : b.high.y - p.y;
            const double gap = low > 0.0 ? low : high < 0.0 ? 0.0 - high : 0.0, middle = std::fabs(low + high);
            if (k != 0 && (gap > beside || (gap >= beside && middle >= least))) continue;
            best = k;
            beside = gap;
            least = middle;
        }
        return best;
    }

    [[nodiscard]] bool is_break(std::uint32_t unit) const noexcept
    {
        return unit < shaped_->text().size() && line_end_at(shaped_->text(), unit) != 0;
    }
    [[nodiscard]] std::uint32_t grapheme_at(std::uint32_t unit) const noexcept
    {
        while (unit > 0 && !has(shaped_->analysis.marks[unit], text_mark::grapheme)) --unit;
        return unit;
    }
    [[nodiscard]] std::uint32_t next_grapheme(std::uint32_t unit) const noexcept
    {
        const auto size = static_cast<std::uint32_t>(shaped_->text().size());
        do ++unit;
        while (unit < size && !has(shaped_->analysis.marks[unit], text_mark::grapheme));
        return unit;
    }

    /// Text that an ellipsis replaces has the edges of the ellipsis.
    [[nodiscard]] edges edges_of(const laid_line& line, std::uint32_t grapheme) const noexcept
    {
        edges found{line.level % 2 != 0 ? line.left : line.right(), 0.0, line.level % 2 != 0};  // for dropped text
        if (grapheme == line.first) found.leading = line.level % 2 != 0 ? line.right() : line.left;
        found.trailing = found.leading;
        bool shown = false;
        const auto own = [&](std::uint32_t unit, const edges& e) noexcept {
            if (unit != grapheme) return;
            found = e;
            shown = true;
        };
        const auto foreign = [&](text_range instead, const edges& e) noexcept {
            if (!shown && instead.holds(grapheme)) found = e;
        };
        for (const line_slice& s : slices_of(line)) each_grapheme(s, own, foreign);
        return found;
    }

    /// Calls with(unit, edges) for each visible grapheme of a line. The slices go from left to right; inside a slice
    /// the order is the order of the text.
    template <class With>
    void each_grapheme(const laid_line& line, const With& with) const noexcept
    {
        for (const line_slice& s : slices_of(line)) each_grapheme(s, with, [](text_range, const edges&) noexcept {});
    }
    /// Also calls foreign(text_range, edges) for clusters that show other text in place of a range.
    template <class With, class Foreign>
    void each_grapheme(const line_slice& s, const With& with, const Foreign& foreign) const noexcept
    {
        const bool back = s.level % 2 != 0;
        each_cluster(s, [&](std::uint32_t k, double pen, double width) noexcept {
            const text_cluster& c = shaped_->cluster(k);
            if (has(c.flags, cluster_flags::foreign))
                foreign(text_range{c.first, c.last}, edges{pen, back ? pen - width : pen + width, back});
            else
                each_part(k, pen, width, back, with);
        });
    }
    /// Visits the graphemes of a cluster of this width, which lies to the right of the pen, or to its left if `back`.
    /// The font's caret positions divide the cluster; without caret positions, the graphemes have equal widths.
    template <class With>
    void each_part(std::uint32_t cluster, double pen, double width, bool back, const With& with) const noexcept
    {
        const text_cluster& c = shaped_->cluster(cluster);
        std::uint32_t count = 0;
        const auto begins = [this, &c](std::uint32_t u) noexcept {
            return u == c.first || has(shaped_->analysis.marks[u], text_mark::grapheme);
        };
        for (std::uint32_t u = c.first; u < c.last; ++u) count += begins(u) ? 1u : 0u;
        const std::span<const double> carets = shaped_->carets_of(cluster);
        const bool own = !carets.empty() && carets.size() + 1 == count;
        const auto place = [&](std::uint32_t number) noexcept {  // the edge before a grapheme, relative to the cluster
            if (!own || number == 0 || number == count) return width * number / count;
            return back ? c.advance - carets[count - 1 - number] : carets[number - 1];
        };
        const double way = back ? -1.0 : 1.0;
        std::uint32_t number = 0;
        for (std::uint32_t u = c.first; u < c.last; ++u) {
            if (!begins(u)) continue;
            with(u, edges{pen + way * place(number), pen + way * place(number + 1), back});
            ++number;
        }
    }

    const shaped_text* shaped_;
    std::span<const laid_line> lines_;
    std::span<const line_slice> slices_;
    double em_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
