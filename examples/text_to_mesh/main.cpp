// SPDX-License-Identifier: MIT
#include "annotations.hpp"
#include "atomic_file.hpp"
#include "colour_layers.hpp"
#include "colour_names.hpp"
#include "gradient_ramps.hpp"
#include "letters.hpp"
#include "marked_text.hpp"
#include "model.hpp"
#include "options.hpp"
#include "page.hpp"
#include "picture/picture.hpp"
#include "plate_model.hpp"
#include "policies.hpp"
#include "progress.hpp"
#include "report.hpp"
#include "sewn.hpp"
#include "statistics.hpp"
#include "svg/svg_layers.hpp"
#include "text_fonts.hpp"
#include "text_icons.hpp"
#include "text_source.hpp"
#include "write_3mf.hpp"
#include "write_curves.hpp"
#include "write_glb.hpp"
#include "write_morph.hpp"
#include "write_obj.hpp"
#include "write_ply.hpp"
#include "write_png.hpp"
#include "write_stl.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/layout/select_glyphs.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
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

constexpr const char* part_names[typemesh::part_count_of<chosen_solid>] = {
    "front", "back", "side", "front_bevel", "back_bevel", "letter_front", "letter_back", "letter_side"};

typemesh::text_options text_options_of(const options& o)
{
    typemesh::text_options how;
    how.tolerance = o.tolerance;
    how.fill = o.fill;
    how.size = o.size;
    how.merge = o.merge && !o.plate.is_on;  // a plate merges them itself, and parts their corners
    how.corners = o.plate.is_on ? typemesh::touching::keep : o.corners;
    return how;
}

void add_part(const options& o, model& out, typemesh::part p, const typemesh::mesh_range& r,
              typemesh::style_id style = {})
{
    if (r.index_count == 0) return;
    const auto number = static_cast<std::size_t>(p);
    constexpr std::size_t of_the_letter = typemesh::part_count_of<letter_solid>;  // within a ring: behind the ring's
    out.parts.push_back({part_names[number], r.first_index, r.index_count, number < of_the_letter ? 0u : 1u});
    model::part& added = out.parts.back();
    added.colour = colour_of_style(o, style);
    if (added.colour) added.name += "_" + name_of(*added.colour);
    const auto tag = tag_of_style(o, style);
    if (!tag) return;
    added.name += (added.colour ? "-style" : "_style") + std::to_string(*tag);
    added.is_named = true;
}

/// The whole mesh of a plan, part by part.
typemesh::result<void> write_model(const options& o, const chosen_plan& plan, model& out)
{
    if (const auto done = plan.write(typemesh::into(out.vertices, out.indices)); !done) return done.error();
    gradient_ramps ramps{o, plan, out};
    for (const typemesh::part p : plan.parts())
        for (const typemesh::style_id style : plan.styles()) {
            const typemesh::mesh_range r = plan.range(style, p);
            add_part(o, out, p, r, style);
            if (r.index_count != 0) out.parts.back().ramp = ramps.ramp_of(style);
        }
    ramps.place_vertices();
    return {};
}

/// Adds to the mesh of a plan what --letters and --per-letter request.
typemesh::result<void> tell_letters(const options& o, const chosen_plan& plan, model& mesh)
{
    if (!o.letters && !o.per_letter) return {};
    const bool down = o.direction == typemesh::direction::top_to_bottom;
    if (const auto found = plan.find_letters(o.text, {.down = down}); !found) return found.error();
    if (o.letters) name_vertices(plan, o.text, mesh);
    if (o.per_letter)
        part_letters(plan, o.text, mesh,
                     [&o](model& to, typemesh::part p, const typemesh::mesh_range& r, typemesh::style_id style) {
                         add_part(o, to, p, r, style);
                     });
    return {};
}

/// The font's name for a letter; what is no letter has a name, too.
std::string name_of_letter(const chosen_plan& plan, const font_set& fonts, const typemesh::glyph_mesh& letter)
{
    const typemesh::glyph_run& all = plan.run();
    const std::uint32_t glyph_style = all.glyphs[plan.glyphs()[letter.first_glyph].glyph].glyph_style;
    const std::uint32_t face = all.glyph_styles.empty() ? 0 : all.glyph_styles[glyph_style].face;
    if (face == typemesh::bar_face) return "bar";
    if (face >= fonts.face_count()) return "icon";
    char name[64];
    hb_font_glyph_to_string(fonts.font(face).handle(), letter.id, name, sizeof name);
    return name;
}

