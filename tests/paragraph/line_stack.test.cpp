// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/paragraph/line_stack.hpp>

using namespace typemesh;

namespace {

const line_metrics metrics{700.0, -200.0, 100.0};

line_stack stack(vertical_anchor anchor, double height, std::size_t lines, double spacing = 1.0)
{
    return {metrics, 1000.0, {.anchor = anchor, .height = height, .line_spacing = spacing}, lines, false};
}

}  // namespace

TEST_CASE("lines stand below one another, columns to the left of one another", "[paragraph]")
{
    const line_stack lines = stack(vertical_anchor::first_baseline, 0.0, 3, 1.5);
    CHECK(lines.at(0, 7.0) == point{7.0, 0.0});
    CHECK(lines.at(2, 7.0) == point{7.0, -3000.0});
    const line_stack columns{metrics, 1000.0, {}, 3, true};
    CHECK(columns.at(2, 7.0) == point{-2000.0, -7.0});
    CHECK(line_stack({}, 1000.0, {}, 2, false).at(1, 0.0) == point{0.0, -1000.0});  // without metrics: one em
}

TEST_CASE("an anchor puts the text's own edges to the box's", "[paragraph]")
{
    for (const double height : {0.0, 5.0})
        for (const std::size_t lines : {1u, 2u, 5u}) {
            const double last = -1000.0 * static_cast<double>(lines - 1);
            const auto first = [&](vertical_anchor a) { return stack(a, height, lines).at(0, 0.0).y; };
            CHECK(first(vertical_anchor::first_baseline) == 0.0);
            CHECK(first(vertical_anchor::last_baseline) + last == 0.0);
            CHECK(first(vertical_anchor::top) + 700.0 == 0.0);
            CHECK(first(vertical_anchor::bottom) + last - 200.0 == -1000.0 * height);
            const double middle = first(vertical_anchor::middle);
            CHECK((middle + 700.0) + (middle + last - 200.0) == -1000.0 * height);
        }
}
