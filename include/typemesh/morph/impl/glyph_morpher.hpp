// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/box.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/morph/impl/contour_chords.hpp>
#include <typemesh/morph/impl/keyed_outlines.hpp>
#include <typemesh/morph/impl/morph_normals.hpp>
#include <typemesh/morph/impl/morph_points.hpp>
#include <typemesh/morph/impl/morph_proof.hpp>
#include <typemesh/morph/impl/morph_store.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Makes the morph of one glyph after another: its keys, points, sections and triangles.
class glyph_morpher {
public:
    explicit glyph_morpher(memory source = heap()) noexcept
        : outlines_{source},
          points_{source},
          proof_{source},
          chords_{source},
          members_{source},
          groups_{source},
          owners_{source},
          areas_{source},
          waiting_{source},
          found_{source},
          triangles_{source}
    {
    }

    /// Appends a glyph to a store. A glyph for which no triangles are found is no failure: it is then `refused`.
    ///
    ///     masters      coordinates that ascend: the ends of the stretch of the axis, and all between them where the
    ///                  outline may stop moving evenly
    ///     tolerance    in font units
    ///
    /// Fails  error::out_of_memory
    template <variation_axis Axis>
    error append(Axis& axis, glyph_id id, array_view<const axis_coordinate> masters, double tolerance,
                 double crease_degrees, morph_store& out) noexcept
    {
        morph_glyph glyph{.id = id,
                          .first_key = out.keys.size(),
                          .first_point = out.points.size(),
                          .first_corner = out.corners.size(),
                          .first_section = static_cast<std::uint32_t>(out.sections.size())};
        found_.clear();
        triangles_.clear();
        error e = read(axis, id, masters, tolerance, glyph);
        if (!e && points_.count() != 0) e = solve(axis, id, glyph);
        if (e == error::out_of_memory) return e;
        if (e) {
            glyph.refused = true;
            glyph.reason = e.at(id, no_cluster);
            return out.glyphs.push_back(glyph) ? error{} : error{error::out_of_memory};
        }
        if (points_.count() == 0) return out.glyphs.push_back(glyph) ? error{} : error{error::out_of_memory};
        return keep(crease_degrees, glyph, out);
    }

private:
    static constexpr std::size_t max_keys = 64;
    static constexpr std::uint32_t none = ~0u;
    static constexpr axis_coordinate shortest = 128;  ///< sections are not divided below this length

    /// A stretch of the axis that was proven, with its triangles.
    struct proven_stretch {
        axis_coordinate first, last;
        std::size_t first_triangle, end_triangle;
    };
    struct stretch {
        axis_coordinate first, last;
    };

    /// Records the glyph and divides its curves.
    template <variation_axis Axis>
    error read(Axis& axis, glyph_id id, array_view<const axis_coordinate> masters, double tolerance,
               morph_glyph& glyph) noexcept
    {
        if (error e = outlines_.record(axis, id, masters)) return e;
        const auto fitted = grid::fitting(axis.font().units_per_em(), outlines_.bounds());
        if (!fitted) return fitted.error();
        grid_ = *fitted;
        while (!is_within(0.25)) grid_.cells *= 0.5;
        glyph.cells = grid_.cells;
        if (error e = settle_keys(axis, id)) return e;
        if (error e = points_.divide(outlines_, tolerance, grid_)) return e;
        if (whole_area() < 0.0) points_.reverse();
        return {};
    }

    /// Forgets keys where the outline does not stop moving evenly, and checks that it moves evenly between the others.
    template <variation_axis Axis>
    error settle_keys(Axis& axis, glyph_id id) noexcept
    {
        outlines_.forget_unbent(0.125 / grid_.cells);
        if (outlines_.keys() > max_keys) return error::bad_outline;
        for (std::size_t k = 0; k + 1 < outlines_.keys();) {
            const axis_coordinate a = outlines_.coordinates()[k], b = outlines_.coordinates()[k + 1];
            if (b - a < 2) {
                ++k;
                continue;
            }
            const auto key = outlines_.insert(axis, id, a + (b - a) / 2);
            if (!key) return key.error();
            if (!is_within(0.5)) return error::outline_beyond_grid;
            if (outlines_.bend_at(*key) * grid_.cells <= 0.5) {
                outlines_.remove(*key);
                ++k;
            }
            if (outlines_.keys() > max_keys) return error::bad_outline;
        }
        return {};
    }

