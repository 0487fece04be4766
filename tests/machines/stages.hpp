// SPDX-License-Identifier: MIT
#pragma once

// One hash for each stage of the library, of what it makes of letters.txt and of texts.

#include "letters.hpp"

#include "support/toy_shaper.hpp"

#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/twist.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/discretise/adaptive_subdivision.hpp>
#include <typemesh/discretise/thesis_quality.hpp>
#include <typemesh/discretise/two_lines.hpp>
#include <typemesh/extrude/bent.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/carved.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/extrude/flat_curved.hpp>
#include <typemesh/extrude/inflated.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/refined.hpp>
#include <typemesh/extrude/tubed.hpp>
#include <typemesh/outline/stroked.hpp>
#include <typemesh/outline/svg_path.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/total_fit.hpp>
#include <typemesh/plate/name_plate.hpp>
#include <typemesh/refine/non_obtuse.hpp>
#include <typemesh/refine/quadtree_refined.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <string>
#include <vector>

namespace machines {

/// From  G. Fowler, L. C. Noll, K.-P. Vo, FNV-1a: of numbers, byte by byte, the lowest first, on every machine.
class hash {
public:
    void add(std::uint64_t value, int bytes = 8) noexcept
    {
        for (int i = 0; i < bytes; ++i) state_ = (state_ ^ (value >> (8 * i) & 0xFF)) * 0x0000'0100'0000'01B3u;
        ++count_;
    }
    void add(typemesh::grid_point p) noexcept
    {
        add(static_cast<std::uint32_t>(p.x), 4);
        add(static_cast<std::uint32_t>(p.y), 4);
    }
    void add(float value) noexcept
    {
        std::uint32_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        add(bits, 4);
    }
    void add(double value) noexcept
    {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        add(bits);
    }

    [[nodiscard]] std::uint64_t value() const noexcept { return state_; }
    [[nodiscard]] std::size_t count() const noexcept { return count_; }  ///< of numbers

private:
    std::uint64_t state_ = 0xCBF2'9CE4'8422'2325u;
    std::size_t count_ = 0;
};

struct stage_hash {
    std::string stage;
    std::size_t numbers = 0;
    std::uint64_t value = 0;
};

struct vertex {
    typemesh::vec3 position, normal;
    typemesh::vec2 uv;
    typemesh::vec4 tangent;
    std::uint32_t cluster = 0;
    std::uint32_t part = 0;
};

}  // namespace machines

template <>
struct typemesh::vertex_traits<machines::vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv | attribute::tangent |
                                  attribute::cluster | attribute::part;
    machines::vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position, s.normal, s.uv, s.tangent, s.cluster, static_cast<std::uint32_t>(s.part)};
    }
};

