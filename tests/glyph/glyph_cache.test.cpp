// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/typemesh.hpp>

#include <optional>
#include <string>
#include <vector>

using namespace typemesh;
using test::full_mesh;

namespace {

/// A toy font that counts how often it is asked to draw.
class counted_font : public test::toy_font {
public:
    std::size_t drawn = 0;
    std::uint64_t axes = 0;

    [[nodiscard]] std::uint64_t variation_key() const noexcept { return axes; }
    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) noexcept
    {
        ++drawn;
        return toy_font::outline(id, sink);
    }
};

template <class Mesher, class Text>
full_mesh build(Mesher& mesher, const Text& text, const text_options& options = {})
{
    full_mesh m;
    REQUIRE(mesher.build(text, into(m.vertices, m.indices), options));
    return m;
}

/// Parts of a made-up glyph with `points` points.
glyph_draft draft_of(const std::vector<grid_point>& points)
{
    glyph_draft parts;
    parts.form.points = points;
    return parts;
}

/// A glyph that is in the cache, and not pinned.
void keep_unpinned(glyph_cache<>& cache, glyph_id id, const std::vector<grid_point>& points)
{
    const built_glyph* s = cache.keep({}, id, draft_of(points));
    REQUIRE(s != nullptr);
    cache.release({&s, 1});
}

/// Finds a glyph that is not pinned, and pins it only meanwhile.
const built_glyph* found_in(glyph_cache<>& cache, glyph_id id)
{
    const built_glyph* s = cache.find({}, id);
    if (s != nullptr) cache.release({&s, 1});
    return s;
}

/// How many bytes a shape of `points` points takes in a cache.
std::size_t bytes_of(std::size_t points)
{
    glyph_cache cache;
    keep_unpinned(cache, 0, std::vector<grid_point>(points));
    return cache.statistics().bytes;
}

}  // namespace

TEST_CASE("a kept glyph is found by its own key and no other", "[text]")
{
    glyph_cache cache;
    const std::vector<grid_point> points{{1, 2}, {3, 4}, {-5, 6}};
    glyph_context here;
    const built_glyph* kept = cache.keep(here, 7, draft_of(points));
    REQUIRE(kept != nullptr);
    CHECK(std::equal(points.begin(), points.end(), kept->form().points.begin(), kept->form().points.end()));
    CHECK(kept->form().points.data() != points.data());

    const built_glyph* found = cache.find(here, 7);
    CHECK(found == kept);
    CHECK(cache.find(here, 8) == nullptr);
    std::vector<glyph_context> others(12, here);
    others[0].font = 1, others[1].variation = 1, others[2].tolerance = 1, others[3].fill = 1;
    for (int i = 0; i < 4; ++i) others[4 + static_cast<std::size_t>(i)].discretiser.options.words[i] = 1;
    others[8].discretiser.type = &points, others[9].triangulator.type = &points, others[10].extruder.type = &points;
    others[11].extruder.options.words[3] = 1;
    for (const glyph_context& c : others) CHECK(cache.find(c, 7) == nullptr);
    const built_glyph* pinned[] = {kept, found};
    cache.release(pinned);
    CHECK(cache.statistics().hits == 1);
    CHECK(cache.statistics().misses == 13);
    CHECK(cache.statistics().pinned == 0);
}

TEST_CASE("contexts with equal hashes are distinguished", "[text]")
{
    glyph_cache cache;
    glyph_context here, there;
    there.tolerance = 1;
    const std::vector<grid_point> points{{1, 2}, {3, 4}};
    const built_glyph* kept = cache.keep(here, 42, 7, draft_of(points));
    REQUIRE(kept != nullptr);
    CHECK(cache.find(there, 42, 7) == nullptr);
    const built_glyph* other = cache.keep(there, 42, 7, draft_of(points));
    CHECK(other != kept);
    const built_glyph* found = cache.find(there, 42, 7);
    CHECK(found == other);
    const built_glyph* pinned[] = {kept, other, found};
    cache.release(pinned);
}

