// SPDX-License-Identifier: MIT

// What is written is read by a reader of group codes of this test, which evaluates splines by de Boor's algorithm.

#include <typemesh/core/curve.hpp>
#include <typemesh/outline/dxf_writer.hpp>

#include <cmath>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;

namespace {

using pairs = std::vector<std::pair<int, std::string>>;

pairs read(std::string_view text)
{
    std::istringstream in{std::string{text}};
    pairs all;
    std::string code, value;
    while (std::getline(in, code)) {
        REQUIRE(std::getline(in, value));
        all.push_back({std::stoi(code), value});
    }
    return all;
}

struct entity {
    std::string name, handle;
    std::size_t degree = 1, knot_count = 0, point_count = 0;
    std::vector<double> knots;
    std::vector<point> points;

    /// de Boor.
    [[nodiscard]] point at(double t) const
    {
        if (name == "LINE") return lerp(points[0], points[1], t);
        std::vector<point> d = points;
        for (std::size_t r = 1; r <= degree; ++r)
            for (std::size_t j = degree; j >= r; --j) {
                const double low = knots[j], high = knots[j + 1 + degree - r];
                d[j] = lerp(d[j - 1], d[j], (t - low) / (high - low));
            }
        return d[degree];
    }
};

std::vector<entity> entities_of(const pairs& all)
{
    std::vector<entity> found;
    bool inside = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto& [code, value] = all[i];
        if (code == 2 && value == "ENTITIES") inside = true;
        if (code == 0 && value == "ENDSEC") inside = false;
        if (!inside || code == 2) continue;
        if (code == 0) found.push_back({value, {}, 1, 0, 0, {}, {}});
        if (found.empty()) continue;
        entity& e = found.back();
        if (code == 5) e.handle = value;
        if (code == 71) e.degree = std::stoul(value);
        if (code == 72) e.knot_count = std::stoul(value);
        if (code == 73) e.point_count = std::stoul(value);
        if (code == 40) e.knots.push_back(std::stod(value));
        if (code == 10 || code == 11) e.points.push_back({std::stod(value), 0.0});
        if (code == 20 || code == 21) e.points.back().y = std::stod(value);
    }
    return found;
}

template <class Sink>
void draw(Sink& to)
{
    to.move({0, 0});
    to.line({100, 0});
    to.quadratic({150.125, 50}, {100, 100});
    to.cubic({70, 180}, {-30, 120.5}, {0, 50});
    to.close();
    to.move({10, 10});
    to.line({10, 20});
    to.line({20, 20});
    to.line({10, 10});
    to.close();
}

}  // namespace

TEST_CASE("a drawing has a line or a spline for each curve, end to end", "[outline][dxf]")
{
    dxf_writer drawing{{.xx = 0.5, .yy = -0.5, .dy = 200.0}};
    draw(drawing);
    REQUIRE(drawing.finish());
    const pairs all = read(drawing.text());
    CHECK(all.front() == std::pair<int, std::string>{0, "SECTION"});
    CHECK(all.back() == std::pair<int, std::string>{0, "EOF"});
    const auto entities = entities_of(all);
    REQUIRE(entities.size() == 7);
    const auto map = [](double x, double y) { return point{0.5 * x, 200.0 - 0.5 * y}; };
    const curve wanted[] = {
        curve::from(map(0, 0), map(100, 0)),
        curve::from(quadratic{map(100, 0), map(150.125, 50), map(100, 100)}),
        curve::from(cubic{map(100, 100), map(70, 180), map(-30, 120.5), map(0, 50)}),
        curve::from(map(0, 50), map(0, 0)),
        curve::from(map(10, 10), map(10, 20)),
        curve::from(map(10, 20), map(20, 20)),
        curve::from(map(20, 20), map(10, 10)),
    };
    for (std::size_t i = 0; i < entities.size(); ++i) {
        const entity& e = entities[i];
        CHECK(e.name == (wanted[i].degree == 1 ? "LINE" : "SPLINE"));
        CHECK(e.degree == wanted[i].degree);
        CHECK(e.knots.size() == e.knot_count);
        CHECK((e.name == "LINE" || e.points.size() == e.point_count));
        for (int k = 0; k <= 10; ++k) CHECK(length(e.at(k / 10.0) - wanted[i].at(k / 10.0)) < 1e-6);
        for (std::size_t k = 0; k < i; ++k) CHECK(entities[k].handle != e.handle);
    }
}

TEST_CASE("a drawing that cannot be written is refused", "[outline][dxf]")
{
    dxf_writer nan, large, headless;
    nan.move({0, 0});
    nan.line({std::nan(""), 0});
    CHECK(nan.finish() == error::outline_not_finite);
    large.move({0, 0});
    large.line({1e10, 0});
    CHECK(large.finish() == error::too_large);
    headless.line({1, 1});
    CHECK(headless.finish() == error::bad_outline);
    headless.clear();
    draw(headless);
    CHECK(headless.finish());
    for (std::size_t n = 1; n < 5; ++n) {
        test::counting_memory counted{.fail_at = n};
        dxf_writer poor{{}, counted.source()};
        draw(poor);
        CHECK(poor.finish() == error::out_of_memory);
    }
    test::counting_memory counted;
    dxf_writer twice{{}, counted.source()};
    draw(twice);
    REQUIRE(twice.finish());
    const std::string first{twice.text()};
    const std::size_t before = counted.requests;
    twice.clear();
    draw(twice);
    REQUIRE(twice.finish());
    CHECK(counted.requests == before);
    CHECK(std::string{twice.text()} == first);
}

TEST_CASE("pieces that are points after rounding are left out of a drawing", "[outline][dxf]")
{
    dxf_writer drawing;
    drawing.move({1e-8, 0});
    drawing.line({3e-7, 4e-7});                          // no way from 0, 0
    drawing.quadratic({1e-7, 2e-7}, {2e-7, 1e-7});       // nor here
    drawing.cubic({0, 4e-7}, {4e-7, 0}, {-4e-7, 4e-7});  // nor here
    drawing.line({5, 0});
    drawing.cubic({5, 1e-7}, {6, 0}, {5, 0});  // there and back
    drawing.line({1e-7, 3e-7});
    drawing.close();
    REQUIRE(drawing.finish());
    const auto found = entities_of(read(drawing.text()));
    REQUIRE(found.size() == 3);
    point last = found.back().points.back();
    for (const entity& e : found) {
        CHECK(last == e.points.front());
        last = e.points.back();
        bool moves = false;
        for (const point p : e.points) moves = moves || !(p == e.points.front());
        CHECK(moves);
    }
}
