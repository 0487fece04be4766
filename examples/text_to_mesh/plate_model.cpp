// SPDX-License-Identifier: MIT
#include "plate_model.hpp"

#include "colour_names.hpp"
#include "report.hpp"

#include <typemesh/core/contours.hpp>

#include <algorithm>
#include <cstdio>
#include <string_view>
#include <utility>
#include <vector>

namespace text_to_mesh {
namespace {

using namespace typemesh;

/// What a part is called. The letters' own parts have the names of a text's.
std::string_view name_of(plate_style style, plate_part p)
{
    const bool stands = style == plate_style::standing;
    switch (p) {
    case plate_part::front: return stands ? "front" : "plate_front";
    case plate_part::back: return "plate_back";
    case plate_part::rim: return "plate_side";
    case plate_part::front_bevel: return stands ? "front_bevel" : "plate_front_bevel";
    case plate_part::back_bevel: return "plate_back_bevel";
    case plate_part::floor_bevel: return "plate_front_bevel";
    case plate_part::floor: return stands ? "plate_front" : "pocket_front";
    case plate_part::wall: break;
    }
    return stands ? "side" : style == plate_style::cut ? "cut_side" : "pocket_side";
}

/// Whether a part has the colour of the text.
bool is_text(std::string_view name)
{
    return name == "front" || name == "front_bevel" || name == "side" || name == "inlay" || name.starts_with("pocket_");
}

std::string in_em(float n)
{
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.3g em", static_cast<double>(n));
    return digits;
}

options outline_of(const options& o)
{
    options own = o;
    own.embolden += o.plate.growth;
    return own;
}

}  // namespace

plate_model::plate_model(const options& o, font_set& font) : o_{o}, bolder_{font}
{
    choose_policies(outline_of(o), font.units_per_em(), bolder_);
}

result<void> plate_model::make(const chosen_plan& text, const glyph_run& page, const text_options& how, model& out)
{
    plate_options own = o_.plate.how;
    own.corners = o_.corners;
    out.vertices.clear();
    out.indices.clear();
    out.parts.clear();
    out.solid_names.clear();
    if (o_.plate.follows) {
        const auto outline = bolder_.plan(page, how);
        if (!outline) return outline.error();
        if (const auto done = plate_.plan(text, *outline, own, constrained_delaunay{}); !done) return done.error();
    } else if (const auto done = plate_.plan(text, own, constrained_delaunay{}); !done) {
        return done.error();
    }
    for (std::size_t k = 0; k < plate_.solid_count(); ++k)
        if (const auto done = add_solid(k, out); !done) return done.error();
    if (plate_.solid_count() > 1) out.solid_names = {"plate", "inlay"};
    return {};
}

result<void> plate_model::add_solid(std::size_t k, model& out) const
{
    constexpr auto vertex =
        [](const surface_point<attribute::position | attribute::normal | attribute::uv>& s) noexcept {
            return model_vertex{
                {s.position.x, s.position.y, s.position.z}, {s.normal.x, s.normal.y, s.normal.z}, {s.uv.x, s.uv.y}};
        };
    std::vector<model_vertex> vertices;
    std::vector<std::uint32_t> indices;
    if (const auto done = plate_.write(k, into(vertices, indices, vertex)); !done) return done.error();
    const std::size_t first_index = out.indices.size();
    const auto first = static_cast<std::uint32_t>(out.vertices.size());
    out.vertices.insert(out.vertices.end(), vertices.begin(), vertices.end());
    for (const std::uint32_t i : indices) out.indices.push_back(first + i);
    const auto add = [&](std::string_view name, std::size_t index, std::size_t count) {
        if (count == 0) return;
        model::part made{std::string{name}, first_index + index, count, static_cast<unsigned>(k)};
        if (o_.colour && is_text(name)) {
            made.colour = o_.colour;
            made.name += "_" + text_to_mesh::name_of(*o_.colour);
        }
        out.parts.push_back(std::move(made));
    };
    if (plate_.solid_count() > 1) {  // one material each
        add(k == 0 ? "plate" : "inlay", 0, indices.size());
        return {};
    }
    for (const plate_part p : all_plate_parts) {
        const mesh_range r = plate_.solid(k).range(p);
        add(name_of(o_.plate.how.style, p), r.first_index, r.index_count);
    }
    return {};
}

std::uint32_t plate_model::pieces_of(cell_set cells)
{
    workspace space;
    contours loops;
    const auto made = plate_.cells().trace(cells, space, loops);
    return made ? made->outers() : 0;
}

bool plate_model::name_faults()
{
    const auto say = [this](const std::string& line) {
        std::fprintf(stderr, "%s%s\n", o_.who.c_str(), line.c_str());
        return true;
    };
    bool any = false;
    const std::uint32_t loose = plate_.stencil().loose, whole = pieces_of(name_plate::body());
    const bool cut = o_.plate.how.style == plate_style::cut;
    const std::uint32_t left = cut ? pieces_of(name_plate::body() & ~name_plate::text()) : whole;
    if (loose > 0)
        any = say(std::to_string(loose) + (loose == 1 ? " island" : " islands") +
                  " of the stencil would fall out: no bridge reaches the plate.");
    else if (left > whole && !(o_.plate.how.bridge_width > 0.0f))
        any = say("the plate falls into " + std::to_string(left) + " pieces: --stencil holds them together.");
    if (whole > 1)
        any = say("the plate has " + std::to_string(whole) + " pieces" +
                  (o_.plate.follows ? ": give a larger --backing." : "."));
    const plate_rims& rims = plate_.rims();
    const auto is_less = [](float reached, float wanted) { return reached < 0.95f * wanted; };
    if (rims.bevels != 0 && is_less(rims.bevel, o_.plate.how.bevel))
        any = say(rims.bevel > 0.0f ? "some bevels are only " + in_em(rims.bevel) + " wide: more does not fit."
                                    : "some rims have no bevel: it does not fit.");
    if (is_less(rims.fillet, o_.plate.how.fillet))
        any = say(rims.fillet > 0.0f ? "the radius of the fillet is only " + in_em(rims.fillet) + ": more does not fit."
                                     : "the letters have no fillet: it does not fit.");
    if (o_.corners != touching::keep && !plate_.is_manifold())
        any = say("corners of the plate still touch in spite of --touching.");
    return any;
}

std::string plate_model::bridges_in_words() const
{
    const stencil_report& made = plate_.stencil();
    if (!(o_.plate.how.bridge_width > 0.0f)) return {};
    return "; " + std::to_string(made.bridges) + (made.bridges == 1 ? " bridge holds " : " bridges hold ") +
           std::to_string(made.islands) + (made.islands == 1 ? " island" : " islands");
}

std::string plate_refusal_in_words(const options& o, const error& e)
{
    if (e.code != error::bad_option) return in_words(e);
    const std::string_view option = e.option;
    const auto too_large = [](const char* name) {
        return std::string{name} + " is too large for a plate of this text: give a smaller number.";
    };
    if (option == "margin")
        return o.plate.how.margin < 0.0f ? "--plate: the margin is so negative that nothing is left of the plate."
                                         : too_large("--plate");
    if (option == "radius" || option == "thickness") return too_large("--plate");
    if (option == "bevel") return too_large("--bevel");
    if (option == "ring_hole" || option == "ring_width") return too_large("--keyring");
    if (option == "bridge_width") return too_large("--stencil");
    if (option == "by") return too_large("--backing");
    if (option == "top" || option == "depth")
        return "the letters' depth is too small beside the plate's thickness: 32-bit numbers do not tell them apart.";
    return in_words(e);
}

void part_solids(model& mesh)
{
    for (std::size_t k = 0; k < mesh.solid_names.size(); ++k) {
        model::letter l{mesh.solid_names[k], mesh.vertices.size(), 0, mesh.parts.size(), 0};
        std::size_t end = 0;
        for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
            const model::part& part = mesh.parts[p];
            if (part.solid != k) continue;
            l.first_part = (std::min)(l.first_part, p);
            ++l.part_count;
            for (std::size_t i = part.first_index; i < part.first_index + part.index_count; ++i) {
                l.first_vertex = (std::min)(l.first_vertex, std::size_t{mesh.indices[i]});
                end = (std::max)(end, std::size_t{mesh.indices[i]} + 1);
            }
        }
        l.vertex_count = end - l.first_vertex;
        mesh.letters.push_back(l);
        mesh.places.push_back({k, {0.0f, 0.0f, 0.0f}});
    }
}

}  // namespace text_to_mesh
