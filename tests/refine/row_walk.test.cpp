// SPDX-License-Identifier: MIT

#include <typemesh/core/orientation.hpp>
#include <typemesh/refine/impl/row_walk.hpp>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/regions.hpp"

using namespace typemesh;

namespace {

using column_and_row = std::pair<std::int64_t, std::int64_t>;

/// Rows and columns of squares of a width, from 0.
struct plain_squares {
    std::int64_t width;

    [[nodiscard]] std::int64_t index(std::int64_t v) const { return v < 0 ? -((width - 1 - v) / width) : v / width; }
    [[nodiscard]] detail::interval rows_between(std::int64_t bottom, std::int64_t top) const noexcept
    {
        return {index(bottom), index(top)};
    }
    [[nodiscard]] detail::interval height_of(std::int64_t row) const noexcept
    {
        return {row * width, (row + 1) * width};
    }
    [[nodiscard]] detail::interval columns_between(std::int64_t left, std::int64_t right) const noexcept
    {
        return rows_between(left, right);
    }
    [[nodiscard]] detail::interval inside_of(std::int64_t i) const noexcept
    {
        return {i * width, i * width + width - 1};
    }
};

/// Whether a square has a cell's corner that lies in a triangle, by trying all of them.
bool holds_part(const plain_squares& in, column_and_row at, const grid_point (&t)[3])
{
    const detail::interval x = in.inside_of(at.first), y = in.inside_of(at.second);
    for (std::int64_t v = y.first; v <= y.last; ++v)
        for (std::int64_t u = x.first; u <= x.last; ++u) {
            const grid_point p{std::int32_t(u), std::int32_t(v)};
            if (orientation(t[0], t[1], p) >= 0 && orientation(t[1], t[2], p) >= 0 && orientation(t[2], t[0], p) >= 0)
                return true;
        }
    return false;
}

template <std::size_t count>
std::vector<column_and_row> walked_over(const plain_squares& in, const grid_point (&corners)[count])
{
    std::vector<column_and_row> all;
    CHECK(detail::walk_rows(in, corners, [&](std::int64_t column, std::int64_t row) {
        all.emplace_back(column, row);
        return true;
    }));
    return all;
}

}  // namespace

TEST_CASE("a walk over rows visits every square that a triangle has a part of, row by row, once", "[refine]")
{
    test::dice d{11};
    std::size_t visited = 0, with_part = 0;
    for (int round = 0; round < 200; ++round) {
        const plain_squares in{5 + d.roll(8)};
        const auto roll = [&] { return d.roll(80) - 40; };
        grid_point t[] = {{roll(), roll()}, {roll(), roll()}, {roll(), roll()}};
        if (orientation(t[0], t[1], t[2]) < 0) std::swap(t[1], t[2]);
        if (orientation(t[0], t[1], t[2]) == 0) continue;
        const auto all = walked_over(in, t);
        CHECK(std::is_sorted(all.begin(), all.end(), [](const column_and_row& a, const column_and_row& b) {
            return a.second != b.second ? a.second < b.second : a.first < b.first;
        }));
        CHECK(std::adjacent_find(all.begin(), all.end()) == all.end());
        visited += all.size();
        for (std::int64_t row = -10; row <= 10; ++row)
            for (std::int64_t column = -10; column <= 10; ++column) {
                if (!holds_part(in, {column, row}, t)) continue;
                ++with_part;
                if (std::find(all.begin(), all.end(), column_and_row{column, row}) == all.end()) {
                    CAPTURE(round, in.width, column, row);
                    FAIL("a square is missing");
                }
            }
    }
    CHECK(with_part > 1000);
    CHECK(visited < 2 * with_part);
}

TEST_CASE("a walk along a segment visits both ends, and no more than it passes and their neighbours", "[refine]")
{
    const plain_squares in{1 << 10};
    test::dice d{12};
    for (int round = 0; round < 300; ++round) {
        const auto roll = [&] { return d.roll(1 << 14) - (1 << 13); };
        const grid_point ends[] = {{roll(), roll()}, {round % 5 == 0 ? 77 : roll(), roll()}};
        const auto all = walked_over(in, ends);
        for (const grid_point p : ends)
            CHECK(std::count(all.begin(), all.end(), column_and_row{in.index(p.x), in.index(p.y)}) == 1);
        const std::int64_t columns = std::abs(in.index(ends[0].x) - in.index(ends[1].x)),
                           rows = std::abs(in.index(ends[0].y) - in.index(ends[1].y));
        CHECK(std::int64_t(all.size()) >= (std::max)(columns, rows) + 1);
        CHECK(std::int64_t(all.size()) <= columns + 3 * (rows + 1));
    }
}

TEST_CASE("a walk over rows keeps its range at the limits of the grid, and stops where a visit says so", "[refine]")
{
    const plain_squares in{1 << 26};
    constexpr std::int32_t reach = 1 << 28;
    const grid_point all_of_it[] = {{-reach, -reach}, {reach, -reach}, {reach, reach}};
    const auto all = walked_over(in, all_of_it);
    CHECK(all.front() == column_and_row{-5, -4});  // a span is a cell wider than the side
    CHECK(all.back().second == 4);
    std::size_t visited = 0;
    CHECK_FALSE(detail::walk_rows(in, all_of_it, [&](std::int64_t, std::int64_t) { return ++visited < 7; }));
    CHECK(visited == 7);

    struct no_rows : plain_squares {
        [[nodiscard]] detail::interval rows_between(std::int64_t, std::int64_t) const noexcept { return {0, -1}; }
    };
    CHECK(detail::walk_rows(no_rows{{16}}, all_of_it, [](std::int64_t, std::int64_t) { return false; }));
}
