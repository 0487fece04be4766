// SPDX-License-Identifier: MIT
#include "settle_output.hpp"

#include "atomic_file.hpp"
#include "option_values.hpp"

#include <algorithm>
#include <string_view>

namespace text_to_mesh {
namespace {

/// Decides which place comes to the origin. Gives an empty string, or what is wrong.
std::string settle_place(options& out, const raw_options& raw)
{
    for (const char* option : {"--anchor", "--origin"}) {
        const bool anchor = option == std::string_view{"--anchor"};
        const std::string& given = anchor ? raw.anchor : raw.origin;
        if (given.empty()) continue;
        if (out.output.empty()) return std::string{option} + " needs --output";
        const std::string trouble = anchor ? read_anchor(given, out.place) : read_origin(given, out.place);
        if (!trouble.empty()) return std::string{option} + " " + trouble;
    }
    if (out.place.z == placing::depth::automatic && is_printed(out.kind)) out.place.z = placing::depth::base;
    return {};
}

/// Finishes levels of detail. Gives an empty string, or one sentence of what is wrong.
std::string settle_levels(options& out, const raw_options& raw)
{
    if (raw.lod.empty()) return {};
    if (const std::string trouble = read_levels(raw.lod, out.lod); !trouble.empty()) return "--lod " + trouble;
    if (out.kind != file_kind::glb) return "--lod needs --output FILE.glb";
    if (out.instances) return "--lod does not work with --instances";
    if (out.embolden != 0.0f) return "--lod does not work with --embolden";
    if (out.discretiser == discretiser_name::certified && out.lod.front() <= out.tolerance)
        return "--lod must be above the finest distance, which --quality or --tolerance gives: " + raw.lod;
    return {};
}

/// Why letters cannot be instances, or an empty string.
std::string refused_instances(const options& o, const raw_options&)
{
    return o.instances && o.kind != file_kind::glb ? "--instances needs --output FILE.glb" : std::string{};
}

/// Why the file cannot distinguish letters, or an empty string.
std::string refused_letters(const options& o, const raw_options&)
{
    const std::string option = o.per_letter ? "--per-letter" : "--letters";
    if (!o.letters && !o.per_letter) return {};
    if (o.kind != file_kind::glb) return option + " needs --output FILE.glb";
    if (!o.lod.empty()) return option + " does not work with --lod";
    if (o.instances) return option + " does not work with --instances, whose meshes are shared by several letters";
    return {};
}

/// Why the file cannot say that it is a manifold, or an empty string.
std::string refused_manifold(const options& o, const raw_options&)
{
    if (!o.manifold) return {};
    if (o.kind != file_kind::glb) return "--manifold needs --output FILE.glb";
    if (!o.lod.empty() || o.instances || o.per_letter || !o.morph.axis.empty())
        return "--manifold needs one mesh: leave out --lod, --instances, --per-letter and --morph";
    if (o.depth == 0.0f) return "--manifold needs a solid, but --depth 0 makes a flat mesh: give a larger --depth";
    return {};
}

/// Finishes a morph. Gives an empty string, or one sentence of what is wrong.
std::string settle_morph(options& out, const raw_options& raw)
{
    if (raw.morph.empty()) return {};
    if (const std::string trouble = read_morph(raw.morph, out.morph); !trouble.empty()) return "--morph " + trouble;
    if (out.kind != file_kind::glb) return "--morph needs --output FILE.glb";
    if (out.instances || !out.lod.empty()) return "--morph does not work with --instances or --lod";
    if (out.family || !out.fallback.empty()) return "--morph needs one font: give it with --font";
    if (out.markup || !out.styles.empty()) return "--morph does not work with --markup or --style";
    if (typemesh::is_finite(out.lines.width) || !raw.fit.empty() || out.merge || !out.picture.empty())
        return "--morph sets plain lines of letters: leave out --width, --fit, --merge and --picture";
    if (out.bevel.width > 0.0f || out.carve.tool_angle > 0.0f || out.embolden != 0.0f || out.outline.width > 0.0f ||
        out.inflate.height > 0.0f || out.tube.radius > 0.0f || out.refine.refiner != refiner_name::none ||
        !raw.bend.empty() || !raw.path.empty() || out.segments != 1)
        return "--morph makes plain solids: leave out bevels and whatever else changes their form";
    for (const char* option :
         {"--stats", "--colour-layers", "--letters", "--per-letter", "--anchor", "--origin", "--touching"})
        if (is_given(raw, option)) return std::string{option} + " does not work with --morph";
    return {};
}

/// Finishes the layers of colour glyphs. Gives an empty string, or one sentence of what is wrong.
std::string settle_colour_layers(options& out, const raw_options& raw)
{
    if (raw.colour_layers.empty()) return {};
    if (raw.colour_layers != "visible" && raw.colour_layers != "stacked")
        return "--colour-layers must be visible or stacked, not " + raw.colour_layers;
    const bool stacked = raw.colour_layers == "stacked";
    out.colour_layers = stacked ? typemesh::layer_cut::stacked : typemesh::layer_cut::visible;
    if (!out.output.empty() && !holds_colours(out.kind))
        return "--colour-layers needs a file with colours: .glb, .obj, .3mf or .svg";
    if (out.markup) return "--colour-layers does not work with --markup";
    if (out.discretiser != discretiser_name::certified) return "--colour-layers needs --discretiser certified";
    if (out.show_contours || out.show_points || out.show_control) return "--colour-layers does not work with --show";
    if (!stacked) return {};
    if (out.depth <= 0.0f) return "--colour-layers=stacked needs --depth above 0";
    if (out.instances) return "--colour-layers=stacked does not work with --instances";
    if (!out.lod.empty()) return "--colour-layers=stacked does not work with --lod";
    if (out.bevel.width > 0.0f || out.carve.tool_angle > 0.0f || out.inflate.height > 0.0f || out.tube.radius > 0.0f)
        return "--colour-layers=stacked does not work with bevelled, carved, inflated or tube letters";
    return {};
}

/// Why letters cannot be strokes, or an empty string.
std::string refused_stroke(const options& o, const raw_options& raw)
{
    if (o.stroke.width == 0.0) return {};
    if (o.bend.warp.index() != 0) return "--stroke does not work with a --bend in the plane";
    if (!raw.path.empty()) return "--stroke does not work with --path";
    if (!raw.morph.empty()) return "--stroke does not work with --morph";
    if (o.colour_layers) return "--stroke does not work with --colour-layers";
    if (o.instances) return "--stroke does not work with --instances";
    return {};
}

/// Why there can be no file of curves, or an empty string.
std::string refused_curves(const options& o, const raw_options& raw)
{
    if (!holds_curves(o.kind)) return {};
    const std::string file = o.kind == file_kind::svg ? "A .svg file" : "A .dxf file";
    const bool formed = o.bevel.width > 0.0f || o.carve.tool_angle > 0.0f || o.outline.width > 0.0f ||
                        o.inflate.height > 0.0f || o.refine.refiner != refiner_name::none || o.bend.is_on ||
                        o.tube.radius > 0.0f;
    if (formed) return file + " has the letters' outlines: leave out bevels and whatever else is made of solids";
    if (!o.svg.empty() && (o.embolden != 0.0f || o.bend.warp.index() != 0))
        return file + " has the outlines of --svg: leave out --embolden and --bend";
    if (o.colour_layers == typemesh::layer_cut::stacked) return file + " has no stacked layers";
    if (o.markup) return file + " does not work with --markup";
    if (!o.picture.empty() || o.stats) return {};  // which show the solids
    for (const char* option : {"--depth", "--segments", "--normals", "--crease", "--uv"})
        if (is_given(raw, option))
            return std::string{option} + " does not work with a" + file.substr(1) + ", which contains outlines";
    return {};
}

/// Why options for the picture are refused, or an empty string.
std::string refused_picture(const options& o, const raw_options& raw)
{
    if (!o.picture.empty()) return {};
    const std::string lost = first_given(raw, {"--show", "--shading", "--turn"});
    return lost.empty() ? lost : lost + " needs --picture";
}

/// Why options for the distance to the curves are refused, or an empty string.
std::string refused_quality(const options& o, const raw_options& raw)
{
    if (o.discretiser != discretiser_name::certified && is_given(raw, "--tolerance"))
        return "--tolerance needs --discretiser certified: adaptive uses --quality, and two_lines uses neither";
    if (o.discretiser == discretiser_name::two_lines && o.quality_given)
        return "--quality does not work with --discretiser two_lines, which makes two lines of every curve";
    return {};
}

}  // namespace

std::string settle_files(options& out, const raw_options& raw)
{
    const bool piped = out.output == standard_output;
    out.kind = kind_of(out.output);
    if (!raw.format.empty()) {
        if (out.output.empty()) return "--format needs --output";
        const file_kind wanted = kind_of_format(raw.format);
        if (out.kind != file_kind::unknown && out.kind != wanted)
            return "--format is " + raw.format + ", but the name of --output is " + out.output;
        if (wanted == file_kind::obj && out.output.ends_with(".mtl"))
            return "--output must not end in .mtl, because the materials of an .obj file have such a name";
        out.kind = wanted;
    }
    if (piped && raw.format.empty()) return "--output - needs --format, because standard output has no file name";
    if (!out.output.empty() && (out.kind == file_kind::unknown || out.kind == file_kind::png))
        return "--output must end in .glb, .obj, .stl, .ply, .3mf, .svg or .dxf, not " + out.output;
    if (!out.picture.empty() && out.picture != standard_output && kind_of(out.picture) != file_kind::png)
        return "--picture must end in .png, not " + out.picture;
    if (out.output.empty() && out.picture.empty() && !out.stats)
        return "there is nothing to do: give --output, --picture or --stats";
    const bool pictured = out.picture == standard_output;
    if (piped && pictured)
        return "--picture - is standard output, which already contains the mesh: write one of them to a file";
    if ((piped || pictured) && out.stats)
        return std::string{"--stats prints on standard output, which already contains the "} +
               (piped ? "mesh" : "picture") + ": write it to a file";
    if (is_printed(out.kind) && out.depth == 0.0f)
        return std::string{"--depth must be more than 0 in a ."} + (out.kind == file_kind::stl ? "stl" : "3mf") +
               " file, which contains solids";
    return {};
}

std::string settle_contents(options& out, const raw_options& raw)
{
    if (std::string trouble = settle_all(out, raw, settle_levels, settle_morph, settle_place, settle_colour_layers,
                                         refused_stroke, refused_curves, refused_picture, refused_quality,
                                         refused_instances, refused_letters, refused_manifold);
        !trouble.empty())
        return trouble;
    using typemesh::touching;
    out.size = raw.size.value_or(has_millimetres(out.kind) ? 10.0 : 1.0);
    out.keeps_apart = raw.no_merge;
    const bool parts = wants_two_faces(out.kind) || out.plate.is_on || out.manifold;
    out.corners = raw.corners.value_or(parts ? touching::part : touching::keep);
    const bool edges_move = out.bevel.width > 0.0f || out.carve.tool_angle > 0.0f || out.outline.width > 0.0f ||
                            out.embolden != 0.0f || out.tube.radius > 0.0f;
    out.merge = out.merge ||
                (!raw.no_merge && !out.instances &&
                 (holds_solids(out.kind) || holds_curves(out.kind) || edges_move || out.corners != touching::keep));
    return {};
}

}  // namespace text_to_mesh
