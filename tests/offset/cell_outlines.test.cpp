// SPDX-License-Identifier: MIT

#include <typemesh/offset/impl/cell_outlines.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/regions.hpp"

#include <cstdint>
#include <list>
#include <map>
#include <vector>

using namespace typemesh;
using detail::cell_outlines;

namespace {

std::vector<std::uint32_t> outline_of(const cell_outlines& all, std::size_t cell)
{
    std::vector<std::uint32_t> nodes;
    std::uint32_t i = all.cells[cell].corner;
    do {
        nodes.push_back(all.corners[i].node);
        i = all.corners[i].next;
    } while (i != all.cells[cell].corner && nodes.size() <= all.corners.size());
    return nodes;
}

/// A cell as a ring of nodes in which each open piece is a gap.
struct slow_outline {
    using place = std::list<std::int64_t>::iterator;

    std::list<std::int64_t> ring;
    std::map<int, place> gaps;  ///< by piece
    std::map<int, cell_outlines::ends> ends;

    place after(int piece) { return std::next(gaps[piece]); }
};

}  // namespace

TEST_CASE("a cell's outline begins with its segment and runs counter-clockwise", "[offset][cell_outlines]")
{
    cell_outlines all{heap()};
    auto ends = all.open(7, 0, 1);
    all.at_tail(ends, 2);
    all.at_head(ends, 4);
    all.close(ends, 3);
    CHECK(all.cells[0].line == 7);
    CHECK(outline_of(all, 0) == std::vector<std::uint32_t>{0, 1, 2, 3, 4});

    ends = all.open(8, 5, 6);
    all.at_head(ends, 8);
    all.at_tail(ends, 7);
    all.close(ends);
    CHECK(outline_of(all, 1) == std::vector<std::uint32_t>{5, 6, 7, 8});
}

TEST_CASE("when a segment is split, its right piece closes first", "[offset][cell_outlines]")
{
    //   8--7      5--4
    //   |   \    /   |
    //   |    \  /    |
    //   9     6      3       6: where the segment was split
    //   0------------1       2, 10: unused
    cell_outlines all{heap()};
    auto left = all.open(0, 0, 1);
    all.at_tail(left, 3);
    all.at_head(left, 9);
    auto right = all.split(left, 6);
    all.at_head(right, 5);
    all.at_tail(left, 7);
    all.at_head(left, 8);
    all.at_tail(right, 4);
    all.close(right);
    all.close(left);
    CHECK(outline_of(all, 0) == std::vector<std::uint32_t>{0, 1, 3, 4, 5, 6, 7, 8, 9});
}

TEST_CASE("outlines grow, split and close in any order like rings with gaps", "[offset][cell_outlines]")
{
    test::dice d{1};
    for (int round = 0; round < 300; ++round) {
        cell_outlines all{heap()};
        std::vector<slow_outline> slow(static_cast<std::size_t>(1 + d.roll(4)));
        int pieces = 0;
        std::uint32_t node = 0;
        std::vector<std::pair<std::size_t, int>> open;
        for (std::size_t c = 0; c < slow.size(); ++c) {
            slow[c].ends[pieces] = all.open(static_cast<std::uint32_t>(c), node, node + 1);
            slow[c].ring = {node, node + 1, -1};
            slow[c].gaps[pieces] = std::prev(slow[c].ring.end());
            open.emplace_back(c, pieces++);
            node += 2;
        }
        for (int step = 0; !open.empty(); ++step) {
            const auto which = static_cast<std::size_t>(d.roll(static_cast<std::int32_t>(open.size())));
            const auto [c, piece] = open[which];
            slow_outline& s = slow[c];
            cell_outlines::ends& ends = s.ends[piece];
            const int what = step < 200 ? d.roll(10) : 9;
            if (what < 4) {
                all.at_head(ends, node);
                s.ring.insert(s.after(piece), node++);
            } else if (what < 8) {
                all.at_tail(ends, node);
                s.ring.insert(s.gaps[piece], node++);
            } else if (what < 9) {
                s.ends[pieces] = all.split(s.ends[piece], node);
                s.gaps[pieces] = s.ring.insert(s.gaps[piece], -1);
                s.ring.insert(s.gaps[piece], node++);
                open.emplace_back(c, pieces++);
            } else {
                if (d.roll(2) == 0) {
                    all.close(ends, node);
                    s.ring.insert(s.gaps[piece], node++);
                } else {
                    all.close(ends);
                }
                s.ring.erase(s.gaps[piece]);
                open.erase(open.begin() + static_cast<std::ptrdiff_t>(which));
            }
        }
        REQUIRE(!all.failed);
        REQUIRE(all.cells.size() == slow.size());
        for (std::size_t c = 0; c < slow.size(); ++c) {
            CHECK(all.cells[c].line == c);
            CHECK(outline_of(all, c) == std::vector<std::uint32_t>(slow[c].ring.begin(), slow[c].ring.end()));
        }
        all.clear();
        CHECK((all.cells.empty() && all.corners.empty()));
    }
}

TEST_CASE("outlines remember that memory ran out, and stay harmless", "[offset][cell_outlines]")
{
    for (std::size_t fail_at = 1; fail_at <= 4; ++fail_at) {
        test::counting_memory limited{.fail_at = fail_at};
        cell_outlines all{limited.source()};
        auto ends = all.open(0, 0, 1);
        for (std::uint32_t node = 2; node < 200; ++node) {
            all.at_head(ends, node);
            all.at_tail(ends, node);
            auto right = all.split(ends, node);
            all.close(right, node);
        }
        CHECK(all.failed);
    }
}
