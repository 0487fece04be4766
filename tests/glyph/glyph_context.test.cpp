// SPDX-License-Identifier: MIT

#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/two_lines.hpp>
#include <typemesh/extrude/averaged_normals.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/glyph/glyph_context.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"

#include <cmath>
#include <set>
#include <vector>

using namespace typemesh;

namespace {

struct with_option : two_lines {
    double amount = 1.0;
    explicit with_option(double a = 1.0) : amount{a} {}
    [[nodiscard]] option_bits cache_key() const noexcept { return {amount}; }
};
struct with_the_same_option : two_lines {
    double amount = 1.0;
    explicit with_the_same_option(double a = 1.0) : amount{a} {}
    [[nodiscard]] option_bits cache_key() const noexcept { return {amount}; }
};
struct other_two_lines : two_lines {};

glyph_settings tolerant(double tolerance) { return {.tolerance = tolerance}; }

/// One context for each way in which a glyph may be another.
std::vector<glyph_context> all_different()
{
    const std::uint64_t font = 0;  // its variation
    no_observer nobody;
    const glyph_settings usual = tolerant(0.01);
    glyph_settings even_odd = usual, non_zero = usual, fewer = usual, shorter = usual;
    even_odd.fill = fill_rule::even_odd;
    non_zero.fill = fill_rule::non_zero;
    fewer.max_pieces = usual.max_pieces - 1;
    shorter.max_points = usual.max_points - 1;
    return {
        context_of(1, font, usual, policies{certified{}, monotone{}, flat{}, nobody}),
        context_of(2, font, usual, policies{certified{}, monotone{}, flat{}, nobody}),
        context_of(1, 7, usual, policies{certified{}, monotone{}, flat{}, nobody}),
        context_of(1, font, tolerant(std::nextafter(0.01, 1.0)), policies{certified{}, monotone{}, flat{}, nobody}),
        context_of(1, font, even_odd, policies{certified{}, monotone{}, flat{}, nobody}),
        context_of(1, font, non_zero, policies{certified{}, monotone{}, flat{}, nobody}),
        context_of(1, font, fewer, policies{certified{}, monotone{}, flat{}, nobody}),
        context_of(1, font, shorter, policies{certified{}, monotone{}, flat{}, nobody}),
        context_of(1, font, usual, policies{two_lines{}, monotone{}, flat{}, nobody}),
        context_of(1, font, usual, policies{certified{}, constrained_delaunay{}, flat{}, nobody}),
        context_of(1, font, usual, policies{certified{}, monotone{}, extruded<>{}, nobody}),
        context_of(1, font, usual, policies{certified{}, monotone{}, extruded<>{.back = false}, nobody}),
        context_of(1, font, usual, policies{certified{}, monotone{}, extruded<averaged_normals>{}, nobody}),
        context_of(1, font, usual, policies{other_two_lines{}, monotone{}, flat{}, nobody}),
        context_of(1, font, usual, policies{with_option{}, monotone{}, flat{}, nobody}),
        context_of(1, font, usual, policies{with_option{2.0}, monotone{}, flat{}, nobody}),
        context_of(1, font, usual, policies{with_the_same_option{}, monotone{}, flat{}, nobody}),
    };
}

}  // namespace

TEST_CASE("contexts are equal when all that a glyph depends on is, and only then", "[glyph][glyph_context]")
{
    const std::vector<glyph_context> all = all_different(), again = all_different();
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t k = 0; k < all.size(); ++k) {
            INFO(i << " and " << k);
            CHECK((all[i] == again[k]) == (i == k));
        }
    }
}

TEST_CASE("equal contexts have one hash, and each of these another", "[glyph][glyph_context]")
{
    std::set<std::uint64_t> hashes;
    const std::vector<glyph_context> all = all_different(), again = all_different();
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(all[i].hash() == again[i].hash());
        hashes.insert(all[i].hash());
    }
    CHECK(hashes.size() == all.size());
}

TEST_CASE("what changes time alone, or writing alone, is no part of a key", "[glyph][glyph_context]")
{
    CHECK(key_of(extruded<>{.depth = 0.5f}) == key_of(extruded<>{.depth = 0.25f}));
    CHECK(key_of(constrained_delaunay{.max_flips = 0}) == key_of(constrained_delaunay{}));
}
