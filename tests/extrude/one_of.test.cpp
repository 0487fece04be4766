// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/emboldened.hpp"
#include "support/lit_mesh.hpp"
#include "support/toy_font.hpp"

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/one_of.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

using bold_letters = test::emboldened<bevelled>;
using hollow_letters = outlined<extruded<>, extruded<>>;
using any_solid = one_of<flat, extruded<creased_normals>, extruded<>, bevelled, bold_letters, hollow_letters>;

constexpr const char* chosen_word = "oExi Eo";  // x has contours that cross

/// A solid of a type with options that are not those by default.
template <class Solid>
Solid odd_options()
{
    if constexpr (std::same_as<Solid, flat>)
        return {.texture = texture_mapping::box};
    else if constexpr (std::same_as<Solid, bevelled>)
        return {.depth = 0.3f, .width = 0.06f, .bevel_depth = 0.05f, .mode = bevel_mode::fit_text};
    else if constexpr (std::same_as<Solid, bold_letters>)
        return {.by = 0.02f, .solid = {.width = 0.01f}};
    else if constexpr (std::same_as<Solid, hollow_letters>)
        return {.width = 0.02f, .place = outline_place::outer, .letter = {.depth = 0.1f}};
    else
        return {.depth = 0.4f};
}

/// Every part of two plans begins and ends at the same places, and both report the same.
template <class A, class B>
bool are_alike(const A& a, const B& b)
{
    bool alike = a.size() == b.size() && a.bounds().low == b.bounds().low && a.bounds().high == b.bounds().high &&
                 a.report().refused == b.report().refused && a.report().narrowed == b.report().narrowed;
    for (const part p : parts_of<bold_letters>) {
        const mesh_range x = a.range(p), y = b.range(p);
        alike = alike && x.first_vertex == y.first_vertex && x.vertex_count == y.vertex_count &&
                x.first_index == y.first_index && x.index_count == y.index_count;
    }
    return alike;
}

}  // namespace

static_assert(extruder<any_solid> && cacheable_policy<any_solid> && any_solid::part_count == 6);
static_assert(has_heights<any_solid> && has_front_triangles<any_solid> && has_outline<any_solid> &&
              refitting_extruder<any_solid>);

// It says of itself what one of its solids says, and no more.
using plain_choice = one_of<flat, extruded<>>;
static_assert(plain_choice::part_count == 3 && has_hard_edges<plain_choice>);
static_assert(!has_heights<plain_choice> && !has_front_triangles<plain_choice> && !has_outline<plain_choice> &&
              !refitting_extruder<plain_choice>);

TEMPLATE_TEST_CASE("a solid chosen at run time makes the same mesh as by itself", "[extrude][one_of]", flat,
                   extruded<creased_normals>, extruded<>, bevelled, bold_letters, hollow_letters)
{
    test::toy_font font;
    const text_options how{.size = 2.0, .merge = GENERATE(false, true)};
    text_mesher single{font, odd_options<TestType>()};
    const auto expected = single.plan(chosen_word, how);
    REQUIRE(expected);
    const test::lit_mesh mesh = test::written(*expected);
    REQUIRE(mesh.indices.size() > 100);

    text_mesher<any_solid> chosen{font, odd_options<TestType>()};
    const auto first = chosen.plan(chosen_word, how);
    REQUIRE(first);
    CHECK(are_alike(*first, *expected));
    CHECK(test::written(*first) == mesh);

    text_mesher<any_solid> mesher{font};
    glyph_cache<> cache;
    mesher.use(cached_in{cache, 1});
    REQUIRE(mesher.plan(chosen_word, how));
    mesher.use(odd_options<TestType>());
    CHECK(mesher.solid().template get<TestType>() != nullptr);
    for (int round = 0; round < 2; ++round) {
        const auto plan = mesher.plan(chosen_word, how);
        REQUIRE(plan);
        CHECK(are_alike(*plan, *expected));
        CHECK(test::written(*plan) == mesh);
    }

    // The same as another extruder's solid.
    if constexpr (std::same_as<TestType, extruded<>> || std::same_as<TestType, bevelled>) {
        text_mesher inner{font, test::emboldened<any_solid>{.by = 0.01f, .solid = odd_options<TestType>()}};
        text_mesher outer{font, test::emboldened<TestType>{.by = 0.01f, .solid = odd_options<TestType>()}};
        const auto a = inner.plan(chosen_word, how);
        const auto b = outer.plan(chosen_word, how);
        REQUIRE(a);
        REQUIRE(b);
        CHECK(test::written(*a) == test::written(*b));
    }
}

