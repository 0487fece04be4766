// SPDX-License-Identifier: MIT
#include "options.hpp"

#include "atomic_file.hpp"
#include "colour_names.hpp"
#include "option_values.hpp"
#include "text_source.hpp"
#include "wrong_usage.hpp"

#include <typemesh/extrude/tapered.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <memory>
#include <string_view>
#include <utility>

namespace text_to_mesh {
namespace {

/// One of some words. `also` are understood as well, but not advertised.
CLI::Validator one_of(const std::vector<std::string>& names, const std::vector<std::string>& also = {})
{
    const auto complaint = [names, also](std::string& given) -> std::string {
        for (const auto* some : {&names, &also})
            if (std::find(some->begin(), some->end(), given) != some->end()) return {};
        return "must be " + joined(names) + ", not " + given;
    };
    std::string shown;
    for (const std::string& name : names) shown += (shown.empty() ? "{" : ",") + name;
    return {complaint, shown + "}"};
}

/// An option that takes a number which `holds`; `what` says so in words, `take` gets it.
template <class Holds, class Take>
CLI::Option* add_number(CLI::App& app, const char* option, const char* meaning, const char* what, Holds holds,
                        Take take)
{
    const auto complaint = [what, holds](std::string& given) -> std::string {
        const auto value = decimal(given);
        return value && holds(*value) ? std::string{} : "must be " + std::string{what} + ", not " + given;
    };
    return app
        .add_option_function<std::string>(
            option, [take](const std::string& given) { take(*decimal(given)); }, meaning)
        ->check(CLI::Validator{complaint, ""});
}

/// An option whose values have names; `value` keeps what it holds unless one is given.
template <class T>
CLI::Option* add_named(CLI::App& app, const char* option, T& value, const char* meaning,
                       const std::vector<std::pair<std::string, T>>& names, const std::vector<std::string>& also = {})
{
    std::vector<std::string> allowed;
    for (const auto& [name, unused] : names)
        if (std::find(also.begin(), also.end(), name) == also.end()) allowed.push_back(name);
    const auto take = [names, &value](const std::string& given) {
        for (const auto& [name, named_value] : names)
            if (given == name) value = named_value;
    };
    return app.add_option_function<std::string>(option, take, meaning)->check(one_of(allowed, also));
}

/// What the help says of an option's value: "FILE", "{ltr,rtl,ttb}". Words of the library's own are left out.
class plain_help : public CLI::Formatter {
public:
    plain_help()
    {
        column_width(26);
        label("Positionals", "The text");
    }
    std::string make_usage(const CLI::App*, std::string name) const override
    {
        return "Usage: " + name +
               " (TEXT | --text-file FILE | --batch FILE) (--font FONT | --family FAMILY)\n"
               "       " +
               name +
               " --svg FILE\n"
               "                    (--output FILE | --picture FILE.png | --stats) [options]\n";
    }
    std::string make_option_opts(const CLI::Option* option) const override
    {
        const std::string type = option->get_type_name();
        if (option->get_positional() || type.empty()) return {};
        const auto choice = type.find('{');
        return " " + (choice == std::string::npos ? type : type.substr(choice));
    }
};

std::string version()
{
    return "text_to_mesh " + std::to_string(TYPEMESH_VERSION_MAJOR) + "." + std::to_string(TYPEMESH_VERSION_MINOR) +
           "." + std::to_string(TYPEMESH_VERSION_PATCH);
}

/// Words of the command line that become something else after parsing.
struct raw_values {
    plate_words plate;
    std::string not_with_plates;  // an option that is given and does not work with a plate
    std::string not_with_inlays;  // likewise, with an inlay
    std::string not_with_taper;   // likewise, with --taper
    std::vector<std::string> variations, features, show;
    std::string uv, fill, fit, lod, morph, tube, colour_layers, profile = "chamfer", refine, bend, path, family, format,
                                                                anchor, origin;
    std::optional<typemesh::touching> corners;
    std::optional<double> size, bevel_depth, bevel_steps, letter_spacing;
    bool text_given = false, no_merge = false, tolerance_given = false, shading_given = false, normals_given = false,
         bevel_given = false, depth_given = false;
    std::string of_a_carving, of_a_bevel, of_an_outline, of_refining,
        of_inflating;                   // the first option that only a bevel, ... has
    std::string of_columns;             // likewise
    std::vector<std::string> of_lines;  // options for lines that depend on each other; those that are given
    std::vector<std::string> given;     // all options that are given
    std::string stroke;
};

void add_text_options(CLI::App& app, options& out, raw_values& raw)
{
    using namespace typemesh;
    app.add_option("TEXT", out.text,
                   "in UTF-8; \\n starts a new line; - reads standard input; write \\@ or \\- to begin with @ or -");
    app.add_option("--text-file", out.text_file,
                   "read the text from a file, or from standard input with -; \\n is two letters there")
        ->type_name("FILE");
    app.add_option("--batch", out.batch,
                   "make a mesh of each line of a file, or of standard input (-); {n} and {text} name the files")
        ->type_name("FILE");
    app.add_option("--svg", out.svg, "instead of a text, the shapes of an SVG file, whose larger side is one em")
        ->type_name("FILE");
    app.add_option("--icon", out.icons, "the SVG file that fills the next [box] of --markup; may be repeated")
        ->type_name("FILE");
    app.add_option("-f,--font", out.font,
                   "a font file (TrueType, OpenType, collection) or an installed family: \"DejaVu Sans:bold\"")
        ->type_name("FONT");
    app.add_option("--fallback", out.fallback,
                   "another font for characters that the fonts before it lack; may be repeated")
        ->type_name("FONT")
        ->take_all()
        ->expected(1);
    app.add_option("--family", raw.family,
                   "an installed family instead of --font; other installed fonts supply what it lacks")
        ->type_name("FAMILY");
    add_number(
        app, "--face", "the number of the face in a collection, from 0", "a whole number",
        [](double n) { return n >= 0.0 && n < 4294967296.0 && n == std::floor(n); },
        [&out](double n) { out.face = static_cast<unsigned>(n); })
        ->type_name("N");
    app.add_option("--variation", raw.variations, "set an axis of a variable font: wght=700; may be repeated")
        ->type_name("AXIS=VALUE")
        ->take_all()
        ->expected(1);
    app.add_option("--morph", raw.morph,
                   "in a .glb, move along an axis of a variable font, with morph targets: wght=100..900")
        ->type_name("AXIS=FROM..TO");
    app.add_option("--feature", raw.features, "set an OpenType feature: smcp, liga=0, -kern; may be repeated")
        ->type_name("TAG[=N]")
        ->take_all()
        ->expected(1);
    app.add_option("--language", out.language, "the language of the text, by BCP 47: tr, zh-Hant")->type_name("L");
    app.add_option("--script", out.script, "the script of the text, by ISO 15924: Latn, Arab")->type_name("S");
    add_named<direction>(
        app, "--direction", out.direction, "the direction of the text (default: found from the text)",
        {{"ltr", direction::left_to_right}, {"rtl", direction::right_to_left}, {"ttb", direction::top_to_bottom}});
    add_named<column_latin>(app, "--latin", out.columns.latin,
                            "how Latin stands in columns, with --direction ttb (default sideways)",
                            {{"sideways", column_latin::sideways}, {"upright", column_latin::upright}});
    using typemesh::column_progress;
    add_named<column_progress>(app, "--columns", out.columns.progress,
                               "where the next column stands (default auto: right in Mongolian, otherwise left)",
                               {{"auto", column_progress::automatic},
                                {"left", column_progress::leftwards},
                                {"right", column_progress::rightwards}});
    add_number(
        app, "--combine-digits", "in columns, numbers of at most N digits take the room of one character",
        "a whole number from 0 to 255", [](double n) { return n >= 0.0 && n <= 255.0 && n == std::floor(n); },
        [&out](double n) { out.columns.combined_digits = static_cast<std::uint8_t>(n); })
        ->type_name("N");
    add_named<alignment>(app, "--align", out.lines.align,
                         "align lines with each other, or within --width (default start)",
                         {{"left", alignment::left},
                          {"center", alignment::centre},
                          {"centre", alignment::centre},
                          {"right", alignment::right},
                          {"start", alignment::start},
                          {"end", alignment::end},
                          {"justify", alignment::justify}},
                         {"centre"});
    add_number(
        app, "--letter-spacing",
        "add space between letters, or remove it if negative (default: the growth of the letters)",
        "a number from -1000 to 1000", [](double n) { return n >= -1000.0 && n <= 1000.0; },
        [&raw](double n) { raw.letter_spacing = n; })
        ->type_name("EM");
    add_number(
        app, "--line-spacing", "multiply the font's own distance between lines by N (default 1)",
        "a number from -1000 to 1000", [](double n) { return n >= -1000.0 && n <= 1000.0; },
        [&out](double n) { out.lines.line_spacing = n; })
        ->type_name("N");
}

void add_line_options(CLI::App& app, options& out, raw_values& raw)
{
    using namespace typemesh;
    add_number(
        app, "--width", "end lines before they are wider than this", "a positive number up to 1000000",
        [](double n) { return n > 0.0 && n <= 1e6; }, [&out](double n) { out.lines.width = n; })
        ->type_name("EM");
    app.add_option("--fit", raw.fit,
                   "find the largest size at which the text fits into a box, in the file's unit: 30x10")
        ->type_name("WxH");
    add_named<wrap_mode>(app, "--wrap", out.lines.wrap,
                         "end lines at words, also inside too long words (break, default), at any letter, or nowhere",
                         {{"word", wrap_mode::word},
                          {"break", wrap_mode::word_or_grapheme},
                          {"letter", wrap_mode::grapheme},
                          {"none", wrap_mode::none}});
    add_named<bool>(app, "--breaker", out.even_lines,
                    "fill each line (first_fit, default), or make all lines as even as possible (total_fit)",
                    {{"first_fit", false}, {"total_fit", true}});
    add_named<justification>(
        app, "--justify", out.lines.justify,
        "what widens justified lines: auto (default: ideographs, else spaces), spaces, letters, kashida",
        {{"auto", justification::automatic},
         {"spaces", justification::spaces},
         {"letters", justification::letters},
         {"kashida", justification::kashida}});
    add_number(
        app, "--indent", "indent the first line of each paragraph, or let it hang out if negative",
        "a number from -1000 to 1000", [](double n) { return n >= -1000.0 && n <= 1000.0; },
        [&out](double n) { out.lines.indent = n; })
        ->type_name("EM");
    add_number(
        app, "--max-lines", "drop all lines after the first N", "a whole number from 1",
        [](double n) { return n >= 1.0 && n < 4294967296.0 && n == std::floor(n); },
        [&out](double n) { out.lines.max_lines = static_cast<std::uint32_t>(n); })
        ->type_name("N");
    app.add_option("--ellipsis", out.ellipsis,
                   "show this for text that is dropped or does not fit; ... where the font lacks it")
        ->type_name("TEXT");
    add_named<ellipsis_place>(
        app, "--elide", out.lines.elide, "where the ellipsis stands in its line (default end)",
        {{"end", ellipsis_place::end}, {"middle", ellipsis_place::middle}, {"start", ellipsis_place::start}});
    const auto complaint = [](std::string& given) {
        styled_range unused;
        return read_styled_range(given, unused);
    };
    const auto take = [&out](const std::vector<std::string>& given) {
        for (const std::string& one : given) (void)read_styled_range(one, out.styles.emplace_back());
        return true;
    };
    app.add_option_function<std::string>(
           "--colour,--color", [&out](const std::string& given) { out.colour = read_colour(given); },
           "the colour of all text that no --style colours; .stl and .ply have no colours")
        ->type_name("COLOUR")
        ->check(CLI::Validator{[](std::string& given) {
                                   return read_colour(given) ? std::string{}
                                                             : "must be " + colours_in_words() + ", not " + given;
                               },
                               ""});
    app.add_flag("--colour-layers{visible},--color-layers{visible}", raw.colour_layers,
                 "draw the colours of emoji: visible (default), cut where covered; or stacked in steps");
    app.add_option("--style", CLI::callback_t{take},
                   "style code points, counted from 0: \"6..11:colour=red,underline,size=1.5\"; may be repeated")
        ->type_name("A..B:SETTING,...")
        ->check(CLI::Validator{complaint, ""})
        ->take_all()
        ->expected(1);
    app.add_flag("--markup", out.markup,
                 "read tags such as [b], [size=1.5] and [colour=#c33] in the text; see below for all of them");
    raw.of_lines = {"--width", "--fit", "--wrap", "--breaker", "--justify", "--max-lines", "--ellipsis", "--elide"};
}

void add_mesh_options(CLI::App& app, options& out, raw_values& raw)
{
    add_number(
        app, "--size", "the size of an em in the file (default 1; in .stl, .3mf, .svg and .dxf 10 millimetres)",
        "a number from 1e-30 to 1000000", [](double n) { return n >= 1e-30 && n <= 1e6; },
        [&raw](double n) { raw.size = n; })
        ->type_name("N");
    app.add_option("--anchor", raw.anchor,
                   "the place of the text that moves to --origin, for example centre,bottom,base (see below)")
        ->type_name("PLACE,...");
    app.add_option("--origin", raw.origin, "where --anchor moves to, in the file's unit (default 0,0,0)")
        ->type_name("X,Y[,Z]");
    add_number(
        app, "--depth", "how deep the letters are, up to 1000; 0 makes a flat mesh (default 0.2)",
        "a number from 0 to 1000", [](double n) { return n >= 0.0 && n <= 1000.0; },
        [&out](double n) { out.depth = static_cast<float>(n); })
        ->type_name("EM");
    add_number(
        app, "--segments", "divide the sides into this many equal pieces along the depth, for meshes to be bent",
        "a whole number from 1 to 1024", [](double n) { return n >= 1.0 && n <= 1024.0 && n == std::floor(n); },
        [&out](double n) { out.segments = static_cast<std::uint32_t>(n); })
        ->type_name("N");
    auto* named = add_named<preset>(
        app, "--quality", out.quality,
        "the largest distance to the curve: 1/100, 1/160, 1/800 (high, default) or 1/16000 em",
        {{"low", preset::low}, {"normal", preset::normal}, {"high", preset::high}, {"best", preset::best}});
    add_number(
        app, "--tolerance", "the same distance as a number, with --discretiser certified", "a positive number",
        [](double n) { return n > 0.0; }, [&out](double n) { out.tolerance = n; })
        ->type_name("EM")
        ->excludes(named);
    app.add_option("--lod", raw.lod, "in a .glb, also coarser levels of detail with these tolerances: 0.006,0.02,0.05")
        ->type_name("EM[,EM...]");
    add_named<discretiser_name>(
        app, "--discretiser", out.discretiser,
        "how curves become lines (default certified); adaptive uses the thesis' four, by --quality",
        {{"certified", discretiser_name::certified},
         {"two_lines", discretiser_name::two_lines},
         {"adaptive", discretiser_name::adaptive}});
    add_named<triangulator_name>(
        app, "--triangulator", out.triangulator, "how faces become triangles (default monotone)",
        {{"monotone", triangulator_name::monotone}, {"delaunay", triangulator_name::delaunay}});
    add_named<normals_name>(app, "--normals", out.normals, "the normals of the sides (default curve)",
                            {{"cap", normals_name::cap},
                             {"shared", normals_name::shared},
                             {"averaged", normals_name::averaged},
                             {"creased", normals_name::creased},
                             {"curve", normals_name::curve}});
    add_number(
        app, "--crease", "make edges hard that turn by more than this, 0 to 180 (default 15; with creased 30)",
        "a number from 0 to 180", [](double n) { return n >= 0.0 && n <= 180.0; },
        [&out](double n) { out.crease = static_cast<float>(n); })
        ->type_name("DEGREES");
    app.add_option("--fill", raw.fill, "the fill rule, instead of the font's own")
        ->check(one_of({"nonzero", "evenodd"}));
    app.add_option("--uv", raw.uv, "texture coordinates: over the text's box, in em (default), or once round each edge")
        ->check(one_of({"box", "em", "cylindrical"}));
    auto* merged =
        app.add_flag("--merge", out.merge,
                     "make one solid without inner walls of letters that meet (default except for plain .glb)");
    app.add_flag("--no-merge", raw.no_merge, "keep each letter as a solid of its own")->excludes(merged);
    add_named<std::optional<typemesh::touching>>(
        app, "--touching", raw.corners,
        "part (default except for .glb), join or keep corners that touch; part and join imply --merge",
        {{"part", typemesh::touching::part}, {"join", typemesh::touching::join}, {"keep", typemesh::touching::keep}});
    app.add_flag("--instances", out.instances,
                 "in .glb, store each different letter once, unmerged, with a node for each place")
        ->excludes(merged);
    app.add_flag("--letters", out.letters,
                 "in .glb, give vertices the numbers of their letter, word and line, and the letter's pivot");
    app.add_flag("--per-letter", out.per_letter,
                 "in .glb, make each letter a node, named by its text, that turns about the letter's pivot");
    app.add_flag("--manifold", out.manifold,
                 "in .glb, mark the mesh as a closed solid, with EXT_mesh_manifold; implies --merge");
    app.add_flag("--strict", out.strict, "treat every warning as an error, and write nothing");
}

void add_bevel_options(CLI::App& app, options& out, raw_values& raw)
{
    using namespace typemesh;
    add_number(
        app, "--bevel", "the width of the bevels; 0 makes none (default); letters that meet become one, as by --merge",
        "a number from 0 to 1000", [](double n) { return n >= 0.0 && n <= 1000.0; },
        [&out](double n) { out.bevel.width = static_cast<float>(n); })
        ->type_name("EM");
    add_number(
        app, "--bevel-depth", "how far a bevel cuts into the depth (default: the bevel's width)",
        "a number from 0 to 1000", [](double n) { return n >= 0.0 && n <= 1000.0; },
        [&raw](double n) { raw.bevel_depth = n; })
        ->type_name("EM");
    app.add_option("--profile", raw.profile,
                   "the bevel's profile: a name, or points as shares of width and depth: \"0,0;0.2,0.8;1,1\"")
        ->type_name("{chamfer,round,concave,stepped,engraved,T,H;T,H;...}");
    add_number(
        app, "--bevel-steps", "the steps of a round or concave profile, up to 63; 0 follows the quality (default)",
        "a whole number from 0 to 63", [](double n) { return n >= 0.0 && n <= 63.0 && n == std::floor(n); },
        [&raw](double n) { raw.bevel_steps = n; })
        ->type_name("N");
    add_named<bevel_mode>(
        app, "--bevel-mode", out.bevel.mode,
        "thin strokes get a ridge (clip, default), or narrower bevels: one letter (fit), all (fit_text)",
        {{"clip", bevel_mode::clip}, {"fit", bevel_mode::fit}, {"fit_text", bevel_mode::fit_text}});
    app.add_flag("--bevel-out", out.bevel.outward, "put the bevels around the letters, which then grow");
    add_named<bevel_sides>(app, "--bevel-sides", out.bevel.sides, "the edges that are bevelled (default both)",
                           {{"front", bevel_sides::front}, {"back", bevel_sides::back}, {"both", bevel_sides::both}});
}

void add_taper_option(CLI::App& app, options& out)
{
    add_number(
        app, "--taper", "let the walls lean inwards by this angle, as in a mould; thin strokes get a ridge",
        "a number from 0 to 89", [](double n) { return n >= 0.0 && n <= 89.0; },
        [&out](double n) { out.taper = static_cast<float>(n); })
        ->type_name("DEGREES");
}

void add_carve_options(CLI::App& app, options& out)
{
    using namespace typemesh;
    add_number(
        app, "--carve", "give the letters the slopes that a V-bit of this angle carves; --depth does not matter then",
        "a number from 1 to 179", [](double n) { return n >= 1.0 && n <= 179.0; },
        [&out](double n) { out.carve.tool_angle = static_cast<float>(n); })
        ->type_name("DEGREES");
    add_number(
        app, "--carve-depth", "end the slopes in a flat floor at this depth; 0 lets them meet (default)",
        "a number from 0 to 1000", [](double n) { return n >= 0.0 && n <= 1000.0; },
        [&out](double n) { out.carve.depth = static_cast<float>(n); })
        ->type_name("EM");
    add_named<carving>(app, "--carve-as", out.carve.as,
                       "letters that rise (default), the surface that a tool leaves, or what it removes",
                       {{"relief", carving::relief}, {"groove", carving::groove}, {"cutter", carving::cutter}});
}

void add_weight_options(CLI::App& app, options& out, raw_values& raw)
{
    using namespace typemesh;
    add_number(
        app, "--embolden", "move edges outwards by this, which widens strokes by twice as much; inwards if negative",
        "a number from -1 to 1", [](double n) { return n >= -1.0 && n <= 1.0; },
        [&out](double n) { out.embolden = static_cast<float>(n); })
        ->type_name("EM");
    add_number(
        app, "--outline", "make hollow letters with a ring of this width; 0 makes none (default)",
        "a number from 0 to 1", [](double n) { return n >= 0.0 && n <= 1.0; },
        [&out](double n) { out.outline.width = static_cast<float>(n); })
        ->type_name("EM");
    add_named<outline_place>(app, "--outline-place", out.outline.place,
                             "put the ring inside the letter's edges (inner, default), around them, or half and half",
                             {{"inner", outline_place::inner},
                              {"center", outline_place::centre},
                              {"centre", outline_place::centre},
                              {"outer", outline_place::outer}},
                             {"centre"});
    app.add_option("--stroke", raw.stroke, "letters are strokes along their outlines: 0.03 or 0.03,round,0.1,0.05")
        ->type_name("EM[,JOIN][,DASH,GAP...]");
    app.add_flag("--outline-letter", out.outline.letter, "also make the letter inside the ring, as parts of its own");
}

void add_refine_options(CLI::App& app, options& out, raw_values& raw)
{
    app.add_option("--refine", raw.refine, "add points to the letters, for meshes to be bent or used in a simulation")
        ->check(one_of({"delaunay", "quadtree", "nonobtuse"}));
    add_number(
        app, "--min-angle", "the least angle of triangles from --refine delaunay (default 25)", "a number from 0 to 33",
        [](double n) { return n >= 0.0 && n <= 33.0; },
        [&out](double n) { out.refine.min_angle = static_cast<float>(n); })
        ->type_name("DEGREES");
    add_number(
        app, "--max-edge", "the longest edge of refined triangles (default: 0.05 with quadtree, otherwise any)",
        "a number from 0 to 1000", [](double n) { return n >= 0.0 && n <= 1000.0; },
        [&out](double n) { out.refine.max_edge = static_cast<float>(n); })
        ->type_name("EM");
    app.add_option("--bend", raw.bend, "bend the text around a cylinder:2 or in another SHAPE of the list below")
        ->type_name("SHAPE");
    app.add_option("--path", raw.path, "stand the letters on a circle:2 or on another CURVE of the list below")
        ->type_name("CURVE");
}

void add_inflate_options(CLI::App& app, options& out, raw_values& raw)
{
    using typemesh::inflated_form;
    add_number(
        app, "--inflate", "inflate the letters: 1 makes strokes round, 0.5 half as high; 0 does not (default)",
        "a number from 0 to 100", [](double n) { return n >= 0.0 && n <= 100.0; },
        [&out](double n) { out.inflate.height = static_cast<float>(n); })
        ->type_name("TIMES");
    add_named<inflated_form>(app, "--inflate-form", out.inflate.form,
                             "inflate front and back (balloon, default), or the front on walls of --depth (dome)",
                             {{"balloon", inflated_form::balloon}, {"dome", inflated_form::dome}});
    app.add_option("--tube", raw.tube,
                   "make neon letters, of tubes along the outline: their radius and, 16 if left out, their sides")
        ->type_name("EM[,SIDES]");
}

void add_plate_options(CLI::App& app, plate_words& words)
{
    app.add_option("--plate", words.plate,
                   "stand the letters, --depth high (default 0.05), on a plate; radius and thickness are 0.1")
        ->type_name("MARGIN[,RADIUS[,THICKNESS]]");
    app.add_option("--backing", words.backing, "stand them on a plate that follows their outline at this distance")
        ->type_name("EM[,THICKNESS]");
    app.add_flag("--open-counters", words.open_counters, "leave the counters of a --backing open");
    app.add_option("--keyring", words.keyring,
                   "a hole at the left end of the plate: its radius, and the width of its ring (default 0.06)")
        ->type_name("EM[,WIDTH]");
    app.add_option("--fillet", words.fillet, "a hollow around the foot of standing letters, of this radius")
        ->type_name("EM");
    app.add_option("--engrave", words.engrave, "engrave the letters into the plate, this deep")->type_name("EM");
    app.add_flag("--cut", words.cut, "cut the letters through the plate");
    app.add_option("--stencil", words.stencil,
                   "cut them through, with N (default 2) bridges of this width for each counter")
        ->type_name("EM[,N]");
    app.add_flag("--inlay", words.inlay,
                 "fill what --engrave (default 0.05) or --cut removes with a second solid: .3mf, .glb, .obj");
    app.add_flag("--stamp", words.stamp, "mirror the plate and its letters");
}

void add_output_options(CLI::App& app, options& out, raw_values& raw)
{
    app.add_option("-o,--output", out.output,
                   "write .glb, .obj (with .mtl), .stl, .ply or .3mf; curves: .svg, .dxf; - is standard output")
        ->type_name("FILE");
    app.add_option("--format", raw.format, "the format of --output, whatever its name is")
        ->check(one_of({"glb", "obj", "stl", "ply", "3mf", "svg", "dxf"}));
    app.add_option("--picture", out.picture, "write a picture, as fine as its pixels, or of the given quality")
        ->type_name("FILE.png");
    add_named<shading>(app, "--shading", out.shading, "the shading of the picture (default phong)",
                       {{"flat", shading::flat}, {"gouraud", shading::gouraud}, {"phong", shading::phong}});
    add_number(
        app, "--turn", "turn the view of the picture to the right (default -26, less for a long line; 0 if flat)",
        "a number from -180 to 180", [](double n) { return n >= -180.0 && n <= 180.0; },
        [&out](double n) { out.turn = static_cast<float>(n); })
        ->type_name("DEGREES");
    app.add_option("--show", raw.show,
                   "draw these on the picture, joined by commas; most of them show the mesh of --output")
        ->delimiter(',')
        ->check(one_of({"triangles", "points", "contours", "control", "normals", "checker"}))
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    app.add_flag("--stats", out.stats, "print counts, bounds, volume and times as one line of JSON");
}

/// A number in as few digits as tell it.
std::string written(float n)
{
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, n).ptr};
}

