// SPDX-License-Identifier: MIT
#pragma once

// What must be true of the caps and the solid of one glyph, whatever its contours do and whichever triangulator cuts
// them; and the fonts to try it on.

#include "support/delaunay.hpp"
#include "support/mesh_laws.hpp"
#include "support/oracle.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <hb-ot.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace test {

/// One face of a font file, at one place of its axes.
struct face_instance {
    std::string path;
    std::uint32_t face = 0;
    std::vector<typemesh::variation> variations;
    std::uint32_t glyph_count = 0;

    [[nodiscard]] std::string name() const
    {
        std::string s = std::filesystem::path{path}.filename().string();
        if (face != 0) s += " face " + std::to_string(face);
        for (const auto& v : variations)
            s += " " + std::string{v.tag} + "=" + std::to_string(static_cast<int>(v.value));
        return s;
    }
    [[nodiscard]] auto open() const
    {
        return typemesh::harfbuzz_font::open(path.c_str(), {.face = face, .variations = variations});
    }
};

/// All faces of a file that have outlines: variable ones at their default, at each axis' ends and at mixed corners.
inline std::vector<face_instance> instances_of(const std::string& path)
{
    std::vector<face_instance> all;
    hb_blob_t* blob = hb_blob_create_from_file_or_fail(path.c_str());
    if (blob == nullptr) return all;
    const std::uint32_t faces = hb_face_count(blob);
    for (std::uint32_t f = 0; f < faces; ++f) {
        face_instance plain{path, f, {}, 0};
        const auto font = plain.open();
        if (!font) continue;
        plain.glyph_count = font->glyph_count();
        all.push_back(plain);
        hb_face_t* face = hb_face_create(blob, f);
        hb_ot_var_axis_info_t axes[8];
        unsigned count = 8;
        hb_ot_var_get_axis_infos(face, 0, &count, axes);
        hb_face_destroy(face);
        const auto at = [&](auto&& value_of) {
            face_instance corner = plain;
            for (unsigned a = 0; a < count; ++a) {
                typemesh::variation v;
                for (int k = 0; k < 4; ++k) v.tag[k] = static_cast<char>(axes[a].tag >> (24 - 8 * k) & 0xFF);
                v.value = value_of(a);
                corner.variations.push_back(v);
            }
            all.push_back(corner);
        };
        for (unsigned a = 0; a < count; ++a) {
            at([&](unsigned b) { return a == b ? axes[b].min_value : axes[b].default_value; });
            at([&](unsigned b) { return a == b ? axes[b].max_value : axes[b].default_value; });
        }
        if (count > 1) {
            at([&](unsigned b) { return axes[b].min_value; });
            at([&](unsigned b) { return axes[b].max_value; });
            at([&](unsigned b) { return b % 2 == 0 ? axes[b].min_value : axes[b].max_value; });
            at([&](unsigned b) { return b % 2 == 0 ? axes[b].max_value : axes[b].min_value; });
        }
    }
    hb_blob_destroy(blob);
    return all;
}

/// What was found out about one glyph.
struct glyph_findings {
    bool blank = false;
    bool resolved = false;  ///< its contours meet
    bool touching = false;  ///< and so do its region's
    std::size_t points = 0;
    std::size_t crowded = 0;  ///< vertical edges with more than two faces
    double moved = 0.0;       ///< by how much the area differs from what the polygons fill, over their length, in cells
    std::string wrong;        ///< the first law that is broken; empty: none
};