/// What of the text each cluster shows.
class cluster_texts {
public:
    cluster_texts(const typemesh::glyph_run& run, std::string_view text) : text_{text}
    {
        for (const typemesh::placed_glyph& g : run.glyphs) begins_.push_back(g.cluster);
        std::sort(begins_.begin(), begins_.end());
    }
    [[nodiscard]] std::string of(typemesh::cluster_id cluster) const
    {
        if (cluster == typemesh::no_cluster || cluster >= text_.size()) return {};  // a bar, an ellipsis at the end
        const auto next = std::upper_bound(begins_.begin(), begins_.end(), cluster);
        std::string_view own = text_.substr(cluster, next == begins_.end() ? std::string_view::npos : *next - cluster);
        return std::string{own.substr(0, own.find('\n'))};
    }

private:
    std::string_view text_;
    std::vector<typemesh::cluster_id> begins_;
};

/// Each different letter of a plan once, by the font's name for it, in each of its colours, and where it stands.
typemesh::result<void> write_letters(const options& o, const chosen_plan& plan, const font_set& fonts, model& out)
{
    if (const auto done = plan.write_meshes(typemesh::into(out.vertices, out.indices)); !done) return done.error();
    std::map<std::pair<std::size_t, typemesh::style_id>, std::size_t> numbers;  // of the letters
    for (std::size_t m = 0; m < plan.meshes().size(); ++m) {
        bool again = false;
        for (const typemesh::style_id style : plan.styles()) {
            if (plan.instances(m, style).count == 0) continue;
            model::letter l{name_of_letter(plan, fonts, plan.meshes()[m]),
                            plan.meshes()[m].first_vertex,
                            0,
                            out.parts.size(),
                            0,
                            again};
            again = true;
            for (const typemesh::part p : plan.parts()) {
                add_part(o, out, p, plan.mesh_part(m, p), style);
                l.vertex_count += plan.mesh_part(m, p).vertex_count;
            }
            l.part_count = out.parts.size() - l.first_part;
            numbers.emplace(std::pair{m, style}, out.letters.size());
            out.letters.push_back(l);
        }
    }
    const cluster_texts shown{plan.run(), o.text};
    plan.write_instances([&](const typemesh::glyph_instance& i) {
        out.places.push_back({numbers.at({i.mesh, i.style}),
                              {i.translation.x, i.translation.y, i.translation.z},
                              shown.of(i.cluster),
                              {i.x.x, i.x.y}});
    });
    return {};
}

/// The indices glyph by glyph instead of part by part: STL has no indices, so a reader welds corners by their places.
/// Letters are merged by default; with --no-merge two that touch in an edge are distinguished only by which facets come
/// together.
std::vector<std::uint32_t> solid_by_solid(const chosen_plan& plan, const std::vector<std::uint32_t>& indices)
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

/// Adds a mesh whose z is moved to another one.
void append(model& all, const model& some, float up)
{
    const auto first = static_cast<std::uint32_t>(all.vertices.size());
    const std::size_t first_index = all.indices.size();
    for (model_vertex v : some.vertices) {
        v.position[2] += up;
        all.vertices.push_back(v);
    }
    for (const std::uint32_t i : some.indices) all.indices.push_back(first + i);
    for (model::part p : some.parts) {
        p.first_index += first_index;
        if (p.ramp) *p.ramp += all.ramps.size();
        all.parts.push_back(std::move(p));
    }
    all.ramps.insert(all.ramps.end(), some.ramps.begin(), some.ramps.end());
}

/// Puts a thin solid of a level of colour layers on the front of the level below: the two planes are the same floats.
void stand_on(model& some, std::uint32_t level, double size)
{
    const auto front_of = [size](std::uint32_t n) {
        return static_cast<float>(double{colour_layers::step} * n * size);
    };
    const float half = -0.5f * front_of(1);
    for (model_vertex& v : some.vertices) v.position[2] = front_of(v.position[2] < half ? level - 1 : level);
}

/// Adds a coarser level of detail behind the finer ones.
void add_level(model& all, const model& level)
{
    const std::string name = all.name.empty() ? "text" : all.name;
    if (all.letters.empty()) all.letters.push_back({name, 0, all.vertices.size(), 0, all.parts.size()});
    all.letters.push_back({name + "_lod" + std::to_string(all.letters.size()), all.vertices.size(),
                           level.vertices.size(), all.parts.size(), level.parts.size()});
    append(all, level, 0.0f);
    all.has_levels = true;
}

