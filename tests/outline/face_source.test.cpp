// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/outline/face_source.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/outline/transformed_outlines.hpp>

using namespace typemesh;

namespace {

/// Two faces: 0 draws a wedge of glyph 0, 1 the same twice as large and even-odd.
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

bool same_curves(const outline& a, const outline& b)
{
    if (a.curves.size() != b.curves.size() || a.rule != b.rule) return false;
    for (std::size_t i = 0; i < a.curves.size(); ++i)
        for (std::size_t k = 0; k < 4; ++k)
            if (!(a.curves[i].p[k] == b.curves[i].p[k])) return false;
    return true;
}

}  // namespace

TEST_CASE("a source that says nothing of faces has one", "[outline]")
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

TEST_CASE("a mapped face draws one face through a map, in the units that it was given", "[outline]")
{
    two_faces both;
    outline expected, found;
    for (const std::uint32_t face : {0u, 1u}) {
        mapped_face plain{both, face, nullptr, 100.0};
        outline_recorder by_hand{expected};
        REQUIRE_FALSE(both.outline(face, 0, by_hand));
        REQUIRE_FALSE(by_hand.finish());
        expected.rule = both.fill(face);
        REQUIRE_FALSE(record(plain, 0, found));
        CHECK(same_curves(found, expected));
        CHECK(plain.units_per_em() == 100.0);
        CHECK(record(plain, 1, found) == error::unknown_glyph);
    }
    const affine map{0.5, 0.25, 3, 0.125, 2, -7};
    mapped_face mapped{both, 0, &map, 100.0};
    transformed_outlines transformed{both, map};
    REQUIRE_FALSE(record(transformed, 0, expected));
    REQUIRE_FALSE(record(mapped, 0, found));
    CHECK(same_curves(found, expected));
}