/// Holds what is needed to look at one glyph after another. Use each on one thread.
class glyph_laws {
public:
    template <class Font>
    glyph_findings examine(Font& font, typemesh::glyph_id id, double tolerance_em)
    {
        using namespace typemesh;
        glyph_findings f;
        if (const error e = record(font, id, outline_)) return f.wrong = e.message(), f;
        if (outline_.curves.empty()) return f.blank = true, f;
        const auto cells = grid::fitting(font.units_per_em(), outline_.bounds);
        if (!cells) return f.wrong = cells.error().message(), f;
        if (const error e = discretise(outline_, certified{}, tolerance_em * font.units_per_em(), *cells, loops_))
            return f.wrong = e.message(), f;
        if (loops_.points.empty()) return f.blank = true, f;
        const std::vector<grid_point> points{loops_.points.begin(), loops_.points.end()};
        const std::vector<std::uint32_t> starts{loops_.starts.begin(), loops_.starts.end()};
        const auto given = oracle::loops_of(points, starts);

        triangles_.clear();
        {
            contours_copy(points, starts);
            orient(copy_);
            f.resolved = !monotone{}.prove(copy_, space_, triangles_);
            triangles_.clear();
        }
        const auto made = cap(loops_, outline_.rule, monotone{}, space_, triangles_);
        if (!made) return f.wrong = std::string{"refused: "} + made.error().message(), f;
        f.touching = made->is_touching();
        f.points = made->points().size();
        const auto kept = oracle::loops_of(*made);
        if (made->points().empty()) return f.blank = true, f;

        if (f.wrong = oracle::broken_law(*made, triangles_.view()); !f.wrong.empty()) return f;
        if (f.wrong = broken_delaunay(*made); !f.wrong.empty()) return f;
        if (f.resolved)
            if (f.wrong = oracle::broken_walk(kept); !f.wrong.empty()) return f;
        const double area = static_cast<double>(oracle::doubled_area(kept)),
                     filled = oracle::doubled_filled_area(given, outline_.rule);
        const double off = std::fabs(area - filled) - 1e-11 * filled;
        f.moved = off > 0 ? off / (2 * oracle::length(given)) : 0;
        if (f.resolved ? f.moved > 0.71 : off > 0) return f.wrong = "the area is not what the contours fill", f;

        for (const triangle t : triangles_) {
            const auto at = [&](std::uint32_t i) {
                const point p = made->grid().place(made->points()[i]);
                return vec2{static_cast<float>(p.x), static_cast<float>(p.y)};
            };
            const vec2 a = at(t.a), b = at(t.b), c = at(t.c);
            const double turn = (double(b.x) - a.x) * (double(c.y) - a.y) - (double(b.y) - a.y) * (double(c.x) - a.x);
            if (!(turn > 0)) return f.wrong = "a triangle is flipped or flat in 32-bit floats", f;
        }

        sample(font, id, tolerance_em * font.units_per_em() * cells->cells, cells->cells, kept, f);
        if (!f.wrong.empty()) return f;

        glyph_run alone;
        alone.units_per_em = font.units_per_em();
        if (!alone.glyphs.push_back({id, 0, {0, 0}})) return f.wrong = "no memory", f;
        text_mesher mesher{font};
        const auto built = mesher.plan(alone, {.tolerance = tolerance_em, .unit = output_unit::font_units});
        if (!built) return f.wrong = built.error().message(), f;
        if (built->report().refused != 0) return f.wrong = "refused by the mesher", f;
        if (built->write(into(mesh_.vertices, mesh_.indices))) return f.wrong = "cannot be written", f;
        const closedness law = test::examine(mesh_);
        f.crowded = law.crowded_edges;
        if (law.unmatched_edges != 0) return f.wrong = "the solid is not closed", f;
        if (law.crowded_slanted != 0) return f.wrong = "more than two faces meet at an edge that is not vertical", f;
        if (law.zero_area != 0) return f.wrong = "a wall or cap triangle is flat", f;
        if (!f.touching && law.crowded_edges != 0) return f.wrong = "more than two faces meet where nothing touches", f;
        return f;
    }

private:
    void contours_copy(const std::vector<typemesh::grid_point>& points, const std::vector<std::uint32_t>& starts)
    {
        copy_.clear();
        copy_.grid = loops_.grid;
        (void)copy_.points.append(points);
        (void)copy_.edges.append(loops_.edges.view());
        (void)copy_.starts.append(starts);
    }

