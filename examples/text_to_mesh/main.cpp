// SPDX-License-Identifier: MIT
#include "annotations.hpp"
#include "model.hpp"
#include "options.hpp"
#include "picture.hpp"
#include "policies.hpp"
#include "write_glb.hpp"
#include "write_obj.hpp"
#include "write_ply.hpp"
#include "write_png.hpp"
#include "write_stl.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdio>
#include <string_view>

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

int fail(const std::string& sentence)
{
    std::fprintf(stderr, "text_to_mesh: %s\n", sentence.c_str());
    return 1;
}

/// The error's sentence; places in the text are bytes, for the text is UTF-8.
std::string in_words(const typemesh::error& e)
{
    std::string where;
    if (e.glyph != typemesh::no_glyph) where = "glyph " + std::to_string(e.glyph);
    if (e.cluster != typemesh::no_cluster)
        where += (where.empty() ? "at byte " : ", at byte ") + std::to_string(e.cluster) + " of the text";
    char sentence[256];
    return (where.empty() ? "" : where + ": ") +
           typemesh::describe(e.at(typemesh::no_glyph, typemesh::no_cluster), sentence);
}

std::string kind_of(const std::string& path) { return path.substr(path.size() - 4); }

std::string write_mesh(const model& mesh, const std::string& path)
{
    const std::string kind = kind_of(path);
    return kind == ".glb" ? write_glb(mesh, path) : kind == ".obj" ? write_obj(mesh, path) : write_ply(mesh, path);
}

/// Says on standard error what is not in the mesh; true when something is not.
bool name_losses(const typemesh::text_report& report)
{
    if (report.refused > 0)
        std::fprintf(stderr, "text_to_mesh: %u of %u glyphs left out; the first: %s\n", report.refused, report.glyphs,
                     in_words(report.first_refusal).c_str());
    if (report.missing > 0)
        std::fprintf(
            stderr,
            "text_to_mesh: the font has no glyph for %u of %u characters; the first is at byte %u of the text\n",
            report.missing, report.glyphs, report.first_missing);
    if (report.invalid_units > 0)
        std::fprintf(stderr,
                     "text_to_mesh: the text is not valid UTF-8 at %u place%s; the first is at byte %u of the text\n",
                     report.invalid_units, report.invalid_units == 1 ? "" : "s", report.first_invalid_unit);
    return !report.complete();
}

/// The indices glyph by glyph instead of part by part: STL has no indices, so a reader welds corners by their places,
/// and letters that touch in an edge are told apart only by which facets come together.
template <class Plan>
std::vector<std::uint32_t> solid_by_solid(const Plan& plan, const std::vector<std::uint32_t>& indices)
{
    std::vector<std::uint32_t> ordered;
    ordered.reserve(indices.size());
    for (std::size_t g = 0; g < plan.glyphs().size(); ++g) {
        for (const typemesh::part p : typemesh::all_parts) {
            const auto first = indices.begin() + plan.range(g, p).first_index;
            ordered.insert(ordered.end(), first, first + plan.range(g, p).index_count);
        }
    }
    return ordered;
}

/// The triangles of the front, as they lie in the mesh.
typemesh::triangle_quality quality_of_front(const model& mesh)
{
    std::vector<typemesh::point> points;
    for (const model_vertex& v : mesh.vertices) points.push_back({double{v.position[0]}, double{v.position[1]}});
    std::vector<typemesh::triangle> triangles;
    for (const auto& part : mesh.parts)
        if (std::string_view{part.name} == "front")
            for (std::size_t i = part.first_index; i < part.first_index + part.index_count; i += 3)
                triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    typemesh::triangle_quality q;
    typemesh::add_triangles<typemesh::point>(q, points, triangles);
    return q;
}

template <class Plan>
void print_stats(const Plan& plan, const model& mesh, const stage_clock& clock)
{
    const auto& report = plan.report();
    std::printf(
        "{\"glyphs\":%u,\"refused\":%u,\"missing\":%u,\"contour_points\":%llu,\"hard_edges\":%llu,\"vertices\":%llu,"
        "\"triangles\":%llu",
        report.glyphs, report.refused, report.missing, static_cast<unsigned long long>(plan.contour_points()),
        static_cast<unsigned long long>(plan.hard_edges()), static_cast<unsigned long long>(plan.size().vertices),
        static_cast<unsigned long long>(plan.size().triangles));
    const typemesh::triangle_quality q = quality_of_front(mesh);
    std::printf(
        ",\"front\":{\"triangles\":%llu,\"smallest_angle\":%.4g,\"angle_5_percent\":%.4g,\"angle_median\":%.4g,"
        "\"largest_aspect\":%.4g}",
        static_cast<unsigned long long>(q.triangles), q.smallest_angle, q.angle_at(0.05), q.angle_at(0.5),
        q.largest_aspect);
    const char* names[] = {"shape", "outline", "discretise", "fill", "triangulate", "extrude"};
    std::printf(",\"nanoseconds\":{");
    for (int i = 0; i < 6; ++i)
        std::printf("%s\"%s\":%lld", i > 0 ? "," : "", names[i], static_cast<long long>(clock.nanoseconds[i]));
    std::puts("}}");
}

