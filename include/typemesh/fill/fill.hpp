// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/contours.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/nest.hpp>
#include <typemesh/fill/resolve.hpp>

namespace typemesh::inline TYPEMESH_ABI {

/// The region that the contours fill under `rule`. If the contours do not meet, nest() makes the region and leaves
/// their points unchanged; otherwise resolve() makes it. nest() itself finds out whether the contours meet.
///
/// Replaces `loops`; the result may be an empty region.
///
///     how    the options for contours that meet: see resolve()
///
/// Fails  error::too_many_pieces, for contours that meet: more than how.max_pieces points, crossings or pieces
///        error::too_large, error::out_of_memory; `loops` is then unchanged
/// Cost   O(n log n), plus the cost of resolve() if contours meet
template <class = void>  // see resolve()
[[nodiscard]] result<region> fill(contours& loops, fill_rule rule, workspace& space,
                                  const resolve_options& how = {}) noexcept
{
    auto nested = nest(loops, rule, space);
    if (nested || nested.error().code != error::crossing_contours) return nested;
    return resolve(loops, rule, space, how);
}

}  // namespace typemesh::inline TYPEMESH_ABI