TEST_CASE("the bound limits glyphs that are not pinned, and the one released first is dropped first", "[text]")
{
    const std::size_t each = bytes_of(10);
    const std::vector<grid_point> points(10);
    glyph_cache cache{3 * each};
    const built_glyph* shapes[5];
    for (glyph_id id = 0; id < 5; ++id) shapes[id] = cache.keep({}, id, draft_of(points));
    CHECK(cache.statistics().entries == 5);  // pinned: none may go
    CHECK(cache.statistics().pinned_bytes == 5 * each);
    CHECK(cache.statistics().evictions == 0);

    cache.release(shapes);  // 0 first
    CHECK(cache.statistics().entries == 3);
    CHECK(cache.statistics().bytes == 3 * each);
    CHECK(cache.statistics().evictions == 2);
    CHECK(cache.find({}, 0) == nullptr);
    CHECK(cache.find({}, 1) == nullptr);

    REQUIRE(found_in(cache, 2) != nullptr);  // used again: now 3 is the oldest
    keep_unpinned(cache, 9, points);
    CHECK(cache.find({}, 3) == nullptr);
    for (const glyph_id id : {2u, 4u, 9u}) CHECK(found_in(cache, id) != nullptr);
    cache.set_bound(each);
    CHECK(cache.statistics().entries == 1);
    cache.set_bound(0);
    CHECK(cache.statistics().entries == 0);
}

TEST_CASE("a pinned glyph stays in place while all others are dropped", "[text]")
{
    const std::vector<grid_point> points(10, grid_point{3, 4});
    glyph_cache cache{0};
    const built_glyph* first = cache.keep({}, 0, draft_of(points));
    for (glyph_id id = 1; id < 2000; ++id) keep_unpinned(cache, id, points);
    cache.clear();
    CHECK(cache.statistics().entries == 1);
    CHECK(first->form().points[9] == grid_point{3, 4});
    const built_glyph* again = cache.find({}, 0);  // two pins now
    CHECK(again == first);
    cache.release({&first, 1});
    CHECK(cache.statistics().pinned == 1);
    cache.release({&again, 1});
    CHECK(cache.statistics().entries == 0);
}

TEST_CASE("the second caller who keeps the same glyph gets the first one's", "[text]")
{
    const std::vector<grid_point> points(10);
    glyph_cache cache;
    const built_glyph* both[] = {cache.keep({}, 5, draft_of(points)), cache.keep({}, 5, draft_of(points))};
    CHECK(both[0] == both[1]);
    CHECK(cache.statistics().entries == 1);
    cache.release(both);
    CHECK(cache.statistics().pinned == 0);
}

TEST_CASE("a failed request for memory leaves a cache unchanged", "[text]")
{
    const std::vector<grid_point> points(10);
    for (std::size_t n = 1; n < 1100; n += n < 20 ? 1 : 37) {
        test::counting_memory counted{.fail_at = n};
        {
            glyph_cache cache{std::size_t{64} << 20, counted.source()};
            std::vector<const built_glyph*> kept;
            for (glyph_id id = 0; id < 1000; ++id) {
                const built_glyph* s = cache.keep({}, id, draft_of(points));
                if (s != nullptr) kept.push_back(s);
            }
            CHECK(cache.statistics().entries == kept.size());
            for (std::size_t id = 0; id < kept.size(); ++id)
                CHECK(found_in(cache, static_cast<glyph_id>(id)) == kept[id]);
            counted.fail_at = 0;
            const built_glyph* late = cache.keep({}, 5000, draft_of(points));
            CHECK(late != nullptr);
            kept.push_back(late);
            cache.release(kept);
        }
        CHECK(counted.bytes_held == 0);
    }
}

TEST_CASE("meshes are the same to the bit with and without reuse and a cache", "[text]")
{
    const char* text = "oEi xooE~q\nEoixio";
    const auto unit = GENERATE(output_unit::em, output_unit::unit_box);
    const auto over = GENERATE(texture_box::text, texture_box::line, texture_box::glyph);
    text_options options{.unit = unit, .texture_over = over, .draw_missing = true};
    counted_font font;
    text_mesher plain{font};
    const auto expected = build(plain, text, options);
    CHECK(font.drawn == 7);  // o E i x ~ .notdef, and the blank

    options.reuse = false;
    CHECK(test::same_bits(build(plain, text, options), expected));
    CHECK(font.drawn == 7 + 16);

    options.reuse = true;
    glyph_cache cache;
    auto cached = text_mesher{font}.with(cached_in{cache, 1});
    CHECK(test::same_bits(build(cached, text, options), expected));
    CHECK(font.drawn == 7 + 16 + 7);
    CHECK(test::same_bits(build(cached, text, options), expected));
    auto another = text_mesher{font}.with(cached_in{cache, 1});
    CHECK(test::same_bits(build(another, text, options), expected));
    CHECK(font.drawn == 7 + 16 + 7);  // refusals and blanks are kept as well
    CHECK(cache.statistics().entries == 7);
    CHECK(cache.statistics().hits == 14);
    CHECK(cache.statistics().misses == 7);
    CHECK(cache.statistics().pinned == 0);
}

