// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/outline/transformed_outlines.hpp>

#include <limits>

using namespace typemesh;

namespace {

const auto square = [](outline_sink auto& pen) {
    pen.move({0, 0});
    pen.line({100, 0});
    pen.line({100, 100});
    pen.line({0, 100});
    pen.close();
};
const auto drop = [](outline_sink auto& pen) {
    pen.move({0, 0});
    pen.quadratic({50, 0}, {50, 50});
    pen.cubic({50, 80}, {0, 80}, {0, 0});
    pen.close();
    pen.move({10, 10});
    pen.line({20, 10});
    pen.line({10, 20});
    pen.close();
};

bool same(const outline& a, const outline& b)
{
    if (a.curves.size() != b.curves.size() || a.starts.size() != b.starts.size()) return false;
    for (std::size_t i = 0; i < a.starts.size(); ++i)
        if (a.starts[i] != b.starts[i]) return false;
    for (std::size_t i = 0; i < a.curves.size(); ++i) {
        if (a.curves[i].degree != b.curves[i].degree) return false;
        for (std::uint32_t k = 0; k <= a.curves[i].degree; ++k)
            if (!(a.curves[i].p[k] == b.curves[i].p[k])) return false;
    }
    return true;
}

}  // namespace

TEST_CASE("a recorded drawing comes back call by call", "[outline][recorded_outlines]")
{
    recorded_outlines set{1000.0, fill_rule::even_odd};
    for (int i = 0; i < 50; ++i) {
        const auto id = i % 2 == 0 ? set.add(square) : set.add(drop);
        REQUIRE(id);
        CHECK(*id == static_cast<glyph_id>(i));
    }
    CHECK(set.size() == 50);
    CHECK(set.units_per_em() == 1000.0);

    outline direct, back;
    outline_recorder pen{direct};
    drop(pen);
    REQUIRE(!pen.finish());
    REQUIRE(record(set, 49, back));
    CHECK(same(direct, back));
    CHECK(back.rule == fill_rule::even_odd);

    const error none = record(set, 50, back).error();
    CHECK(none == error::unknown_glyph);
    CHECK(none.glyph == 50);
}

TEST_CASE("a drawing of nothing is a blank glyph", "[outline][recorded_outlines]")
{
    recorded_outlines set{1000.0};
    REQUIRE(set.add([](outline_sink auto&) {}));
    REQUIRE(set.add(square));
    outline o;
    REQUIRE(record(set, 0, o));
    CHECK(o.contour_count() == 0);
    REQUIRE(record(set, 1, o));
    CHECK(o.contour_count() == 1);
}

TEST_CASE("a drawing that is refused leaves the set as it was", "[outline][recorded_outlines]")
{
    recorded_outlines set{1000.0};
    REQUIRE(set.add(square));
    CHECK(set.add([](outline_sink auto& pen) { pen.line({1, 1}); }).error() == error::bad_outline);
    CHECK(set.add([](outline_sink auto& pen) {
                 pen.move({0, 0});
                 pen.line({std::numeric_limits<double>::infinity(), 1});
             })
              .error() == error::outline_not_finite);
    CHECK(set.size() == 1);

    test::counting_memory counted;
    {
        recorded_outlines whole{1000.0, fill_rule::non_zero, counted.source()};
        REQUIRE(whole.add(drop));
    }
    const std::size_t needed = counted.requests;
    for (std::size_t at = 1; at <= needed; ++at) {
        test::counting_memory failing{.fail_at = at, .fail_once = true};
        recorded_outlines part{1000.0, fill_rule::non_zero, failing.source()};
        CHECK(part.add(drop).error() == error::out_of_memory);
        CHECK(part.size() == 0);
        const auto id = part.add(drop);
        REQUIRE(id);
        CHECK(*id == 0);
        outline a, b;
        outline_recorder pen{a};
        drop(pen);
        REQUIRE(!pen.finish());
        REQUIRE(record(part, 0, b));
        CHECK(same(a, b));
    }
}

TEST_CASE("a transformed source draws every point where its map puts it", "[outline][transformed_outlines]")
{
    recorded_outlines set{500.0, fill_rule::even_odd};
    REQUIRE(set.add(drop));
    const affine map{.xx = 2.0, .xy = 0.25, .dx = -3.0, .yx = 0.0, .yy = -1.0, .dy = 7.0};
    transformed_outlines slanted{set, map};
    CHECK(slanted.units_per_em() == 500.0);
    CHECK(slanted.fill() == fill_rule::even_odd);

    outline a, b;
    REQUIRE(record(set, 0, a));
    REQUIRE(record(slanted, 0, b));
    REQUIRE(a.curves.size() == b.curves.size());
    for (std::size_t i = 0; i < a.curves.size(); ++i) {
        CHECK(a.curves[i].degree == b.curves[i].degree);
        for (std::uint32_t k = 0; k <= a.curves[i].degree; ++k) {
            const point p = a.curves[i].p[k];
            CHECK(b.curves[i].p[k] == point{2.0 * p.x + 0.25 * p.y - 3.0, 7.0 - p.y});
        }
    }
    CHECK(record(slanted, 1, b) == error::unknown_glyph);
}
