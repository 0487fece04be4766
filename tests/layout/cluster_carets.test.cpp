// SPDX-License-Identifier: MIT
#include "support/each_failure.hpp"

#include <typemesh/layout/impl/cluster_carets.hpp>

#include <vector>

using namespace typemesh;

namespace {

/// A font whose glyph n has carets at 100, 200, ... n times; 99 has them out of order.
struct caret_font {
    error ligature_carets(std::uint32_t, glyph_id id, bool, buffer<double>& carets) const noexcept
    {
        for (glyph_id i = 1; i <= id && id != 99; ++i)
            if (!carets.push_back(100.0 * i)) return error::out_of_memory;
        if (id == 99 && (!carets.push_back(200.0) || !carets.push_back(100.0))) return error::out_of_memory;
        return {};
    }
};

std::vector<double> places_in(const cluster_carets& all, std::uint32_t cluster)
{
    const auto places = all.of(cluster);
    return {places.begin(), places.end()};
}

}  // namespace

TEST_CASE("a cluster's carets are its font's, scaled, from where its pen begins", "[paragraph][carets]")
{
    cluster_carets all;
    const shaped_glyph one[] = {{.id = 2, .advance = 600.0, .offset = {10.0, 0.0}}};
    const shaped_glyph two[] = {{.id = 0, .advance = 50.0}, {.id = 1, .advance = 300.0}};
    REQUIRE_FALSE(all.find(caret_font{}, one, {.cluster = 3, .count = 2}));
    REQUIRE_FALSE(all.find(caret_font{}, two, {.cluster = 7, .count = 1, .scale = 2.0}));
    CHECK(places_in(all, 3) == std::vector<double>{110.0, 210.0});
    CHECK(places_in(all, 7) == std::vector<double>{250.0});
    for (const std::uint32_t other : {0u, 4u, 8u}) CHECK(places_in(all, other).empty());

    all.truncate(7);
    CHECK(places_in(all, 7).empty());
    CHECK(places_in(all, 3).size() == 2);
    all.clear();
    CHECK(places_in(all, 3).empty());
}

TEST_CASE("carets of a glyph on its side are a line's carets, down from where its pen begins", "[paragraph][carets]")
{
    struct line_font {
        error ligature_carets(std::uint32_t, glyph_id, bool down, buffer<double>& carets) const noexcept
        {
            return down || carets.push_back(300.0) ? error{} : error{error::out_of_memory};
        }
    };
    cluster_carets all;
    const shaped_glyph turned[] = {{.id = 1, .advance = 700.0, .offset = {-400.0, -10.0}}};
    REQUIRE_FALSE(all.find(line_font{}, turned, {.cluster = 1, .count = 1, .down = true, .turned = true}));
    CHECK(places_in(all, 1) == std::vector<double>{310.0});
    REQUIRE_FALSE(all.find(line_font{}, turned, {.cluster = 2, .count = 1, .down = true}));
    CHECK(places_in(all, 2).empty());
}

TEST_CASE("carets that are too few, too many, out of order or outside are ignored", "[paragraph][carets]")
{
    cluster_carets all;
    std::uint32_t cluster = 0;
    const auto kept = [&](shaped_glyph g, std::uint32_t count, bool down = false) {
        const shaped_glyph glyphs[] = {g};
        REQUIRE_FALSE(all.find(caret_font{}, glyphs, {.cluster = ++cluster, .count = count, .down = down}));
        return !places_in(all, cluster).empty();
    };
    CHECK(kept({.id = 2, .advance = 600.0}, 2));
    CHECK_FALSE(kept({.id = 2, .advance = 600.0}, 1));
    CHECK_FALSE(kept({.id = 2, .advance = 600.0}, 3));
    CHECK_FALSE(kept({.id = 99, .advance = 600.0}, 2));
    CHECK_FALSE(kept({.id = 2, .advance = 200.0}, 2));
    CHECK_FALSE(kept({.id = 2, .advance = 600.0, .offset = {-100.0, 0.0}}, 2));
    CHECK(kept({.id = 2, .advance = 600.0, .offset = {-100.0, 0.0}}, 2, true));
    CHECK_FALSE(kept({.id = 2, .advance = 600.0, .offset = {0.0, 100.0}}, 2, true));
}

TEST_CASE("carets without memory say so", "[paragraph][carets]")
{
    const shaped_glyph glyphs[] = {{.id = 2, .advance = 600.0}};
    test::check_each_failure([&glyphs](memory source) {
        cluster_carets all{source};
        const error e = all.find(caret_font{}, glyphs, {.cluster = 1, .count = 2});
        CHECK(places_in(all, 1).empty() == bool(e));
        return e;
    });
}
