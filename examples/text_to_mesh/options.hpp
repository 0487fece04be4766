// SPDX-License-Identifier: MIT
#pragma once

#include "chosen_bend.hpp"
#include "chosen_morph.hpp"
#include "chosen_path.hpp"
#include "chosen_plate.hpp"
#include "chosen_stroke.hpp"
#include "chosen_tube.hpp"
#include "file_kind.hpp"
#include "marked_text.hpp"
#include "picture/picture_options.hpp"
#include "placing.hpp"
#include "styled_range.hpp"

#include <typemesh/colour/layer_regions.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/carved.hpp>
#include <typemesh/extrude/inflated.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/layout/layout_options.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace text_to_mesh {

class colour_layers;
class svg_layers;
class text_icons;

enum class discretiser_name { certified, two_lines, adaptive };
enum class triangulator_name { monotone, delaunay };
enum class normals_name { cap, shared, averaged, creased, curve };
enum class profile_name { chamfer, round, concave, stepped, engraved, points };
enum class refiner_name { none, delaunay, quadtree, non_obtuse };
enum class preset { low, normal, high, best };

/// Bevels, as bevelled.hpp has them.
struct bevel_options {
    float width = 0.0f;  ///< em; 0: none
    float depth = 0.0f;  ///< em
    profile_name profile = profile_name::chamfer;
    typemesh::profile_points points;  ///< of profile_name::points
    unsigned steps = 0;               ///< 0: by the tolerance
    typemesh::bevel_mode mode = typemesh::bevel_mode::clip;
    typemesh::bevel_sides sides = typemesh::bevel_sides::both;
    bool outward = false;
};

/// Carved letters, as carved.hpp has them.
struct carve_options {
    float tool_angle = 0.0f;  ///< degrees; 0: not carved
    float depth = 0.0f;       ///< em; 0: without a floor
    typemesh::carving as = typemesh::carving::relief;
};

/// Hollow letters, as outlined.hpp has them.
struct outline_options {
    float width = 0.0f;  ///< em; 0: none
    typemesh::outline_place place = typemesh::outline_place::inner;
    bool letter = false;  ///< the letter is made, too
};

/// Refined letters, as delaunay_refined.hpp, quadtree_refined.hpp and non_obtuse.hpp have them.
struct refine_options {
    refiner_name refiner = refiner_name::none;
    float min_angle = 25.0f;        ///< degrees; of delaunay
    std::optional<float> max_edge;  ///< em; of delaunay, 0: any length
};

/// Bent letters, as bent.hpp has them, or warped ones, as warped.hpp has them.
struct bend_options {
    bool is_on = false;  ///< bent
    chosen_bend how;
    chosen_warp warp;
};

/// Inflated letters, as inflated.hpp has them.
struct inflate_options {
    float height = 0.0f;  ///< in halves of a stroke's width; 0: none
    typemesh::inflated_form form = typemesh::inflated_form::balloon;
};

/// What the command line requests.
struct options {
    std::string who = "text_to_mesh: ";  ///< begins a sentence on standard error; of a batch it names the line
    std::string text;
    std::string text_file;           ///< instead of it, "-" is standard input; empty: none
    std::string svg;                 ///< a file of SVG instead of a text and fonts; empty: none
    std::vector<std::string> icons;  ///< files of SVG for the boxes of mark-up
    std::string batch;               ///< likewise, a text a line
    std::string font;                ///< a file's name or a family's
    bool family = false;             ///< it is the font of --family: other installed fonts stand in for it
    std::vector<std::string> fallback;
    std::optional<unsigned> face;  ///< in a collection
    std::vector<typemesh::variation> variations;
    std::vector<typemesh::feature> features;
    std::string language, script;
    typemesh::direction direction = typemesh::direction::automatic;
    typemesh::column_options columns;
    double growth = 0.0;          ///< em; how far letters reach beyond their own edges, not negative
    double letter_spacing = 0.0;  ///< em; by default as much as letters have become wider
    typemesh::layout_options lines;
    std::string ellipsis;
    std::vector<styled_range> styles;
    bool markup = false;                                  ///< the text has tags
    std::shared_ptr<marked_text> marked;                  ///< they have been read
    std::optional<rgb_colour> colour;                     ///< of what no style has a colour for
    std::optional<typemesh::layer_cut> colour_layers;     ///< colour glyphs are drawn as layers
    std::shared_ptr<text_to_mesh::colour_layers> layers;  ///< they have been read
    std::shared_ptr<svg_layers> drawing;                  ///< the file of --svg has been read
    std::shared_ptr<text_icons> placed_icons;             ///< the files of `icons` have been read
    bool even_lines = false;                              ///< by total_fit, else by first_fit
    double fit_width = 0.0, fit_height = 0.0;             ///< of the box that gives the size; 0: none

    double size = 1.0;  ///< of an em in the file
    placing place;
    float depth = 0.2f;          ///< em; 0 makes a flat mesh
    std::uint32_t segments = 1;  ///< of the sides, along the depth
    bevel_options bevel;
    float taper = 0.0f;  ///< degrees; then `bevel` is the slope of the walls
    carve_options carve;
    float embolden = 0.0f;  ///< em; how far edges move outwards
    outline_options outline;
    chosen_stroke stroke;
    refine_options refine;
    bend_options bend;
    chosen_path path;
    chosen_plate plate;
    inflate_options inflate;
    chosen_tube tube;
    chosen_morph morph;
    preset quality = preset::high;
    double tolerance = typemesh::quality::high;
    std::vector<double> lod;     ///< em; the tolerances of coarser levels of detail, ascending
    bool quality_given = false;  ///< by --quality or --tolerance
    discretiser_name discretiser = discretiser_name::certified;
    triangulator_name triangulator = triangulator_name::monotone;
    normals_name normals = normals_name::curve;
    std::optional<float> crease;  ///< degrees; each style has a default of its own
    std::optional<typemesh::fill_rule> fill;
    typemesh::texture_mapping uv = typemesh::texture_mapping::em;
    bool strict = false;
    bool merge = false;
    bool keeps_apart = false;  ///< by --no-merge
    bool instances = false;
    bool manifold = false;    ///< the .glb says how its mesh is a 2-manifold
    bool letters = false;     ///< vertices know their letters
    bool per_letter = false;  ///< each letter is a mesh, and has a node
    typemesh::touching corners = typemesh::touching::keep;

    std::string output;  ///< "-" is standard output; of a batch a pattern, as `picture` is: see file_name()
    file_kind kind = file_kind::unknown;  ///< of the output
    std::string picture;
    text_to_mesh::shading shading = text_to_mesh::shading::phong;
    std::optional<float> turn;  ///< degrees that the picture's eye is moved to the right
    bool show_triangles = false, show_points = false, show_contours = false, show_control = false, show_normals = false;
    bool checker = false;
    bool stats = false;
};

/// Reads the command line into `out`. Gives nothing when the program should go on, or its exit status: 0 after --help
/// and --version, 2 after wrong usage, which has been explained on standard error by then.
[[nodiscard]] std::optional<int> parse(int argc, char** argv, options& out);

}  // namespace text_to_mesh