    /// The Delaunay triangles obey the laws of all triangles, and their own; and both ways to make them agree.
    std::string broken_delaunay(const typemesh::region& r)
    {
        using namespace typemesh;
        delaunay_.clear();
        by_slabs_.clear();
        if (const error e = constrained_delaunay{}(r, space_, delaunay_)) return std::string{"Delaunay: "} + e.message();
        if (const error e = constrained_delaunay{.most_flips = 0}(r, space_, by_slabs_))
            return std::string{"Delaunay by slabs: "} + e.message();
        std::string wrong = oracle::broken_law(r, delaunay_.view());
        if (wrong.empty()) wrong = oracle::broken_delaunay(r, delaunay_.view());
        if (wrong.empty() && oracle::as_set(delaunay_.view()) != oracle::as_set(by_slabs_.view()))
            wrong = "flips and slabs do not make the same triangles";
        return wrong.empty() ? wrong : "Delaunay: " + wrong;
    }

    /// Places farther than the tolerance from all curves are filled exactly where the curves' winding number says so.
    template <class Font>
    void sample(Font&, typemesh::glyph_id id, double tolerance, double cells, const std::vector<oracle::loop>& kept,
                glyph_findings& f)
    {
        using namespace typemesh;
        constexpr int steps = 24;
        dense_.clear();
        for (const curve& c : outline_.curves) {
            const int n = c.degree == 1 ? 1 : steps;
            for (int i = 0; i < n; ++i)
                dense_.push_back({cells * at(c, double(i) / n), cells * at(c, double(i + 1) / n)});
        }
        const box& b = outline_.bounds;
        std::uint64_t state = id * 0x9E37'79B9'7F4A'7C15u + 1;
        for (int i = 0; i < 20; ++i) {
            const auto fraction = [&] {
                state ^= state << 13, state ^= state >> 7, state ^= state << 17;
                return static_cast<double>(state >> 11) * 0x1p-53;
            };
            const grid_point p{static_cast<std::int32_t>(cells * (b.low.x + fraction() * b.width())),
                               static_cast<std::int32_t>(cells * (b.low.y + fraction() * b.height()))};
            const point q{double(p.x), double(p.y)};
            double nearest = 1e300;
            std::int32_t w = 0;
            for (const auto& [s, e] : dense_) {
                const point along = e - s, to = q - s;
                const double square = dot(along, along);
                const double t = square == 0 ? 0.0 : (std::max)(0.0, (std::min)(1.0, dot(to, along) / square));
                const point gap = to - t * along;
                nearest = (std::min)(nearest, dot(gap, gap));
                if (s.y <= q.y && e.y > q.y && cross(along, to) > 0) ++w;
                if (e.y <= q.y && s.y > q.y && cross(along, to) < 0) --w;
            }
            if (std::sqrt(nearest) <= 1.02 * tolerance + 2.0) continue;
            if (oracle::winding(kept, p) != (is_filled(outline_.rule, w) ? 1 : 0)) {
                f.wrong = "a place is filled wrongly";
                return;
            }
        }
    }

    static typemesh::point at(const typemesh::curve& c, double t)
    {
        using typemesh::lerp;
        typemesh::point p[4] = {c.p[0], c.p[1], c.p[2], c.p[3]};
        for (int left = c.degree; left > 0; --left)
            for (int i = 0; i < left; ++i) p[i] = lerp(p[i], p[i + 1], t);
        return p[0];
    }

    struct chord {
        typemesh::point start, end;
    };
    typemesh::workspace space_;
    typemesh::outline outline_;
    typemesh::contours loops_, copy_;
    typemesh::triangle_list triangles_, delaunay_, by_slabs_;
    std::vector<chord> dense_;
    full_mesh mesh_;
};

}  // namespace test