    /// Whether no point is farther out than a share of what a proof can take, at the keys up to now. At later keys of a
    /// damaged font they may be anywhere; up to half, there is room for the frame around them.
    [[nodiscard]] bool is_within(double share) const noexcept
    {
        const box& b = outlines_.bounds();
        const double limit = share * area_path::reach / grid_.cells;
        return b.empty() || (b.low.x >= -limit && b.low.y >= -limit && b.high.x <= limit && b.high.y <= limit);
    }

    /// The sum of the areas of a contour at all keys, doubled.
    [[nodiscard]] double area(std::uint32_t contour) const noexcept
    {
        double sum = 0.0;
        const std::size_t n = points_.count();
        for (std::size_t k = 0; k < outlines_.keys(); ++k)
            for (std::uint32_t i = points_.starts[contour], last = points_.starts[contour + 1], p = last - 1; i < last;
                 p = i++) {
                const grid_point a = points_.places[k * n + p], b = points_.places[k * n + i];
                sum += static_cast<double>(a.x) * b.y - static_cast<double>(a.y) * b.x;
            }
        return sum;
    }
    [[nodiscard]] double whole_area() const noexcept
    {
        double sum = 0.0;
        for (std::uint32_t c = 0; c < points_.contours(); ++c) sum += area(c);
        return sum;
    }

    /// First the glyph as one solid; if its contours cross anywhere, a solid for each outer contour.
    template <variation_axis Axis>
    error solve(Axis& axis, glyph_id id, morph_glyph& glyph) noexcept
    {
        const auto at = outlines_.coordinates();
        const stretch whole{at[0], at[at.size() - 1]};
        glyph_pieces_ = false;
        if (error e = group_all()) return e;
        if (error e = prove(axis, id, whole)) return e;
        const axis_coordinate length = whole.last - whole.first;
        if (crosses_ && covered() != length && points_.contours() > 1)
            if (error e = prove_pieces(axis, id, whole, glyph)) return e;
        if (crosses_ && covered() != length) {
            bool divided = false;
            if (error e = chords_.divide(points_, outlines_, grid_, divided)) return e;
            if (divided)
                if (error e = prove_pieces(axis, id, whole, glyph)) return e;
        }
        if (crosses_ && !glyph_pieces_) {  // a hole lies in no contour: as one solid, where that is possible
            if (error e = group_all()) return e;
            glyph_pieces_ = true;
            found_.clear();
            triangles_.clear();
            if (error e = prove(axis, id, whole)) return e;
        }
        glyph.refused = covered() != length;
        return {};
    }

    /// A solid for each outer contour.
    template <variation_axis Axis>
    error prove_pieces(Axis& axis, glyph_id id, stretch whole, morph_glyph& glyph) noexcept
    {
        bool good = false;
        if (error e = group_by_contours(good)) return e;
        glyph_pieces_ = good;
        found_.clear();
        triangles_.clear();  // what was found belongs to other points
        if (!good) return {};
        glyph.overlapping = true;
        for (std::size_t k = outlines_.keys() - 1; k-- > 1;)  // the glyph as one solid may have been divided in vain
            if (outlines_.bend_at(k) * grid_.cells <= 0.5) outlines_.remove(k);
        if (error e = points_.place_all(outlines_, grid_)) return e;
        return prove(axis, id, whole);
    }

    [[nodiscard]] axis_coordinate covered() const noexcept
    {
        axis_coordinate sum = 0;
        for (const proven_stretch& s : found_) sum += s.last - s.first;
        return sum;
    }

