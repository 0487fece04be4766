// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/triangulate/monotone.hpp>

namespace test {

/// monotone, as a triangulator that takes proven regions only.
struct unproving {
    typemesh::error operator()(const typemesh::region& r, typemesh::workspace& space,
                               typemesh::triangle_list& out) const noexcept
    {
        return typemesh::monotone{}(r, space, out);
    }
};

}  // namespace test
