// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/morph/impl/morph_points.hpp>
#include <typemesh/morph/impl/moving_points.hpp>
#include <typemesh/morph/impl/steady_triangles.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Finds triangles for moving contours that are positive throughout a stretch of the axis, and proves that the contours
/// neither cross nor touch on the way.
///
/// The contours are triangulated at nine places of the stretch, and the best of the triangulations is repaired by
/// flips. The outside, between the contours and a rectangle around them that does not move, is triangulated likewise,
/// but its triangles may differ from one part of a step to another, because they are used only for the proof: inner and
/// outer triangles together map a rectangle onto itself. If all of them are positive, no two overlap, so the contours
/// are simple.
///
/// At the keys themselves points may meet (area_path).
class morph_proof {
public:
    explicit morph_proof(memory source = heap()) noexcept
        : space_{source}, loops_{source}, names_{source}, triangles_{source}, best_{source}, fixer_{source}
    {
    }

    /// What the last call has found.
    enum class finding : std::uint8_t {
        proven,
        crossing,  ///< at each of the places that were tried, the contours crossed or touched
        unproven,  ///< some places are good, but no triangles were found for the whole stretch
    };

    /// Tries to prove the contours in `members` (numbers of contours of `points`), and appends their triangles.
    ///
    /// Fails  error::out_of_memory
    result<finding> operator()(const morph_points& points, array_view<const std::uint32_t> members,
                               const moving_stretch& where, triangle_list& out) noexcept
    {
        points_ = &points;
        members_ = members;
        moving_ = {points.places.view(), points.count(), {}};
        fences(where);
        crossed_anywhere_ = false;
        const auto inner = find(where, false);
        if (!inner || *inner != finding::proven) return inner;
        const std::size_t before = out.size();
        if (!out.append(best_.view())) return error::out_of_memory;

        moving_.fixed = frame_;
        for (std::size_t k = where.key; k < where.key + where.steps; ++k) {
            const auto outer = find_outside({k, 1, 0, area_path::parts});
            if (outer && *outer == finding::proven) continue;
            out.truncate(before);
            return outer;
        }
        return finding::proven;
    }

    /// Whether the contours crossed at any place that the last call tried.
    [[nodiscard]] bool crossed_anywhere() const noexcept { return crossed_anywhere_; }

private:
    /// The outside of one step or a part of it; halves it if no triangles hold throughout.
    result<finding> find_outside(const moving_stretch& where) noexcept
    {
        const auto found = find(where, true);
        if (!found || *found != finding::unproven || where.last - where.first == 1) return found;
        const std::int32_t middle = where.middle();
        const auto low = find_outside({where.key, 1, where.first, middle});
        if (!low || *low != finding::proven) return low;
        return find_outside({where.key, 1, middle, where.last});
    }

    result<finding> find(const moving_stretch& where, bool outside) noexcept
    {
        static constexpr std::size_t places[] = {4, 2, 6, 3, 5, 1, 7, 0, 8};  // eighths of the stretch
        std::uint32_t fewest = ~0u;
        bool crosses = false, tried = false;
        const auto length = static_cast<std::size_t>(where.last - where.first) * where.steps;
        std::size_t last_place = ~std::size_t{0};
        for (const std::size_t eighth : places) {
            const std::size_t place = static_cast<std::size_t>(where.first) + length * eighth / 8;
            if (place == last_place) continue;
            last_place = place;
            std::size_t key = where.key + place / area_path::parts;
            auto part = static_cast<std::int32_t>(place % area_path::parts);
            if (key == where.key + where.steps && part == 0) {
                --key;
                part = area_path::parts;
            }
            const error e = triangulate(key, part, outside);
            if (e == error::crossing_contours) {
                crosses = crossed_anywhere_ = true;
                continue;
            }
            if (e) return e;
            tried = true;
            const std::uint32_t faults = fixer_.repair(moving_, where, triangles_.view());
            if (faults == ~0u) return error::out_of_memory;
            if (faults >= fewest) continue;
            fewest = faults;
            best_.swap(triangles_);
            if (faults == 0) return finding::proven;
        }
        return crosses && !tried ? finding::crossing : finding::unproven;
    }

    /// The constrained Delaunay triangulation at one place, in triangles_.
    error triangulate(std::size_t key, std::int32_t part, bool outside) noexcept
    {
        loops_.clear();
        names_.clear();
        triangles_.clear();
        bool good = loops_.starts.push_back(0);
        const auto put = [&](std::uint32_t point) noexcept {
            const grid_point p =
                part == area_path::parts ? moving_.at(key + 1, point) : moving_.between(key, part, point);
            good = good && loops_.points.push_back(p) && loops_.edges.push_back({}) && names_.push_back(point);
        };
        const auto end = [&]() noexcept {
            good = good && loops_.starts.push_back(static_cast<std::uint32_t>(loops_.points.size()));
        };
        if (outside) {
            for (std::uint32_t i = 0; i < 4; ++i) put(static_cast<std::uint32_t>(moving_.count) + i);
            end();
        }
        for (const std::uint32_t c : members_) {
            const std::uint32_t first = points_->starts[c], last = points_->starts[c + 1];
            for (std::uint32_t i = first; i < last; ++i) put(outside ? last - 1 - (i - first) : i);
            end();
        }
        if (!good) return error::out_of_memory;
        const auto found = constrained_delaunay{}.prove_touching(loops_, space_, triangles_);
        if (!found) return found.error();
        for (triangle& t : triangles_) t = {names_[t.a], names_[t.b], names_[t.c]};
        return {};
    }

    /// A rectangle around the members at all keys of a stretch.
    void fences(const moving_stretch& where) noexcept
    {
        std::int32_t low = area_path::reach, high = -low, left = low, right = high;
        for (std::size_t k = where.key; k <= where.key + where.steps; ++k)
            for (const std::uint32_t c : members_)
                for (std::uint32_t i = points_->starts[c]; i < points_->starts[c + 1]; ++i) {
                    const grid_point p = moving_.at(k, i);
                    left = p.x < left ? p.x : left;
                    right = p.x > right ? p.x : right;
                    low = p.y < low ? p.y : low;
                    high = p.y > high ? p.y : high;
                }
        const std::int32_t margin = (right - left > high - low ? right - left : high - low) / 4 + 1;
        frame_[0] = {left - margin, low - margin};
        frame_[1] = {right + margin, low - margin};
        frame_[2] = {right + margin, high + margin};
        frame_[3] = {left - margin, high + margin};
    }

    workspace space_;
    contours loops_;
    buffer<std::uint32_t> names_;
    triangle_list triangles_, best_;
    steady_triangles fixer_;
    const morph_points* points_ = nullptr;
    array_view<const std::uint32_t> members_;
    moving_points moving_;
    grid_point frame_[4];
    bool crossed_anywhere_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI
