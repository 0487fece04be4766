// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/refine/impl/delaunay_refinement.hpp>
#include <typemesh/refine/impl/radical_weights.hpp>
#include <typemesh/refine/impl/right_triangles.hpp>
#include <typemesh/refine/refiner.hpp>

#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Adds points until no angle is above 90 degrees.
///
///     1. triangles   delaunay_refinement with a small least angle. If no angle is above 90 degrees then, that is all.
///     2. weights     radical_weights looks for weights with which each triangle's radical centre lies inside.
///     3. points      Where it finds none, the centre of the circle around the triangle becomes a point, as in
///                    delaunay_refinement; then step 2 is repeated. From the fourth time on it looks longer, and is
///                    content with centres nearer to the edges. It ends after 40 times at most.
///     4. division    right_triangles divides each triangle into six.
///
/// Steps 1 and 3 keep the mesh valid by exact decisions, and step 4 checks each triangle exactly, so the triangles are
/// valid for every region and all weights.
class non_obtuse_refinement : delaunay_refinement {
public:
    explicit non_obtuse_refinement(memory source = heap()) noexcept
        : delaunay_refinement{source}, weights_{source}, bad_{source}, parts_{source}
    {
    }

    using delaunay_refinement::attach;

    /// Fails  error::out_of_memory, error::too_many_points
    [[nodiscard]] error run(const region& r, array_view<const triangle> triangles,
                            const refinement_limits& limits) noexcept
    {
        if (error e = delaunay_refinement::run(r, triangles, limits)) return e;
        is_divided_ = false;
        weights_.clear();
        for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t) is_divided_ = is_divided_ || is_obtuse(t);
        kept_ = 0;
        if (!is_divided_) return {};
        if (error e = find_weights()) return e;
        if (!parts_.divide(mesh_, weights_, cut_)) return error::out_of_memory;
        const right_triangles::counts all = parts_.count(mesh_);
        kept_ = all.obtuse;
        return all.points > limits_.max_points ? error{error::too_many_points, limits_.max_points} : error{};
    }

    /// Writes the refined cap. Fails with error::out_of_memory.
    [[nodiscard]] error write(const refined_cap& out) noexcept
    {
        return is_divided_ ? parts_.write(mesh_, *region_, out) : delaunay_refinement::write(out);
    }

    /// The number of triangles that have a larger angle than rounding explains: see is_right_or_less().
    [[nodiscard]] std::uint32_t kept() const noexcept { return kept_; }

private:
    [[nodiscard]] bool is_obtuse(std::uint32_t t) const noexcept
    {
        for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h)
            if (dot(mesh_.place(mesh_.apex(h)), mesh_.start(h), mesh_.place(mesh_.target(h))) < 0) return true;
        return false;
    }

    /// Steps 2 and 3. If no point can be added any more, triangles remain whose radical centres lie outside.
    [[nodiscard]] error find_weights() noexcept
    {
        for (int round = 0; round < 40; ++round) {
            if (!weights_.open(mesh_)) return error::out_of_memory;
            if (round < 3 ? weights_.settle(60, 1.0) : weights_.settle(500, 0.3)) return {};
            const std::uint32_t before = mesh_.vertex_count();
            if (error e = add_points()) return e;
            if (mesh_.vertex_count() == before) return {};
        }
        return weights_.open(mesh_) ? error{} : error{error::out_of_memory};
    }

    /// Adds the centre of the circle around each triangle whose radical centre does not lie inside.
    [[nodiscard]] error add_points() noexcept
    {
        bad_.clear();
        for (std::uint32_t t = 0; t < mesh_.triangle_count(); ++t)
            if (!weights_.is_centred(t) &&
                !bad_.push_back({t, mesh_.origin(4 * t), mesh_.origin(4 * t + 1), mesh_.origin(4 * t + 2)}))
                return error::out_of_memory;
        const double usual = limits_.off_centre;
        limits_.off_centre = 0x1p100;
        for (const queued_triangle& one : bad_) {
            if (error e = improve(one)) return e;
            if (error e = split_edges()) return e;
        }
        limits_.off_centre = usual;
        return settle();
    }

    radical_weights weights_;
    buffer<queued_triangle> bad_;
    right_triangles parts_;
    bool is_divided_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
