// SPDX-License-Identifier: MIT

#include <typemesh/extrude/impl/box_tree.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <random>
#include <vector>

using namespace typemesh;

TEST_CASE("a tree finds exactly the boxes that meet a box, in ascending order", "[extrude][curved]")
{
    std::mt19937 random{7};
    detail::box_tree tree;
    for (const std::size_t count : {0u, 1u, 2u, 3u, 8u, 9u, 100u, 257u}) {
        std::vector<detail::grid_box> boxes(count);
        const auto somewhere = [&] { return static_cast<std::int32_t>(random() % 200) - 100; };
        REQUIRE(tree.open(count));
        for (std::size_t i = 0; i < count; ++i) {
            const grid_point at{somewhere(), somewhere()};
            boxes[i].add(at);
            boxes[i].add(
                {at.x + static_cast<std::int32_t>(random() % 20), at.y + static_cast<std::int32_t>(random() % 20)});
            tree.set(i, boxes[i]);
        }
        tree.close();
        for (int k = 0; k < 50; ++k) {
            detail::grid_box asked;
            asked.add({somewhere(), somewhere()});
            if (k % 2 == 0) asked.add({somewhere(), somewhere()});
            std::vector<std::size_t> expected, found;
            for (std::size_t i = 0; i < count; ++i) {
                const auto &b = boxes[i], &a = asked;
                const bool apart = b.high.x < a.low.x || a.high.x < b.low.x || b.high.y < a.low.y || a.high.y < b.low.y;
                if (!apart) expected.push_back(i);
            }
            tree.each_meeting(asked, [&](std::size_t i) { found.push_back(i); });
            CHECK(found == expected);
        }
    }
}

TEST_CASE("a tree without memory says so", "[extrude][curved]")
{
    test::counting_memory none{.fail_at = 1};
    detail::box_tree tree{none.source()};
    CHECK_FALSE(tree.open(10));
}