/// Gives a mesher what draws the glyphs of the run, if that is not the fonts alone.
void use_source(const options& o, chosen_mesher& mesher)
{
    if (o.layers) mesher.use(o.layers->source());
    if (o.drawing) mesher.use(*o.drawing);
    if (o.placed_icons) mesher.use(*o.placed_icons);
}

/// The whole mesh, in which the letters of each solid that tags ask for are planned apart. Their backs lie in one plane.
typemesh::result<void> write_solids(const options& o, font_set& font, const typemesh::glyph_run& page,
                                    typemesh::text_options how, model& out)
{
    chosen_mesher mesher{font};
    use_source(o, mesher);
    for (std::uint32_t solid = 0; solid < solids_of(o); ++solid) {
        typemesh::glyph_run run;
        const auto is_its = [&](typemesh::style_id s) noexcept { return solid_of_style(o, s) == solid; };
        if (const auto done = typemesh::select_glyphs(page, is_its, run); !done) return done.error();
        if (run.glyphs.empty()) continue;
        const options own = options_of_solid(o, solid);
        choose_policies(own, font.units_per_em(), mesher);
        how.merge = own.merge;
        const auto plan = mesher.plan(run, how);
        if (!plan) return plan.error();
        model some;
        if (const auto done = write_model(own, *plan, some); !done) return done.error();
        if (o.kind == file_kind::stl) some.indices = solid_by_solid(*plan, some.indices);
        const bool behind = !(o.depth > 0.0f) && o.marked->styles.solids()[solid].has(typemesh::markup_tag::mark);
        const double step =
            behind ? -0.01 : double{own.depth} - double{o.depth};  // flat backgrounds are not in the way
        append(out, some, static_cast<float>(step * how.size));
    }
    return {};
}

bool is_stacked(const options& o) { return (o.layers || o.drawing) && o.colour_layers == typemesh::layer_cut::stacked; }

/// The whole mesh of a run with stacked layers, which `source` draws. The lowest level is as deep as the text, and each
/// further level a thin solid on the front of the level below it.
template <class Source>
typemesh::result<void> write_levels(const options& o, Source& source, const typemesh::glyph_run& page,
                                    const typemesh::text_options& how, model& out)
{
    chosen_mesher mesher{source};
    for (std::uint32_t level = 0; level < source.level_count(); ++level) {
        typemesh::glyph_run run;
        const auto is_its = [&](typemesh::style_id s) noexcept { return source.level_of(s) == level; };
        if (const auto done = typemesh::select_glyphs(page, is_its, run); !done) return done.error();
        if (run.glyphs.empty()) continue;
        options own = o;
        if (level != 0) own.depth = colour_layers::step;
        choose_policies(own, source.units_per_em(), mesher);
        const auto plan = mesher.plan(run, how);
        if (!plan) return plan.error();
        model some;
        if (const auto done = write_model(own, *plan, some); !done) return done.error();
        if (level != 0) stand_on(some, level, how.size);
        append(out, some, 0.0f);
    }
    return {};
}

typemesh::result<void> write_levels(const options& o, const typemesh::glyph_run& page,
                                    const typemesh::text_options& how, model& out)
{
    return o.drawing ? write_levels(o, *o.drawing, page, how, out)
                     : write_levels(o, o.layers->source(), page, how, out);
}

/// Makes the parts of each colour a solid, so that they are sewn to no other colour's: in layers of colours each of them
/// is closed, and they touch along walls. A letter and the ring around it stay two.
void part_colours_from_each_other(model& mesh)
{
    std::vector<std::optional<rgb_colour>> seen;
    for (model::part& p : mesh.parts) {
        const auto known = std::find(seen.begin(), seen.end(), p.colour);
        p.solid += 2 * static_cast<unsigned>(known - seen.begin());
        if (known == seen.end()) seen.push_back(p.colour);
    }
}

