// SPDX-License-Identifier: MIT
//
// The stages, and whole texts from their characters to their vertices. See kernel.hpp.

#include "full_vertex.hpp"
#include "kernel.hpp"
#include "polygons.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/fill/orient.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

using namespace typemesh;
using namespace bench;

template <class Mesher>
std::size_t texts(Mesher&& mesher, const char* file, int times, bool reuse)
{
    const std::string text = first_line(file);
    std::vector<full_vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < times + 2; ++i)
        if (!mesher.build(text, into(vertices, indices), {.reuse = reuse})) std::abort();
    return 1;
}

std::size_t extruded_text(const char* file, int times, bool reuse, const char* font_file = sans)
{
    auto font = open_font(font_file);
    return texts(text_mesher{font}, file, times, reuse);
}

/// A text again and again, its letters in a cache.
std::size_t warm(const char* file, int times)
{
    auto font = open_font(sans);
    glyph_cache cache;
    return texts(text_mesher{font}.with(cached_in{cache, 1}), file, times, true);
}

std::size_t flat_hello(int times)
{
    auto font = open_font(sans);
    return texts(text_mesher{font}.with(flat{}), "phrases-latin.txt", times, false);
}

/// Shaping and outlines of "Hello world!", the floor under it.
std::size_t hello_floor(int times)
{
    auto font = open_font(sans);
    const std::string text = first_line("phrases-latin.txt");
    glyph_run run;
    plain_layout layout;
    ignore_outline sink;
    for (int i = 0; i < times + 2; ++i) {
        if (!layout(font, text, {}, {}, run)) std::abort();
        for (const placed_glyph& g : run.glyphs)
            if (font.outline(g.id, sink)) std::abort();
    }
    return 1;
}

/// Proof and triangles of the glyphs whose contours do not meet.
template <class Triangulator>
std::size_t proofs(const char* file, double tolerance, int times)
{
    std::vector<contours> loops;
    workspace space;
    triangle_list out;
    std::size_t points = 0;
    for (const auto& p : bench::glyphs_of(file, tolerance, 400)) {
        contours c = bench::contours_of(p);
        orient(c);
        out.clear();
        if (!monotone{}.prove(c, space, out)) continue;
        points += c.points.size();
        loops.push_back(std::move(c));
    }
    for (int i = 0; i < times; ++i)
        for (const contours& c : loops) {
            out.clear();
            if (!Triangulator{}.prove(c, space, out)) std::abort();
        }
    return points;
}

/// Letters of a font of which four in ten cross themselves, as a flat text: U+00C0 to U+024F, marks of division left out.
std::size_t crossing(int times)
{
    const variation weight[] = {{"wght", 637.5f}};
    auto font = open_font("truetype/inter-vf/Inter-roman.var.ttf", {.variations = weight});
    std::u16string text;
    for (char16_t c = 0xC0; c < 0x250; ++c)
        if (c != 0xD7 && c != 0xF7) text += c;
    auto mesher = text_mesher{font}.with(flat{});
    std::vector<full_vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < times; ++i)
        if (!mesher.build(text, into(vertices, indices), {.reuse = false})) std::abort();
    return text.size();
}

template <class Curve>
std::size_t chords(const char* file, int times)
{
    auto font = open_font(file);
    std::vector<Curve> curves;
    outline drawn;
    for (std::uint32_t g = 0; g < 0xFFFF && record(font, g, drawn).has_value(); ++g)
        for (const curve& c : drawn.curves)
            if constexpr (sizeof(Curve) == sizeof(quadratic)) {
                if (c.degree == 2) curves.push_back({c.p[0], c.p[1], c.p[2]});
            } else {
                if (c.degree == 3) curves.push_back({c.p[0], c.p[1], c.p[2], c.p[3]});
            }
    std::vector<point> room(std::size_t{1} << 21);
    const double tolerance = quality::high * font.units_per_em();
    for (int i = 0; i < times; ++i) {
        point* next = room.data();
        for (const Curve& each : curves) certified{}(each, tolerance, [&next](point p, double) { *next++ = p; });
        if (next == room.data()) std::abort();
    }
    return curves.size();
}

constexpr kernel kernels[] = {
    {"hello", "text", "\"Hello world!\" extruded, nothing kept, every letter built anew, Liberation Sans, 1/800 em",
     [](int n) { return extruded_text("phrases-latin.txt", n, false); }},
    {"hello_flat", "text", "the same, flat", flat_hello},
    {"hello_floor", "text", "its shaping and outlines alone", hello_floor},
    {"hello_warm", "text", "the same, extruded, glyphs in a glyph_cache",
     [](int n) { return warm("phrases-latin.txt", n); }},
    {"hello_cubic", "text", "the same, every letter built anew, Comic Neue, whose curves are cubic",
     [](int n) { return extruded_text("phrases-latin.txt", n, false, comic); }},
    {"lorem", "text", "lorem ipsum, extruded, repeated letters built once",
     [](int n) { return extruded_text("long-latin.txt", n, true); }},
    {"lorem_warm", "text", "the same, glyphs in a glyph_cache", [](int n) { return warm("long-latin.txt", n); }},
    {"monotone_60", "point", "monotone with its proof, Liberation Sans, about 60 points a glyph",
     [](int n) { return proofs<monotone>(sans, 1.5, n); }},
    {"monotone_200", "point", "the same, about 200", [](int n) { return proofs<monotone>(sans, 0.06, n); }},
    {"monotone_mplus", "point", "the same, M+ 1", [](int n) { return proofs<monotone>(mplus, 0.1, n); }},
    {"delaunay_60", "point", "constrained_delaunay with its proof, Liberation Sans, about 60 points a glyph",
     [](int n) { return proofs<constrained_delaunay>(sans, 1.5, n); }},
    {"delaunay_200", "point", "the same, about 200", [](int n) { return proofs<constrained_delaunay>(sans, 0.06, n); }},
    {"delaunay_mplus", "point", "the same, M+ 1", [](int n) { return proofs<constrained_delaunay>(mplus, 0.1, n); }},
    {"crossing", "glyph",
     "Inter variable, weight 637.5, a flat text of Latin letters with accents: four in ten cross themselves", crossing},
    {"quadratics", "curve", "certified, 1/800 em, Liberation Sans", [](int n) { return chords<quadratic>(sans, n); }},
    {"cubics", "curve", "certified, 1/800 em, Comic Neue", [](int n) { return chords<cubic>(comic, n); }},
};

}  // namespace

int main(int argc, char** argv) { return run_one_of(kernels, argc, argv); }
