// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/contours.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/region.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/core/workspace.hpp>
#include <typemesh/plate/cell_set.hpp>
#include <typemesh/plate/layer_arrangement.hpp>
#include <typemesh/plate/silhouette.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// The bridges of a stencil, and what they tie.
struct stencil_report {
    std::uint32_t islands = 0;  ///< the number of islands that were loose without bridges
    std::uint32_t bridges = 0;  ///< the number of bridges that were made
    std::uint32_t loose = 0;    ///< the number of islands that are still loose: 0, unless no bar can reach them
};

class stencil_bridges {
public:
    static constexpr int max_rounds = 6;
    explicit stencil_bridges(memory source = heap()) noexcept : loops_{source} {}
    void clear() noexcept { report_ = {}; }
    [[nodiscard]] const stencil_report& report() const noexcept { return report_; }
    [[nodiscard]] result<void> tie(layer_arrangement&, cell_set, cell_set, std::uint32_t, std::int32_t, std::uint32_t, silhouette&, workspace&, bool& more) noexcept { more = false; return {}; }
private:
    contours loops_;
    stencil_report report_;
};

}  // namespace typemesh::inline TYPEMESH_ABI
