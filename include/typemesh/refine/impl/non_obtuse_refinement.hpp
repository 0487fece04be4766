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
#include <typemesh/refine/impl/refinable_mesh.hpp>
#include <typemesh/refine/impl/right_triangles.hpp>
#include <typemesh/refine/impl/triangle_queue.hpp>
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
class non_obtuse_refinement {
public:
    explicit non_obtuse_refinement(memory source = heap()) noexcept
        : coarse_{source}, weights_{source}, bad_{source}, parts_{source}
    {
    }

    /// Corners beyond the next region's edges: see boundary_cutter.
    void attach(array_view<const grid_point> corners) noexcept { coarse_.attach(corners); }

    /// Fails  error::out_of_memory, error::too_many_points
    [[nodiscard]] error run(const region& r, array_view<const triangle> triangles,
                            const refinement_limits& limits) noexcept
    {
        region_ = &r;
        is_divided_ = false;
        kept_ = 0;
        weights_.clear();
        if (error e = coarse_.run(r, triangles, limits)) return e;
        const refinable_mesh& mesh = coarse_.mesh();
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t) is_divided_ = is_divided_ || is_obtuse(mesh, t);
        if (!is_divided_) return {};
        if (error e = find_weights()) return e;
        if (!parts_.divide(mesh, weights_, coarse_.cutter())) return error::out_of_memory;
        const right_triangles::counts all = parts_.count(mesh);
        kept_ = all.obtuse;
        return all.points > limits.max_points ? error{error::too_many_points, limits.max_points} : error{};
    }

    /// Writes the refined cap. Fails with error::out_of_memory.
    [[nodiscard]] error write(const refined_cap& out) noexcept
    {
        return is_divided_ ? parts_.write(coarse_.mesh(), *region_, out) : coarse_.write(out);
    }

    /// The number of triangles that have a larger angle than rounding explains: see is_right_or_less().
    [[nodiscard]] std::uint32_t kept() const noexcept { return kept_; }

private:
    static constexpr int max_rounds = 40, quick_rounds = 3;

    /// How long a search for weights goes on, and the margin that it aims at: see radical_weights::settle().
    struct search {
        int passes;
        double margin;
    };
    static constexpr search quick{60, 1.0}, thorough{500, 0.3};

    [[nodiscard]] static bool is_obtuse(const refinable_mesh& mesh, std::uint32_t t) noexcept
    {
        for (std::uint32_t h = 4 * t; h < 4 * t + 3; ++h)
            if (refinable_mesh::dot(mesh.place(mesh.apex(h)), mesh.start(h), mesh.place(mesh.target(h))) < 0)
                return true;
        return false;
    }

    /// Steps 2 and 3. If no point can be added any more, triangles remain whose radical centres lie outside.
    [[nodiscard]] error find_weights() noexcept
    {
        const refinable_mesh& mesh = coarse_.mesh();
        for (int round = 0; round < max_rounds; ++round) {
            if (!weights_.open(mesh)) return error::out_of_memory;
            const search& how = round < quick_rounds ? quick : thorough;
            if (weights_.settle(how.passes, how.margin)) return {};
            const std::uint32_t before = mesh.vertex_count();
            if (error e = add_points()) return e;
            if (mesh.vertex_count() == before) return {};
        }
        return weights_.open(mesh) ? error{} : error{error::out_of_memory};
    }

    /// Adds the centre of the circle around each triangle whose radical centre does not lie inside.
    [[nodiscard]] error add_points() noexcept
    {
        const refinable_mesh& mesh = coarse_.mesh();
        bad_.clear();
        for (std::uint32_t t = 0; t < mesh.triangle_count(); ++t)
            if (!weights_.is_centred(t) && !bad_.push_back(queued_triangle::of(mesh, t))) return error::out_of_memory;
        return coarse_.add_centres(bad_.view());
    }

    delaunay_refinement coarse_;
    radical_weights weights_;
    buffer<queued_triangle> bad_;
    right_triangles parts_;
    const region* region_ = nullptr;
    std::uint32_t kept_ = 0;
    bool is_divided_ = false;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
