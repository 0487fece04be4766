// SPDX-License-Identifier: MIT

// The strangers of tests/stranger with the mistakes that are made, and the sentence that each gets. What the compiler refuses
// is in tests/compile.

#include "support/recorded_asserts.hpp"

#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/text/shaped_by.hpp>
#include <typemesh/typemesh.hpp>

#include "stranger/flared.hpp"
#include "stranger/monospace_shaper.hpp"
#include "stranger/ply_sink.hpp"
#include "stranger/svg_paths.hpp"
#include "stranger/tapering_twist.hpp"

#include <cstdio>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

/// The first sentence of those that came, or "".
std::string told()
{
    std::string words = test::failed_asserts.empty() ? "" : test::failed_asserts.front();
    test::failed_asserts.clear();
    return words;
}

struct nowhere {
    static constexpr auto wants = attribute::position;
    error begin(mesh_size) noexcept { return {}; }
    void vertex(const surface_point<wants>&) noexcept {}
    void triangle(std::uint32_t, std::uint32_t, std::uint32_t) noexcept {}
    void end() noexcept {}
};

template <class Mesher>
std::string told_by(Mesher mesher, const char* text = "oE")
{
    nowhere sink;
    const text_options options;
    const auto report = mesher.build(text, sink, options);
    REQUIRE(report);
    return told();
}

/// Equal steps that stop before the end: `i < n`.
struct forgets_the_end {
    template <class Curve, class Put>
    void operator()(const Curve& c, double, Put&& put) const noexcept
    {
        for (int i = 1; i < 8; ++i) put(c.at(i / 8.0), i / 8.0);
    }
};

/// Equal steps from the end to the start.
struct runs_backwards {
    template <class Curve, class Put>
    void operator()(const Curve& c, double, Put&& put) const noexcept
    {
        for (int i = 8; i >= 1; --i) put(c.at(i / 8.0), i / 8.0);
    }
};

/// A fan from the first point of each loop: right for convex letters without holes.
struct fan {
    error operator()(const region& r, workspace&, triangle_list& out) const noexcept
    {
        for (std::uint32_t k = 0; k < r.loop_count(); ++k)
            for (std::uint32_t i = r.starts()[k] + 2; i < r.starts()[k + 1]; ++i)
                if (!out.push_back({r.starts()[k], i - 1, i})) return error::out_of_memory;
        return {};
    }
};

/// Counts the levels between front and back, and forgets one of the two.
struct counts_steps_as_levels : stranger::tapering_twist {
    result<solid_plan> plan(const region& r, plan_data& data) const noexcept
    {
        auto made = tapering_twist::plan(r, data);
        if (made) made->sizes.vertices[part::side] -= static_cast<std::uint32_t>(r.points().size());
        return made;
    }
};
/// Turns letters out of their boxes and says nothing of it.
struct forgets_the_box : stranger::tapering_twist {
    result<part_sizes> plan(const region& r, plan_data& data) const noexcept
    {
        const auto made = tapering_twist::plan(r, data);
        if (!made) return made.error();
        return made->sizes;
    }
};
/// Says half of its depth.
struct halves_its_heights : stranger::tapering_twist {
    height_range heights() const noexcept { return {-0.5 * depth, 0.0}; }
};
/// Has five parts and says nothing of the last two.
struct forgets_its_parts : stranger::flared {
    static constexpr std::size_t part_count = 3;
};
/// Plans a back, and writes none.
struct forgets_the_back : stranger::tapering_twist {
    template <class Put>
    void triangles(part p, const solid& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (p != part::back) tapering_twist::triangles(p, s, first, put);
    }
};
/// Numbers vertices from 0 on in each part.
struct numbers_from_nought : stranger::tapering_twist {
    template <class Put>
    void triangles(part p, const solid& s, const first_vertices&, Put&& put) const noexcept
    {
        first_vertices far_off;
        far_off[p] = 1u << 20;
        tapering_twist::triangles(p, s, far_off, put);
    }
};

