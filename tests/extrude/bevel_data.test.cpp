// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/bevel_data.hpp>

#include <typemesh/extrude/extruder.hpp>

#include <cstddef>
#include <vector>

#include "support/catch.hpp"

using namespace typemesh;

TEST_CASE("a glyph stores only the plan arrays of a bevel's data, and clear() empties them", "[bevel_data]")
{
    bevel_data data;
    const std::size_t empty = data.bytes();
    REQUIRE(data.of<bevel_vertex>().push_back({{1, 2}, {0.0f, 1.0f}, 3.0f, 0.5f, 4}));
    const std::size_t one = data.bytes();
    CHECK(one > empty);
    REQUIRE(data.swept.nodes.push_back({}));
    REQUIRE(data.corners.push_back({}));
    CHECK(data.bytes() == one);

    std::vector<std::byte> block(one);
    data.copy_to(block.data());
    const auto back = bevel_data::read_from(block.data());
    REQUIRE(back.of<bevel_vertex>().size() == 1);
    CHECK(back.of<bevel_vertex>()[0].at == grid_point{1, 2});
    CHECK(back.of<bevel_vertex>()[0].strip == 4);
    data.clear();
    CHECK(data.bytes() == empty);
}
