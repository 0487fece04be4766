// SPDX-License-Identifier: MIT
#include "annotations.hpp"

namespace text_to_mesh {
namespace {

constexpr unsigned char contour_rgb[3] = {20, 60, 160}, point_rgb[3] = {20, 30, 60}, control_rgb[3] = {120, 120, 120},
                        on_curve_rgb[3] = {30, 140, 70}, normal_rgb[3] = {30, 120, 200};

void add_segment(overlay& to, const float (&a)[3], const float (&b)[3], const unsigned char (&rgb)[3])
{
    to.segments.push_back({{a[0], a[1], a[2]}, {b[0], b[1], b[2]}, {rgb[0], rgb[1], rgb[2]}});
}

void add_dot(overlay& to, const float (&p)[3], const unsigned char (&rgb)[3], float radius)
{
    to.dots.push_back({{p[0], p[1], p[2]}, {rgb[0], rgb[1], rgb[2]}, radius});
}

/// A place of the mesh's front.
struct place {
    float at[3];
};

/// Closed polylines and their points, as far as they are asked for; `put` gives the place of a grid point.
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

}  // namespace

overlay annotate(const options& o, font_set& font, const typemesh::glyph_run& run,
                 std::span<const typemesh::drawn_glyph> shapes, const chosen_discretiser& discretiser,
                 const model& mesh)
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

    const double upem = font.units_per_em();
    typemesh::outline shape;
    typemesh::contours loops;
    for (const typemesh::placed_glyph& glyph : run.glyphs) {
        const typemesh::look drawn_so = run.looks.empty() ? typemesh::look{} : run.looks[glyph.look];
        const double scale = upem / typemesh::units_per_em_of(font, drawn_so.face);
        const typemesh::affine map = typemesh::scaled_before(drawn_so.map, scale);
        typemesh::mapped_face own{font, drawn_so.face, &map, upem};
        if (glyph.missing || record(own, glyph.id, shape) || shape.curves.empty()) continue;
        const auto grid = typemesh::grid::fitting(upem, shape.bounds);
        const auto lines = [&](const auto& d) { return discretise(shape, d, o.tolerance * upem, *grid, loops); };
        if (!grid || std::visit(lines, discretiser)) continue;

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
        if (!o.merge)
            add_loops(drawn, o, loops.points.view(), loops.starts.view(),
                      [&](typemesh::grid_point p) { return put(grid->place(p)); });
    }
    for (std::size_t k = 0; k < shapes.size() && o.merge; ++k) {
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