TEST_CASE("a refusal from the cache is reported with its own place in the text", "[text]")
{
    test::toy_font font;
    glyph_cache cache;
    auto mesher = text_mesher{font}.with(cached_in{cache, 1});
    full_mesh m;
    for (int i = 0; i < 2; ++i) {
        const auto made = mesher.build(i == 0 ? "E~~" : "EE~", into(m.vertices, m.indices));
        REQUIRE(made);
        CHECK(made->refused == (i == 0 ? 2u : 1u));
        CHECK(made->first_refusal == error::outline_not_finite);
        CHECK(made->first_refusal.glyph == 6);
        CHECK(made->first_refusal.cluster == (i == 0 ? 1u : 2u));
    }
}

TEST_CASE("settings and policies that shape glyphs differently never share them", "[text]")
{
    counted_font font;
    glyph_cache cache;
    const auto drawn_by = [&](auto mesher, const text_options& options = {}) {
        auto without = std::move(mesher);
        const std::size_t unkept = font.drawn;
        const auto expected = build(without, "ox", options);
        CHECK(font.drawn - unkept == 2);
        auto with_cache = std::move(without).with(cached_in{cache, 1});
        const std::size_t before = font.drawn;
        const auto m = build(with_cache, "ox", options);
        const std::size_t drawn = font.drawn - before;
        CHECK(test::same_bits(m, expected));
        return drawn;
    };
    const auto plain = [&] { return text_mesher{font}; };
    CHECK(drawn_by(plain()) == 2);
    CHECK(drawn_by(plain()) == 0);
    CHECK(drawn_by(plain(), {.tolerance = 0.01}) == 2);
    CHECK(drawn_by(plain(), {.fill = fill_rule::even_odd}) == 2);
    CHECK(drawn_by(plain(), {.fill = fill_rule::non_zero}) == 2);  // not known to be the font's own
    const auto check_drawn_by_each = [&](const auto&... policies) {
        int row = 0;
        const auto check = [&](const auto& policy) {
            INFO("policy " << row++);
            CHECK(drawn_by(plain().with(policy)) == 2);
        };
        (check(policies), ...);
    };
    check_drawn_by_each(two_lines{}, adaptive_subdivision{.distance = 0.5},
                        adaptive_subdivision{.levels = 2, .distance = 0.5}, adaptive_subdivision{.distance = 30.0},
                        adaptive_subdivision{.distance = 0.5, .angle = 0.5});
    for (const auto preset : {thesis_quality::low, thesis_quality::normal, thesis_quality::high, thesis_quality::best})
        CHECK(drawn_by(plain().with(thesis_quality{preset, 1000.0})) == 2);
    check_drawn_by_each(thesis_quality{thesis_quality::high, 2048.0}, constrained_delaunay{}, flat{},
                        extruded<shared_normals>{}, extruded<creased_normals>{}, extruded<>{.front = false},
                        extruded<>{.back = false}, extruded<>{.side = false},
                        extruded<>{.texture = texture_mapping::box}, extruded<>{.normals = {.crease_degrees = 100.0f}});
    font.axes = 9;
    CHECK(drawn_by(plain()) == 2);
    font.axes = 0;
    // What matters only to writing is shared.
    CHECK(drawn_by(plain()) == 0);
    CHECK(drawn_by(plain().with(extruded<>{.depth = 3.0f, .centred = true})) == 0);
    CHECK(drawn_by(plain().with(flat{.texture = texture_mapping::box})) == 0);
    CHECK(drawn_by(plain(), {.unit = output_unit::pixels, .size = 3.0, .frame = left_handed_z_up}) == 0);
}

TEST_CASE("a bad option is refused even if the glyphs are cached", "[text]")
{
    test::toy_font font;
    glyph_cache cache;
    auto mesher = text_mesher{font}.with(cached_in{cache, 1});
    REQUIRE(mesher.plan("o"));
    mesher.solid().depth = -1.0f;
    CHECK(mesher.plan("o").error() == error::bad_option);
    CHECK(cache.statistics().pinned == 0);
    mesher.solid().depth = 0.2f;
    mesher.solid().normals.crease_degrees = 999.0f;
    CHECK(mesher.plan("o").error() == error::bad_option);
    mesher.solid().normals.crease_degrees = 15.0f;
    CHECK(mesher.plan("o"));
}

