// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/extrude/impl/path_pairs.hpp>
#include <typemesh/extrude/impl/tube_clearance.hpp>
#include <typemesh/extrude/impl/tube_thinning.hpp>
#include <typemesh/extrude/side_point.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Finds the paths of tubes and their radii: leaves out points beside sharp corners, as far as the tubes that fit then
/// are thick enough to allow it.
///
/// Thinning with too large a radius in mind would change a path more than its tube, once that has found its clearance.
/// So a path whose tube comes out thinner is thinned again, with a smaller radius in mind. In the end a path is nowhere
/// farther from what was drawn than `cut` times 1.5 times its tube's radius. If thinning makes two paths meet that do
/// not meet as drawn, all points of these two stay.
///
/// Cost   a few times tube_thinning and tube_clearance, at most 19 times
class tube_fitting {
public:
    explicit tube_fitting(memory source = heap()) noexcept
        : clearance_{source}, thinning_{source}, points_{source}, targets_{source}, drawn_meetings_{source}
    {
    }

    /// Fits tubes. `sides` has an element for each point; elements of points that are left out are removed.
    ///
    ///     radius   in cells
    ///     cut      tubed::corner_cut
    ///     crease   the cosine of the crease angle
    ///
    /// Fails  error::out_of_memory
    [[nodiscard]] error fit(const tube_paths& drawn, buffer<side_point>& sides, double radius, double cut,
                            double crease) noexcept
    {
        targets_.clear();
        for (std::size_t k = 0; k < drawn.count(); ++k)
            if (!targets_.push_back(radius)) return error::out_of_memory;
        if (error e = approach(drawn, sides.view(), radius, cut)) return e;
        std::uint32_t count = 0;
        for (const std::uint32_t i : thinning_.kept()) sides[count++] = sides[i];
        sides.truncate(count);
        thinning_.light(points_.view(), sides.view(), crease);
        return {};
    }

    /// The points that stay, and where the paths begin among them.
    [[nodiscard]] array_view<const grid_point> points() const noexcept { return points_.view(); }
    [[nodiscard]] array_view<const std::uint32_t> starts() const noexcept { return thinning_.starts(); }
    /// The radii, mitres and meetings of these paths.
    [[nodiscard]] const tube_clearance& clearance() const noexcept { return clearance_; }

private:
    /// Attempts with smaller and smaller targets. The last one leaves out nothing.
    [[nodiscard]] error approach(const tube_paths& drawn, array_view<const side_point> sides, double radius,
                                 double cut) noexcept
    {
        constexpr int rounds = 16;
        bool drawn_meetings_known = false;
        for (int round = 0;; ++round) {
            if (error e = attempt(drawn, sides, radius, round < rounds ? cut : 0.0)) return e;
            if (!(cut > 0.0) || round == rounds) return {};
            if (lower_targets()) continue;
            if (clearance_.meetings().empty()) return {};
            if (!drawn_meetings_known) {
                drawn_meetings_known = true;
                if (error e = attempt(drawn, sides, radius, 0.0)) return e;
                if (!drawn_meetings_.assign(clearance_.meetings())) return error::out_of_memory;
                if (error e = attempt(drawn, sides, radius, cut)) return e;
            }
            if (!release_new_meetings()) return {};
        }
    }

    [[nodiscard]] error attempt(const tube_paths& drawn, array_view<const side_point> sides, double radius,
                                double cut) noexcept
    {
        if (error e = thinning_.find(drawn, sides, targets_.view(), cut)) return e;
        points_.clear();
        for (const std::uint32_t i : thinning_.kept())
            if (!points_.push_back(drawn.points[i])) return error::out_of_memory;
        return clearance_.find({points_.view(), thinning_.starts(), drawn.open}, radius);
    }

    /// Whether any radius has become much smaller than what its path was thinned for.
    [[nodiscard]] bool lower_targets() noexcept
    {
        bool any = false;
        for (std::size_t k = 0; k < targets_.size(); ++k) {
            const double found = clearance_.radii()[k];
            if (found * 1.5 >= targets_[k]) continue;
            targets_[k] = found * 1.25 > 0.5 * targets_[k] ? found * 1.25 : 0.5 * targets_[k];
            if (targets_[k] < 4.0) targets_[k] = 0.0;  // it has no tube, and the others need not wait for it
            any = true;
        }
        return any;
    }

    /// Lets all points stay of paths that meet and do not meet as drawn. Whether there are such paths.
    [[nodiscard]] bool release_new_meetings() noexcept
    {
        bool any = false;
        clearance_.meetings().each([&](std::uint32_t a, std::uint32_t b) noexcept {
            if (drawn_meetings_.has(a, b)) return;
            targets_[a] = targets_[b] = 0.0;
            any = true;
        });
        return any;
    }

    tube_clearance clearance_;
    tube_thinning thinning_;
    buffer<grid_point> points_;
    buffer<double> targets_;  // for each path the radius to thin for; 0: all its points stay
    path_pairs drawn_meetings_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
