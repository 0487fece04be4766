// SPDX-License-Identifier: MIT

#include <typemesh/discretise/certified.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/glyph/glyph_builder.hpp>
#include <typemesh/glyph/impl/glyph_store.hpp>
#include <typemesh/text/impl/split_glyphs.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/toy_font.hpp"

#include <array>
#include <vector>

using namespace typemesh;

namespace {

/// A mesh as a sink gets it: places and normals, and triangles of them.
struct collected {
    static constexpr attribute wants = attribute::position | attribute::normal;
    using corner = std::array<float, 6>;

    std::vector<corner> vertices;
    std::vector<std::array<std::uint32_t, 3>> triangles;

    error begin(mesh_size) noexcept { return {}; }
    void vertex(const surface_point<wants>& v) noexcept
    {
        vertices.push_back({v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z});
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept { triangles.push_back({a, b, c}); }
    void end() noexcept {}

    /// Corner by corner, in the order of the triangles.
    [[nodiscard]] std::vector<corner> corners() const
    {
        std::vector<corner> all;
        for (const auto& t : triangles)
            for (const std::uint32_t v : t) all.push_back(vertices.at(v));
        return all;
    }
};

/// Toy glyphs, built once.
template <class Extruder>
struct glyphs {
    Extruder how;
    glyph_builder builder;
    glyph_store store{heap()};
    no_observer nobody;
    test::toy_font font;

    const built_glyph& operator[](char c)
    {
        const auto draft = builder.build(font, test::toy_font::glyph_of(static_cast<unsigned char>(c)),
                                         {.tolerance = 0.001}, policies{certified{}, monotone{}, how, nobody});
        REQUIRE(draft);
        const built_glyph* kept = store.keep(*draft);
        REQUIRE(kept != nullptr);
        REQUIRE_FALSE(kept->form().points.empty());
        return *kept;
    }
};

template <class Extruder>
collected whole(const built_glyph& g, const Extruder& how, const placement& at, bool turned)
{
    collected m;
    for (const part p : parts_of<Extruder>) write_vertices(p, g.planned<Extruder>(), how, at, m);
    for (const part p : parts_of<Extruder>)
        write_triangles(p, g.planned<Extruder>(), how, g.sizes().vertices.starts(), turned, m);
    return m;
}

template <class Extruder>
void check_pieces(char c, bool turned)
{
    glyphs<Extruder> all;
    const built_glyph& g = all[c];
    placement at;
    at.unit_per_cell = 1.0 / 512.0;
    const collected mesh = whole(g, all.how, at, turned);
    const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const std::uint32_t most : {3u, 4u, 5u, 7u, 20u, n / 2, n - 1, n, n + 1, 65'535u}) {
        if (most < 3) continue;
        INFO("glyph " << c << " of " << n << " vertices in pieces of " << most);
        split_glyphs split{heap()};
        REQUIRE_FALSE(split.split(g, all.how, turned, most));
        std::vector<collected::corner> corners;
        for (std::uint32_t k = 0; k < split.size(); ++k) {
            collected piece;
            split.write(k, g, all.how, at, piece);
            const auto told = split.sizes(k).total();
            CHECK(piece.vertices.size() == told.vertices);
            CHECK(piece.triangles.size() == told.triangles);
            CHECK(piece.vertices.size() <= most);
            CHECK_FALSE(piece.triangles.empty());
            std::vector<bool> used(piece.vertices.size());
            for (const auto& t : piece.triangles)
                for (const std::uint32_t v : t) used.at(v) = true;
            CHECK(std::vector<bool>(piece.vertices.size(), true) == used);
            const auto more = piece.corners();
            corners.insert(corners.end(), more.begin(), more.end());
        }
        CHECK((corners == mesh.corners()));  // the extruder's own triangles, in its own order
        if (most >= n) CHECK(split.size() == 1);
        if (most < n) CHECK(split.size() > 1);
    }
}

}  // namespace

TEST_CASE("pieces have the triangles of the whole, in its order, and no more vertices than they may",
          "[text][split_glyphs]")
{
    for (const char c : {'o', 'E', 'x', 'i'}) {
        for (const bool turned : {false, true}) {
            check_pieces<extruded<>>(c, turned);
            check_pieces<flat>(c, turned);
        }
    }
}

TEST_CASE("pieces of several glyphs follow one another until they are cleared", "[text][split_glyphs]")
{
    glyphs<extruded<>> all;
    const built_glyph &o = all['o'], &e = all['E'];
    split_glyphs alone{heap()}, both{heap()};
    REQUIRE_FALSE(alone.split(e, all.how, false, 10));
    REQUIRE_FALSE(both.split(o, all.how, false, 10));
    const std::uint32_t first = both.size();
    REQUIRE_FALSE(both.split(e, all.how, false, 10));
    REQUIRE(both.size() == first + alone.size());
    for (std::uint32_t k = 0; k < alone.size(); ++k) {
        collected a, b;
        alone.write(k, e, all.how, {}, a);
        both.write(first + k, e, all.how, {}, b);
        CHECK((a.vertices == b.vertices));
        CHECK((a.triangles == b.triangles));
    }
    both.clear();
    CHECK(both.size() == 0);
}

TEST_CASE("splitting reports a memory that gives nothing", "[text][split_glyphs]")
{
    glyphs<extruded<>> all;
    const built_glyph& g = all['o'];
    std::size_t failed = 0;
    for (std::size_t at = 1;; ++at) {
        test::counting_memory failing{.fail_at = at};
        error e;
        {
            split_glyphs split{failing.source()};
            e = split.split(g, all.how, false, 10);
        }
        CHECK(failing.bytes_held == 0);
        if (!e) break;
        REQUIRE(e == error::out_of_memory);
        ++failed;
    }
    CHECK(failed >= 4);
}
