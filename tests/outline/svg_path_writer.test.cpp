// SPDX-License-Identifier: MIT

// What is written is read again as it was, to the last digit that was written.

#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/svg_path.hpp>
#include <typemesh/outline/svg_path_writer.hpp>

#include <cmath>
#include <random>
#include <string>

#include "outline/same_curves.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;

namespace {

template <class Sink>
void draw_at_random(unsigned seed, double unit, Sink& to)
{
    std::mt19937 engine{seed};
    const auto d = [&] { return static_cast<unsigned>(engine()); };
    const auto next = [&]() -> point {
        const auto x = static_cast<double>(d() % 2'000'001), y = static_cast<double>(d() % 2'000'001);
        return {(x - 1e6) / unit, (y - 1e6) / unit};
    };
    for (unsigned n = 1 + d() % 3; n > 0; --n) {
        to.move(next());
        for (unsigned k = d() % 5; k > 0; --k) {
            const point a = next(), b = next(), c = next();
            switch (d() % 3) {
            case 0: to.line(a); break;
            case 1: to.quadratic(a, b); break;
            default: to.cubic(a, b, c);
            }
        }
        if (d() % 2 != 0) to.close();
    }
}

}  // namespace

TEST_CASE("a path that is written and read again is the same", "[outline][svg]")
{
    double unit = 1.0;
    for (int decimals = 0; decimals <= 9; ++decimals, unit *= 10.0)
        for (unsigned seed = 0; seed < 200; ++seed) {
            outline drawn, read;
            outline_recorder first{drawn}, second{read};
            svg_path_writer text{affine{}, decimals};
            draw_at_random(seed, unit, first);
            draw_at_random(seed, unit, text);
            REQUIRE(text.finish());
            REQUIRE(draw_svg_path(text.text(), 1e-3, second));
            REQUIRE(first.finish() == error::none);
            REQUIRE(second.finish() == error::none);
            INFO(text.text());
            CHECK_QUICKLY(drawn.curves.size() == read.curves.size());
            CHECK_QUICKLY(test::same_curves(drawn, read));
        }
}

TEST_CASE("numbers are as short as they can be", "[outline][svg]")
{
    svg_path_writer text{affine{}, 3};
    text.move({0.0, -0.0});
    text.line({1.5, -0.25});
    text.quadratic({100.0, 0.0004}, {-0.0004, 1000.001});
    text.cubic({0.01, 0.1}, {-7.0, 12.0}, {-0.5, 0.999});
    text.close();
    CHECK(std::string{text.text()} == "M0 0L1.5 -0.25Q100 0 0 1000.001C0.01 0.1 -7 12 -0.5 0.999Z");
    text.clear();
    CHECK(text.text().empty());
    svg_path_writer down{};
    down.move({1.0, 2.0});
    CHECK(std::string{down.text()} == "M1 -2");
}

TEST_CASE("a path that cannot be written is refused", "[outline][svg]")
{
    CHECK(svg_path_writer{{}, 10}.finish() == error::bad_option);
    CHECK(svg_path_writer{{}, -1}.finish() == error::bad_option);
    svg_path_writer nan, large;
    nan.move({std::nan(""), 0.0});
    CHECK(nan.finish() == error::outline_not_finite);
    large.move({1e13, 0.0});
    CHECK(large.finish() == error::too_large);
    large.clear();
    CHECK(large.finish());
    test::counting_memory none{.fail_at = 1};
    svg_path_writer poor{{}, 3, none.source()};
    poor.move({});
    CHECK(poor.finish() == error::out_of_memory);
}

TEST_CASE("path data without a move before its first segment is not written", "[outline][svg]")
{
    svg_path_writer line, curve, after, closed;
    line.line({1.0, 1.0});
    CHECK(line.finish() == error::bad_outline);
    line.clear();
    CHECK(line.finish());
    curve.cubic({}, {1.0, 0.0}, {1.0, 1.0});
    CHECK(curve.finish() == error::bad_outline);
    after.move({});
    after.line({1.0, 0.0});
    after.close();
    CHECK(after.finish());
    after.quadratic({1.0, 1.0}, {0.0, 1.0});
    CHECK(after.finish() == error::bad_outline);
    closed.close();
    CHECK(closed.finish());
    CHECK(closed.text().empty());
}
