// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/heap_sort.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/layout/glyph_run.hpp>
#include <typemesh/layout/layout.hpp>
#include <typemesh/layout/variation_axis.hpp>
#include <typemesh/morph/impl/glyph_morpher.hpp>
#include <typemesh/morph/impl/morph_store.hpp>
#include <typemesh/morph/impl/morph_writer.hpp>
#include <typemesh/morph/morph_options.hpp>
#include <typemesh/morph/morph_plan.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Plans texts that move along an axis of a variable font, such as its weight, with the same triangles throughout:
/// morph targets.
///
///     auto weight = harfbuzz_axis::open(*font, "wght");
///     axis_morph morph{*weight};
///     auto plan = morph.plan("breathe", {.depth = 0.1f});
///     plan->write_at(weight->coordinate(550), into(vertices, indices));    // each frame; allocates nothing
///
/// Points lie at the same parameters of the curves at all places of the axis. Between two masters they move evenly
/// along straight lines, exactly as the font's control points do. The triangles of a section are proven to stay
/// counter-clockwise at every place, not only at samples, and outlines to stay simple: morph_proof.hpp. Advances and
/// kerning move with the masters, too. Where the font replaces glyphs along the axis, a new section begins.
///
/// Every mesh of write_at() keeps the tolerance, plus one cell of the grid (1/512 font unit in ordinary fonts).
/// The axis must outlive this object. It keeps its memory for the next text.
///
/// This work is based on: M. Floater, C. Gotsman, "How to morph tilings injectively" (1999), for mappings that are
/// one-to-one because all triangles keep their orientation.
template <variation_axis Axis>
class axis_morph {
public:
    explicit axis_morph(Axis& axis, memory source = heap()) noexcept
        : axis_{&axis},
          source_{source},
          layout_{source},
          morpher_{source},
          run_{source},
          other_{source},
          before_{source},
          third_{source},
          masters_{source},
          changes_{source},
          ends_{source},
          marks_{source},
          keys_{source}
    {
    }

    /// Plans plain text.
    ///
    /// Fails  error::bad_option: from, to, size, depth or crease_degrees is out of range, or "styles": a style, also
    ///        of a space, or a column turns, slants or scales letters, takes them from another face, or adds bars,
    ///        boxes or ruby, which morphs do not draw; error::bad_tolerance
    ///        error::too_large, error::out_of_memory, and the errors of layout() and of the axis
    /// Cost   a few milliseconds for each different letter
    result<morph_plan> plan(text_view text, const morph_options& options) noexcept
    {
        morph_plan made{source_};
        error e = refused(options);
        if (!e) e = find_axis(options);
        if (!e) e = find_ranges(text, options);
        for (std::size_t r = 0; r + 1 < ends_.size() && !e; r += 2) e = add_range(text, options, r, made);
        if (!e) e = finish(options, made);
        if (e) return e;
        return result<morph_plan>{static_cast<morph_plan&&>(made)};
    }

private:
    static constexpr std::size_t max_keys = 64;

    static error refused(const morph_options& o) noexcept
    {
        if (!is_finite(o.tolerance) || !(o.tolerance > 0.0)) return error::bad_tolerance;
        if (!is_finite(o.size) || !(o.size > 0x1p-100) || !(o.size < 0x1p100)) return error::bad("size");
        if (!is_finite(as_double(o.depth)) || !(o.depth >= 0.0f)) return error::bad("depth");
        if (!(o.crease_degrees >= 0.0f && o.crease_degrees <= 180.0f)) return error::bad("crease_degrees");
        return {};
    }

    /// Finds the part of the axis and the masters in it, and possible changes of glyphs.
    error find_axis(const morph_options& o) noexcept
    {
        const auto clamped = [&](double value) noexcept {
            return value < axis_->low() ? axis_->low() : value > axis_->high() ? axis_->high() : value;
        };
        if (!(o.from < o.to)) return error::bad("from");  // NaN, too, which an axis cannot place
        low_ = axis_->coordinate(clamped(o.from));
        high_ = axis_->coordinate(clamped(o.to));
        if (low_ >= high_) return error::bad("from");
        masters_.clear();
        changes_.clear();
        if (error e = axis_->append_masters(masters_)) return e;
        if (error e = axis_->append_changes(changes_)) return e;
        if (!masters_.push_back(low_) || !masters_.push_back(high_)) return error::out_of_memory;
        settle(masters_, low_);
        settle(changes_, low_ + 1);
        return {};
    }

