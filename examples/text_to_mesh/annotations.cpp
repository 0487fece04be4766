// SPDX-License-Identifier: MIT
#include "annotations.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string_view>
#include <utility>

namespace text_to_mesh {
namespace {

constexpr unsigned char contour_rgb[3] = {20, 60, 160}, point_rgb[3] = {20, 30, 60}, control_rgb[3] = {120, 120, 120},
                        on_curve_rgb[3] = {30, 140, 70}, normal_rgb[3] = {30, 120, 200};

void add_segment(overlay& to, const float* a, const float* b, const unsigned char (&rgb)[3])
{
    to.segments.push_back({{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {rgb[0], rgb[1], rgb[2]}});
}

void add_dot(overlay& to, const float* p, const unsigned char (&rgb)[3], float radius)
{
    to.dots.push_back({{p[0], p[1], p[2]}, {rgb[0], rgb[1], rgb[2]}, radius});
}

/// A place of the mesh's front.
struct place {
    float at[3];
};

/// Closed polylines and their points, as far as they are requested; `put` gives the place of a grid point.
template <class Put>
void add_loops(overlay& to, const options& o, std::span<const typemesh::grid_point> points,
               std::span<const std::uint32_t> starts, const Put& put)
{
    for (std::size_t k = 0; k + 1 < starts.size(); ++k) {
        const std::uint32_t first = starts[k], last = starts[k + 1];
        for (std::uint32_t i = first; i < last; ++i) {
            const place a = put(points[i]), b = put(points[i + 1 == last ? first : i + 1]);
            if (o.show_contours) add_segment(to, a.at, b.at, contour_rgb);
            if (o.show_points) add_dot(to, a.at, point_rgb, 3.0f);
        }
    }
}

/// The outline of letters whose edges have moved, and of rings: edges of what is seen from the front that have a triangle
/// on one side only.
void add_moved_loops(overlay& to, const options& o, const model& mesh)
{
    using position = std::array<float, 3>;
    const auto at = [&](std::size_t i) -> position {
        const float* p = mesh.vertices[mesh.indices[i]].position;
        return {p[0], p[1], p[2]};
    };
    for (const unsigned solid : {0u, 1u}) {
        std::map<std::pair<position, position>, int> edges;  // how often there, less how often back
        for (const model::part& part : mesh.parts) {
            const std::string_view name = part.kind();
            if (part.solid != solid || (name != "front" && name != "front_bevel" && name != "letter_front")) continue;
            for (std::size_t i = part.first_index; i < part.first_index + part.index_count; ++i) {
                const position a = at(i), b = at(i % 3 == 2 ? i - 2 : i + 1);
                a < b ? ++edges[{a, b}] : --edges[{b, a}];
            }
        }
        for (const auto& [ends, count] : edges) {
            if (count == 0) continue;
            if (o.show_contours) add_segment(to, ends.first.data(), ends.second.data(), contour_rgb);
            if (!o.show_points) continue;
            add_dot(to, ends.first.data(), point_rgb, 3.0f);
            add_dot(to, ends.second.data(), point_rgb, 3.0f);
        }
    }
}

}  // namespace

overlay annotate(const options& o, font_set& font, const typemesh::glyph_run& run,
                 std::span<const typemesh::drawn_glyph> shapes, const model& mesh)
{
    overlay drawn;
    if (o.show_normals) {
        constexpr float length = 0.05f;
        for (const model_vertex& v : mesh.vertices) {
            const float tip[3] = {v.position[0] + length * v.normal[0], v.position[1] + length * v.normal[1],
                                  v.position[2] + length * v.normal[2]};
            add_segment(drawn, v.position, tip, normal_rgb);
        }
    }
    if (!o.show_contours && !o.show_points && !o.show_control) return drawn;
    const bool moved = o.outline.width > 0.0f || std::fabs(o.embolden) > 0.0f;
    if (moved) add_moved_loops(drawn, o, mesh);

    const double upem = font.units_per_em();
    typemesh::outline shape;
    typemesh::contours loops;
    for (const typemesh::placed_glyph& glyph : run.glyphs) {
        const typemesh::glyph_style drawn_so =
            run.glyph_styles.empty() ? typemesh::glyph_style{} : run.glyph_styles[glyph.glyph_style];
        const double scale = upem / typemesh::units_per_em_of(font, drawn_so.face);
        const typemesh::affine map = typemesh::scaled_before(drawn_so.map, scale);
        typemesh::mapped_face own{font, drawn_so.face, &map, upem};
        if (glyph.missing || !record(own, glyph.id, shape) || shape.curves.empty()) continue;
        const auto grid = typemesh::grid::fitting(upem, shape.bounds);
        if (!grid) continue;
        typemesh::result<void> flattened;
        with_discretiser(o, upem,
                         [&](const auto& d) { flattened = discretise(shape, d, o.tolerance * upem, *grid, loops); });
        if (!flattened) continue;

        const auto put = [&](typemesh::point p) {
            return place{{static_cast<float>((glyph.origin.x + p.x) / upem),
                          static_cast<float>((glyph.origin.y + p.y) / upem), 0.0f}};
        };
        if (o.show_control) {
            for (const typemesh::curve& c : shape.curves) {
                for (std::uint32_t i = 0; i < c.degree && c.degree > 1; ++i)
                    add_segment(drawn, put(c.p[i]).at, put(c.p[i + 1]).at, control_rgb);
                for (std::uint32_t i = 1; i < c.degree; ++i) add_dot(drawn, put(c.p[i]).at, control_rgb, 3.0f);
                add_dot(drawn, put(c.start()).at, on_curve_rgb, 4.5f);
            }
        }
        if (!o.merge && !moved)
            add_loops(drawn, o, loops.points.view(), loops.starts.view(),
                      [&](typemesh::grid_point p) { return put(grid->place(p)); });
    }
    for (std::size_t k = 0; k < shapes.size() && o.merge && !moved; ++k) {
        const typemesh::drawn_glyph& s = shapes[k];
        const double unit = s.built->font_units_per_cell();
        add_loops(drawn, o, s.built->form().points, s.built->form().starts, [&](typemesh::grid_point p) {
            return place{{static_cast<float>((s.origin.x + unit * p.x) / upem),
                          static_cast<float>((s.origin.y + unit * p.y) / upem), 0.0f}};
        });
    }
    return drawn;
}

}  // namespace text_to_mesh