namespace machines {

using faces = std::vector<std::unique_ptr<face>>;

inline typemesh::outline curves_of(const face& f, typemesh::glyph_id letter)
{
    typemesh::outline curves;
    typemesh::outline_recorder recorder{curves};
    if (f.letters.outline(letter, recorder) || recorder.finish()) stop("a letter cannot be read back");
    return curves;
}

/// Calls of(face, curves, grid, contours) for each letter, with its curves flattened to 1/quality em.
template <class Discretiser, class F>
void each_letter(const faces& all, const Discretiser& how, double quality, const F& of)
{
    typemesh::contours flattened;
    for (const auto& f : all) {
        const double em = f->letters.units_per_em();
        for (typemesh::glyph_id g = 0; g < f->letters.size(); ++g) {
            const typemesh::outline curves = curves_of(*f, g);
            const auto cells = typemesh::grid::fitting(em, curves.bounds);
            if (!cells || !typemesh::discretise(curves, how, em / quality, *cells, flattened))
                stop("a letter is not flattened");
            of(*f, curves, *cells, flattened);
        }
    }
}

/// The points, and where each is on its curve.
template <class Discretiser>
void hash_curves(hash& h, const faces& all, const Discretiser& how, double quality)
{
    each_letter(all, how, quality, [&h](const auto&, const auto&, const auto&, const typemesh::contours& c) {
        for (const typemesh::grid_point p : c.points) h.add(p);
        for (const typemesh::contour_edge& e : c.edges) h.add(e.t0), h.add(e.t1);
        for (const std::uint32_t s : c.starts) h.add(s, 4);
    });
}

inline void hash_region(hash& h, const typemesh::region& r)
{
    for (const typemesh::grid_point p : r.points()) h.add(p);
    for (const std::uint32_t s : r.starts()) h.add(s, 4);
}

/// Regions and triangles of polygons of integers: the letters' control points, whose polygons cross often.
template <class Triangulator>
void hash_grid(hash& h, const faces& all, typemesh::fill_rule rule, const Triangulator& how)
{
    typemesh::cap_builder caps;
    for (const auto& f : all)
        for (typemesh::glyph_id g = 0; g < f->letters.size(); ++g) {
            const typemesh::outline curves = curves_of(*f, g);
            typemesh::contours& loops = caps.loops();
            loops.clear();
            for (std::uint32_t k = 0; k < curves.contour_count(); ++k) {
                if (k == 0 && !loops.starts.push_back(0)) stop("out of memory");
                for (std::uint32_t i = curves.starts[k]; i < curves.starts[k + 1]; ++i) {
                    const typemesh::curve& c = curves.curves[i];
                    for (std::uint32_t corner = 0; corner < c.degree; ++corner) {
                        const typemesh::grid_point p{static_cast<std::int32_t>(c.p[corner].x * 2.0),
                                                     static_cast<std::int32_t>(c.p[corner].y * 2.0)};
                        if (loops.points.size() > loops.starts.back() && loops.points.back() == p) continue;
                        if (!loops.points.push_back(p) || !loops.edges.push_back({i, 0.0f, 1.0f}))
                            stop("out of memory");
                    }
                }
                if (!loops.starts.push_back(static_cast<std::uint32_t>(loops.points.size()))) stop("out of memory");
            }
            const auto filled = caps.fill({rule}, how);
            if (!filled) stop(std::string{"a polygon is refused: "} + filled.error().message());
            hash_region(h, *filled);
            for (const typemesh::triangle& t : caps.triangles()) h.add(t.a, 4), h.add(t.b, 4), h.add(t.c, 4);
        }
}

/// All letters of a face in a row, which overlap a little.
inline typemesh::glyph_run row_of(const face& f)
{
    typemesh::glyph_run run;
    for (typemesh::glyph_id g = 0; g < f.letters.size(); ++g)
        if (!run.glyphs.push_back({g, g, {0.55 * f.letters.units_per_em() * g, 0.0}})) stop("out of memory");
    return run;
}

/// The cubics of elliptical arcs, at several tolerances.
inline void hash_arcs(hash& h)
{
    struct pen {
        hash& h;
        void add(typemesh::point p) const noexcept { h.add(p.x), h.add(p.y); }
        void move(typemesh::point) const noexcept {}
        void line(typemesh::point p) const noexcept { add(p); }
        void quadratic(typemesh::point c, typemesh::point p) const noexcept { add(c), add(p); }
        void cubic(typemesh::point a, typemesh::point b, typemesh::point p) const noexcept { add(a), add(b), add(p); }
        void close() const noexcept {}
    } to{h};
    for (int turn = 0; turn < 360; turn += 7)
        for (int flags = 0; flags < 4; ++flags)
            for (const double tolerance : {1e-2, 1e-5}) {
                const std::string data = "M1 2A" + std::to_string(3 + turn % 40) + " 5 " + std::to_string(turn) + " " +
                                         std::to_string(flags % 2) + " " + std::to_string(flags / 2) + " 7." +
                                         std::to_string(turn) + " 1.5";
                if (!typemesh::draw_svg_path(data, tolerance, to)) stop("an arc is refused");
            }
}

inline void hash_written(hash& h, const std::vector<vertex>& vertices, const std::vector<std::uint32_t>& indices)
{
    for (const vertex& v : vertices) {
        for (const float x : {v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, v.uv.x,
                              v.uv.y, v.tangent.x, v.tangent.y, v.tangent.z, v.tangent.w})
            h.add(x);
        h.add(v.cluster, 4), h.add(v.part, 4);
    }
    for (const std::uint32_t i : indices) h.add(i, 4);
}

/// Every written number.
template <class Policy>
void hash_mesh(hash& h, const faces& all, const Policy& policy, const typemesh::text_options& how = {})
{
    for (const auto& f : all) {
        const typemesh::glyph_run run = row_of(*f);
        std::vector<vertex> vertices;
        std::vector<std::uint32_t> indices;
        auto mesher = typemesh::text_mesher{f->letters}.with(policy);
        if (auto made = mesher.build(run, typemesh::into(vertices, indices), how); !made)
            stop(std::string{"a mesh is refused: "} + made.error().message());
        hash_written(h, vertices, indices);
    }
}

/// Every written number of plates with the letters.
inline void hash_plates(hash& h, const faces& all, const typemesh::plate_options& how)
{
    typemesh::name_plate plate;
    for (const auto& f : all) {
        auto mesher = typemesh::text_mesher{f->letters};
        const typemesh::glyph_run run = row_of(*f);
        const auto text = mesher.plan(run, {});
        if (!text) stop("letters are not planned");
        if (const auto made = plate.plan(*text, how, typemesh::monotone{}); !made)
            stop(std::string{"a plate is refused: "} + made.error().message());
        for (std::size_t k = 0; k < plate.solid_count(); ++k) {
            std::vector<vertex> vertices;
            std::vector<std::uint32_t> indices;
            if (!plate.write(k, typemesh::into(vertices, indices))) stop("a plate is not written");
            hash_written(h, vertices, indices);
        }
    }
}

/// Directions mixed and nested, marks, several scripts, all kinds of line ends; and whatever random bytes read as.
inline std::vector<std::string> texts()
{
    std::vector<std::string> all = {
        "The quick brown fox (\xD7\x90\xD7\x91\xD7\x92 12-34) jumps over 5,678.90 lazy dogs\xE2\x80\xA6 and a "
        "co\xC2\xADop.",
        "\xD8\xA7\xD9\x84\xD8\xB9\xD8\xB1\xD8\xA8\xD9\x8A\xD8\xA9 ABC [\xD9\xA1\xD9\xA2] "
        "def\n\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D! x\tAV fi\r\nlast",
        "\xE2\x81\xA7"
        "a\xE2\x80\xAE"
        "bc\xE2\x80\xAC \xE2\x81\xA6\xD7\x90\xE2\x81\xA9 d\xE2\x81\xA9 \xE2\x80\xAB"
        "12\xE2\x80\xAC",
        "\xE6\x97\xA5\xE6\x9C\xAC\xE8\xAA\x9E\xE3\x81\xAE\xE3\x80\x8C\xE6\x96\x87\xE7\xAB\xA0\xE3\x80\x8D\xE3\x80\x82"
        "\xE4\xB8\xAD\xE6\x96\x87\xEF\xBC\x8C"
        "\xED\x95\x9C\xEA\xB5\xAD\xEC\x96\xB4",
        "\xE0\xA4\xB9\xE0\xA4\xBF\xE0\xA4\xA8\xE0\xA5\x8D\xE0\xA4\xA6\xE0\xA5\x80 "
        "\xE0\xB8\xA0\xE0\xB8\xB2\xE0\xB8\xA9\xE0\xB8\xB2 "
        "\xF0\x9F\x91\xA9\xE2\x80\x8D\xF0\x9F\x91\xA9\xE2\x80\x8D\xF0\x9F\x91\xA7 "
        "\xF0\x9F\x87\xA7\xF0\x9F\x87\xAA\xF0\x9F\x87\xA9\xF0\x9F\x87\xAA e\xCC\x81",
    };
    const char* const words[] = {"in",     "a",   "paragraph", "lines",     "of", "sensible",
                                 "widths", "are", "chosen",    "to-gether", "or", "apart"};
    std::uint64_t dice = 1;
    for (std::uint32_t i = 0; i < 120; ++i)
        all.back() += std::string(" ") + words[(dice = dice * 48271 % 2147483647) % std::size(words)];
    for (int i = 0; i < 200; ++i) {
        std::string text;
        for (int n = 0; n < 60; ++n) {
            dice = dice * 6364136223846793005u + 1442695040888963407u;
            text += static_cast<char>(dice >> 56);
        }
        all.push_back(text);
    }
    return all;
}

inline void hash_analysis(hash& h)
{
    typemesh::unicode_analyser analyser;
    typemesh::text_analysis found;
    for (const std::string& text : texts()) {
        if (analyser.analyse(text, {}, found)) stop("a text is refused");
        for (const std::uint8_t level : found.levels) h.add(level, 1);
        for (const typemesh::text_mark marks : found.marks) h.add(static_cast<std::uint64_t>(marks), 4);
        for (const auto& run : found.scripts) h.add(run.first, 4);
    }
}

/// Line ends and the places of glyphs, at several widths.
template <class Breaker>
void hash_lines(hash& h, const typemesh::layout_options& how, const Breaker& breaker)
{
    test::toy_shaper font;
    typemesh::paragraph<test::toy_shaper, typemesh::unicode_analyser, Breaker> words{
        font, typemesh::heap(), typemesh::unicode_analyser{}, breaker};
    typemesh::glyph_run run;
    for (std::string text : texts()) {
        for (char& c : text)
            if (c == '!') c = '?';  // which the toy font refuses
        if (!words.set(text)) stop("a text is not set");
        for (const double width : {3.0, 7.5, 20.0}) {
            typemesh::layout_options options = how;
            options.width = width;
            if (!words.lay_out(options, run)) stop("a text is not laid out");
            for (const typemesh::laid_line& line : words.lines()) h.add(line.first, 4), h.add(line.last, 4);
            for (const typemesh::placed_glyph& g : run.glyphs) h.add(g.id, 4), h.add(g.origin.x), h.add(g.origin.y);
        }
    }
}

inline std::vector<stage_hash> hash_stages(const faces& all)
{
    using namespace typemesh;
    std::vector<stage_hash> made;
    const auto stage = [&made](const char* name, const std::function<void(hash&)>& fill) {
        hash h;
        fill(h);
        made.push_back({name, h.count(), h.value()});
    };
    stage("curves: certified, 1/160 em", [&](hash& h) { hash_curves(h, all, certified{}, 160.0); });
    stage("curves: certified, 1/800 em", [&](hash& h) { hash_curves(h, all, certified{}, 800.0); });
    stage("curves: certified, 1/16000 em", [&](hash& h) { hash_curves(h, all, certified{}, 16000.0); });
    stage("curves: two_lines", [&](hash& h) { hash_curves(h, all, two_lines{}, 160.0); });
    stage("curves: adaptive_subdivision",
          [&](hash& h) { hash_curves(h, all, adaptive_subdivision{.distance = 2.0}, 160.0); });
    stage("curves: thesis_quality",
          [&](hash& h) { hash_curves(h, all, thesis_quality{thesis_quality::high, 1000.0}, 160.0); });
    for (const fill_rule rule : {fill_rule::non_zero, fill_rule::even_odd}) {
        const bool even = rule == fill_rule::even_odd;
        stage(even ? "grid: monotone, even-odd" : "grid: monotone",
              [&](hash& h) { hash_grid(h, all, rule, monotone{}); });
        stage(even ? "grid: constrained_delaunay, even-odd" : "grid: constrained_delaunay",
              [&](hash& h) { hash_grid(h, all, rule, constrained_delaunay{}); });
    }
    stage("curves: arcs of svg", [](hash& h) { hash_arcs(h); });
    stage("mesh: flat", [&](hash& h) { hash_mesh(h, all, flat{}); });
    stage("mesh: extruded", [&](hash& h) { hash_mesh(h, all, extruded<>{}); });
    stage("mesh: extruded, merged", [&](hash& h) { hash_mesh(h, all, extruded<>{}, {.merge = true}); });
    stage("mesh: constrained_delaunay", [&](hash& h) { hash_mesh(h, all, constrained_delaunay{}); });
    stage("mesh: bevelled, chamfer", [&](hash& h) { hash_mesh(h, all, bevelled{.depth = 0.2f}); });
    stage("mesh: bevelled, round",
          [&](hash& h) { hash_mesh(h, all, bevelled{.depth = 0.2f, .width = 0.05f, .profile = round_profile()}); });
    stage("mesh: emboldened", [&](hash& h) { hash_mesh(h, all, embolden{.by = 0.02f}); });
    stage("mesh: outlined", [&](hash& h) { hash_mesh(h, all, outlined<>{}); });
    stage("mesh: refined, delaunay", [&](hash& h) { hash_mesh(h, all, refined<>{.how = {.max_edge = 0.1f}}); });
    stage("mesh: refined, quadtree",
          [&](hash& h) { hash_mesh(h, all, refined<extruded<>, quadtree_refined>{.how = {.max_edge = 0.1f}}); });
    stage("mesh: refined, non_obtuse",
          [&](hash& h) { hash_mesh(h, all, refined<extruded<>, non_obtuse>{.how = {.max_edge = 0.1f}}); });
    stage("mesh: bent, cylinder", [&](hash& h) { hash_mesh(h, all, bent<on_cylinder>{.how = {50.0}}); });
    stage("mesh: bent, twisted bevels", [&](hash& h) { hash_mesh(h, all, bent<twist, bevelled>{.how = {5.0}}); });
    stage("mesh: warped, arc", [&](hash& h) { hash_mesh(h, all, warped{arc{.degrees = 90.0}}); });
    stage("mesh: carved", [&](hash& h) { hash_mesh(h, all, carved{}); });
    stage("mesh: inflated", [&](hash& h) { hash_mesh(h, all, inflated{.edge = 0.1f}); });
    stage("mesh: stroked", [&](hash& h) {
        hash_mesh(h, all, stroked{{.width = 0.03, .cap = stroke_cap::round, .join = stroke_join::round}});
    });
    stage("mesh: flat_curved", [&](hash& h) { hash_mesh(h, all, flat_curved{}); });
    stage("mesh: tubed", [&](hash& h) { hash_mesh(h, all, tubed{}); });
    stage("mesh: plate, inlay", [&](hash& h) { hash_plates(h, all, {.style = plate_style::inlay}); });
    stage("mesh: plate, stencil",
          [&](hash& h) { hash_plates(h, all, {.style = plate_style::cut, .bridge_width = 0.05f}); });
    stage("text: levels, graphemes, breaks, scripts", [](hash& h) { hash_analysis(h); });
    stage("text: lines, first_fit", [](hash& h) { hash_lines(h, {}, first_fit{}); });
    stage("text: lines, first_fit, justified",
          [](hash& h) { hash_lines(h, {.align = alignment::justify}, first_fit{}); });
    stage("text: lines, total_fit", [](hash& h) { hash_lines(h, {.align = alignment::justify}, total_fit{}); });
    return made;
}

}  // namespace machines