    /// Proves the groups in as few sections as possible. Sets crosses_.
    template <variation_axis Axis>
    error prove(Axis& axis, glyph_id id, stretch whole) noexcept
    {
        crosses_ = false;
        waiting_.clear();
        if (!waiting_.push_back(whole)) return error::out_of_memory;
        while (!waiting_.empty()) {
            const stretch now = waiting_.back();
            waiting_.truncate(waiting_.size() - 1);
            const std::size_t first = key_at(now.first), last = key_at(now.last), before = triangles_.size();
            bool all = true, hopeless = false;
            for (std::size_t g = 0; g + 1 < groups_.size() && all; ++g) {
                const auto found = proof_(points_, members_.view().subspan(groups_[g], groups_[g + 1] - groups_[g]),
                                          {first, last - first, 0, area_path::parts}, triangles_);
                if (!found) return found.error();
                all = *found == morph_proof::finding::proven;
                hopeless = hopeless || *found == morph_proof::finding::crossing;
                crosses_ = crosses_ || (!all && proof_.crossed_anywhere());
            }
            if (all) {
                if (!found_.push_back({now.first, now.last, before, triangles_.size()})) return error::out_of_memory;
                continue;
            }
            triangles_.truncate(before);
            if (hopeless || (!glyph_pieces_ && crosses_)) continue;
            if (error e = divide(axis, id, now, first, last)) return e;
        }
        return {};
    }

    /// Puts the two halves of a stretch on the list, the first on top; nothing if it is too short.
    template <variation_axis Axis>
    error divide(Axis& axis, glyph_id id, stretch now, std::size_t first, std::size_t last) noexcept
    {
        axis_coordinate middle = now.first + (now.last - now.first) / 2;
        if (last - first > 1) {
            middle = outlines_.coordinates()[(first + last) / 2];
        } else {
            if (now.last - now.first < 2 * shortest || outlines_.keys() >= max_keys) return {};
            const auto key = outlines_.insert(axis, id, middle);
            if (!key) return key.error();
            if (!is_within(0.5)) return error::outline_beyond_grid;
            if (error e = points_.place_all(outlines_, grid_)) return e;
        }
        return waiting_.push_back({middle, now.last}) && waiting_.push_back({now.first, middle})
                   ? error{}
                   : error{error::out_of_memory};
    }

    [[nodiscard]] std::size_t key_at(axis_coordinate c) const noexcept
    {
        std::size_t k = 0;
        while (outlines_.coordinates()[k] != c) ++k;
        return k;
    }

    error group_all() noexcept
    {
        members_.clear();
        groups_.clear();
        bool good = groups_.push_back(0);
        for (std::uint32_t c = 0; c < points_.contours(); ++c) good = good && members_.push_back(c);
        good = good && groups_.push_back(points_.contours());
        return good ? error{} : error{error::out_of_memory};
    }

    /// Each outer contour, with the holes for which it is the smallest outer contour around. The union of these solids
    /// is the glyph's own area, whichever holes belong to which of them, if each of them is proven: the winding numbers
    /// of the solids are 0 and 1, and their sum is the glyph's. `good` is false if a hole lies in no outer contour.
    ///
    /// Cost   O(points), and O(contours + points of contours that are larger) for each hole
    error group_by_contours(bool& good) noexcept
    {
        members_.clear();
        groups_.clear();
        areas_.clear();
        owners_.clear();
        const std::uint32_t count = points_.contours();
        bool stored = groups_.push_back(0);
        for (std::uint32_t c = 0; c < count; ++c) stored = stored && areas_.push_back(area(c));
        if (!stored) return error::out_of_memory;
        good = true;
        for (std::uint32_t c = 0; c < count && stored; ++c) {
            const std::uint32_t owner = areas_[c] < 0.0 ? smallest_around(c) : c;
            good = good && owner != none;
            stored = owners_.push_back(owner);
        }
        for (std::uint32_t c = 0; c < count && stored; ++c) {
            if (areas_[c] < 0.0) continue;
            stored = members_.push_back(c);
            for (std::uint32_t h = 0; h < count && stored; ++h)
                if (h != c && owners_[h] == c) stored = members_.push_back(h);
            stored = stored && groups_.push_back(static_cast<std::uint32_t>(members_.size()));
        }
        return stored ? error{} : error{error::out_of_memory};
    }

