// SPDX-License-Identifier: MIT
#include "options.hpp"

#include "declare_options.hpp"
#include "raw_options.hpp"
#include "settle_form.hpp"
#include "settle_output.hpp"
#include "settle_text.hpp"
#include "wrong_usage.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>

namespace text_to_mesh {
namespace {

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

/// Writes what the options of values in words stand for.
void settle_words(options& out, const raw_options& raw)
{
    using namespace typemesh;
    const auto shown = [&raw](const char* what) {
        return std::find(raw.show.begin(), raw.show.end(), what) != raw.show.end();
    };
    out.show_triangles = shown("triangles");
    out.show_points = shown("points");
    out.show_contours = shown("contours");
    out.show_control = shown("control");
    out.show_normals = shown("normals");
    out.checker = shown("checker");
    if (raw.uv == "box") out.uv = texture_mapping::box;
    if (raw.uv == "cylindrical") out.uv = texture_mapping::cylindrical;
    if (!raw.fill.empty()) out.fill = raw.fill == "nonzero" ? fill_rule::non_zero : fill_rule::even_odd;
    out.quality_given = is_given(raw, "--tolerance") || is_given(raw, "--quality");
    if (is_given(raw, "--tolerance")) return;
    constexpr double em[] = {quality::low, quality::normal, quality::high, quality::best};
    out.tolerance = em[static_cast<int>(out.quality)];
    if (!out.svg.empty() && !out.quality_given) out.tolerance *= 0.2;  // its em is not a letter, but the whole
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
    raw_options raw;
    declare_options(app, out, raw);

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
    if (app.count("TEXT") > 0) raw.given.push_back("TEXT");
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
    settle_words(out, raw);
    const std::string trouble =
        settle_all(out, raw, settle_text, settle_files, settle_form, settle_contents, settle_source);
    if (!trouble.empty()) return complain(trouble);
    return {};
}

}  // namespace text_to_mesh
