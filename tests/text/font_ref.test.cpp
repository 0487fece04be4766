// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/text/font_faces.hpp>
#include <typemesh/text/impl/font_ref.hpp>

using namespace typemesh;

TEST_CASE("a font is recorded through its reference as by itself, face by face, mapped or not", "[text][font_ref]")
{
    test::toy_font letters;
    recorded_outlines icons{500.0, fill_rule::even_odd};
    REQUIRE(icons.add([](auto& pen) { pen.move({0, 0}), pen.line({9, 0}), pen.line({0, 9}); }));
    font_faces both{letters, icons};
    const font_ref refers{both};
    CHECK(refers.face_count() == 2);
    CHECK(refers.units_per_em() == 1000.0);
    CHECK(refers.units_per_em(1) == 500.0);
    outline own, by_ref;
    REQUIRE(record(letters, 1, own));
    REQUIRE_FALSE(refers.record(0, 1, by_ref, 1000));
    CHECK(own.curves.size() == by_ref.curves.size());
    REQUIRE_FALSE(refers.record(1, 0, by_ref, 1000));
    CHECK(by_ref.rule == fill_rule::even_odd);
    CHECK(refers.record(1, 0, by_ref, 2) == error::too_many_points);
    CHECK(refers.record(0, 99, by_ref, 1000) == error::unknown_glyph);
    const affine twice{2.0, 0.0, 0.0, 0.0, 2.0, 0.0};
    drawn_face face{refers, 1, &twice, 1000.0};
    REQUIRE(record(face, 0, by_ref));
    CHECK(by_ref.bounds.high == point{18.0, 18.0});
}

TEST_CASE("what a font cannot do its reference does not promise", "[text][font_ref]")
{
    test::toy_font letters, others;
    const recorded_outlines icons{500.0};
    CHECK(font_ref{letters}.is_shaper());
    CHECK_FALSE(font_ref{icons}.is_shaper());
    CHECK(font_ref{letters}.is_like(others));
    CHECK_FALSE(font_ref{letters}.is_like(icons));
}