/// The profile by its name or its points. Gives an empty string, or what is wrong.
std::string settle_profile(bevel_options& out, const raw_values& raw)
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
std::string settle_rims(options& out, const raw_values& raw)
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
std::string settle_bevel(options& out, const raw_values& raw)
{
    const auto width = static_cast<double>(out.bevel.width);
    if (std::string trouble = settle_profile(out.bevel, raw); !trouble.empty()) return trouble;
    if (width == 0.0)
        return raw.of_a_bevel.empty() || raw.bevel_given ? std::string{} : raw.of_a_bevel + " needs --bevel";
    if (out.depth == 0.0f) return "--bevel needs a solid, but --depth 0 makes a flat mesh: give a larger --depth";
    if (raw.normals_given) return "--normals does not work with --bevel, which takes all normals from the curves";
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
std::string settle_taper(options& out, const raw_values& raw)
{
    if (out.taper == 0.0f) return {};
    if (!raw.not_with_taper.empty()) return raw.not_with_taper + " does not work with --taper";
    if (out.depth == 0.0f) return "--taper needs a solid, but --depth 0 makes a flat mesh: give a larger --depth";
    if (raw.normals_given) return "--normals does not work with --taper, which takes all normals from the curves";
    const typemesh::bevelled walls = typemesh::tapered{.depth = out.depth, .degrees = out.taper}.walls();
    out.bevel.width = walls.width;
    out.bevel.depth = walls.bevel_depth;
    out.bevel.sides = walls.sides;
    return {};
}

/// Finishes carved letters. Gives an empty string, or one sentence of what is wrong.
std::string settle_carving(const options& o, const raw_values& raw)
{
    if (o.carve.tool_angle == 0.0f)
        return raw.of_a_carving.empty() ? std::string{} : raw.of_a_carving + " needs --carve";
    if (raw.depth_given) return "--depth does not work with --carve: give --carve-depth";
    if (o.bevel.width > 0.0f) return "--bevel does not work with --carve";
    if (o.outline.width > 0.0f) return "--outline does not work with --carve";
    if (!raw.refine.empty()) return "--refine does not work with --carve";
    if (raw.normals_given) return "--normals does not work with --carve, which takes all normals from the curves";
    if (o.carve.as == typemesh::carving::groove && is_printed(o.kind))
        return std::string{"--carve-as groove is an open surface, but a ."} +
               (o.kind == file_kind::stl ? "stl" : "3mf") + " file contains solids: give relief or cutter";
    return {};
}

/// Finishes bold and hollow letters. Gives an empty string, or one sentence of what is wrong.
std::string settle_weight(options& out, const raw_values& raw)
{
    using typemesh::outline_place;
    const auto width = static_cast<double>(out.outline.width), bolder = static_cast<double>(out.embolden);
    if (width == 0.0 && !raw.of_an_outline.empty()) return raw.of_an_outline + " needs --outline";
    if (out.outline.letter && out.bevel.outward && out.bevel.width > 0.0f)
        return "--bevel-out does not work with --outline-letter, because the ring would grow into the letter";
    const double ring = out.outline.place == outline_place::outer    ? width
                        : out.outline.place == outline_place::centre ? 0.5 * width
                                                                     : 0.0;
    const double around = ring + static_cast<double>(out.tube.radius);
    if (std::find(raw.given.begin(), raw.given.end(), "--stroke") != raw.given.end())
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
std::string settle_refine(options& out, const raw_values& raw)
{
    if (raw.refine.empty()) return raw.of_refining.empty() ? std::string{} : raw.of_refining + " needs --refine";
    out.refine.refiner = raw.refine == "quadtree"    ? refiner_name::quadtree
                         : raw.refine == "nonobtuse" ? refiner_name::non_obtuse
                                                     : refiner_name::delaunay;
    if (out.refine.refiner != refiner_name::delaunay && raw.of_refining == "--min-angle")
        return "--min-angle needs --refine delaunay";
    if (out.refine.refiner == refiner_name::quadtree && out.refine.max_edge && !(*out.refine.max_edge > 0.0f))
        return "--max-edge must be above 0 with --refine quadtree";
    if (out.bevel.width > 0.0f) return "--refine does not work with --bevel";
    if (out.outline.width > 0.0f) return "--refine does not work with --outline";
    return {};
}

/// Says what is wrong with inflated letters; empty if nothing is.
std::string refused_inflation(const options& out, const raw_values& raw)
{
    if (out.inflate.height == 0.0f)
        return raw.of_inflating.empty() ? std::string{} : raw.of_inflating + " needs --inflate";
    if (out.bevel.width > 0.0f) return "--inflate does not work with --bevel";
    if (out.outline.width > 0.0f) return "--inflate does not work with --outline";
    if (out.refine.refiner != refiner_name::none) return "--inflate does not work with --refine";
    if (out.carve.tool_angle > 0.0f) return "--inflate does not work with --carve";
    if (raw.normals_given) return "--normals does not work with --inflate, which has normals of its own";
    if (out.inflate.form == typemesh::inflated_form::dome && out.depth == 0.0f)
        return "--inflate-form dome needs walls, but --depth is 0: give a larger --depth";
    return {};
}

/// Finishes tubes, before anything that they exclude or make wider. Gives an empty string, or one sentence of what is
/// wrong.
std::string settle_tube(options& out, const raw_values& raw)
{
    if (raw.tube.empty()) return {};
    if (const std::string trouble = read_tube(raw.tube, out.tube); !trouble.empty()) return "--tube " + trouble;
    if (raw.depth_given) return "--depth does not work with --tube: its radius is the depth";
    if (out.bevel.width > 0.0f) return "--bevel does not work with --tube";
    if (out.carve.tool_angle > 0.0f) return "--carve does not work with --tube";
    if (out.outline.width > 0.0f) return "--outline does not work with --tube";
    if (out.inflate.height > 0.0f) return "--inflate does not work with --tube";
    if (!raw.refine.empty()) return "--refine does not work with --tube";
    if (out.segments != 1) return "--segments does not work with --tube";
    if (raw.normals_given) return "--normals does not work with --tube, whose normals are round";
    return {};
}

/// Finishes bent letters. Gives an empty string, or one sentence of what is wrong.
std::string settle_bend(options& out, const raw_values& raw)
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
std::string settle_path(options& out, const raw_values& raw)
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
std::string settle_plate(options& out, const raw_values& raw)
{
    const std::optional<float> depth = raw.depth_given ? std::optional{out.depth} : std::nullopt;
    if (std::string trouble = read_plate(raw.plate, depth, out.plate); !trouble.empty()) return trouble;
    if (!out.plate.is_on) return {};
    const std::string option = out.plate.follows ? "--backing" : "--plate";
    if (!raw.not_with_plates.empty()) return raw.not_with_plates + " does not work with " + option;
    constexpr file_kind solids[] = {file_kind::glb, file_kind::obj, file_kind::stl, file_kind::ply,
                                    file_kind::three_mf};
    if (!out.output.empty() && std::find(std::begin(solids), std::end(solids), out.kind) == std::end(solids))
        return option + " needs a file of solids: .glb, .obj, .stl, .ply or .3mf";
    if (out.bend.is_on) return "--bend works with " + option + " only in the plane: arc, arch, flag, perspective";
    for (const styled_range& r : out.styles)
        if (r.colour) return "--style: colours do not work with " + option + ", whose letters have one colour";
    if (out.show_contours || out.show_points || out.show_control)
        return "--show contours, points and control do not work with " + option;
    if (out.plate.how.style == typemesh::plate_style::inlay && !raw.not_with_inlays.empty())
        return raw.not_with_inlays + " does not work with --inlay";
    if (out.plate.how.style == typemesh::plate_style::inlay && !out.output.empty() && !holds_colours(out.kind))
        return "--inlay needs a file that keeps its two solids apart: .3mf, .glb or .obj";
    return {};
}

/// Finishes the options for lines. Gives an empty string, or what is wrong.
std::string settle_lines(options& out, const raw_values& raw)
{
    using typemesh::alignment;
    const auto given = [&raw](const char* option) {
        return std::find(raw.of_lines.begin(), raw.of_lines.end(), option) != raw.of_lines.end();
    };
    const alignment align = out.lines.align;
    if (given("--fit") && !read_box(raw.fit, out.fit_width, out.fit_height))
        return "--fit must be two positive numbers up to 1000000, such as 30x10, not " + raw.fit;
    for (const char* other : {"--width", "--ellipsis"})
        if (given("--fit") && given(other))
            return std::string{other} + " does not work with --fit, which shows all text";
    if (given("--fit") && raw.size) return "--size does not work with --fit, which finds the size";
    const bool boxed = given("--width") || given("--fit");
    if (!boxed && align == alignment::justify) return "--align justify needs --width or --fit";
    if (align != alignment::justify && given("--justify")) return "--justify needs --align justify";
    for (const char* option : {"--wrap", "--breaker"})
        if (!boxed && given(option)) return std::string{option} + " needs --width or --fit";
    if (out.lines.wrap == typemesh::wrap_mode::none && given("--breaker"))
        return "--breaker does not work with --wrap none";
    if (!given("--width") && !given("--max-lines") && given("--ellipsis"))
        return "--ellipsis needs --width or --max-lines";
    out.ellipsis = with_line_breaks(out.ellipsis);
    if (out.ellipsis.find('\n') != std::string::npos) return "--ellipsis must be one line";
    if (!given("--ellipsis") && given("--elide")) return "--elide needs --ellipsis";
    return {};
}

/// Why what is for columns only is refused, or an empty string.
std::string refused_columns(const options& o, const raw_values& raw)
{
    if (o.direction == typemesh::direction::top_to_bottom) return {};
    if (!raw.of_columns.empty()) return raw.of_columns + " needs --direction ttb";
    for (const styled_range& r : o.styles)
        if (r.style.column != typemesh::column_style::automatic)
            return "--style: upright, sideways and combined need --direction ttb";
    return {};
}

/// Chooses between --font and --family. Gives an empty string, or what is wrong.
std::string settle_font(options& out, const raw_values& raw)
{
    if (raw.family.empty() && out.font.empty()) return "there is no font: give --font or --family";
    if (!raw.family.empty() && !out.font.empty()) return "--family does not work with --font: give one of them";
    out.family = !raw.family.empty();
    if (out.family) out.font = raw.family;
    for (const std::string& name : out.fallback)
        if (name.empty()) return "--fallback must be a font, not an empty name";
    return {};
}

/// Why the fonts of styles are refused, or an empty string.
std::string refused_faces(const options& o)
{
    const std::size_t fonts = o.fallback.size() + 1;
    for (const styled_range& r : o.styles)
        if (r.style.face >= fonts)
            return "font=" + std::to_string(r.style.face + 1) + " needs another --fallback, because there " +
                   (fonts == 1 ? "is only 1 font" : "are only " + std::to_string(fonts) + " fonts");
    return {};
}

/// Finishes levels of detail. Gives an empty string, or one sentence of what is wrong.
std::string settle_levels(options& out, const raw_values& raw)
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

/// Why the file cannot distinguish letters, or an empty string.
std::string refused_letters(const options& o)
{
    const std::string option = o.per_letter ? "--per-letter" : "--letters";
    if (!o.letters && !o.per_letter) return {};
    if (o.kind != file_kind::glb) return option + " needs --output FILE.glb";
    if (!o.lod.empty()) return option + " does not work with --lod";
    if (o.instances) return option + " does not work with --instances, whose meshes are shared by several letters";
    return {};
}

/// Why the file cannot say that it is a manifold, or an empty string.
std::string refused_manifold(const options& o)
{
    if (!o.manifold) return {};
    if (o.kind != file_kind::glb) return "--manifold needs --output FILE.glb";
    if (!o.lod.empty() || o.instances || o.per_letter || !o.morph.axis.empty())
        return "--manifold needs one mesh: leave out --lod, --instances, --per-letter and --morph";
    if (o.depth == 0.0f) return "--manifold needs a solid, but --depth 0 makes a flat mesh: give a larger --depth";
    return {};
}

bool is_given(const raw_values& raw, std::string_view option)
{
    return std::find(raw.given.begin(), raw.given.end(), option) != raw.given.end();
}

/// Finishes a morph. Gives an empty string, or one sentence of what is wrong.
std::string settle_morph(options& out, const raw_values& raw)
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

/// Why the layers of colour glyphs are refused, or an empty string.
std::string settle_colour_layers(options& out, const raw_values& raw)
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
std::string refused_stroke(const options& o, const raw_values& raw)
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
std::string refused_curves(const options& o, const raw_values& raw)
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

/// Why an option does not fit to a drawing instead of a text, or an empty string.
std::string settle_svg(options& out, const raw_values& raw)
{
    constexpr std::string_view of_texts[] = {
        "--text-file",  "--batch",          "--font",         "--fallback",  "--family",
        "--face",       "--variation",      "--morph",        "--feature",   "--language",
        "--script",     "--direction",      "--latin",        "--columns",   "--combine-digits",
        "--align",      "--letter-spacing", "--line-spacing", "--width",     "--wrap",
        "--breaker",    "--justify",        "--indent",       "--max-lines", "--ellipsis",
        "--elide",      "--style",          "--markup",       "--lod",       "--fill",
        "--instances",  "--letters",        "--per-letter",   "--path",      "--stroke",
        "--discretiser"};
    if (raw.text_given) return "--svg does not work with TEXT: give one of them";
    for (const std::string_view option : of_texts)
        if (std::find(raw.given.begin(), raw.given.end(), option) != raw.given.end())
            return std::string{option} + " does not work with --svg";
    if (out.show_contours || out.show_points || out.show_control)
        return "--show contours, points and control do not work with --svg";
    return {};
}

/// Why there can be no drawings in the text, or an empty string.
std::string refused_icons(const options& o)
{
    if (o.icons.empty()) return {};
    if (!o.markup) return "--icon needs --markup, and a tag [box=W,H] for each file";
    if (o.discretiser != discretiser_name::certified) return "--icon needs --discretiser certified";
    if (o.show_contours || o.show_points || o.show_control)
        return "--show contours, points and control do not work with --icon";
    return {};
}

/// Finds out what is to be written. Gives an empty string, or what is wrong.
std::string settle_files(options& out, const raw_values& raw)
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

/// Decides which place comes to the origin. Gives an empty string, or what is wrong.
std::string settle_place(options& out, const raw_values& raw)
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

/// Decides where the text comes from. Gives an empty string, or what is wrong.
std::string settle_source(options& out, const raw_values& raw)
{
    if (!out.svg.empty()) return {};
    const bool file = !out.text_file.empty(), batch = !out.batch.empty();
    if (!raw.text_given && !file && !batch) return "there is no text: give TEXT, --text-file, --batch or --svg";
    if (raw.text_given && (file || batch))
        return std::string{file ? "--text-file" : "--batch"} + " does not work with TEXT: give one of them";
    if (file && batch) return "--batch does not work with --text-file: give one of them";
    if (batch) return refused_patterns(out);
    if (file) return {};
    if (out.text == standard_output) {
        out.text_file = out.text;
        return {};
    }
    if (out.text.starts_with('@'))
        return "TEXT begins with @: give --text-file " + out.text.substr(1) + " for a file, or \\" + out.text +
               " for this text";
    if (out.text.starts_with("\\@") || out.text == "\\-") out.text.erase(0, 1);
    out.text = with_line_breaks(out.text);
    if (out.markup) return {};  // read later, as the texts of files are
    const std::string trouble = refused_ranges(out.styles, out.text);
    return trouble.empty() ? trouble : "--style: " + trouble;
}

/// Finishes what the words left open. Gives an empty string, or one sentence of what is wrong.
std::string settle(options& out, const raw_values& raw)
{
    using namespace typemesh;
    for (const std::string& v : raw.variations) {
        const auto read = read_variation(v);
        if (!read) return "--variation must have the form wght=700, not " + v;
        out.variations.push_back(*read);
    }
    for (const std::string& f : raw.features) {
        const auto read = read_feature(f);
        if (!read) return "--feature must have the form liga, -liga or liga=0, not " + f;
        out.features.push_back(*read);
    }
    if (!out.script.empty() && out.script.size() != 4)
        return "--script must be four letters, such as Latn, not " + out.script;
    if (raw.uv == "box") out.uv = texture_mapping::box;
    if (raw.uv == "cylindrical") out.uv = texture_mapping::cylindrical;
    if (!raw.fill.empty()) out.fill = raw.fill == "nonzero" ? fill_rule::non_zero : fill_rule::even_odd;
    const auto shown = [&](const char* what) {
        return std::find(raw.show.begin(), raw.show.end(), what) != raw.show.end();
    };
    out.show_triangles = shown("triangles");
    out.show_points = shown("points");
    out.show_contours = shown("contours");
    out.show_control = shown("control");
    out.show_normals = shown("normals");
    out.checker = shown("checker");

    if (out.markup && !out.styles.empty()) return "--style does not work with --markup: give its settings as tags";
    if (std::string trouble = refused_icons(out); !trouble.empty()) return trouble;
    if (!out.svg.empty()) {
        if (std::string trouble = settle_svg(out, raw); !trouble.empty()) return trouble;
    } else if (std::string trouble = settle_font(out, raw); !trouble.empty()) {
        return trouble;
    }
    if (std::string trouble = settle_lines(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = refused_columns(out, raw); !trouble.empty()) return trouble;
    if (out.depth == 0.0f && out.segments != 1)
        return "--segments needs a solid, but --depth 0 makes a flat mesh: give a larger --depth";
    if (std::string trouble = settle_tube(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_rims(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_bevel(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_taper(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_weight(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_refine(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_bend(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_path(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = refused_inflation(out, raw); !trouble.empty()) return trouble;

    if (std::string trouble = settle_files(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_plate(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_levels(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_morph(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_carving(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_place(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = settle_colour_layers(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = refused_stroke(out, raw); !trouble.empty()) return trouble;
    if (std::string trouble = refused_curves(out, raw); !trouble.empty()) return trouble;
    if (out.picture.empty() && !raw.show.empty()) return "--show needs --picture";
    if (out.picture.empty() && raw.shading_given) return "--shading needs --picture";
    if (out.picture.empty() && out.turn) return "--turn needs --picture";
    if (out.discretiser != discretiser_name::certified && raw.tolerance_given)
        return "--tolerance needs --discretiser certified: adaptive uses --quality, and two_lines uses neither";
    if (out.discretiser == discretiser_name::two_lines && out.quality_given)
        return "--quality does not work with --discretiser two_lines, which makes two lines of every curve";
    if (out.instances && out.kind != file_kind::glb) return "--instances needs --output FILE.glb";
    if (std::string trouble = refused_letters(out); !trouble.empty()) return trouble;
    if (std::string trouble = refused_manifold(out); !trouble.empty()) return trouble;
    out.size = raw.size.value_or(has_millimetres(out.kind) ? 10.0 : 1.0);
    using typemesh::touching;
    out.keeps_apart = raw.no_merge;
    const bool parts = wants_two_faces(out.kind) || out.plate.is_on || out.manifold;
    out.corners = raw.corners.value_or(parts ? touching::part : touching::keep);
    const bool edges_move = out.bevel.width > 0.0f || out.carve.tool_angle > 0.0f || out.outline.width > 0.0f ||
                            out.embolden != 0.0f || out.tube.radius > 0.0f;
    out.merge = out.merge ||
                (!raw.no_merge && !out.instances &&
                 (holds_solids(out.kind) || holds_curves(out.kind) || edges_move || out.corners != touching::keep));
    if (std::string trouble = refused_faces(out); !trouble.empty()) return "--style: " + trouble;
    return settle_source(out, raw);
}

}  // namespace

std::optional<int> parse(int argc, char** argv, options& out)
{
    CLI::App app{"Makes a 3D mesh and a picture of a text.", "text_to_mesh"};
    app.formatter(std::make_shared<plain_help>());
    app.set_help_flag("-h,--help", "print this and exit");
    app.footer(
        "Settings of --style: colour=red or #2060c0, underline, strike-through, overline, superscript, subscript,\n"
        "size=TIMES, rise=EM, slant=EM, letter-spacing=EM, word-spacing=EM, feature=TAG[=N], language=L,\n"
        "font=N (1: --font, 2: the first --fallback); in columns upright, sideways, combined.\n"
        "Tags of --markup: [b] [i] [u] [s] [o] [sup] [sub] [size=TIMES] [rise=EM] [spacing=EM] [colour=#c33] [font=N]\n"
        "[lang=L] [style=N] [depth=EM] [bevel=EM] [mark=#HEX] [ruby=TEXT] [box=W,H]; [/b] closes [b], [/] the last "
        "tag;\n"
        "[[ is a bracket.\n"
        "Places of --anchor: left, centre, right (default: where --align has it); baseline (default), bottom, middle, "
        "top;\n"
        "front (default), halfway, base (default in .stl and .3mf, which puts it on z = 0).\n"
        "Shapes of --bend: cylinder:RADIUS, sphere:RADIUS, twist:DEGREES, taper:GROWTH, wave:HEIGHT,LENGTH; in the "
        "plane\n"
        "arc:DEGREES, arch:TOP,BASELINE, flag:HEIGHT,LENGTH (a length of 0 is the text's), perspective:SCALE.\n"
        "Curves of --path, in em: circle:RADIUS, arc:RADIUS,DEGREES (a negative radius: inside), wave:HEIGHT,LENGTH, "
        "or\n"
        "a path with the commands M, L, Q, C and Z of SVG, y up: \"M0,0 C1,1 2,1 3,0\".\n"
        "A tab moves to the next tab stop; \\t does not.\n"
        "\n"
        "Examples:\n"
        "  text_to_mesh Hello -f \"DejaVu Sans:bold\" -o hello.glb\n"
        "  text_to_mesh \"Happy\\nbirthday\" -f Arial --align centre --fit 80x40 -o sign.stl    (millimetres)\n"
        "  text_to_mesh Rag -f F.ttf --bevel 0.03 --profile round --colour red -o rag.glb --picture rag.png\n"
        "  text_to_mesh --text-file page.txt -f F.ttf --width 30 --align justify -o page.glb --instances\n"
        "  text_to_mesh \"Letters that move\" -f F.ttf --per-letter -o letters.glb\n"
        "  text_to_mesh Anna -f F.ttf --plate 0.2 -o plate.3mf\n"
        "  text_to_mesh --batch names.txt -f F.ttf --anchor centre,middle -o \"tags/{n} {text}.stl\"\n"
        "  text_to_mesh --svg logo.svg --depth 0.1 --bevel 0.01 -o logo.glb\n"
        "  fortune | text_to_mesh - --family \"Noto Sans\" -o - --format obj | less\n");
    app.set_version_flag("--version", version(), "print the version and exit");
    raw_values raw;
    add_text_options(app, out, raw);
    add_line_options(app, out, raw);
    add_mesh_options(app, out, raw);
    add_bevel_options(app, out, raw);
    add_taper_option(app, out);
    add_carve_options(app, out);
    add_weight_options(app, out, raw);
    add_refine_options(app, out, raw);
    add_inflate_options(app, out, raw);
    add_plate_options(app, raw.plate);
    add_output_options(app, out, raw);

    const auto complain = [](const std::string& sentence) {
        std::fprintf(stderr, "text_to_mesh: %s%s\nRun text_to_mesh --help for all options.\n", sentence.c_str(),
                     sentence.ends_with('?') ? "" : ".");
        return 2;
    };
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {  // --help, --version
        return app.exit(asked);
    } catch (const CLI::ParseError& wrong) {
        return complain(in_words(wrong, app, argc, argv));
    }
    raw.text_given = app.count("TEXT") > 0;
    for (const CLI::Option* option : app.get_options())
        if (option->count() > 0 && !option->get_lnames().empty()) raw.given.push_back("--" + option->get_lnames()[0]);
    for (const auto& [option, value] :
         {std::pair{"--text-file", &out.text_file}, std::pair{"--batch", &out.batch}, std::pair{"--svg", &out.svg}})
        if (app.count(option) > 0 && value->empty())
            return complain(std::string{option} + " must be a file's name or -");
    for (const char* option :
         {"--plate", "--backing", "--engrave", "--stencil", "--keyring", "--fillet", "--tube", "--bend", "--path",
          "--lod", "--morph", "--anchor", "--origin", "--output", "--picture"}) {
        const auto values = app.get_option(option)->results();  // an empty variable of a shell is no missing option
        if (std::find(values.begin(), values.end(), "") != values.end())
            return complain(std::string{option} + " must not be empty");
    }
    raw.of_lines.erase(std::remove_if(raw.of_lines.begin(), raw.of_lines.end(),
                                      [&app](const std::string& option) { return app.count(option) == 0; }),
                       raw.of_lines.end());
    raw.tolerance_given = app.count("--tolerance") > 0;
    raw.bevel_given = app.count("--bevel") > 0;
    raw.normals_given = app.count("--normals") > 0;
    for (const char* option :
         {"--bevel-out", "--bevel-sides", "--bevel-mode", "--bevel-steps", "--profile", "--bevel-depth"})
        if (app.count(option) > 0) raw.of_a_bevel = option;
    raw.depth_given = app.count("--depth") > 0;
    for (const char* name : not_with_plates)
        if (const CLI::Option* option = app.get_option_no_throw(name); option != nullptr && option->count() > 0)
            raw.not_with_plates = name;
    if (const CLI::Option* option = app.get_option_no_throw("--manifold"); option != nullptr && option->count() > 0)
        raw.not_with_inlays = "--manifold";  // two solids that touch
    for (const char* option : {"--bevel", "--carve", "--inflate", "--refine", "--tube"})
        if (app.count(option) > 0) raw.not_with_taper = option;
    for (const char* option : {"--carve-as", "--carve-depth"})
        if (app.count(option) > 0) raw.of_a_carving = option;
    for (const char* option : {"--outline-letter", "--outline-place"})
        if (app.count(option) > 0) raw.of_an_outline = option;
    for (const char* option : {"--max-edge", "--min-angle"})
        if (app.count(option) > 0) raw.of_refining = option;
    if (app.count("--inflate-form") > 0) raw.of_inflating = "--inflate-form";
    for (const char* option : {"--latin", "--combine-digits", "--columns"})
        if (app.count(option) > 0) raw.of_columns = option;
    raw.shading_given = app.count("--shading") > 0;
    out.quality_given = raw.tolerance_given || app.count("--quality") > 0;
    if (!raw.tolerance_given) {
        using namespace typemesh;
        constexpr double em[] = {quality::low, quality::normal, quality::high, quality::best};
        out.tolerance = em[static_cast<int>(out.quality)];
        if (!out.svg.empty() && !out.quality_given) out.tolerance *= 0.2;  // its em is not a letter, but the whole
    }
    if (const std::string trouble = settle(out, raw); !trouble.empty()) return complain(trouble);
    return {};
}

}  // namespace text_to_mesh
