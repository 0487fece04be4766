// SPDX-License-Identifier: MIT
//
// Triangulation alone, over the glyphs of whole fonts: typemesh, GLU's tessellator, CGAL's constrained Delaunay triangulation (GPL),
// and Clipper, which cuts crossing contours to simple ones and does not triangulate.
//
//     triangulators POLYGONS [quick]    prints a row "cut" for each (see ../README.md)
//
// std::sort, of the same points packed into 64-bit keys, is the floor. Each time is the least of some passes, of the processor.
// "wrong" counts glyphs whose triangles cover another area than typemesh's region, which the tests hold against exact
// arithmetic, by more than 1e-5. POLYGONS is written for triangulators.mjs.

#include "polygons.hpp"

#include "peers.hpp"  // after polygons.hpp, whose names it uses

#include <typemesh/fill/orient.hpp>
#include <typemesh/glyph/cap_builder.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include <clipper.hpp>

#include <cstdio>
#include <ctime>
#include <functional>
#include <memory>

namespace {

using namespace typemesh;

struct glyph {
    bench::polygon polygon;  ///< as the font draws it
    contours loops;          ///< the same, oriented where it is simple
    double area = 0;         ///< of what is filled, in cells
};

struct set {
    std::string font, tolerance;
    std::vector<glyph> glyphs;
    double points = 0;
};

int passes = 5;

double area_of(std::span<const grid_point> points, const triangle_list& triangles)
{
    double twice = 0;
    for (const auto& t : triangles) {
        const grid_point a = points[t.a], b = points[t.b], c = points[t.c];
        twice += std::abs((double(b.x) - a.x) * (double(c.y) - a.y) - (double(b.y) - a.y) * (double(c.x) - a.x));
    }
    return twice / 2;
}

struct font_set {
    const char *name, *file;
    double tolerance, units_per_em;  ///< the tolerance in font units
    unsigned most;                   ///< glyphs
    bool simple;                     ///< those that are simple, or else those that are not
};

set set_of(const font_set& f)
{
    char in_em[32];
    std::snprintf(in_em, sizeof in_em, "%.2g", f.tolerance / f.units_per_em);
    set s{f.name, in_em, {}, 0};
    workspace space;
    triangle_list out;
    cap_builder caps;
    for (bench::polygon& p : bench::glyphs_of(f.file, f.tolerance, f.most)) {
        glyph g;
        g.polygon = std::move(p);
        g.loops = bench::contours_of(g.polygon);
        orient(g.loops);
        out.clear();
        const auto proven = monotone{}.prove(g.loops, space, out);
        if (bool(proven) != f.simple) continue;
        g.area = proven ? area_of(proven->points(), out) : 0;
        if (!proven) {
            g.loops = bench::contours_of(g.polygon);
            caps.loops() = bench::contours_of(g.polygon);
            const auto filled = caps.fill({}, monotone{});
            if (!filled) continue;
            g.area = area_of(filled->points(), caps.triangles());
        }
        s.points += double(g.loops.points.size());
        s.glyphs.push_back(std::move(g));
    }
    return s;
}

double microseconds_a_glyph(const set& s, const std::function<void(const glyph&)>& work)
{
    double best = 1e300;
    for (int pass = 0; pass < passes; ++pass) {
        const std::clock_t start = std::clock();
        for (const glyph& g : s.glyphs) work(g);
        best = std::min(best, 1e6 * double(std::clock() - start) / CLOCKS_PER_SEC);
    }
    return best / double(s.glyphs.size());
}

/// GLU, which also finds where contours cross.
struct glu_of_crossings : bench::glu_run {
    std::vector<std::unique_ptr<std::array<double, 3>>> found;

    glu_of_crossings()
    {
        const auto combine = +[](double* at, void**, float*, void** out, void* self) {
            auto& me = *static_cast<glu_of_crossings*>(static_cast<glu_run*>(self));
            me.places.push_back({at[0], at[1], at[2]});
            *out = reinterpret_cast<void*>(me.places.size() - 1);
        };
        gluTessCallback(tessellator, GLU_TESS_COMBINE_DATA, reinterpret_cast<_GLUfuncptr>(combine));
    }

    void operator()(const contours& c)
    {
        places.reserve(c.points.size() * 4 + 1000);  // GLU keeps pointers to those of its vertices
        glu_run::operator()(c);
    }

    [[nodiscard]] double area() const
    {
        double twice = 0;
        for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
            const auto &a = places[triangles[i]], &b = places[triangles[i + 1]], &c = places[triangles[i + 2]];
            twice += std::abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        }
        return twice / 2;
    }
};

ClipperLib::Paths united(const bench::polygon& p)
{
    ClipperLib::Paths paths, made;
    for (const auto& loop : p) {
        paths.emplace_back();
        for (const grid_point q : loop) paths.back().push_back(ClipperLib::IntPoint(q.x, q.y));
    }
    ClipperLib::SimplifyPolygons(paths, made, ClipperLib::pftNonZero);
    return made;
}

double area_of(const ClipperLib::Paths& paths)
{
    double sum = 0;
    for (const ClipperLib::Path& p : paths) sum += ClipperLib::Area(p);
    return std::abs(sum);
}

