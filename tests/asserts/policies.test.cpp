// SPDX-License-Identifier: MIT

// What a policy promises beyond its signatures is held against what it does, in builds with asserts: each broken promise
// has a sentence, which comes before anything is written that was not planned.

#include "support/recorded_asserts.hpp"

#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <array>
#include <vector>

using namespace typemesh;

namespace {

/// The sentences of the failed asserts, each once, in the order of their first failure.
std::vector<std::string> told()
{
    std::vector<std::string> once;
    for (const std::string& words : test::failed_asserts) {
        if (std::find(once.begin(), once.end(), words) == once.end()) once.push_back(words);
    }
    test::failed_asserts.clear();
    return once;
}
using sentences = std::vector<std::string>;

/// A sink with exactly as much room as it was told to need: what comes in excess is counted, and lost.
struct exact_sink {
    static constexpr auto wants = attribute::position;
    mesh_size announced, came;

    error begin(mesh_size exact) noexcept { return announced = exact, came = {}, error{}; }
    void vertex(const surface_point<wants>&) noexcept { ++came.vertices; }
    void triangle(std::uint32_t, std::uint32_t, std::uint32_t) noexcept { ++came.triangles; }
    void end() noexcept {}
};

// --- discretisers ------------------------------------------------------------------------------------------------

/// Emits the points of a curve at these places of it.
template <int... Percent>
struct at_percent {
    template <class Curve, class Put>
    void operator()(const Curve& c, double, Put&& put) const noexcept
    {
        (put(c.at(Percent / 100.0), Percent / 100.0), ...);
    }
};

/// Says that it has come to the end, and has not.
struct elsewhere {
    template <class Curve, class Put>
    void operator()(const Curve& c, double, Put&& put) const noexcept
    {
        put(c.at(0.5), 0.5);
        put(c.at(0.98), 1.0);
    }
};

// --- triangulators -----------------------------------------------------------------------------------------------

/// The triangles that monotone makes, spoilt.
template <class Spoil>
struct spoilt {
    Spoil spoil;
    error operator()(const region& r, workspace& space, triangle_list& out) const noexcept
    {
        const std::size_t before = out.size();
        if (error e = monotone{}(r, space, out)) return e;
        spoil(out, before);
        return {};
    }
};
template <class Spoil>
spoilt(Spoil) -> spoilt<Spoil>;

/// The same with loops that it proves.
template <class Spoil>
struct spoilt_proof : spoilt<Spoil> {
    result<region> prove(const contours& loops, workspace& space, triangle_list& out) const noexcept
    {
        const std::size_t before = out.size();
        auto r = monotone{}.prove(loops, space, out);
        if (r) this->spoil(out, before);
        return r;
    }
};

// --- extruders ---------------------------------------------------------------------------------------------------

/// flat, with so many vertices and triangles too many (or too few) when it writes.
struct miscounting : flat {
    int more_vertices = 0, more_triangles = 0;
    bool wild = false;  ///< its last triangle has a corner that is no vertex

    [[nodiscard]] option_bits cache_key() const noexcept { return {}; }

    template <attribute Wants, class Put>
    void vertices(part p, const solid& s, const placement& at, Put&& put) const noexcept
    {
        if (p != part::front) return;
        const auto count = static_cast<int>(s.points.size()) + more_vertices;
        surface_point<Wants> v;
        if constexpr (has(Wants, attribute::position)) v.position = at.position(s.points[0], 0.0f);
        for (int i = 0; i < count; ++i) put(v);
    }
    template <class Put>
    void triangles(part p, const solid& s, const first_vertices& first, Put&& put) const noexcept
    {
        if (p != part::front) return;
        const auto count = static_cast<int>(s.triangles.size()) + more_triangles;
        for (int i = 0; i < count; ++i) {
            const bool last = i + 1 == count;
            put(first[p], first[p] + 1,
                wild && last ? first[p] + static_cast<std::uint32_t>(s.points.size()) : first[p] + 2);
        }
    }
};

/// A vertex of places alone.
struct corner {
    vec3 place;
};
struct writer {
    static constexpr auto wants = attribute::position;
    corner operator()(const surface_point<wants>& s) const noexcept { return {s.position}; }
};

constexpr const char* text = "oE";

template <class Mesher>
exact_sink written(Mesher mesher)
{
    exact_sink sink;
    const text_options options;
    const auto report = mesher.build(text, sink, options);
    REQUIRE(report);
    return sink;
}

}  // namespace

