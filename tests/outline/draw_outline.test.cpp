// SPDX-License-Identifier: MIT
#include "outline/same_curves.hpp"
#include "support/catch.hpp"

#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/outline_recorder.hpp>

#include <string>

using namespace typemesh;

namespace {

struct noting_pen {
    std::string calls;
    void move(point) noexcept { calls += 'm'; }
    void line(point) noexcept { calls += 'l'; }
    void quadratic(point, point) noexcept { calls += 'q'; }
    void cubic(point, point, point) noexcept { calls += 'c'; }
    void close() noexcept { calls += 'z'; }
};

}  // namespace

TEST_CASE("a stored outline is drawn curve by curve, and recorded again it is the same", "[outline][draw_outline]")
{
    outline given, again;
    outline_recorder pen{given};
    pen.move({0, 0}), pen.quadratic({50, 0}, {50, 50}), pen.cubic({50, 80}, {0, 80}, {0, 0}), pen.close();
    pen.move({10, 10}), pen.line({20, 10}), pen.line({10, 20}), pen.close();
    REQUIRE(!pen.finish());

    noting_pen calls;
    draw_outline(given, calls);
    CHECK(calls.calls == "mqczmlllz");

    outline_recorder second{again};
    draw_outline(given, second);
    REQUIRE(!second.finish());
    CHECK(test::same_curves(given, again));

    calls = {};
    draw_outline(outline{}, calls);
    CHECK(calls.calls == "");
}
