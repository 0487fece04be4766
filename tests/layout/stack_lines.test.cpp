// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/impl/stack_lines.hpp>

#include <utility>
#include <vector>

using namespace typemesh;

namespace {

const line_metrics small_line{700.0, -200.0, 100.0}, large_line{1400.0, -500.0, 300.0};

std::vector<laid_line> stacked(const std::vector<line_metrics>& metrics, const layout_options& options,
                               line_stack way = line_stack::downwards)
{
    std::vector<laid_line> lines;
    for (const line_metrics& m : metrics) lines.push_back({.metrics = m});
    stack_lines(lines, 1000.0, options, way);
    return lines;
}

}  // namespace

TEST_CASE("lines stand below one another, columns to the left of one another", "[paragraph]")
{
    CHECK(stacked({}, {}).empty());
    const auto lines = stacked({3, small_line}, {.line_spacing = 1.5});
    CHECK(lines[0].origin == point{});
    CHECK(lines[2].origin == point{0.0, -3000.0});
    CHECK(stacked({3, small_line}, {}, line_stack::leftwards)[2].origin == point{-2000.0, 0.0});
    CHECK(stacked({2, line_metrics{}}, {})[1].origin == point{0.0, -1000.0});  // without metrics: one em
}

TEST_CASE("lines of different heights neither overlap nor part", "[paragraph]")
{
    const auto lines = stacked({small_line, large_line, small_line}, {});
    CHECK(lines[1].origin.y == -(200.0 + 200.0 + 1400.0));
    CHECK(lines[2].origin.y - lines[1].origin.y == -(500.0 + 200.0 + 700.0));
}

TEST_CASE("columns that go to the right mirror those that go to the left", "[paragraph]")
{
    // What reaches to the right of a baseline there reaches to its left here.
    const auto turned = [](const line_metrics& m) { return line_metrics{-m.descender, -m.ascender, m.gap}; };
    const std::vector<line_metrics> metrics{small_line, large_line, small_line, line_metrics{}};
    std::vector<line_metrics> mirrored;
    for (const line_metrics& m : metrics) mirrored.push_back(turned(m));
    for (const vertical_anchor anchor : {vertical_anchor::first_baseline, vertical_anchor::last_baseline,
                                         vertical_anchor::top, vertical_anchor::middle, vertical_anchor::bottom}) {
        const layout_options how{.anchor = anchor, .height = 3.0, .line_spacing = 1.5};
        const auto right = stacked(metrics, how, line_stack::rightwards);
        const auto left = stacked(mirrored, how, line_stack::leftwards);
        for (std::size_t k = 0; k < metrics.size(); ++k) CHECK(right[k].origin == point{0.0 - left[k].origin.x, 0.0});
    }
    CHECK(stacked({2, small_line}, {.anchor = vertical_anchor::top}, line_stack::rightwards)[0].origin.x == 200.0);
}

TEST_CASE("an anchor puts the text's own edges to the box's", "[paragraph]")
{
    for (const double height : {0.0, 5.0})
        for (const auto& metrics : {std::vector<line_metrics>{small_line}, {5, small_line}, {large_line, small_line}}) {
            std::vector<laid_line> lines;
            for (const line_metrics& m : metrics) lines.push_back({.metrics = m});
            for (const double spacing : {1.0, 1.5}) {
                const auto edges = [&](vertical_anchor a) {
                    const double high = stack_lines(
                        lines, 1000.0, {.anchor = a, .height = height, .line_spacing = spacing}, line_stack::downwards);
                    const double top = lines.front().origin.y + metrics.front().ascender;
                    const double bottom = lines.back().origin.y + metrics.back().descender;
                    CHECK(top - bottom == high);
                    return std::pair{top, bottom};
                };
                CHECK(edges(vertical_anchor::top).first == 0.0);
                CHECK(edges(vertical_anchor::bottom).second == -1000.0 * height);
                const auto [top, bottom] = edges(vertical_anchor::middle);
                CHECK(top + bottom == -1000.0 * height);
                edges(vertical_anchor::first_baseline);
                CHECK(lines.front().origin.y == 0.0);
                edges(vertical_anchor::last_baseline);
                CHECK(lines.back().origin.y == 0.0);
            }
        }
}
