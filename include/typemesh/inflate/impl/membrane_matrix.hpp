// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A symmetric matrix without positive numbers beside its diagonal. Each row lists its neighbours in any order:
///
///     columns   [ neighbours of 0 | neighbours of 1 | ... ]      starts: where each row begins, and the end
///     shares    the entry of i and j is -(share of j in row i + share of i in row j)
struct membrane_matrix {
    array_view<const std::uint32_t> starts, columns;
    array_view<const double> shares, diagonal;

    [[nodiscard]] std::size_t size() const noexcept { return diagonal.size(); }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