void measure(const set& s, bool simple)
{
    std::vector<std::uint64_t> keys;
    const auto row = [&](const char* peer, const std::function<void(const glyph&)>& work,
                         const std::function<double()>& area) {
        std::string wrong = "-";
        if (area) {
            std::size_t found = 0;
            for (const glyph& g : s.glyphs) {
                work(g);
                found += std::abs(area() - g.area) > 1e-5 * g.area;
            }
            wrong = std::to_string(found);
        }
        std::printf("cut\t%s\t%s\t%s\t%.1f\t%.3f\t%s\tnative\n", peer, s.font.c_str(), s.tolerance.c_str(),
                    s.points / double(s.glyphs.size()), microseconds_a_glyph(s, work), wrong.c_str());
        std::fflush(stdout);
    };
    const auto sort = [&](const glyph& g) {
        keys.clear();
        for (const grid_point p : g.loops.points)
            keys.push_back(std::uint64_t(std::uint32_t(p.x) ^ 0x8000'0000u) << 32 |
                           (std::uint32_t(p.y) ^ 0x8000'0000u));
        std::sort(keys.begin(), keys.end());
    };
    row("floor: std::sort", sort, {});
    workspace space;
    triangle_list out;
    region made;
    const auto area = [&] { return area_of(made.points(), out); };
    const auto proving = [&](const auto& triangulate) {
        return [&](const glyph& g) {
            out.clear();
            made = *triangulate.prove(g.loops, space, out);
        };
    };
    cap_builder caps;
    const monotone sweep;
    const constrained_delaunay delaunay;
    const auto filling = [&](const auto& triangulate) {
        return [&](const glyph& g) {
            caps.loops().clear();
            (void)caps.loops().points.append(g.loops.points.view());
            (void)caps.loops().edges.append(g.loops.edges.view());
            (void)caps.loops().starts.append(g.loops.starts.view());
            made = *caps.fill({}, triangulate);
        };
    };
    const auto filled = [&] { return area_of(made.points(), caps.triangles()); };
    glu_of_crossings glu;
    if (simple) {
        row("typemesh, monotone", proving(sweep), area);
        row("typemesh, constrained_delaunay", proving(delaunay), area);
    } else {
        row("typemesh, monotone", filling(sweep), filled);
        row("typemesh, constrained_delaunay", filling(delaunay), filled);
    }
    row("GLU", [&](const glyph& g) { glu(g.loops); }, [&] { return glu.area(); });
    if (simple) row("CGAL", [](const glyph& g) { bench::cgal(g.loops); }, {});
    ClipperLib::Paths paths;
    row("Clipper, no triangles", [&](const glyph& g) { paths = united(g.polygon); }, [&] { return area_of(paths); });
}

/// For each glyph a line of JSON: font, tolerance, the area of what is filled, the loops as the font draws them, and whether they
/// are simple.
void dump(std::FILE* to, const set& s, bool simple)
{
    const auto write = [&](std::span<const grid_point> loop) {
        std::fputc('[', to);
        for (std::size_t i = 0; i < loop.size(); ++i)
            std::fprintf(to, "%s%d,%d", i > 0 ? "," : "", loop[i].x, loop[i].y);
        std::fputc(']', to);
    };
    for (const glyph& g : s.glyphs) {
        std::fprintf(to, "{\"font\":\"%s\",\"tolerance\":\"%s\",\"area\":%.17g,\"loops\":[", s.font.c_str(),
                     s.tolerance.c_str(), g.area);
        for (std::uint32_t l = 0; l < g.loops.contour_count(); ++l) {
            if (l > 0) std::fputc(',', to);
            write(g.loops.points.view().subspan(g.loops.starts[l], g.loops.starts[l + 1] - g.loops.starts[l]));
        }
        std::fprintf(to, "],\"simple\":%s}\n", simple ? "true" : "false");
    }
}

}  // namespace

int main(int argc, char** argv)
{
    const font_set sets[] = {
        {"Liberation Sans", "truetype/liberation/LiberationSans-Regular.ttf", 1.5, 2048, 100'000, true},
        {"Liberation Sans", "truetype/liberation/LiberationSans-Regular.ttf", 0.06, 2048, 100'000, true},
        {"M+ 1", "opentype/mplus/Mplus1-Regular.otf", 0.1, 1000, 1000, true},
        {"Inter variable, contours that cross", "truetype/inter-vf/Inter-roman.var.ttf", 1.5, 2816, 100'000, false},
    };
    const bool quick = argc > 2;
    if (quick) passes = 2;
    std::FILE* polygons = argc > 1 ? std::fopen(argv[1], "w") : nullptr;
    std::printf("columns\tcut\tpeer\tfont\ttolerance\tpoints_a_glyph\ttime_us_a_glyph\twrong\tclock\n");
    for (const font_set& f : sets) {
        if (quick && f.tolerance < 1) continue;
        const set s = set_of(f);
        if (s.glyphs.empty()) {
            std::printf("skipped\t%s\tno such font: %s\n", f.name, f.file);
            continue;
        }
        measure(s, f.simple);
        if (polygons != nullptr) dump(polygons, s, f.simple);
    }
    if (polygons != nullptr) std::fclose(polygons);
}