    [[nodiscard]] std::uint32_t smallest_around(std::uint32_t hole) const noexcept
    {
        std::uint32_t best = none;
        for (std::uint32_t c = 0; c < points_.contours(); ++c)
            if (areas_[c] > -areas_[hole] && (best == none || areas_[c] < areas_[best]) &&
                surrounds(c, points_.places[points_.starts[hole]]))
                best = c;
        return best;
    }

    /// Whether a contour goes around a place at the first key.
    [[nodiscard]] bool surrounds(std::uint32_t contour, grid_point p) const noexcept
    {
        int winding = 0;
        for (std::uint32_t i = points_.starts[contour], last = points_.starts[contour + 1], b = last - 1; i < last;
             b = i++) {
            const grid_point u = points_.places[b], v = points_.places[i];
            if ((u.y <= p.y) == (v.y <= p.y)) continue;
            const std::int64_t side = orientation(u, v, p);
            if (u.y <= p.y && side > 0) ++winding;
            if (u.y > p.y && side < 0) --winding;
        }
        return winding != 0;
    }

    /// Moves everything into the store.
    error keep(double crease_degrees, morph_glyph& glyph, morph_store& out) noexcept
    {
        glyph.points = points_.count();
        glyph.keys = static_cast<std::uint32_t>(outlines_.keys());
        if (!out.keys.append(outlines_.coordinates()) || !out.points.append(points_.places.view()))
            return error::out_of_memory;
        if (error e = morph_normals{outlines_, points_, crease_degrees}.append(out, glyph)) return e;
        sort_found();
        for (const proven_stretch& s : found_) {
            const auto first = static_cast<std::uint32_t>(out.triangles.size());
            const auto mine = triangles_.view().subspan(s.first_triangle, s.end_triangle - s.first_triangle);
            const std::size_t from = key_at(s.first), to = key_at(s.last);
            if (!out.triangles.append(mine) ||
                !out.sections.push_back({static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to), first,
                                         static_cast<std::uint32_t>(mine.size())}))
                return error::out_of_memory;
            for (std::size_t k = from; k <= to; ++k)
                for (const triangle& t : mine) {
                    const grid_point* const at = points_.places.data() + k * points_.count();
                    glyph.pinched = glyph.pinched || orientation(at[t.a], at[t.b], at[t.c]) == 0;
                }
        }
        glyph.sections = static_cast<std::uint32_t>(found_.size());
        return out.glyphs.push_back(glyph) ? error{} : error{error::out_of_memory};
    }

    /// By coordinate; there are few.
    void sort_found() noexcept
    {
        for (std::size_t i = 1; i < found_.size(); ++i)
            for (std::size_t j = i; j > 0 && found_[j].first < found_[j - 1].first; --j) {
                const proven_stretch s = found_[j];
                found_[j] = found_[j - 1];
                found_[j - 1] = s;
            }
    }

    keyed_outlines outlines_;
    morph_points points_;
    morph_proof proof_;
    contour_chords chords_;
    buffer<std::uint32_t> members_;  // contours, group by group
    buffer<std::uint32_t> groups_;   // the first member of each group, and the end
    buffer<std::uint32_t> owners_;   // the outer contour to which each contour belongs, while they are grouped
    buffer<double> areas_;           // likewise, of each contour
    buffer<stretch> waiting_;
    buffer<proven_stretch> found_;
    triangle_list triangles_;
    grid grid_;
    bool crosses_ = false;
    bool glyph_pieces_ = false;  // the last attempt: stretches are divided also where contours cross
};

}  // namespace typemesh::inline TYPEMESH_ABI
