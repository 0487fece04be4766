// SPDX-License-Identifier: MIT
#include "options.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <utility>

namespace text_to_mesh {
namespace {

/// "left, center or right"
std::string joined(const std::vector<std::string>& names)
{
    std::string all;
    for (std::size_t i = 0; i < names.size(); ++i)
        all += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
    return all;
}

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

/// A finite number that `holds`; `what` says so in words.
template <class Holds>
CLI::Validator number(const char* what, Holds holds)
{
    const auto complaint = [what, holds](std::string& given) -> std::string {
        char* end = nullptr;
        const double value = std::strtod(given.c_str(), &end);
        const bool is_one = end != given.c_str() && *end == '\0' && std::isfinite(value) && holds(value);
        return is_one ? std::string{} : "must be " + std::string{what} + ", not " + given;
    };
    return {complaint, ""};
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

template <std::size_t N>
bool copy_tag(const std::string& tag, char (&out)[N])
{
    if (tag.size() != 4) return false;
    std::copy(tag.begin(), tag.end(), out);
    return true;
}

/// "wght=700"
std::string add_variation(const std::string& argument, std::vector<typemesh::variation>& out)
{
    const auto equals = argument.find('=');
    typemesh::variation v;
    char* end = nullptr;
    const std::string complaint = "--variation: must be of the form wght=700, not " + argument;
    if (equals == std::string::npos || !copy_tag(argument.substr(0, equals), v.tag)) return complaint;
    v.value = std::strtof(argument.c_str() + equals + 1, &end);
    if (end == argument.c_str() + equals + 1 || *end != '\0' || !std::isfinite(v.value)) return complaint;
    out.push_back(v);
    return {};
}

/// "liga", "liga=0", "-liga", "+liga"
std::string add_feature(std::string argument, std::vector<typemesh::feature>& out)
{
    const std::string complaint = "--feature: must be of the form liga, -liga or liga=0, not " + argument;
    typemesh::feature f;
    if (!argument.empty() && (argument[0] == '-' || argument[0] == '+')) {
        f.value = argument[0] == '+';
        argument.erase(0, 1);
    }
    else if (const auto equals = argument.find('='); equals != std::string::npos) {
        char* end = nullptr;
        const long value = std::strtol(argument.c_str() + equals + 1, &end, 10);
        if (end == argument.c_str() + equals + 1 || *end != '\0' || value < 0 || value > 65535) return complaint;
        f.value = static_cast<std::uint32_t>(value);
        argument.erase(equals);
    }
    if (!copy_tag(argument, f.tag)) return complaint;
    out.push_back(f);
    return {};
}

/// A backslash and an n, as a shell passes them on, become a line break.
std::string with_line_breaks(std::string text)
{
    for (std::size_t i = 0; (i = text.find("\\n", i)) != std::string::npos; ++i) text.replace(i, 2, "\n");
    return text;
}

bool ends_with(const std::string& text, const char* end)
{
    const std::string tail{end};
    return text.size() > tail.size() && text.compare(text.size() - tail.size(), tail.size(), tail) == 0;
}

/// How many letters must be changed, left out, added or exchanged with their neighbour to get from one word to another.
std::size_t distance(const std::string& a, const std::string& b)
{
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t k = 0; k <= b.size(); ++k) {
            if (i == 0 || k == 0) {
                d[i][k] = i + k;
                continue;
            }
            d[i][k] = (std::min)({d[i - 1][k] + 1, d[i][k - 1] + 1, d[i - 1][k - 1] + (a[i - 1] != b[k - 1])});
            if (i > 1 && k > 1 && a[i - 1] == b[k - 2] && a[i - 2] == b[k - 1])
                d[i][k] = (std::min)(d[i][k], d[i - 2][k - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

/// "--fnot is not an option; is --font meant?", of the first argument of which something like it is true; else nothing.
std::string unknown_option(CLI::App& app, int argc, char** argv)
{
    bool is_value = false;  // of the option before it
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const auto equals = argument.find('=');
        const std::string name = argument.substr(0, equals);
        if (is_value || name.size() < 3 || name.compare(0, 2, "--") != 0) {
            is_value = false;
            continue;
        }
        const CLI::Option* option = app.get_option_no_throw(name);
        if (option != nullptr) {
            is_value = equals == std::string::npos && option->get_items_expected_min() > 0;
            continue;
        }
        std::string meant;
        std::size_t nearest = 3;
        for (const CLI::Option* known : app.get_options()) {
            for (const std::string& other : known->get_lnames()) {
                const std::size_t way = distance(name.substr(2), other);
                if (way < nearest) meant = "--" + other, nearest = way;
            }
        }
        return name + " is not an option" + (meant.empty() ? "" : "; is " + meant + " meant?");
    }
    return {};
}

/// One sentence of what is wrong with the command line.
std::string in_words(const CLI::ParseError& wrong, CLI::App& app, int argc, char** argv)
{
    if (std::string typo = unknown_option(app, argc, argv); !typo.empty()) return typo;
    if (dynamic_cast<const CLI::ExtrasError*>(&wrong) != nullptr && !app.remaining().empty()) {
        const std::string unexpected = app.remaining().front();
        return unexpected + (unexpected[0] == '-' ? " is not an option"
                                                  : " was not expected; a text of several words stands in quotes");
    }
    const std::string said = wrong.what();
    const auto colon = said.find(':');
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&wrong) == nullptr || colon == std::string::npos) return said;
    const bool lacks = said.find("missing", colon) != std::string::npos;
    return said.substr(0, colon) + (lacks ? ": needs a value" : ": may be given once only");
}

}  // namespace

std::optional<int> parse(int argc, char** argv, options& out)
{
    using namespace typemesh;
    CLI::App app{"Makes a 3D mesh of a text: GLB, OBJ, STL or PLY, and a picture of it.", "text_to_mesh"};
    std::vector<std::string> variations, features, show;
    std::string uv, fill;

    app.add_option("TEXT", out.text, "UTF-8; \\n starts a new line, a tab leads to the next tab stop")->required();
    app.add_option("--font", out.font, "a font file: TrueType, OpenType, collection, variable")
        ->required()
        ->type_name("FILE");
    app.add_option("--face", out.face, "the face's number in a collection")
        ->type_name("N")
        ->check(number("a whole number", [](double n) { return n >= 0.0 && n < 4294967296.0 && n == std::floor(n); }));
    app.add_option("--variation", variations, "sets a variable font's axis: wght=700; may come again")
        ->type_name("AXIS=VALUE")
        ->take_all()
        ->expected(1);
    app.add_option("--feature", features, "an OpenType feature: liga=0, smcp; may come again")
        ->type_name("TAG[=N]")
        ->take_all()
        ->expected(1);
    app.add_option("--language", out.language, "BCP 47: tr, zh-Hant")->type_name("L");
    app.add_option("--script", out.script, "ISO 15924: Latn, Arab")->type_name("S");
    add_named<direction>(
        app, "--direction", out.direction, "found from the text by default",
        {{"ltr", direction::left_to_right}, {"rtl", direction::right_to_left}, {"ttb", direction::top_to_bottom}});
    add_named<alignment>(app, "--align", out.align, "lines against each other (default left)",
                         {{"left", alignment::left},
                          {"center", alignment::centre},
                          {"centre", alignment::centre},
                          {"right", alignment::right}},
                         {"centre"});

    app.add_option("--depth", out.depth, "of the extrusion, in em, up to 1000; 0 makes a flat mesh (default 0.2)")
        ->type_name("EM")
        ->check(number("a number from 0 to 1000", [](double n) { return n >= 0.0 && n <= 1000.0; }));
    auto* named = add_named<preset>(
        app, "--quality", out.quality, "largest distance to the curve: 1/100, 1/160, 1/800 (default high), 1/16000 em; by default that of a "
        "picture follows its pixels",
        {{"low", preset::low}, {"normal", preset::normal}, {"high", preset::high}, {"best", preset::best}});
    app.add_option("--tolerance", out.tolerance, "the same as a number")
        ->type_name("EM")
        ->excludes(named)
        ->check(number("a positive number", [](double n) { return n > 0.0; }));
    add_named<discretiser_name>(app, "--discretiser", out.discretiser, "how curves become lines (default certified)",
                                {{"certified", discretiser_name::certified},
                                 {"two_lines", discretiser_name::two_lines},
                                 {"adaptive", discretiser_name::adaptive}});
    add_named<triangulator_name>(
        app, "--triangulator", out.triangulator, "how faces become triangles (default monotone)",
        {{"monotone", triangulator_name::monotone}, {"delaunay", triangulator_name::delaunay}});
    add_named<normals_name>(app, "--normals", out.normals, "of the sides (default curve)",
                            {{"shared", normals_name::shared},
                             {"averaged", normals_name::averaged},
                             {"creased", normals_name::creased},
                             {"curve", normals_name::curve}});
    app.add_option("--crease", out.crease, "edges that turn by more, 0 to 180, are hard (default 15, for creased 30)")
        ->type_name("DEGREES")
        ->check(number("a number from 0 to 180", [](double n) { return n >= 0.0 && n <= 180.0; }));
    app.add_option("--fill", fill, "instead of the font's own rule")->check(one_of({"nonzero", "evenodd"}));
    app.add_option("--uv", uv, "texture coordinates: over the text's box (default), or in em")
        ->check(one_of({"box", "em"}));
    bool apart = false;
    auto* merged = app.add_flag("--merge", out.merge,
                                "letters that meet become one solid without inner walls (default for .stl)");
    app.add_flag("--no-merge", apart, "each letter stays a solid of its own (default for the others)")->excludes(merged);
    app.add_flag("--strict", out.strict, "what cannot be drawn or read is an error, and nothing is written");

    app.add_option("--output", out.output, "the mesh: .glb, .obj, .stl or .ply")->type_name("FILE");
    app.add_option("--picture", out.picture, "a picture of it")->type_name("FILE.png");
    add_named<shading>(app, "--shading", out.shading, "of the picture (default phong)",
                       {{"flat", shading::flat}, {"gouraud", shading::gouraud}, {"phong", shading::phong}});
    app.add_option("--show", show,
                   "on the picture, joined by commas; contours and points of merged letters are those of the whole")
        ->delimiter(',')
        ->check(one_of({"triangles", "points", "contours", "control", "normals", "checker"}))
        ->expected(1)
        ->take_all()
        ->allow_extra_args(false);
    app.add_flag("--stats", out.stats, "print counts and times as one line of JSON");

    const auto complain = [](const std::string& sentence) {
        std::fprintf(stderr, "text_to_mesh: %s\nRun with --help for more information.\n", sentence.c_str());
        return 2;
    };
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& wrong) {
        return complain(in_words(wrong, app, argc, argv));
    }