/// Numbers the characters of each item from 0 on.
struct counts_by_item : stranger::monospace_shaper {
    using monospace_shaper::monospace_shaper;
    error shape(text_view text, const text_item& item, const shape_options& how, buffer<shaped_glyph>& glyphs) noexcept
    {
        const std::size_t before = glyphs.size();
        const error e = monospace_shaper::shape(text, item, how, glyphs);
        for (shaped_glyph& g : glyphs.view().subspan(before)) g.cluster -= item.first;
        return e;
    }
};

}  // namespace

TEST_CASE("wrong discretisers, triangulators and extruders are asserted with the right message", "[asserts]")
{
    test::toy_font font;
    CHECK(told_by(text_mesher{font}.with(forgets_the_end{})) ==
          "a discretiser's last point must be the end of its curve, with t = 1");
    CHECK(told_by(text_mesher{font}.with(runs_backwards{})) ==
          "a discretiser must emit its points with t ascending, above 0 and up to 1");
    CHECK(told_by(text_mesher{font}.with(fan{}), "i") == "");
    CHECK(told_by(text_mesher{font}.with(fan{}), "E") ==
          "a triangulator appended a triangle that is flat or clockwise");
    CHECK(told_by(text_mesher{font}.with(fan{}), "o") ==
          "a triangulator appended more or fewer triangles than the region's triangle_count()");
    CHECK(told_by(text_mesher{font}.with(stranger::tapering_twist{})) == "");
    CHECK(told_by(text_mesher{font}.with(counts_steps_as_levels{})) ==
          "an extruder emitted more vertices of a part than its plan() reported");
    CHECK(told_by(text_mesher{font}.with(forgets_the_back{})) ==
          "an extruder emitted fewer triangles of a part than its plan() reported");
    CHECK(told_by(text_mesher{font}.with(numbers_from_nought{})) ==
          "an extruder emitted a triangle with a corner that is not a vertex of its solid");
    const std::string outside = "an extruder emitted a vertex outside the bounds that it states";
    CHECK(told_by(text_mesher{font}.with(forgets_the_box{})) == outside);
    CHECK(told_by(text_mesher{font}.with(halves_its_heights{})) == outside);
    CHECK(told_by(text_mesher{font}.with(stranger::flared{})) == "");
    CHECK(told_by(text_mesher{font}.with(forgets_its_parts{})) ==
          "an extruder planned vertices or triangles of a part beyond its part_count");
}

TEST_CASE("a wrong shaper is asserted, and wrong drawings and full disks are errors", "[asserts]")
{
    stranger::svg_paths paths{100.0, {"", "M10 100 V20 H60 V100 Z", "L10 100 V20 H60 Z", "M10 nowhere"}};
    const std::string characters{"\0ILN", 4};
    counts_by_item wrong{100.0, 60.0, characters};
    shaped_by by_item{wrong, paths};
    CHECK(told_by(text_mesher{by_item}, "II") == "");
    CHECK(told_by(text_mesher{by_item}, "II\nII") ==
          "a shaper gave a glyph a cluster outside the range of text that it had to shape");

    // Errors, not asserts: the file may be what is wrong, not the program.
    stranger::monospace_shaper shaper{100.0, 60.0, characters};
    shaped_by font{shaper, paths};
    text_mesher mesher{font};
    for (const char* text : {"IL", "IN"}) {
        const auto plan = mesher.plan(text);
        REQUIRE(plan);
        CHECK(plan->report().refused == 1);
        char words[200];
        CHECK(std::string{describe(plan->report().first_refusal, words)} ==
              std::string{"glyph "} + (text[1] == 'L' ? "2" : "3") +
                  ", cluster 1: The outline is malformed: begin each contour with move().");
    }
    const auto plan = mesher.plan("I");
    REQUIRE(plan);
    std::FILE* file = std::fopen(TYPEMESH_TEST_DATA "/corpus/regions.txt", "rb");  // it takes nothing, as a full disk
    REQUIRE(file != nullptr);
    stranger::ply_sink sink{file};
    const error e = plan->write(sink).error();
    CHECK(e == error::not_written);
    char words[200];
    CHECK(std::string{describe(e, words)} ==
          "The mesh could not be written to its end: check the free space on the disk.");
    const text_options options;
    CHECK(mesher.build("I", sink, options).error() == error::not_written);
    std::fclose(file);
    CHECK(told() == "");
}
