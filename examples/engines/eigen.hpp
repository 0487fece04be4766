// SPDX-License-Identifier: MIT
#pragma once

// Eigen, as libigl and its like hold a mesh: a matrix of vertices and a matrix of triangles, a row each (row-major, so
// that rows are contiguous), or a column each (Eigen's own order). Right-handed, z up, text on the x axis facing
// -y, as in CAD; Eigen itself has no convention.
//
// Include <Eigen/Core> first.
//
//     Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> v, n;      // or Eigen::Matrix3Xf
//     Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor> f;           // or Eigen::Matrix3Xi
//     if (const auto written = engines::eigen::write(*plan, v, n, f); !written) return written.error();

#include <typemesh/text/text_options.hpp>
#include <typemesh/vertex/stream_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace engines::eigen {

[[nodiscard]] inline typemesh::text_options options() noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::right_handed_z_up;
    return o;
}

template <class Matrix>
inline constexpr bool holds_triples_in_one_piece = (Matrix::ColsAtCompileTime == 3 && bool(Matrix::IsRowMajor)) ||
                                                   (Matrix::RowsAtCompileTime == 3 && !bool(Matrix::IsRowMajor));

/// Resizes the three matrices and fills them: positions, normals, triangles. float, and any integer.
template <class Plan, class Places, class Normals, class Triangles>
[[nodiscard]] typemesh::result<void> write(const Plan& plan, Places& places, Normals& normals, Triangles& triangles)
{
    using namespace typemesh;
    static_assert(holds_triples_in_one_piece<Places> && holds_triples_in_one_piece<Normals> &&
                      holds_triples_in_one_piece<Triangles>,
                  "typemesh: matrices with 3 columns must be row-major, matrices with 3 rows column-major");
    static_assert(std::is_same_v<typename Places::Scalar, float> && std::is_same_v<typename Normals::Scalar, float>);
    struct float3 {
        float x, y, z;
    };
    const mesh_size size = plan.size();
    const auto fit = [](auto& m, std::size_t n) {
        using extent = decltype(m.rows());
        if constexpr (std::remove_reference_t<decltype(m)>::RowsAtCompileTime == 3)
            m.resize(3, static_cast<extent>(n));
        else
            m.resize(static_cast<extent>(n), 3);
    };
    fit(places, size.vertices), fit(normals, size.vertices), fit(triangles, size.triangles);
    return plan.write(stream_sink{std::span{triangles.data(), size.indices()},
                                  stream<attribute::position, float3>{places.data(), size.vertices},
                                  stream<attribute::normal, float3>{normals.data(), size.vertices}});
}

}  // namespace engines::eigen
