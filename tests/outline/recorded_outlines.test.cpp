// SPDX-License-Identifier: MIT
#include "outline/same_curves.hpp"
#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/outline/recorded_outlines.hpp>

#include <limits>

using namespace typemesh;

namespace {

const auto square = [](outline_sink auto& pen) {
    pen.move({0, 0}), pen.line({100, 0}), pen.line({100, 100}), pen.line({0, 100}), pen.close();
};
const auto drop = [](outline_sink auto& pen) {
    pen.move({0, 0}), pen.quadratic({50, 0}, {50, 50}), pen.cubic({50, 80}, {0, 80}, {0, 0}), pen.close();
    pen.move({10, 10}), pen.line({20, 10}), pen.line({10, 20}), pen.close();
};

/// The drop, drawn without a set.
outline drawn_drop()
{
    outline direct;
    outline_recorder pen{direct};
    drop(pen);
    REQUIRE(!pen.finish());
    return direct;
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

    outline back;
    REQUIRE(record(set, 49, back));
    CHECK(test::same_curves(drawn_drop(), back));
    CHECK(back.rule == fill_rule::even_odd);

    const error none = record(set, 50, back).error();
    CHECK(none == error::unknown_glyph);
    CHECK(none.glyph == 50);
}

TEST_CASE("an empty drawing is a blank glyph", "[outline][recorded_outlines]")
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

TEST_CASE("a refused drawing leaves the set unchanged", "[outline][recorded_outlines]")
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

    recorded_outlines copies{1000.0};
    const auto copy = [&](glyph_id id) {
        return copies.add([&](outline_sink auto& pen) { return set.outline(id, pen); });
    };
    const error none = copy(7).error();  // the error of the source
    CHECK(none == error::unknown_glyph);
    CHECK(none.glyph == 7);
    CHECK(copies.size() == 0);
    REQUIRE(copy(0));
    CHECK(copies.size() == 1);

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
        outline b;
        REQUIRE(record(part, 0, b));
        CHECK(test::same_curves(drawn_drop(), b));
    }
}