    for (const auto& v : variations)
        if (auto trouble = add_variation(v, out.variations); !trouble.empty()) return complain(trouble);
    for (const auto& f : features)
        if (auto trouble = add_feature(f, out.features); !trouble.empty()) return complain(trouble);
    out.quality_given = app.count("--tolerance") + app.count("--quality") > 0;
    if (app.count("--tolerance") == 0) {
        constexpr double em[] = {quality::low, quality::normal, quality::high, quality::best};
        out.tolerance = em[static_cast<int>(out.quality)];
    }
    if (!out.script.empty() && out.script.size() != 4)
        return complain("--script: must be four letters, such as Latn, not " + out.script);
    out.merge = out.merge || (!apart && ends_with(out.output, ".stl"));
    if (uv == "em") out.uv = texture_mapping::em;
    if (!fill.empty()) out.fill = fill == "nonzero" ? fill_rule::non_zero : fill_rule::even_odd;
    const auto shown = [&](const char* what) { return std::find(show.begin(), show.end(), what) != show.end(); };
    out.show_triangles = shown("triangles");
    out.show_points = shown("points");
    out.show_contours = shown("contours");
    out.show_control = shown("control");
    out.show_normals = shown("normals");
    out.checker = shown("checker");

    if (!out.output.empty() && !ends_with(out.output, ".glb") && !ends_with(out.output, ".obj") &&
        !ends_with(out.output, ".stl") && !ends_with(out.output, ".ply"))
        return complain("--output: must end in .glb, .obj, .stl or .ply, not " + out.output);
    if (!out.picture.empty() && !ends_with(out.picture, ".png"))
        return complain("--picture: must end in .png, not " + out.picture);
    if (out.output.empty() && out.picture.empty() && !out.stats)
        return complain("nothing to do: give --output, --picture or --stats");
    out.text = with_line_breaks(out.text);
    return {};
}

}  // namespace text_to_mesh
