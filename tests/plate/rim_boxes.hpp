// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/workspace.hpp>
#include <typemesh/plate/cell_set.hpp>
#include <typemesh/plate/layer_arrangement.hpp>

#include "support/catch.hpp"

#include <array>
#include <cstdint>

namespace test {

/// A box of 1000 cells, which are one em, and a box of 400 cells at a place within it, which is counted from `origin`.
struct rim_boxes {
    static constexpr typemesh::cell_set pocket = typemesh::cells_of_layer(0), plate = typemesh::cells_of_layer(1);

    typemesh::layer_arrangement cells;
    typemesh::workspace space;

    explicit rim_boxes(std::int32_t x = 300, std::int32_t y = 300, typemesh::grid_point origin = {})
    {
        typemesh::grid em;
        em.cells = 1000.0;
        em.units_per_em = 1.0;
        cells.begin(em);
        add(origin.x, origin.y, 1000, 1);
        add(origin.x + x, origin.y + y, 400, 0);
        REQUIRE(cells.cut(space));
    }

private:
    void add(std::int32_t x, std::int32_t y, std::int32_t size, std::uint32_t layer)
    {
        const std::array<typemesh::grid_point, 4> p{{{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}}};
        const std::array<std::uint32_t, 2> starts{0, 4};
        REQUIRE(cells.add({p.data(), 4}, {starts.data(), 2}, layer));
    }
};

}  // namespace test