    /// Sorts, and keeps each coordinate once if it lies between `first` and the end.
    void settle(buffer<axis_coordinate>& list, axis_coordinate first) const noexcept
    {
        detail::heap_sort(list.data(), list.size(),
                          [](const axis_coordinate& a, const axis_coordinate& b) noexcept { return a < b; });
        std::size_t kept = 0;
        for (std::size_t i = 0; i < list.size(); ++i)
            if (list[i] >= first && list[i] <= high_ && (kept == 0 || list[kept - 1] != list[i]))
                list[kept++] = list[i];
        list.truncate(kept);
    }

    error shape(text_view text, const morph_options& o, axis_coordinate c, glyph_run& run) noexcept
    {
        if (error e = axis_->move_to(c)) return e;
        if (const auto laid = layout_(axis_->font(), text, o.shape, o.layout, run); !laid) return laid.error();
        for (const glyph_style& drawn : run.glyph_styles)
            if (drawn.face != 0 || !(drawn.map == affine{})) return error::bad("styles");
        return {};
    }

    static bool same_glyphs(const glyph_run& a, const glyph_run& b) noexcept
    {
        if (a.glyphs.size() != b.glyphs.size()) return false;
        for (std::size_t i = 0; i < a.glyphs.size(); ++i)
            if (a.glyphs[i].id != b.glyphs[i].id || a.glyphs[i].cluster != b.glyphs[i].cluster) return false;
        return true;
    }

    /// Divides the part of the axis where glyphs are replaced: the first and the last coordinate of each range, in
    /// ends_. Glyphs are compared at all masters and on both sides of all possible changes.
    error find_ranges(text_view text, const morph_options& o) noexcept
    {
        marks_.clear();
        ends_.clear();
        bool stored = ends_.push_back(low_);
        for (const axis_coordinate c : masters_) stored = stored && marks_.push_back(c);
        for (const axis_coordinate c : changes_) stored = stored && marks_.push_back(c - 1) && marks_.push_back(c);
        if (!stored) return error::out_of_memory;
        settle(marks_, low_);
        if (error e = shape(text, o, low_, before_)) return e;
        for (std::size_t i = 1; i < marks_.size(); ++i) {
            if (error e = shape(text, o, marks_[i], run_)) return e;
            axis_coordinate from = marks_[i - 1];
            while (!same_glyphs(before_, run_)) {  // before_ is shaped at `from`; there may be several changes
                axis_coordinate same = from, changed = marks_[i];
                while (changed - same > 1) {
                    const axis_coordinate middle = same + (changed - same) / 2;
                    if (error e = shape(text, o, middle, other_)) return e;
                    same_glyphs(before_, other_) ? same = middle : changed = middle;
                }
                if (!ends_.push_back(same) || !ends_.push_back(changed)) return error::out_of_memory;
                if (error e = shape(text, o, changed, before_)) return e;
                from = changed;
            }
        }
        return ends_.push_back(high_) ? error{} : error{error::out_of_memory};
    }

    /// Makes the glyphs of a range, then its sections.
    error add_range(text_view text, const morph_options& o, std::size_t range, morph_plan& made) noexcept
    {
        const axis_coordinate first = ends_[range], last = ends_[range + 1];
        if (error e = shape(text, o, first, before_)) return e;
        made.report_.missing = before_.missing > made.report_.missing ? before_.missing : made.report_.missing;
        const double tolerance = o.tolerance * axis_->font().units_per_em();
        for (const placed_glyph& g : before_.glyphs) {
            if (g.missing || number_of(g.id, made.glyphs_) != ~0u) continue;
            if (error e = morpher_.append(*axis_, g.id, masters_.view(), tolerance, as_double(o.crease_degrees),
                                          made.glyphs_))
                return e;
        }
        marks_.clear();
        if (!marks_.push_back(first) || !marks_.push_back(last)) return error::out_of_memory;
        for (const placed_glyph& g : before_.glyphs) {
            const std::uint32_t n = number_of(g.id, made.glyphs_);
            if (g.missing || n == ~0u) continue;
            const morph_glyph& glyph = made.glyphs_.glyphs[n];
            for (const glyph_section& s : made.glyphs_.sections_of(glyph))
                for (const std::uint32_t k : {s.first_key, s.last_key}) {
                    const axis_coordinate c = made.glyphs_.keys_of(glyph)[k];
                    if (c > first && c < last && !marks_.push_back(c)) return error::out_of_memory;
                }
        }
        report(made);
        settle(marks_, first);
        while (marks_.size() > 1 && marks_.back() > last) marks_.truncate(marks_.size() - 1);
        if (first == last) return add_section(text, o, first, last, made);
        const std::size_t count = marks_.size();
        for (std::size_t i = 0; i + 1 < count; ++i) {
            const axis_coordinate a = marks_[i], b = marks_[i + 1];
            if (error e = add_section(text, o, a, b, made)) return e;
        }
        return {};
    }

