// SPDX-License-Identifier: MIT
#include "settle_form.hpp"

#include "option_values.hpp"

#include <typemesh/extrude/tapered.hpp>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

namespace text_to_mesh {
namespace {

/// A number in as few digits as tell it.
std::string written(float n)
{
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, n).ptr};
}

/// The profile by its name or its points. Gives an empty string, or what is wrong.
std::string settle_profile(bevel_options& out, const raw_options& raw)
{
    constexpr std::pair<std::string_view, profile_name> known[] = {{"chamfer", profile_name::chamfer},
                                                                   {"round", profile_name::round},
                                                                   {"concave", profile_name::concave},
                                                                   {"stepped", profile_name::stepped},
                                                                   {"engraved", profile_name::engraved}};
    out.profile = profile_name::points;
    for (const auto& [name, profile] : known)
        if (raw.profile == name) out.profile = profile;
    if (out.profile == profile_name::points)
        if (const std::string trouble = read_profile(raw.profile, out.points); !trouble.empty())
            return "--profile " + trouble;
    if (!raw.bevel_steps) return {};
    if (out.profile != profile_name::round && out.profile != profile_name::concave)
        return "--bevel-steps needs --profile round or concave";
    out.steps = static_cast<unsigned>(*raw.bevel_steps);
    return {};
}

/// Whether a profile is as low somewhere as at the wall, so that a bevel of the whole depth would leave nothing there.
bool reaches_down(const bevel_options& o)
{
    if (o.profile == profile_name::stepped || o.profile == profile_name::engraved) return true;
    const auto low = [](typemesh::profile_point p) { return p.t > 0.0f && p.h <= 0.0f; };
    const auto points = o.points.view();
    return o.profile == profile_name::points && std::any_of(points.begin(), points.end(), low);
}

/// Gives the bevel to a plate, which makes the bevels itself. Gives an empty string, or one sentence of what is wrong.
std::string settle_rims(options& out, const raw_options& raw)
{
    if (raw.plate.plate.empty() && raw.plate.backing.empty()) return {};
    if (raw.profile != "chamfer" && raw.profile != "round")
        return "--profile must be chamfer or round on a plate, not " + raw.profile;
    out.plate.how.bevel = out.bevel.width;
    out.plate.how.round_bevels = raw.profile == "round";
    out.bevel.width = 0.0f;
    return {};
}

/// Finishes the bevel. Gives an empty string, or one sentence of what is wrong.
std::string settle_bevel(options& out, const raw_options& raw)
{
    const auto width = static_cast<double>(out.bevel.width);
    if (std::string trouble = settle_profile(out.bevel, raw); !trouble.empty()) return trouble;
    if (width == 0.0) {
        const std::string lost = first_given(
            raw, {"--bevel-depth", "--profile", "--bevel-steps", "--bevel-mode", "--bevel-sides", "--bevel-out"});
        return lost.empty() || is_given(raw, "--bevel") ? std::string{} : lost + " needs --bevel";
    }
    if (out.depth == 0.0f) return "--bevel needs a solid, but --depth 0 makes a flat mesh: give a larger --depth";
    if (is_given(raw, "--normals"))
        return "--normals does not work with --bevel, which takes all normals from the curves";
    out.bevel.depth = static_cast<float>(raw.bevel_depth.value_or(width));
    const bool both = out.bevel.sides == typemesh::bevel_sides::both, leaves_some = reaches_down(out.bevel);
    const double bevels = (both ? 2.0 : 1.0) * static_cast<double>(out.bevel.depth);
    const auto depth = static_cast<double>(out.depth);
    if (bevels < depth || (bevels <= depth && !leaves_some)) return {};
    return std::string{raw.bevel_depth ? "--bevel-depth" : "--bevel without --bevel-depth"} + " must be " +
           (leaves_some ? "less than " : "at most ") + (both ? "half of " : "") + "--depth " + written(out.depth) +
           ", not " + written(out.bevel.depth);
}

/// Finishes walls that lean: they are one bevel over the whole depth. Gives an empty string, or one sentence of what is
/// wrong.
std::string settle_taper(options& out, const raw_options& raw)
{
    if (out.taper == 0.0f) return {};
    const std::string other = first_given(raw, {"--tube", "--refine", "--inflate", "--carve", "--bevel"});
    if (!other.empty()) return other + " does not work with --taper";
    if (out.depth == 0.0f) return "--taper needs a solid, but --depth 0 makes a flat mesh: give a larger --depth";
    if (is_given(raw, "--normals"))
        return "--normals does not work with --taper, which takes all normals from the curves";
    const typemesh::bevelled walls = typemesh::tapered{.depth = out.depth, .degrees = out.taper}.walls();
    out.bevel.width = walls.width;
    out.bevel.depth = walls.bevel_depth;
    out.bevel.sides = walls.sides;
    return {};
}