TEST_CASE("a discretiser that misses the curve's end, or goes back, is asserted", "[asserts]")
{
    test::toy_font font;
    const auto told_by = [&](auto how) {
        (void)written(text_mesher{font}.with(how));
        return told();
    };
    const std::string end = "a discretiser's last point must be the end of its curve, with t = 1",
                      order = "a discretiser must emit its points with t ascending, above 0 and up to 1";
    CHECK(told_by(at_percent<30, 100>{}) == sentences{});
    CHECK(told_by(at_percent<30, 99>{}) == sentences{end});
    CHECK(told_by(at_percent<>{}) == sentences{end});
    CHECK(told_by(elsewhere{}) == sentences{end});
    CHECK(told_by(at_percent<0, 100>{}) == sentences{order});
    CHECK(told_by(at_percent<60, 40, 100>{}) == sentences{order});
    CHECK(told_by(at_percent<50, 50, 100>{}) == sentences{order});
    CHECK(told_by(at_percent<50, 100, 120>{}) == sentences{order, end});
}

TEST_CASE("a triangulator that appends the wrong number of triangles is asserted", "[asserts]")
{
    const std::string count = "a triangulator appended more or fewer triangles than the region's triangle_count()",
                      range = "a triangulator appended a triangle with a corner that is not a point of the region",
                      turn = "a triangulator appended a triangle that is flat or clockwise",
                      area = "a triangulator appended triangles that do not have the region's area";
    const auto fewer = [](triangle_list& out, std::size_t) noexcept { out.truncate(out.size() - 1); };
    const auto more = [](triangle_list& out, std::size_t before) noexcept { (void)out.push_back(out[before]); };
    const auto turned = [](triangle_list& out, std::size_t before) noexcept {
        std::swap(out[before].a, out[before].b);
    };
    const auto thin = [](triangle_list& out, std::size_t before) noexcept { out[before].a = out[before].b; };
    const auto twice = [](triangle_list& out, std::size_t before) noexcept { out[before] = out[before + 1]; };
    const auto outside = [](triangle_list& out, std::size_t before) noexcept { out[before].c = 0x7FFF'FFFFu; };

    outline drawn;
    test::toy_font font;
    REQUIRE(record(font, font.glyph_of('E'), drawn));
    const auto cells = grid::fitting(font.units_per_em(), drawn.bounds);
    REQUIRE(cells);
    cap_builder caps;
    const auto told_by = [&](auto how) {
        REQUIRE(caps.flatten(drawn, certified{}, 1.0, *cells));
        REQUIRE(caps.fill({drawn.rule}, how));
        auto by_fill = told();
        no_observer nobody;
        REQUIRE(caps.build(drawn, 1.0, *cells, {drawn.rule}, policies{certified{}, how, flat{}, nobody}));
        CHECK(told() == by_fill);
        return by_fill;
    };
    const auto both_ways = [&](auto spoil) {
        auto given = told_by(spoilt{spoil});
        CHECK(told_by(spoilt_proof<decltype(spoil)>{{spoil}}) == given);
        return given;
    };
    CHECK(both_ways([](triangle_list&, std::size_t) noexcept {}) == sentences{});
    CHECK(both_ways(fewer) == sentences{count, area});
    CHECK(both_ways(more) == sentences{count, area});
    CHECK(both_ways(turned) == sentences{turn, area});
    CHECK(both_ways(thin) == sentences{turn, area});
    CHECK(both_ways(twice) == sentences{area});
    CHECK(both_ways(outside) == sentences{range});
}

TEST_CASE("an extruder that emits more or less than it planned is asserted, and no sink gets more", "[asserts]")
{
    test::toy_font font;
    const auto told_by = [&](const miscounting& how) {
        const exact_sink sink = written(text_mesher{font}.with(how));
        CHECK(sink.came.vertices <= sink.announced.vertices);
        CHECK(sink.came.triangles <= sink.announced.triangles);
        auto all = told();

        // As instances, and in chunks: of whole glyphs, and of glyphs that are split.
        auto mesher = text_mesher{font}.with(how);
        const auto plan = mesher.plan(text);
        exact_sink again;
        REQUIRE(plan->write_meshes(again));
        CHECK(again.came.vertices <= again.announced.vertices);
        CHECK(told() == all);
        for (const std::uint32_t most : {65'535u, 6u}) {
            text_chunks chunks;
            REQUIRE(chunks.cut(*plan, most));
            for (std::size_t k = 0; k < chunks.view().size(); ++k) {
                REQUIRE(chunks.write(*plan, k, again));
                CHECK(again.came.vertices <= again.announced.vertices);
            }
            CHECK(told() == all);
        }
        return all;
    };
    using how = miscounting;
    CHECK(told_by(how{}) == sentences{});
    CHECK(told_by(how{{}, 1}) == sentences{"an extruder emitted more vertices of a part than its plan() reported"});
    CHECK(told_by(how{{}, -1}) == sentences{"an extruder emitted fewer vertices of a part than its plan() reported"});
    CHECK(told_by(how{{}, 0, 1}) == sentences{"an extruder emitted more triangles of a part than its plan() reported"});
    CHECK(told_by(how{{}, 0, -1}) ==
          sentences{"an extruder emitted fewer triangles of a part than its plan() reported"});
    CHECK(told_by(how{{}, 0, 0, true}) ==
          sentences{"an extruder emitted a triangle with a corner that is not a vertex of its solid"});
}

TEST_CASE("writing to a sink past its end, or before it begins, is asserted", "[asserts]")
{
    const std::string vertices = "more vertices were written than the sink can hold",
                      triangles = "more triangles were written than the sink can hold";
    // Memory lies behind what the sinks are told of: the sentence comes, and nothing breaks.
    std::array<corner, 4> corners;
    std::array<std::uint16_t, 12> indices;
    const auto overfilled = [&](auto sink) {
        REQUIRE_FALSE(sink.begin({3, 1}));
        for (int i = 0; i < 3; ++i) sink.vertex({});
        sink.triangle(0, 1, 2);
        CHECK(told() == sentences{});
        sink.vertex({});
        CHECK(told() == sentences{vertices});
        sink.triangle(0, 1, 2);
        CHECK(told() == sentences{triangles});
    };
    overfilled(into(std::span{corners}.first(3), std::span{indices}.first(3), writer{}));
    overfilled(stream_sink{std::span{indices}.first(3), stream<attribute::position, vec3>{&corners[0].place, 3}});
    std::vector<corner> grown;
    std::vector<std::uint16_t> numbers;
    grown.reserve(4), numbers.reserve(12);
    overfilled(into(grown, numbers, writer{}));

    // A span that is too small never begins.
    auto small = into(std::span{corners}.first(2), std::span{indices}, writer{});
    const error e = small.begin({3, 1});
    CHECK(e == error::buffer_too_small);
    char words[200];
    CHECK(std::string{describe(e, words)} ==
          "The buffer is too small for the mesh: give a larger one. (needed: 3 vertices)");
}

TEST_CASE("A shaper with clusters outside its text, or out of order, is asserted", "[asserts]")
{
    struct careless : test::toy_font {
        std::uint32_t off = 0;
        bool backwards = false;
        error shape(text_view given, const text_item& item, const shape_options& how,
                    buffer<shaped_glyph>& glyphs) noexcept
        {
            const std::size_t before = glyphs.size();
            const error e = test::toy_font::shape(given, item, how, glyphs);
            for (shaped_glyph& g : glyphs.view().subspan(before)) g.cluster += off;
            if (backwards) std::reverse(glyphs.begin() + before, glyphs.end());
            return e;
        }
    };
    const auto told_by = [](std::uint32_t off, bool backwards = false) {
        careless font;
        font.off = off;
        font.backwards = backwards;
        text_mesher mesher{font};
        REQUIRE(mesher.plan("EE?\n"));  // the unit after the item is one of the text
        return told();
    };
    CHECK(told_by(0) == sentences{});
    CHECK(told_by(0, true) == sentences{"a shaper gave clusters that are not in the order of its item"});
    CHECK(told_by(1) == sentences{"a shaper gave a glyph a cluster outside the range of text that it had to shape"});
}