typemesh::text_options text_options_of(const options& o)
{
    typemesh::text_options how;
    how.shape = {.direction = o.direction, .language = o.language, .script = o.script, .features = o.features};
    how.layout = {.align = o.align};
    how.tolerance = o.tolerance;
    how.fill = o.fill;
    how.merge = o.merge;
    return how;
}

/// The whole mesh of a plan, part by part.
template <class Plan>
typemesh::error write_model(const Plan& plan, model& out)
{
    if (const typemesh::error e = plan.write(typemesh::into(out.vertices, out.indices))) return e;
    const char* names[] = {"front", "back", "side"};
    for (const typemesh::part p : typemesh::all_parts) {
        const typemesh::mesh_range r = plan.range(p);
        if (r.index_count > 0) out.parts.push_back({names[static_cast<int>(p)], r.first_index, r.index_count});
    }
    return {};
}

/// The tolerance in em of the picture's own mesh, by the size at which it will be drawn; but what was asked for where
/// the picture is to show it.
double picture_tolerance(const options& o, const typemesh::bounds3& bounds, const picture_options& look)
{
    const bool shows_the_mesh = o.show_triangles || o.show_points || o.show_contours || o.show_normals;
    if (o.quality_given || shows_the_mesh || o.discretiser != discretiser_name::certified) return o.tolerance;
    model box;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto pick = [&](unsigned bit, float low, float high) { return (corner & bit) != 0 ? high : low; };
        box.vertices.push_back({{pick(1, bounds.low.x, bounds.high.x), pick(2, bounds.low.y, bounds.high.y),
                                 pick(4, bounds.low.z, bounds.high.z)}, {}, {}});
        box.indices.push_back(corner);
    }
    constexpr double error_in_pixels = 0.125;  // half of what is hard to see: lines here are long and their edges sharp
    return typemesh::tolerance_for_pixels(pixels_per_unit(box, look), error_in_pixels);
}

/// Draws the text, one em large, and writes the picture. Gives an empty string, or one sentence.
std::string draw_picture(const options& o, typemesh::harfbuzz_font& font, const typemesh::bounds3& bounds)
{
    picture_options look;
    look.shading = o.shading;
    look.wireframe = o.show_triangles;
    look.texture = o.checker ? texture::checker : texture::none;

    const chosen_discretiser discretiser = discretiser_of(o, font.units_per_em());
    auto mesher = typemesh::text_mesher{font}.with(discretiser).with(triangulator_of(o)).with(extruder_of(o));
    typemesh::text_options how = text_options_of(o);
    how.tolerance = picture_tolerance(o, bounds, look);
    auto plan = mesher.plan(o.text, how);
    if (!plan) return in_words(plan.error());
    model mesh;
    if (const typemesh::error e = write_model(*plan, mesh)) return in_words(e);
    int width = 0, height = 0;
    const overlay over = annotate(o, font, plan->run(), plan->glyphs(), discretiser, mesh);
    const auto pixels = draw(mesh, over, look, width, height);
    return write_png(pixels, width, height, o.picture);
}

int run(const options& o)
{
    auto font = typemesh::harfbuzz_font::open(o.font.c_str(), {.face = o.face, .variations = o.variations});
    if (!font) return fail(o.font + ": " + in_words(font.error()));

    auto mesher = typemesh::text_mesher{*font}
                      .with(discretiser_of(o, font->units_per_em()))
                      .with(triangulator_of(o))
                      .with(extruder_of(o))
                      .with(stage_clock{});
    auto plan = mesher.plan(o.text, text_options_of(o));
    if (!plan) return fail(in_words(plan.error()));

    model mesh;
    mesh.name = o.text;
    mesher.observer()(typemesh::stage::extrude);
    const typemesh::error e = write_model(*plan, mesh);
    mesher.observer()(typemesh::stage::idle);
    if (e) return fail(in_words(e));

    if (name_losses(plan->report()) && o.strict) return fail("--strict: nothing is written.");
    if (!o.output.empty()) {
        std::string trouble;
        if (kind_of(o.output) == ".stl")
            trouble = write_stl({mesh.vertices, solid_by_solid(*plan, mesh.indices), {}, mesh.name}, o.output);
        else trouble = write_mesh(mesh, o.output);
        if (!trouble.empty()) return fail(trouble);
    }
    if (!o.picture.empty())
        if (const std::string trouble = draw_picture(o, *font, plan->bounds()); !trouble.empty()) return fail(trouble);
    if (o.stats) {
        print_stats(*plan, mesh, mesher.observer());
        if (std::fflush(stdout) != 0) return fail("the statistics cannot be written");
    }
    return 0;
}

}  // namespace
}  // namespace text_to_mesh

int main(int argc, char** argv)
{
    text_to_mesh::options o;
    if (const auto status = text_to_mesh::parse(argc, argv, o)) return *status;
    return text_to_mesh::run(o);
}
