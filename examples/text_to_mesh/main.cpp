// SPDX-License-Identifier: MIT
#include "annotations.hpp"
#include "atomic_file.hpp"
#include "model.hpp"
#include "options.hpp"
#include "page.hpp"
#include "picture/picture.hpp"
#include "policies.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "sewn.hpp"
#include "statistics.hpp"
#include "text_fonts.hpp"
#include "write_3mf.hpp"
#include "write_glb.hpp"
#include "write_obj.hpp"
#include "write_ply.hpp"
#include "write_png.hpp"
#include "write_stl.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cstdio>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

template <>
struct typemesh::vertex_traits<text_to_mesh::model_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    text_to_mesh::model_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {{s.position.x, s.position.y, s.position.z}, {s.normal.x, s.normal.y, s.normal.z}, {s.uv.x, s.uv.y}};
    }
};

namespace text_to_mesh {
namespace {

constexpr const char* part_names[] = {"front", "back", "side", "front_bevel", "back_bevel"};
constexpr const char* letter_part_names[] = {"letter_front", "letter_back", "letter_side"};

typemesh::text_options text_options_of(const options& o)
{
    typemesh::text_options how;
    how.shape = {.direction = o.direction, .language = o.language, .script = o.script, .features = o.features};
    how.shape.columns = o.columns;
    how.layout = {.align = o.align, .line_spacing = o.line_spacing, .letter_spacing = o.letter_spacing};
    how.tolerance = o.tolerance;
    how.fill = o.fill;
    how.size = o.size;
    how.merge = o.merge;
    how.corners = o.corners;
    return how;
}

/// How many parts come before those of the letter within a ring.
std::size_t ring_parts(const options& o) { return o.bevel.width > 0.0f ? 5 : o.outline.width > 0.0f ? 3 : 5; }

void add_part(const options& o, model& out, typemesh::part p, const typemesh::mesh_range& r,
              typemesh::style_id style = {})
{
    if (r.index_count == 0) return;
    const auto number = static_cast<std::size_t>(p), own = ring_parts(o);
    if (number < own)
        out.parts.push_back({part_names[number], r.first_index, r.index_count});
    else
        out.parts.push_back({letter_part_names[number - own], r.first_index, r.index_count, 1});
    const auto coloured = static_cast<std::size_t>(style);
    if (coloured == 0) return;
    out.parts.back().name += "_" + std::to_string(coloured);
    out.parts.back().colour = o.styles[coloured - 1].colour;
}

/// The whole mesh of a plan, part by part.
template <class Plan>
typemesh::error write_model(const options& o, const Plan& plan, model& out)
{
    if (const typemesh::error e = plan.write(typemesh::into(out.vertices, out.indices))) return e;
    for (const typemesh::part p : plan.parts())
        for (const typemesh::style_id style : plan.styles()) add_part(o, out, p, plan.range(style, p), style);
    return {};
}

/// Each different letter of a plan once, by the font's name for it, and where it stands.
template <class Plan>
typemesh::error write_letters(const options& o, const Plan& plan, const font_set& fonts, model& out)
{
    if (const typemesh::error e = plan.write_meshes(typemesh::into(out.vertices, out.indices))) return e;
    for (std::size_t m = 0; m < plan.meshes().size(); ++m) {
        char name[64];
        const typemesh::glyph_run& all = plan.run();
        const std::uint32_t look = all.glyphs[plan.glyphs()[plan.meshes()[m].first_glyph].glyph].look;
        const std::uint32_t face = all.looks.empty() ? 0 : all.looks[look].face;
        hb_font_glyph_to_string(fonts.font(face).handle(), plan.meshes()[m].id, name, sizeof name);
        model::letter l{name, plan.meshes()[m].first_vertex, 0, out.parts.size(), 0};
        for (const typemesh::part p : plan.parts()) {
            add_part(o, out, p, plan.mesh_part(m, p));
            l.vertex_count += plan.mesh_part(m, p).vertex_count;
        }
        l.part_count = out.parts.size() - l.first_part;
        out.letters.push_back(l);
    }
    plan.write_instances([&out](const typemesh::glyph_instance& i) {
        out.places.push_back({i.mesh, {i.translation.x, i.translation.y, i.translation.z}});
    });
    return {};
}

/// The indices glyph by glyph instead of part by part: STL has no indices, so a reader welds corners by their places.
/// Letters are merged by default; with --no-merge two that touch in an edge are told apart only by which facets come
/// together.
template <class Plan>
std::vector<std::uint32_t> solid_by_solid(const Plan& plan, const std::vector<std::uint32_t>& indices)
{
    std::vector<std::uint32_t> ordered;
    ordered.reserve(indices.size());
    for (std::size_t g = 0; g < plan.glyphs().size(); ++g) {
        for (const typemesh::part p : plan.parts()) {
            const auto first = indices.begin() + plan.range(g, p).first_index;
            ordered.insert(ordered.end(), first, first + plan.range(g, p).index_count);
        }
    }
    return ordered;
}

/// Gives an empty string, or one sentence.
template <class Plan>
std::string write_output(const options& o, const Plan& plan, model& mesh, file_set& files)
{
    switch (o.kind) {
    case file_kind::glb: return write_glb(mesh, o.output, files);
    case file_kind::obj: return write_obj(mesh, o.output, files);
    case file_kind::ply: return write_ply(mesh, o.output, files);
    case file_kind::three_mf: return write_3mf(o.bevel.width > 0.0f ? sewn(mesh) : mesh, o.output, files);
    case file_kind::stl: {
        mesh.indices = solid_by_solid(plan, mesh.indices);
        mesh.parts.clear();
        return write_stl(mesh, o.output, files);
    }
    case file_kind::png:
    case file_kind::unknown: break;
    }
    return {};
}

/// The tolerance in em of the picture's own mesh, by the size at which it will be drawn; but the requested one where
/// the picture is to show it. `bounds` are those of the text, one em large.
double picture_tolerance(const options& o, const typemesh::bounds3& bounds, const picture_options& look)
{
    const bool shows_the_mesh = o.show_triangles || o.show_points || o.show_contours || o.show_normals;
    if (o.quality_given || shows_the_mesh || o.discretiser != discretiser_name::certified) return o.tolerance;
    model box;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto pick = [&](unsigned bit, float low, float high) { return (corner & bit) != 0 ? high : low; };
        box.vertices.push_back({{pick(1, bounds.low.x, bounds.high.x), pick(2, bounds.low.y, bounds.high.y),
                                 pick(4, bounds.low.z, bounds.high.z)},
                                {},
                                {}});
        box.indices.push_back(corner);
    }
    constexpr double error_in_pixels = 0.125;  // half of what is hard to see: lines here are long and their edges sharp
    return typemesh::tolerance_for_pixels(pixels_per_unit(box, look), error_in_pixels);
}

/// Draws the text, one em large, and prepares the picture. Gives an empty string, or one sentence.
template <class Extruder, class Discretiser>
std::string draw_picture(const options& o, font_set& font, const typemesh::glyph_run& page,
                         const Discretiser& discretiser, file_set& files)
{
    picture_options look;
    look.shading = o.shading;
    look.yaw = o.turn;
    look.wireframe = o.show_triangles;
    look.texture = o.checker ? texture::checker : texture::none;

    const auto extruder = std::get<Extruder>(extruder_of(o));
    auto mesher = typemesh::text_mesher{font}.with(discretiser).with(triangulator_of(o)).with(extruder);
    typemesh::text_options how = text_options_of(o);
    how.size = 1.0;
    typemesh::bounds3 bounds;  // of a mesh of the picture's size: those of the file's may be too small to be told apart
    if (const auto first = plan_of(mesher, o, page, how))
        bounds = first->bounds();
    else
        return in_words(first.error());
    how.tolerance = picture_tolerance(o, bounds, look);
    auto plan = plan_of(mesher, o, page, how);
    if (!plan) return in_words(plan.error());
    model mesh;
    if (const typemesh::error e = write_model(o, *plan, mesh)) return in_words(e);
    int width = 0, height = 0;
    const overlay over = annotate(o, font, plan->run(), plan->glyphs(), discretiser, mesh);
    const auto pixels = draw(mesh, over, look, width, height);
    return write_png(pixels, width, height, o.picture, files);
}

/// Why a text cannot be planned; of an option that no check of the command line can know, as it depends on the font, by
/// its name there.
std::string refusal_in_words(const options& o, const typemesh::error& e)
{
    if (e.code != typemesh::error::bad_option) return in_words(e);
    const std::string_view option = e.option;
    constexpr float narrow = 1e-4f;  // a ring is refused that is narrower than a few cells
    if (option == "outlined::width")
        return o.outline.width < narrow ? "--outline: is too narrow for this font."
                                        : "--outline: is too wide for this font.";
    if (option != "width") return in_words(e);
    return "--bevel: is too wide for this font.";
}

/// Warns the user about a plan. Gives why nothing is written, or an empty string.
template <class Plan>
std::string name_warnings(const options& o, const Plan& plan, const font_set& fonts)
{
    bool warned = name_missing_features(fonts, o.features);
    warned = name_losses(plan.report(), o.family || !o.fallback.empty()) || warned;
    if (!o.output.empty() && !o.instances) {
        const bool instances_help = o.kind == file_kind::glb && !o.merge;
        warned = name_flipped_triangles(flipped_triangles(plan), instances_help) || warned;
    }
    if (warned && o.strict) return "--strict: nothing is written.";
    if ((o.output.empty() && o.picture.empty()) || !plan.glyphs().empty()) return {};
    return plan.report().complete() ? "the text is blank: nothing is written."
                                    : "nothing of the text can be drawn: nothing is written.";
}

/// All of it with an open font. Gives an empty string, or one sentence.
template <class Discretiser, class Extruder>
std::string run(const options& o, progress& tell, font_set& font, const Discretiser& discretiser,
                const Extruder& extruder)
{
    tell.begin("shaping the text and building its letters");
    typemesh::glyph_run page;
    typemesh::text_options how = text_options_of(o);
    stage_clock clock{.tell = &tell};
    clock(typemesh::stage::shape);
    if (std::string trouble = lay_out_page(o, font, page, how.size); !trouble.empty()) return trouble;
    clock(typemesh::stage::idle);
    const std::vector<typemesh::look> looks(page.looks.begin(), page.looks.end());
    if (!holds_colours(o.kind))  // else letters of different colours would not merge
        for (typemesh::look& l : page.looks) l.style = {};
    auto mesher = typemesh::text_mesher{font}.with(discretiser).with(triangulator_of(o)).with(extruder).with(clock);
    auto plan = plan_of(mesher, o, page, how);
    if (!plan) return refusal_in_words(o, plan.error());

    tell.clear();
    if (std::string trouble = name_warnings(o, *plan, font); !trouble.empty()) return trouble;

    model mesh;
    mesh.name = o.text;
    tell.begin("making " + std::to_string(plan->size().triangles) + " triangles");
    mesher.observer()(typemesh::stage::extrude);
    const typemesh::error e = o.instances ? write_letters(o, *plan, font, mesh) : write_model(o, *plan, mesh);
    mesher.observer()(typemesh::stage::idle);
    if (e) return in_words(e);
    const typemesh::triangle_quality quality = o.stats ? quality_of_front(mesh) : typemesh::triangle_quality{};

    file_set files;
    if (!o.output.empty()) {
        tell.begin("writing " + o.output);
        if (std::string trouble = write_output(o, *plan, mesh, files); !trouble.empty()) return trouble;
    }
    if (!o.picture.empty()) {
        tell.begin("drawing " + o.picture);
        std::copy(looks.begin(), looks.end(), page.looks.begin());
        if (std::string trouble = draw_picture<Extruder>(o, font, page, discretiser, files); !trouble.empty())
            return trouble;
    }
    tell.clear();
    if (o.stats) {
        print_stats(*plan, quality, mesher.observer());
        if (std::fflush(stdout) != 0) return "the statistics cannot be written.";
    }
    return files.finish();
}

/// The same from the font on.
std::string run(const options& o, progress& tell)
{
    tell.begin("opening the fonts");
    text_fonts fonts;
    if (std::string trouble = fonts.open(o); !trouble.empty()) return trouble;
    options of_file = o;
    if (o.kind == file_kind::three_mf) of_file.normals = normals_name::shared;  // see write_3mf()
    return std::visit([&](const auto& d, const auto& e) { return run(o, tell, fonts.set(), d, e); },
                      discretiser_of(o, fonts.set().units_per_em()), extruder_of(of_file));
}

}  // namespace
}  // namespace text_to_mesh

int main(int argc, char** argv)
{
    text_to_mesh::options o;
    if (const auto status = text_to_mesh::parse(argc, argv, o)) return *status;
    text_to_mesh::progress tell;
    const std::string trouble = text_to_mesh::run(o, tell);
    tell.clear();
    if (trouble.empty()) return 0;
    std::fprintf(stderr, "text_to_mesh: %s\n", trouble.c_str());
    return 1;
}
