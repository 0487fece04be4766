// SPDX-License-Identifier: MIT
#pragma once

// Laws of closed polylines and of triangles over them: the inspectors' findings, in words.

#include <typemesh/inspect/boundary_check.hpp>
#include <typemesh/inspect/cap_check.hpp>
#include <typemesh/inspect/fill_check.hpp>
#include <typemesh/inspect/filled_area.hpp>
#include <typemesh/inspect/polyline.hpp>
#include <typemesh/inspect/simplicity.hpp>

#include <span>
#include <string>
#include <vector>

namespace test::oracle {

using namespace typemesh::inspect;
using typemesh::grid_point;

/// Why loops are not the boundary cycles of an area, as region promises, or nothing.
inline std::string broken_cycle(const std::vector<loop>& loops) { return check_boundary(loops).broken(); }

/// The first law that a triangulation breaks, or nothing.
inline std::string broken_law(const typemesh::region& r, std::span<const typemesh::triangle> triangles)
{
    return check_cap(r, triangles).broken();
}

}  // namespace test::oracle