/// Gives an empty string, or one sentence.
std::string write_output(const options& o, const chosen_plan& plan, model& mesh, file_set& files)
{
    switch (o.kind) {
    case file_kind::glb: return write_glb(mesh, o.output, files);
    case file_kind::obj: return write_obj(mesh, o.output, files);
    case file_kind::ply: return write_ply(mesh, o.output, files);
    case file_kind::three_mf:
        if (o.layers || o.drawing || o.placed_icons) part_colours_from_each_other(mesh);
        return write_3mf(sewn(mesh), o.output, files);
    case file_kind::stl: {
        if (solids_of(o) == 1 && !o.plate.is_on) mesh.indices = solid_by_solid(plan, mesh.indices);
        mesh.parts.clear();
        return write_stl(mesh, o.output, files);
    }
    case file_kind::svg:
    case file_kind::dxf:
    case file_kind::png:
    case file_kind::unknown: break;
    }
    return {};
}

/// Why a text cannot be planned; of an option that no check of the command line can know, as it depends on the font, by
/// its name there.
std::string refusal_in_words(const options& o, const typemesh::error& e)
{
    if (e.code != typemesh::error::bad_option) return in_words(e);
    if (o.plate.is_on) return plate_refusal_in_words(o, e);
    const std::string_view option = e.option;
    constexpr float narrow = 1e-4f;  // a ring is refused that is narrower than a few cells
    if (option == "max_edge") return "--max-edge is too small for this font: give a larger number.";
    if (option == "outlined::width")
        return o.outline.width < narrow ? "--outline is too narrow for this font: give a larger number."
                                        : "--outline is too wide for this font: give a smaller number.";
    if (option != "width") return in_words(e);
    return std::string{o.taper > 0.0f ? "--taper" : "--bevel"} + " is too wide for this font: give a smaller number.";
}

/// The tolerance in em of the picture's own mesh, by the size at which it will be drawn; but the requested one where
/// the picture is to show it. `bounds` belong to the text, one em large.
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
std::string draw_picture(const options& o, font_set& font, const typemesh::glyph_run& page, file_set& files)
{
    picture_options look;
    look.shading = o.shading;
    look.yaw = o.turn;
    look.wireframe = o.show_triangles;
    look.texture = o.checker ? texture::checker : texture::none;

    chosen_mesher mesher{font};
    use_source(o, mesher);
    choose_policies(o, font.units_per_em(), mesher);
    typemesh::text_options how = text_options_of(o);
    how.size = 1.0;
    typemesh::bounds3 bounds;  // of a mesh of the picture's size: the file's bounds may be too small to differ
    if (const auto first = mesher.plan(page, how))
        bounds = first->bounds();
    else
        return in_words(first.error());
    how.tolerance = picture_tolerance(o, bounds, look);
    auto plan = mesher.plan(page, how);
    if (!plan) return in_words(plan.error());
    model mesh;
    const auto done = o.plate.is_on       ? plate_model{o, font}.make(*plan, page, how, mesh)
                      : is_stacked(o)     ? write_levels(o, page, how, mesh)
                      : solids_of(o) == 1 ? write_model(o, *plan, mesh)
                                          : write_solids(o, font, page, how, mesh);
    if (!done) return refusal_in_words(o, done.error());
    int width = 0, height = 0;
    const overlay over = annotate(o, font, plan->run(), plan->glyphs(), mesh);
    const auto pixels = draw(mesh, over, look, width, height);
    return write_png(pixels, width, height, o.picture, files);
}

/// Warns the user about a plan. Gives why nothing is written, or an empty string.
std::string name_warnings(const options& o, const chosen_plan& plan, const font_set& fonts)
{
    bool warned = name_missing_features(fonts, o.features, o.who);
    if (o.layers) warned = name_colour_losses(o.layers->report(), o.who) || warned;
    if (o.drawing) warned = o.drawing->name_losses(o.who) || warned;
    if (o.placed_icons) warned = o.placed_icons->name_losses(o.who) || warned;
    const std::u32string missing = missing_characters(plan.run(), o.text, fonts);
    warned = name_losses(plan.report(), o.family || !o.fallback.empty(), o.who, missing) || warned;
    if (!o.output.empty() && !o.instances && !o.plate.is_on) {
        const bool instances_help = o.kind == file_kind::glb && !o.merge;
        warned = name_flipped_triangles(flipped_triangles(plan), instances_help, o.who) || warned;
    }
    if (warned && o.strict) return "--strict: nothing is written.";
    if ((o.output.empty() && o.picture.empty()) || !plan.glyphs().empty()) return {};
    if (o.drawing) return "the drawing is blank: nothing is written.";
    return plan.report().complete() ? "the text is blank: nothing is written."
                                    : "no character of the text can be drawn: nothing is written.";
}