/// Why letters cannot be carved, or an empty string.
std::string refused_carving(const options& o, const raw_options& raw)
{
    if (o.carve.tool_angle == 0.0f) {
        const std::string lost = first_given(raw, {"--carve-depth", "--carve-as"});
        return lost.empty() ? lost : lost + " needs --carve";
    }
    if (is_given(raw, "--depth")) return "--depth does not work with --carve: give --carve-depth";
    if (o.bevel.width > 0.0f) return "--bevel does not work with --carve";
    if (o.outline.width > 0.0f) return "--outline does not work with --carve";
    if (!raw.refine.empty()) return "--refine does not work with --carve";
    if (is_given(raw, "--normals"))
        return "--normals does not work with --carve, which takes all normals from the curves";
    if (o.carve.as == typemesh::carving::groove && is_printed(o.kind))
        return std::string{"--carve-as groove is an open surface, but a ."} +
               (o.kind == file_kind::stl ? "stl" : "3mf") + " file contains solids: give relief or cutter";
    return {};
}

/// Finishes bold and hollow letters. Gives an empty string, or one sentence of what is wrong.
std::string settle_weight(options& out, const raw_options& raw)
{
    using typemesh::outline_place;
    const auto width = static_cast<double>(out.outline.width), bolder = static_cast<double>(out.embolden);
    const std::string of_a_ring = first_given(raw, {"--outline-place", "--outline-letter"});
    if (width == 0.0 && !of_a_ring.empty()) return of_a_ring + " needs --outline";
    if (out.outline.letter && out.bevel.outward && out.bevel.width > 0.0f)
        return "--bevel-out does not work with --outline-letter, because the ring would grow into the letter";
    const double ring = out.outline.place == outline_place::outer    ? width
                        : out.outline.place == outline_place::centre ? 0.5 * width
                                                                     : 0.0;
    const double around = ring + static_cast<double>(out.tube.radius);
    if (is_given(raw, "--stroke"))
        if (const std::string trouble = read_stroke(raw.stroke, out.stroke); !trouble.empty())
            return "--stroke " + trouble;
    const double wider = 2.0 * (bolder + around + 0.5 * out.stroke.width);
    out.letter_spacing = raw.letter_spacing.value_or(wider);
    out.columns.combined_gap = wider;
    const double bevel = out.bevel.outward ? static_cast<double>(out.bevel.width) : 0.0;
    out.growth = std::max(0.0, bolder + around + 0.5 * out.stroke.width + bevel);
    return {};
}

/// Finishes refined letters. Gives an empty string, or one sentence of what is wrong.
std::string settle_refine(options& out, const raw_options& raw)
{
    if (raw.refine.empty()) {
        const std::string lost = first_given(raw, {"--min-angle", "--max-edge"});
        return lost.empty() ? lost : lost + " needs --refine";
    }
    out.refine.refiner = raw.refine == "quadtree"    ? refiner_name::quadtree
                         : raw.refine == "nonobtuse" ? refiner_name::non_obtuse
                                                     : refiner_name::delaunay;
    if (out.refine.refiner != refiner_name::delaunay && is_given(raw, "--min-angle"))
        return "--min-angle needs --refine delaunay";
    if (out.refine.refiner == refiner_name::quadtree && out.refine.max_edge && !(*out.refine.max_edge > 0.0f))
        return "--max-edge must be above 0 with --refine quadtree";
    if (out.bevel.width > 0.0f) return "--refine does not work with --bevel";
    if (out.outline.width > 0.0f) return "--refine does not work with --outline";
    return {};
}

/// Why letters cannot be inflated, or an empty string.
std::string refused_inflation(const options& out, const raw_options& raw)
{
    if (out.inflate.height == 0.0f)
        return is_given(raw, "--inflate-form") ? "--inflate-form needs --inflate" : std::string{};
    if (out.bevel.width > 0.0f) return "--inflate does not work with --bevel";
    if (out.outline.width > 0.0f) return "--inflate does not work with --outline";
    if (out.refine.refiner != refiner_name::none) return "--inflate does not work with --refine";
    if (out.carve.tool_angle > 0.0f) return "--inflate does not work with --carve";
    if (is_given(raw, "--normals")) return "--normals does not work with --inflate, which has normals of its own";
    if (out.inflate.form == typemesh::inflated_form::dome && out.depth == 0.0f)
        return "--inflate-form dome needs walls, but --depth is 0: give a larger --depth";
    return {};
}