    static std::uint32_t number_of(glyph_id id, const morph_store& store) noexcept
    {
        for (std::size_t i = 0; i < store.glyphs.size(); ++i)
            if (store.glyphs[i].id == id) return static_cast<std::uint32_t>(i);
        return ~0u;
    }

    error add_section(text_view text, const morph_options& o, axis_coordinate first, axis_coordinate last,
                      morph_plan& made) noexcept
    {
        morph_section s;
        s.first = first;
        s.last = last;
        s.first_letter = made.letters_.size();
        s.first_key = made.keys_.size();
        s.first_origin = made.origins_.size();
        for (const placed_glyph& g : before_.glyphs) {
            const std::uint32_t n = number_of(g.id, made.glyphs_);
            if (g.missing || n == ~0u) continue;
            const morph_glyph& glyph = made.glyphs_.glyphs[n];
            const glyph_section* const over = made.glyphs_.section_over(glyph, first, last);
            if (over == nullptr) continue;
            const auto index = static_cast<std::uint32_t>(over - made.glyphs_.sections.data());
            if (!made.letters_.push_back({n, index, g.cluster})) return error::out_of_memory;
        }
        s.letters = made.letters_.size() - s.first_letter;
        if (error e = find_keys(text, o, s, made)) return e;
        s.keys = made.keys_.size() - s.first_key;
        for (std::size_t k = 0; k < s.keys; ++k) {
            if (error e = shape(text, o, made.keys_[s.first_key + k], run_)) return e;
            std::size_t j = s.first_letter;
            for (const placed_glyph& g : run_.glyphs) {
                if (j == s.first_letter + s.letters) break;
                if (g.id != made.glyphs_.glyphs[made.letters_[j].glyph].id || g.cluster != made.letters_[j].cluster)
                    continue;
                if (!made.origins_.push_back(g.origin)) return error::out_of_memory;
                ++j;
            }
            if (j != s.first_letter + s.letters) return error::bad_outline;  // the axis has concealed a change
        }
        return made.sections_.push_back(s) ? error{} : error{error::out_of_memory};
    }

    /// The keys of a section: its ends, masters, keys of its glyphs, and places where pens do not move evenly.
    error find_keys(text_view text, const morph_options& o, const morph_section& s, morph_plan& made) noexcept
    {
        keys_.clear();
        const auto add = [&](axis_coordinate c) noexcept { return c < s.first || c > s.last || keys_.push_back(c); };
        bool stored = add(s.first) && add(s.last);
        for (const axis_coordinate c : masters_) stored = stored && add(c);
        for (std::size_t j = s.first_letter; j < made.letters_.size(); ++j)
            for (const axis_coordinate c : made.glyphs_.keys_of(made.glyphs_.glyphs[made.letters_[j].glyph]))
                stored = stored && add(c);
        if (!stored) return error::out_of_memory;
        settle(keys_, s.first);
        for (std::size_t k = 0; k + 1 < keys_.size();) {
            const axis_coordinate a = keys_[k], b = keys_[k + 1], middle = a + (b - a) / 2;
            bool even = b - a < 2;
            if (!even) {
                if (error e = shape(text, o, a, run_)) return e;
                if (error e = shape(text, o, b, other_)) return e;
                if (error e = shape(text, o, middle, third_)) return e;
                even = moves_evenly(static_cast<double>(middle - a) / static_cast<double>(b - a));
            }
            if (even) {
                ++k;
                continue;
            }
            if (keys_.size() >= max_keys) return error::bad("layout");
            if (!keys_.push_back(middle)) return error::out_of_memory;
            settle(keys_, s.first);
        }
        return made.keys_.append(keys_.view()) ? error{} : error{error::out_of_memory};
    }