TEST_CASE("a plan pins its glyphs exactly until it ends", "[text]")
{
    test::toy_font font;
    glyph_cache cache{0};  // nothing stays but what is pinned
    auto mesher = text_mesher{font}.with(cached_in{cache, 1});
    text_mesher plain{font};
    const auto expected = build(plain, "oEo");

    std::optional<decltype(mesher)::plan_type> plan;
    {
        auto made = mesher.plan("oEo");
        REQUIRE(made);
        plan.emplace(std::move(*made));
    }
    CHECK(cache.statistics().pinned == 2);
    auto greedy = text_mesher{font}.with(cached_in{cache, 1});
    for (int i = 0; i < 3; ++i) build(greedy, "Eixo .");
    cache.clear();
    CHECK(cache.statistics().entries == 2);
    full_mesh m;
    REQUIRE(plan->write(into(m.vertices, m.indices)));
    CHECK(test::same_bits(m, expected));
    plan.reset();
    CHECK(cache.statistics().entries == 0);

    auto first = mesher.plan("o");
    CHECK(cache.statistics().pinned == 1);
    auto second = mesher.plan("Ei");  // ends the first
    CHECK(cache.statistics().pinned == 2);
    first = error::bad_option;
    CHECK(cache.statistics().pinned == 2);
    second = error::bad_option;
    CHECK(cache.statistics().entries == 0);
}

TEST_CASE("a moved mesher keeps its pins", "[text]")
{
    test::toy_font font;
    glyph_cache cache{0};
    {
        auto mesher = text_mesher{font}.with(cached_in{cache, 1});
        auto plan = mesher.plan("oE");
        REQUIRE(plan);
        auto other = std::move(mesher);
        CHECK(cache.statistics().pinned == 2);
        REQUIRE(other.plan("i"));
        CHECK(cache.statistics().pinned == 0);
        auto last = other.plan("i");
        CHECK(cache.statistics().pinned == 1);
        auto flat_text = std::move(other).with(flat{});
        REQUIRE(flat_text.plan("E"));
    }
    CHECK(cache.statistics().entries == 0);
}

TEST_CASE("a run of cached glyphs is planned without memory and without the font", "[text]")
{
    counted_font font;
    test::counting_memory kept, used;
    glyph_cache cache{std::size_t{1} << 20, kept.source()};
    auto mesher = text_mesher{font, used.source()}.with(cached_in{cache, 1});
    glyph_run run;
    REQUIRE(layout(font, "oEi x~oo", {}, {}, run));
    REQUIRE(mesher.plan(run));
    const std::size_t requests = used.requests + kept.requests, drawn = font.drawn;
    for (int i = 0; i < 3; ++i) {
        auto plan = mesher.plan(run);
        REQUIRE(plan);
        std::vector<test::full_vertex> vertices(plan->size().vertices);
        std::vector<std::uint32_t> indices(plan->size().indices());
        REQUIRE(plan->write(into(std::span{vertices}, std::span{indices})));
    }
    CHECK(used.requests + kept.requests == requests);
    CHECK(font.drawn == drawn);
}

TEST_CASE("a lack of memory in the cache fails only the plan", "[text]")
{
    test::toy_font font;
    text_mesher plain{font};
    const auto expected = build(plain, "oEix");
    for (std::size_t n = 1; n < 8; ++n) {
        test::counting_memory counted{.fail_at = n, .fail_once = true};
        {
            glyph_cache cache{std::size_t{1} << 20, counted.source()};
            auto mesher = text_mesher{font}.with(cached_in{cache, 1});
            full_mesh m;
            const auto made = mesher.build("oEix", into(m.vertices, m.indices));
            if (n <= 5) CHECK(made.error() == error::out_of_memory);
            CHECK(cache.statistics().pinned == 0);
            CHECK(test::same_bits(build(mesher, "oEix"), expected));
        }
        CHECK(counted.bytes_held == 0);
    }
}

TEST_CASE("a cache can be used without a mesher", "[text]")
{
    test::toy_font font;
    glyph_cache cache;
    glyph_builder builder;
    no_observer nobody;
    const glyph_settings how{.tolerance = 0.01};
    const certified flatten;
    const monotone cut;
    const flat raise;
    const policies with{flatten, cut, raise, nobody};
    const glyph_context context = context_of(1, 0, how, with, 1.0);
    const auto parts = builder.build(font, 2, how, with);
    REQUIRE(parts);
    const built_glyph* e = cache.keep(context, 2, *parts);
    REQUIRE(e != nullptr);
    CHECK(e->form().points.size() == 12);
    CHECK(e->form().triangles.size() == 10);
    CHECK(e->ink().low == point{50, 0});
    CHECK(e->ink().high == point{450, 700});
    cache.release({&e, 1});
    auto mesher = text_mesher{font}.with(flat{}).with(cached_in{cache, 1});
    REQUIRE(mesher.plan("E", {.tolerance = 0.01}));
    CHECK(cache.statistics().hits == 1);
}