/// Finishes tubes, before anything that they exclude or make wider. Gives an empty string, or one sentence of what is
/// wrong.
std::string settle_tube(options& out, const raw_options& raw)
{
    if (raw.tube.empty()) return {};
    if (const std::string trouble = read_tube(raw.tube, out.tube); !trouble.empty()) return "--tube " + trouble;
    if (is_given(raw, "--depth")) return "--depth does not work with --tube: its radius is the depth";
    if (out.bevel.width > 0.0f) return "--bevel does not work with --tube";
    if (out.carve.tool_angle > 0.0f) return "--carve does not work with --tube";
    if (out.outline.width > 0.0f) return "--outline does not work with --tube";
    if (out.inflate.height > 0.0f) return "--inflate does not work with --tube";
    if (!raw.refine.empty()) return "--refine does not work with --tube";
    if (out.segments != 1) return "--segments does not work with --tube";
    if (is_given(raw, "--normals")) return "--normals does not work with --tube, whose normals are round";
    return {};
}

/// Finishes bent letters. Gives an empty string, or one sentence of what is wrong.
std::string settle_bend(options& out, const raw_options& raw)
{
    if (raw.bend.empty()) return {};
    if (const std::string trouble = read_bend(raw.bend, out.bend.how, out.bend.warp); !trouble.empty())
        return "--bend " + trouble;
    out.bend.is_on = out.bend.warp.index() == 0;
    if (out.instances) return "--bend does not work with --instances, because every bent letter is another mesh";
    if (!out.bend.is_on) return {};
    if (out.outline.width > 0.0f) return "--bend does not work with --outline";
    if (out.refine.refiner != refiner_name::none)
        return "--bend does not work with --refine, because it adds the points that it needs";
    if (out.carve.tool_angle > 0.0f) return "--bend does not work with --carve";
    if (out.inflate.height > 0.0f) return "--bend does not work with --inflate";
    if (out.tube.radius > 0.0f) return "--bend does not work with --tube, unless it bends in the plane";
    return {};
}

/// Finishes text on a path. Gives an empty string, or one sentence of what is wrong.
std::string settle_path(options& out, const raw_options& raw)
{
    if (raw.path.empty()) return {};
    if (const std::string trouble = read_path(raw.path, out.path); !trouble.empty()) return "--path " + trouble;
    if (out.bend.warp.index() != 0) return "--path does not work with a --bend in the plane";
    if (!raw.anchor.empty() || !raw.origin.empty())
        return "--path does not work with --anchor and --origin: the curve says where the text is";
    if (out.show_contours || out.show_points || out.show_control)
        return "--path does not work with --show-contours, --show-points and --show-control";
    return {};
}

/// Finishes a plate. Gives an empty string, or one sentence of what is wrong.
std::string settle_plate(options& out, const raw_options& raw)
{
    const std::optional<float> depth = is_given(raw, "--depth") ? std::optional{out.depth} : std::nullopt;
    if (std::string trouble = read_plate(raw.plate, depth, out.plate); !trouble.empty()) return trouble;
    if (!out.plate.is_on) return {};
    const std::string option = out.plate.follows ? "--backing" : "--plate";
    const std::string other = first_given(raw, not_with_plates);
    if (!other.empty()) return other + " does not work with " + option;
    constexpr file_kind solids[] = {file_kind::glb, file_kind::obj, file_kind::stl, file_kind::ply,
                                    file_kind::three_mf};
    if (!out.output.empty() && std::find(std::begin(solids), std::end(solids), out.kind) == std::end(solids))
        return option + " needs a file of solids: .glb, .obj, .stl, .ply or .3mf";
    if (out.bend.is_on) return "--bend works with " + option + " only in the plane: arc, arch, flag, perspective";
    for (const styled_range& r : out.styles)
        if (r.colour) return "--style: colours do not work with " + option + ", whose letters have one colour";
    if (out.show_contours || out.show_points || out.show_control)
        return "--show contours, points and control do not work with " + option;
    if (out.plate.how.style == typemesh::plate_style::inlay && is_given(raw, "--manifold"))
        return "--manifold does not work with --inlay, whose two solids touch";
    if (out.plate.how.style == typemesh::plate_style::inlay && !out.output.empty() && !holds_colours(out.kind))
        return "--inlay needs a file that keeps its two solids apart: .3mf, .glb or .obj";
    return {};
}

}  // namespace

std::string settle_form(options& out, const raw_options& raw)
{
    if (out.depth == 0.0f && out.segments != 1)
        return "--segments needs a solid, but --depth 0 makes a flat mesh: give a larger --depth";
    return settle_all(out, raw, settle_tube, settle_rims, settle_bevel, settle_taper, settle_weight, settle_refine,
                      settle_bend, settle_path, refused_inflation, settle_plate, refused_carving);
}

}  // namespace text_to_mesh