    /// Whether the pens of third_ are those between run_ and other_, as far as whole units can tell: font libraries
    /// round each advance, at both keys and between them.
    [[nodiscard]] bool moves_evenly(double share) const noexcept
    {
        if (run_.glyphs.size() != other_.glyphs.size() || run_.glyphs.size() != third_.glyphs.size()) return false;
        for (std::size_t j = 0; j < run_.glyphs.size(); ++j) {
            const point way = third_.glyphs[j].origin - lerp(run_.glyphs[j].origin, other_.glyphs[j].origin, share);
            const double allowed = 1.0 + static_cast<double>(j + 1);
            if (way.x > allowed || -way.x > allowed || way.y > allowed || -way.y > allowed) return false;
        }
        return true;
    }

    /// Sizes, scratch memory and the error of normals.
    error finish(const morph_options& o, morph_plan& made) noexcept
    {
        made.form_ = {axis_->font().units_per_em(), o.size, static_cast<float>(as_double(o.depth) * o.size), o.frame};
        std::size_t max_points = 0;
        for (morph_section& s : made.sections_) {
            std::uint64_t points = 0, sides = 0, caps = 0;
            for (std::size_t j = s.first_letter; j < s.first_letter + s.letters; ++j) {
                const morph_glyph& g = made.glyphs_.glyphs[made.letters_[j].glyph];
                points += g.points;
                sides += 2 * (std::uint64_t{g.points} + g.hard);
                caps += made.glyphs_.sections[made.letters_[j].section].triangle_count;
            }
            const bool deep = o.depth > 0.0f;
            s.size = {deep ? 2 * points + sides : points, deep ? 2 * caps + 2 * points : caps};
            if (!s.size.fits_32_bits()) return error::too_large;
            const auto n = [](std::uint64_t v) noexcept { return static_cast<std::uint32_t>(v); };
            s.ranges[0] = {0, n(points), 0, n(3 * caps)};
            if (deep) {
                s.ranges[1] = {n(points), n(points), n(3 * caps), n(3 * caps)};
                s.ranges[2] = {n(2 * points), n(sides), n(6 * caps), n(6 * points)};
            }
            max_points = (std::max)(max_points, std::size_t{n(points)});
        }
        if (made.feet_.append(2 * max_points) == nullptr && max_points != 0) return error::out_of_memory;
        for (const morph_glyph& g : made.glyphs_.glyphs)
            if (g.normal_error > made.report_.normal_error) made.report_.normal_error = g.normal_error;
        return {};
    }

    /// Counts the letters of a range; what counts in the end is the range with the most of each kind.
    void report(morph_plan& made) const noexcept
    {
        morph_report here;
        for (const placed_glyph& p : before_.glyphs) {
            const std::uint32_t n = number_of(p.id, made.glyphs_);
            if (p.missing || n == ~0u) continue;
            const morph_glyph& g = made.glyphs_.glyphs[n];
            if (g.points == 0 && !g.refused) continue;
            ++here.letters;
            here.split += g.sections > 1 ? 1u : 0u;
            here.overlapping += g.overlapping ? 1u : 0u;
            here.refused += g.refused ? 1u : 0u;
            here.pinched += g.pinched ? 1u : 0u;
        }
        morph_report& counted = made.report_;
        counted.letters = (std::max)(counted.letters, here.letters);
        counted.split = (std::max)(counted.split, here.split);
        counted.overlapping = (std::max)(counted.overlapping, here.overlapping);
        counted.refused = (std::max)(counted.refused, here.refused);
        counted.pinched = (std::max)(counted.pinched, here.pinched);
    }

    Axis* axis_;
    memory source_;
    plain_layout layout_;
    glyph_morpher morpher_;
    glyph_run run_, other_, before_, third_;
    buffer<axis_coordinate> masters_, changes_, ends_, marks_, keys_;
    axis_coordinate low_ = 0, high_ = 0;
};

}  // namespace typemesh::inline TYPEMESH_ABI
