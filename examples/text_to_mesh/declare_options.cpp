// SPDX-License-Identifier: MIT
#include "declare_options.hpp"

#include "colour_names.hpp"
#include "option_values.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

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

void add_text_options(CLI::App& app, options& out, raw_options& raw)
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

void add_line_options(CLI::App& app, options& out, raw_options& raw)
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
}

void add_mesh_options(CLI::App& app, options& out, raw_options& raw)
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
    auto* quality = add_named<preset>(
        app, "--quality", out.quality,
        "the largest distance to the curve: 1/100, 1/160, 1/800 (high, default) or 1/16000 em",
        {{"low", preset::low}, {"normal", preset::normal}, {"high", preset::high}, {"best", preset::best}});
    add_number(
        app, "--tolerance", "the same distance as a number, with --discretiser certified", "a positive number",
        [](double n) { return n > 0.0; }, [&out](double n) { out.tolerance = n; })
        ->type_name("EM")
        ->excludes(quality);
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

void add_bevel_options(CLI::App& app, options& out, raw_options& raw)
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

void add_weight_options(CLI::App& app, options& out, raw_options& raw)
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

void add_refine_options(CLI::App& app, options& out, raw_options& raw)
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

void add_inflate_options(CLI::App& app, options& out, raw_options& raw)
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

void add_output_options(CLI::App& app, options& out, raw_options& raw)
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

}  // namespace

void declare_options(CLI::App& app, options& out, raw_options& raw)
{
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
}

}  // namespace text_to_mesh
