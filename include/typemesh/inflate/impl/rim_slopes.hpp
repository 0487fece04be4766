// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/orientation.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/inflate/impl/membrane_system.hpp>
#include <typemesh/refine/impl/delaunay_refinement.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// The slope of a membrane at the points of its boundary, by the numbers of the points in a mesh that grows. On a
/// straight stroke it is half the width.
class rim_slopes {
public:
    explicit rim_slopes(memory source = heap()) noexcept : slopes_{source}, flows_{source} {}

    /// Finds the slopes from a solution on the mesh's triangles: what leaves the membrane at a point and half of what
    /// leaves at the two points beside it, by the length of their edges. On coarse triangles what leaves at a point is
    /// a sixth too much or too little, in turns along the outline, and these means are exact. Rounded to 64th cells,
    /// so that it does not depend on the last bits of the solution.
    ///
    /// False if out of memory
    [[nodiscard]] bool measure(const membrane_system& solved, const refinable_mesh& mesh,
                               array_view<const std::uint32_t> starts, std::size_t count) noexcept
    {
        slopes_.clear();
        flows_.clear();
        double* const flows = flows_.append(2 * count);
        double* const slopes = slopes_.append(mesh.vertex_count());
        if (flows == nullptr || slopes == nullptr) return false;
        for (std::size_t i = 0; i < count; ++i) flows[i] = 0.0;
        for (std::size_t v = 0; v < slopes_.size(); ++v) slopes[v] = 0.0;
        solved.add_outflow(flows);
        double* const lengths = flows + count;
        std::size_t end = 0;
        for (std::size_t loop = 0; loop + 1 < starts.size(); ++loop) {
            const std::size_t begin = end;
            std::uint32_t v = starts[loop];
            double before = length_before(mesh, v);
            do {
                const double after = length_after(mesh, v);
                lengths[end++] = 0.5 * (before + after);
                before = after;
                v = mesh.next_on_boundary(v);
            } while (v != starts[loop]);
            for (std::size_t i = begin; i < end; ++i, v = mesh.next_on_boundary(v)) {
                const std::size_t last = i == begin ? end - 1 : i - 1, next = i + 1 == end ? begin : i + 1;
                const double slope =
                    (flows[last] + 2.0 * flows[i] + flows[next]) / (lengths[last] + 2.0 * lengths[i] + lengths[next]);
                slopes[v] = std::floor(parts_of_cell * slope + 0.5) / parts_of_cell;
            }
        }
        return true;
    }

    /// Halves the edges of the boundary that are longer than the slopes at both ends, down to a length: strokes
    /// narrower than the mesh get shorter edges. Fails as delaunay_refinement::halve() does.
    [[nodiscard]] error shorten(delaunay_refinement& refinement, array_view<const std::uint32_t> starts,
                                double least) noexcept
    {
        bool is_done = false;
        for (int round = 0; round < max_rounds && !is_done; ++round) {
            is_done = true;
            const auto known = static_cast<std::uint32_t>(slopes_.size());
            for (std::uint32_t v = 0; v < known; ++v) {
                const refinable_mesh& mesh = refinement.mesh();
                if (mesh.at(v).boundary == refinable_mesh::none) continue;
                const std::uint32_t next = mesh.next_on_boundary(v);
                if (next >= known) continue;
                const double length = length_after(mesh, v);
                if (length < 2.0 * least || length < larger(slopes_[v], slopes_[next])) continue;
                if (error e = refinement.halve(v)) return e;
                is_done = false;
            }
            if (!extend(refinement.mesh(), starts)) return error::out_of_memory;
        }
        return {};
    }

    [[nodiscard]] const double* data() const noexcept { return slopes_.data(); }

private:
    /// A round halves an edge once; a membrane's `least` is reached by four.
    static constexpr int max_rounds = 8;
    /// Slopes are rounded to so many parts of a cell.
    static constexpr double parts_of_cell = 64.0;

    /// Interpolates the slopes at the points that have been added to the boundary. False if out of memory.
    [[nodiscard]] bool extend(const refinable_mesh& mesh, array_view<const std::uint32_t> starts) noexcept
    {
        const std::size_t known = slopes_.size(), added = mesh.vertex_count() - known;
        if (added == 0) return true;
        if (slopes_.append(added) == nullptr) return false;
        for (std::size_t v = known; v < slopes_.size(); ++v) slopes_[v] = 0.0;
        for (std::size_t loop = 0; loop + 1 < starts.size(); ++loop) {
            std::uint32_t v = starts[loop];
            do {  // v is known
                std::uint32_t next = mesh.next_on_boundary(v);
                int steps = 1;
                for (; next >= known; next = mesh.next_on_boundary(next)) ++steps;
                int step = 1;
                for (std::uint32_t w = mesh.next_on_boundary(v); w != next; w = mesh.next_on_boundary(w), ++step)
                    slopes_[w] = (slopes_[v] * (steps - step) + slopes_[next] * step) / steps;
                v = next;
            } while (v != starts[loop]);
        }
        return true;
    }

    [[nodiscard]] static double larger(double a, double b) noexcept { return a < b ? b : a; }

    [[nodiscard]] static double length_after(const refinable_mesh& mesh, std::uint32_t v) noexcept
    {
        return std::sqrt(static_cast<double>(squared_distance(mesh.place(v), mesh.place(mesh.next_on_boundary(v)))));
    }
    [[nodiscard]] static double length_before(const refinable_mesh& mesh, std::uint32_t v) noexcept
    {
        return std::sqrt(
            static_cast<double>(squared_distance(mesh.place(v), mesh.place(mesh.previous_on_boundary(v)))));
    }

    buffer<double> slopes_;
    buffer<double> flows_;  // what leaves at each boundary point, then half the length of its edges
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