TEST_CASE("a cache distinguishes the choices, and keeps no more bytes for a chosen solid", "[extrude][one_of][cache]")
{
    test::toy_font font;
    glyph_cache<> cache;
    text_mesher<any_solid> mesher{font, cached_in{cache, 1}};
    const auto of = [&](any_solid solid) {
        mesher.solid() = solid;
        const auto plan = mesher.plan(chosen_word);
        REQUIRE(plan);
        return test::written(*plan);
    };
    std::vector<test::lit_mesh> first;
    const any_solid choices[] = {flat{}, extruded<>{}, extruded<creased_normals>{}, bevelled{},
                                 bevelled{.width = 0.01f}};
    for (const any_solid& solid : choices) first.push_back(of(solid));
    const auto after_one = cache.statistics();
    for (std::size_t k = 0; k < first.size(); ++k) {
        CHECK(of(choices[k]) == first[k]);
        for (std::size_t j = 0; j < k; ++j) CHECK_FALSE(first[k] == first[j]);
    }
    CHECK(cache.statistics().misses == after_one.misses);

    glyph_cache<> own_cache, chosen_cache;
    text_mesher own{font, bevelled{}, cached_in{own_cache, 1}};
    text_mesher<any_solid> chosen{font, bevelled{}, cached_in{chosen_cache, 1}};
    REQUIRE(own.plan(chosen_word));
    REQUIRE(chosen.plan(chosen_word));
    CHECK(chosen_cache.statistics().bytes == own_cache.statistics().bytes);
}

TEST_CASE("letters that meet when a chosen solid grows are merged as for the solid by itself", "[extrude][one_of]")
{
    test::toy_font font;  // o is 0.5 em wide, its advance 0.6
    const text_options how{.merge = true};
    const auto check = [&](const auto& solid, std::size_t apart) {
        text_mesher single{font, solid};
        text_mesher<any_solid> chosen{font, solid};
        const auto a = single.plan("oooo", how);
        const auto b = chosen.plan("oooo", how);
        REQUIRE(a);
        REQUIRE(b);
        CHECK(a->glyphs().size() == apart);
        CHECK(test::written(*a) == test::written(*b));
    };
    check(bevelled{.width = 0.06f, .outward = true}, 1);
    check(bevelled{.width = 0.04f, .outward = true}, 4);
    check(bold_letters{.by = 0.06f}, 1);
    check(hollow_letters{.width = 0.06f, .place = outline_place::outer}, 1);
}

TEST_CASE("a plan keeps the solid that it was made with", "[extrude][one_of]")
{
    test::toy_font font;
    text_mesher<any_solid> mesher{font, bevelled{}};
    const auto plan = mesher.plan(chosen_word);
    REQUIRE(plan);
    const test::lit_mesh before = test::written(*plan);
    mesher.solid() = flat{};
    CHECK(test::written(*plan) == before);
    const auto next = mesher.plan(chosen_word);
    REQUIRE(next);
    CHECK(test::written(*next).vertices.size() < before.vertices.size());
}

TEST_CASE("a chosen solid refuses its own options by their names", "[extrude][one_of]")
{
    test::toy_font font;
    text_mesher<any_solid> mesher{font, bevelled{.width = -1.0f}};
    const auto refused = mesher.plan(chosen_word);
    CHECK(refused.error() == error::bad_option);
    CHECK(std::string{refused.error().option} == "width");
    mesher.use(extruded<>{});
    CHECK(mesher.plan(chosen_word));
}
