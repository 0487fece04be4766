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

template <int Number>
struct with_option : two_lines {
    double amount = 1.0;
    explicit with_option(double a = 1.0) : amount{a} {}
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
    glyph_settings parted = usual;
    parted.corners = touching::part;
    glyph_settings joined = parted, coarser = parted;
    joined.corners = touching::join;
    coarser.max_cells = 0x1p20;
    const auto of = [&](const glyph_settings& settings, const auto& flatten, const auto& raise) {
        return context_of(1, font, settings, policies{flatten, monotone{}, raise, nobody}, 1.0);
    };
    return {
        of(usual, certified{}, flat{}),
        context_of(2, font, usual, policies{certified{}, monotone{}, flat{}, nobody}, 1.0),
        context_of(1, 7, usual, policies{certified{}, monotone{}, flat{}, nobody}, 1.0),
        context_of(1, font, usual, policies{certified{}, constrained_delaunay{}, flat{}, nobody}, 1.0),
        of(tolerant(std::nextafter(0.01, 1.0)), certified{}, flat{}),
        of(even_odd, certified{}, flat{}),
        of(non_zero, certified{}, flat{}),
        of(fewer, certified{}, flat{}),
        of(shorter, certified{}, flat{}),
        of(parted, certified{}, flat{}),
        of(joined, certified{}, flat{}),
        of(coarser, certified{}, flat{}),
        context_of(1, font, parted, policies{certified{}, monotone{}, flat{}, nobody}, 0.5),
        of(usual, two_lines{}, flat{}),
        of(usual, other_two_lines{}, flat{}),
        of(usual, with_option<1>{}, flat{}),
        of(usual, with_option<1>{2.0}, flat{}),
        of(usual, with_option<2>{}, flat{}),
        of(usual, certified{}, extruded<>{}),
        of(usual, certified{}, extruded<>{.back = false}),
        of(usual, certified{}, extruded<averaged_normals>{}),
    };
}

}  // namespace

TEST_CASE("contexts are equal exactly if all that a glyph depends on is equal", "[glyph][glyph_context]")
{
    const std::vector<glyph_context> all = all_different(), again = all_different();
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = 0; k < all.size(); ++k) {
            INFO(i << " and " << k);
            CHECK((all[i] == again[k]) == (i == k));
        }
}

TEST_CASE("equal contexts have equal hashes, and all the others have different ones", "[glyph][glyph_context]")
{
    std::set<std::uint64_t> hashes;
    const std::vector<glyph_context> all = all_different(), again = all_different();
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(all[i].hash() == again[i].hash());
        hashes.insert(all[i].hash());
    }
    CHECK(hashes.size() == all.size());
}

TEST_CASE("options that change only the time or the writing are not part of a key", "[glyph][glyph_context]")
{
    CHECK(key_of(extruded<>{.depth = 0.5f}) == key_of(extruded<>{.depth = 0.25f}));
    CHECK(key_of(constrained_delaunay{.max_flips = 0}) == key_of(constrained_delaunay{}));
    no_observer nobody;
    const policies with{certified{}, monotone{}, flat{}, nobody};
    const glyph_settings as_drawn = tolerant(0.01);
    CHECK(context_of(1, 0, as_drawn, with, 0.5) == context_of(1, 0, as_drawn, with, 1.0));
}