/// Where the glyphs of a run stand, to be put back after a mesh elsewhere.
class moved_run {
public:
    explicit moved_run(typemesh::glyph_run& run) : run_{&run} {}
    moved_run(const moved_run&) = delete;
    moved_run& operator=(const moved_run&) = delete;
    ~moved_run()
    {
        for (std::size_t i = 0; i < before_.size(); ++i) run_->glyphs[i].origin = before_[i];
    }
    /// In font units. Called once.
    void by(typemesh::point way)
    {
        for (typemesh::placed_glyph& g : run_->glyphs) {
            before_.push_back(g.origin);
            g.origin = g.origin + way;
        }
    }
    [[nodiscard]] bool has_moved() const { return !before_.empty(); }
    [[nodiscard]] const typemesh::glyph_run& run() const { return *run_; }

private:
    typemesh::glyph_run* run_;
    std::vector<typemesh::point> before_;
};

typemesh::bounds3 bounds_of_mesh(const model& mesh)
{
    const mesh_facts f = facts_of(mesh);
    const auto place = [](const double* at) {
        return typemesh::vec3{static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
    };
    return {place(f.low), place(f.high)};
}

/// The bounds of what is made of a plan.
using measure = std::function<typemesh::result<typemesh::bounds3>(const chosen_plan&)>;

/// Plans the text as large as the box of --fit has it, and where --anchor and --origin put it: for that it is planned
/// again. `up` is by how much the mesh has to be lifted then.
typemesh::result<chosen_plan> placed_plan(const options& o, chosen_mesher& mesher, typemesh::text_options& how,
                                          moved_run& moved, const measure& bounds_of, double& up)
{
    auto plan = mesher.plan(moved.run(), how);
    if (!plan || plan->glyphs().empty()) return plan;
    auto b = bounds_of(*plan);
    if (!b) return b.error();
    if (o.fit_width > 0.0) {
        constexpr double rounding = 4e-7;  // what is seen must not be larger than the box by a float's last digit
        const double width = double{b->high.x} - double{b->low.x}, height = double{b->high.y} - double{b->low.y};
        how.size *= (1.0 - rounding) * std::min(o.fit_width / width, o.fit_height / height);
        plan = mesher.plan(moved.run(), how);
        if (!plan) return plan;
        b = bounds_of(*plan);
        if (!b) return b.error();
    }
    const shift by = o.output.empty() ? shift{} : shift_of(o.place, *b);
    up = by.z;
    if (by.x == 0.0 && by.y == 0.0) return plan;
    const double units = moved.run().units_per_em / how.size;
    moved.by({by.x * units, by.y * units});
    return mesher.plan(moved.run(), how);
}

/// Why lift() has failed.
std::string heights_lost(const options& o)
{
    return o.place.at[2] != 0.0
               ? "--origin: z is so large that 32-bit numbers cannot hold the depth of the letters: give a smaller z."
               : "32-bit numbers cannot hold so flat a bevel so far from z = 0: give --anchor front.";
}

/// One text with open fonts. Every call gives an empty string, or one sentence.
class one_text {
public:
    one_text(const options& o, progress& tell, font_set& font) : o_{o}, tell_{tell}, font_{font} {}

    std::string make()
    {
        if (!o_.morph.axis.empty()) return make_morph();
        tell_.begin("shaping the text and building its letters");
        typemesh::text_options how = text_options_of(o_);
        stage_clock clock{.tell = &tell_};
        clock(typemesh::stage::shape);
        if (o_.drawing) {
            if (const auto done = o_.drawing->lay_out(page_, holds_colours(o_.kind)); !done)
                return in_words(done.error());
        } else if (std::string trouble = lay_out(o_, font_, page_, how.size); !trouble.empty()) {
            return trouble;
        }
        clock(typemesh::stage::idle);
        if (o_.layers)
            if (std::string trouble = o_.layers->split(page_); !trouble.empty()) return trouble;
        if (o_.placed_icons)
            if (const auto done = o_.placed_icons->place(page_, holds_colours(o_.kind)); !done)
                return in_words(done.error());
        const std::vector<typemesh::glyph_style> glyph_styles(page_.glyph_styles.begin(), page_.glyph_styles.end());
        if (!holds_colours(o_.kind))  // else letters of different colours would not merge
            keep_only_solids(o_, page_);
        chosen_mesher mesher{font_, typemesh::observer_ref{clock}};
        use_source(o_, mesher);
        options of_file = o_;
        if (o_.kind == file_kind::three_mf) of_file.normals = normals_name::shared;  // see write_3mf()
        choose_policies(of_file, font_.units_per_em(), mesher);
        if (std::string trouble = make_mesh(of_file, mesher, how, clock); !trouble.empty()) return trouble;
        if (!o_.picture.empty()) {
            tell_.begin("drawing " + o_.picture);
            std::copy(glyph_styles.begin(), glyph_styles.end(), page_.glyph_styles.begin());
            if (o_.drawing)
                if (const auto done = o_.drawing->lay_out(page_, true); !done) return in_words(done.error());
            if (std::string trouble = draw_picture(o_, font_, page_, files_); !trouble.empty()) return trouble;
        }
        tell_.clear();
        if (o_.stats && !stats_.empty() && (std::fputs(stats_.c_str(), stdout) < 0 || std::fflush(stdout) != 0))
            return "the statistics cannot be written.";
        if (std::string trouble = files_.finish(); !trouble.empty()) return trouble;
        if (o_.stats || o_.output.empty() || o_.output == standard_output) return {};
        if (curves_.empty()) curves_ = size_in_words(facts_, is_printed(o_.kind)) + levels_;
        std::puts((o_.output + ": " + curves_).c_str());
        return std::fflush(stdout) == 0 ? std::string{} : "the size cannot be printed.";
    }

private:
    std::string make_morph()
    {
        tell_.begin("making the morph");
        std::string said;
        std::string trouble = write_morph(o_, font_.font(0), files_, said);
        tell_.clear();
        if (trouble.empty()) trouble = files_.finish();
        if (!trouble.empty() || o_.output == standard_output) return trouble;
        std::puts(said.c_str());
        return {};
    }

    std::string make_mesh(const options& of_file, chosen_mesher& mesher, typemesh::text_options& how,
                          stage_clock& clock)
    {
        moved_run moved{page_};
        double up = 0.0;
        model mesh;
        mesh.name = o_.drawing ? std::filesystem::path{o_.svg}.stem().string() : o_.text;
        mesh.as_manifold = o_.manifold;
        std::optional<plate_model> plate;
        if (o_.plate.is_on) plate.emplace(o_, font_);
        const auto bounds_of = [&](const chosen_plan& of) -> typemesh::result<typemesh::bounds3> {
            if (!plate) return of.bounds();
            if (const auto done = plate->make(of, page_, how, mesh); !done) return done.error();
            return bounds_of_mesh(mesh);
        };
        auto plan = placed_plan(o_, mesher, how, moved, bounds_of, up);
        if (!plan) return refusal_in_words(o_, plan.error());
        tell_.clear();
        if (std::string trouble = name_warnings(o_, *plan, font_); !trouble.empty()) return trouble;
        if (plate && moved.has_moved())
            if (const auto done = plate->make(*plan, page_, how, mesh); !done)
                return refusal_in_words(o_, done.error());
        if (plate && plate->name_faults() && o_.strict) return "--strict: nothing is written.";
        if (plate) levels_ = plate->bridges_in_words();

        if (holds_curves(o_.kind) && !o_.stats) {  // no mesh is needed
            tell_.begin("writing " + o_.output);
            return write_curves(o_, font_, page_, how, files_, curves_);
        }
        tell_.begin("making " + std::to_string(plan->size().triangles) + " triangles");
        clock(typemesh::stage::extrude);
        const auto written = plate                ? typemesh::result<void>{}
                             : o_.instances       ? write_letters(o_, *plan, font_, mesh)
                             : is_stacked(o_)     ? write_levels(of_file, page_, how, mesh)
                             : solids_of(o_) == 1 ? write_model(o_, *plan, mesh)
                                                  : write_solids(of_file, font_, page_, how, mesh);
        clock(typemesh::stage::idle);
        if (!written) return in_words(written.error());
        if (const auto told = tell_letters(o_, *plan, mesh); !told) return in_words(told.error());
        if (!lift(mesh, up)) return heights_lost(o_);
        facts_ = facts_of(mesh);
        if (plate && o_.kind == file_kind::glb) part_solids(mesh);
        if (o_.stats) {
            const typemesh::mesh_size size =
                plate ? typemesh::mesh_size{mesh.vertices.size(), mesh.indices.size() / 3} : plan->size();
            stats_ = stats_of(*plan, size, quality_of_front(mesh), facts_, is_printed(o_.kind), clock);
        }
        if (o_.output.empty()) return {};
        if (std::string trouble = add_levels(mesher, how, up, mesh); !trouble.empty()) return trouble;
        tell_.begin("writing " + o_.output);
        if (holds_curves(o_.kind)) return write_curves(o_, font_, page_, how, files_, curves_);
        return write_output(o_, *plan, mesh, files_);
    }

    /// Adds the coarser levels of detail; the plan of the finest one ends.
    std::string add_levels(chosen_mesher& mesher, const typemesh::text_options& how, double up, model& mesh)
    {
        if (!o_.lod.empty()) levels_ = "; triangles of the levels: " + std::to_string(mesh.indices.size() / 3);
        for (std::size_t level = 1; level <= o_.lod.size(); ++level) {
            use_level(o_, level, mesher);
            const auto coarser = mesher.plan(page_, how);
            if (!coarser) return refusal_in_words(o_, coarser.error());
            model made;
            if (const auto done = write_model(o_, *coarser, made); !done) return in_words(done.error());
            if (!lift(made, up)) return heights_lost(o_);
            levels_ += ", " + std::to_string(made.indices.size() / 3);
            add_level(mesh, made);
        }
        return {};
    }

    const options& o_;
    progress& tell_;
    font_set& font_;
    typemesh::glyph_run page_;
    file_set files_;
    mesh_facts facts_;
    std::string stats_;
    std::string levels_;  // what is said of levels of detail, and of bridges
    std::string curves_;  // what is said of the file
};

/// One text. Gives an empty string, or one sentence.
std::string run(const options& o, progress& tell, font_set& fonts)
{
    if (!o.markup)
        if (const std::string trouble = refused_ranges(o.styles, o.text); !trouble.empty())
            return "--style: " + trouble + ".";
    return one_text{o, tell, fonts}.make();
}

/// Reads the files of --icon, as finely as the largest of their boxes in any text needs. Gives an empty string, or one
/// sentence.
std::string open_icons(options& o, const std::vector<text_job>& jobs, font_set& fonts)
{
    double side = 1.0;
    for (const text_job& job : jobs) side = std::max(side, largest_box(job.text, o.icons.size()));
    auto icons = std::make_shared<text_icons>(fonts);
    if (std::string trouble = icons->open(o, side); !trouble.empty()) return trouble;
    o.placed_icons = std::move(icons);
    return {};
}

/// All texts, one after the other. Gives the program's exit status.
int run_all(options& o)
{
    const auto complain = [&](const std::string& trouble) {
        std::fprintf(stderr, "%s%s\n", o.who.c_str(), trouble.c_str());
        return 1;
    };
    std::vector<text_job> jobs;
    if (const std::string wrong = read_texts(o, jobs); !wrong.empty()) return complain(wrong);
    text_fonts fonts;
    std::string trouble;
    {
        progress tell;
        tell.begin("opening the fonts");
        trouble = fonts.open(o);
    }
    if (trouble.empty() && !o.icons.empty()) trouble = open_icons(o, jobs, fonts.set());
    if (!trouble.empty()) return complain(trouble);
    int status = 0;
    for (const text_job& job : jobs) {
        o.text = job.text;
        o.output = job.output;
        o.picture = job.picture;
        if (job.line != 0) o.who = "text_to_mesh: line " + std::to_string(job.line) + ": ";
        {
            progress tell;
            trouble = o.markup ? read_markup(o) : std::string{};
            if (o.colour_layers && !o.layers && o.svg.empty())
                o.layers = std::make_shared<colour_layers>(fonts.set(), o);
            if (!o.svg.empty()) {
                o.drawing = std::make_shared<svg_layers>();
                trouble = o.drawing->open(o.svg, o.tolerance, o.colour_layers.value_or(typemesh::layer_cut::visible),
                                          o.colour.value_or(rgb_colour{{0, 0, 0}}));
            }
            if (trouble.empty()) trouble = run(o, tell, fonts.set());
        }
        if (!trouble.empty()) status = complain(trouble);
    }
    return status;
}

}  // namespace
}  // namespace text_to_mesh

int main(int argc, char** argv)
{
    text_to_mesh::options o;
    if (const auto status = text_to_mesh::parse(argc, argv, o)) return *status;
    return text_to_mesh::run_all(o);
}
