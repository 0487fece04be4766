// SPDX-License-Identifier: MIT
#include "outline/same_curves.hpp"
#include "support/catch.hpp"

#include <typemesh/outline/face_source.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/outline/transformed_outlines.hpp>

#include <cmath>

using namespace typemesh;
using test::same_curves;

namespace {

/// Two faces: face 0 draws a triangle as glyph 0; face 1 draws it twice as large and even-odd.
struct two_faces {
    double units_per_em() noexcept { return 100.0; }
    double units_per_em(std::uint32_t face) noexcept { return face == 0 ? 100.0 : 200.0; }
    fill_rule fill() noexcept { return fill_rule::non_zero; }
    fill_rule fill(std::uint32_t face) noexcept { return face == 0 ? fill_rule::non_zero : fill_rule::even_odd; }
    std::uint32_t face_count() noexcept { return 2; }
    std::uint64_t variation_key() const noexcept { return 5; }
    std::uint64_t variation_key(std::uint32_t face) const noexcept { return 5 + face; }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        return outline(0, id, sink);
    }
    template <outline_sink Sink>
    error outline(std::uint32_t face, glyph_id id, Sink& sink) noexcept
    {
        if (id != 0) return error::unknown_glyph;
        const double k = face == 0 ? 1.0 : 2.0;
        sink.move({0, 0}), sink.line({10 * k, 0}), sink.quadratic({10 * k, 5 * k}, {5 * k, 5 * k});
        sink.cubic({4 * k, 4 * k}, {2 * k, 3 * k}, {0, 1 * k}), sink.close();
        return {};
    }
};
static_assert(face_source<two_faces>);
static_assert(!face_source<recorded_outlines>);
static_assert(outline_source<mapped_face<two_faces>>);
static_assert(outline_source<mapped_face<const recorded_outlines>>);

}  // namespace

TEST_CASE("a source that does not mention faces has one", "[outline]")
{
    recorded_outlines drawings{1000.0};
    CHECK(face_count_of(drawings) == 1);
    CHECK(units_per_em_of(drawings, 0) == 1000.0);
    two_faces both;
    CHECK(face_count_of(both) == 2);
    CHECK(units_per_em_of(both, 1) == 200.0);
    CHECK(variation_of(both, 1) == 6);
    CHECK(variation_of(drawings, 0) == variation_of(drawings));
}

TEST_CASE("a mapped face draws one face through a map, in the given units", "[outline]")
{
    two_faces both;
    outline expected, found;
    for (const std::uint32_t face : {0u, 1u}) {
        mapped_face plain{both, face, nullptr, 100.0};
        outline_recorder by_hand{expected};
        REQUIRE_FALSE(both.outline(face, 0, by_hand));
        REQUIRE_FALSE(by_hand.finish());
        expected.rule = both.fill(face);
        REQUIRE(record(plain, 0, found));
        CHECK((same_curves(found, expected) && found.rule == expected.rule));
        CHECK(plain.units_per_em() == 100.0);
        CHECK(record(plain, 1, found) == error::unknown_glyph);
    }
    const affine map{0.5, 0.25, 3, 0.125, 2, -7};
    mapped_face mapped{both, 0, &map, 100.0};
    transformed_outlines transformed{both, map};
    REQUIRE(record(transformed, 0, expected));
    REQUIRE(record(mapped, 0, found));
    CHECK((same_curves(found, expected) && found.rule == expected.rule));
    outline_recorder recorder{found};
    REQUIRE_FALSE(mapped.outline(0, recorder));
    REQUIRE_FALSE(recorder.finish());
    CHECK((same_curves(found, expected) && found.rule == expected.rule));
}

TEST_CASE("a map that shrinks curves to points drops them, like drawing through it", "[outline]")
{
    recorded_outlines drawings{1000.0};
    REQUIRE(drawings.add([](auto& pen) {
        pen.move({5, 0}), pen.line({5, 9}), pen.line({5, 3}), pen.close();  // upright: gone
        pen.move({0, 0}), pen.line({8, 0}), pen.quadratic({8, 4}, {8, 8}), pen.line({0, 8}), pen.close();
        pen.move({7, 1}), pen.cubic({7, 2}, {7, 3}, {7, 4}), pen.close();  // gone
        pen.move({1, 1}), pen.line({2, 5}), pen.line({3, 1}), pen.close();
    }));
    for (const affine& map : {affine{.yy = 0.0}, affine{.xx = 1.0, .yy = 0.0}, affine{.xx = 0.0},
                              affine{.xx = 0.0, .yy = 0.0}, affine{.xx = 0.0, .xy = 1.0, .yx = -1.0, .yy = 0.0}}) {
        outline expected, found;
        transformed_outlines transformed{drawings, map};
        mapped_face mapped{drawings, 0, &map, 1000.0};
        REQUIRE(record(transformed, 0, expected));
        REQUIRE(record(mapped, 0, found));
        CHECK((same_curves(found, expected) && found.rule == expected.rule));
    }
    const affine nowhere{.dx = std::nan("")};
    outline found;
    mapped_face mapped{drawings, 0, &nowhere, 1000.0};
    CHECK(record(mapped, 0, found) == error::outline_not_finite);
}
