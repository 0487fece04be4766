// SPDX-License-Identifier: MIT
#include "settle_text.hpp"

#include "atomic_file.hpp"
#include "option_values.hpp"
#include "text_source.hpp"

#include <algorithm>
#include <cstddef>
#include <string_view>

namespace text_to_mesh {
namespace {

/// Finishes the options for lines. Gives an empty string, or what is wrong.
std::string settle_lines(options& out, const raw_options& raw)
{
    using typemesh::alignment;
    const auto given = [&raw](const char* option) { return is_given(raw, option); };
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
std::string refused_columns(const options& o, const raw_options& raw)
{
    if (o.direction == typemesh::direction::top_to_bottom) return {};
    const std::string lost = first_given(raw, {"--columns", "--combine-digits", "--latin"});
    if (!lost.empty()) return lost + " needs --direction ttb";
    for (const styled_range& r : o.styles)
        if (r.style.column != typemesh::column_style::automatic)
            return "--style: upright, sideways and combined need --direction ttb";
    return {};
}

/// Why an option does not work with a drawing instead of a text, or an empty string.
std::string refused_drawing(const options& o, const raw_options& raw)
{
    const std::initializer_list<const char*> of_texts = {
        "--text-file",  "--batch",          "--font",         "--fallback",  "--family",
        "--face",       "--variation",      "--morph",        "--feature",   "--language",
        "--script",     "--direction",      "--latin",        "--columns",   "--combine-digits",
        "--align",      "--letter-spacing", "--line-spacing", "--width",     "--wrap",
        "--breaker",    "--justify",        "--indent",       "--max-lines", "--ellipsis",
        "--elide",      "--style",          "--markup",       "--lod",       "--fill",
        "--instances",  "--letters",        "--per-letter",   "--path",      "--stroke",
        "--discretiser"};
    if (is_given(raw, "TEXT")) return "--svg does not work with TEXT: give one of them";
    const std::string lost = first_given(raw, of_texts);
    if (!lost.empty()) return lost + " does not work with --svg";
    if (o.show_contours || o.show_points || o.show_control)
        return "--show contours, points and control do not work with --svg";
    return {};
}

/// Reads --variation, --feature and --script. Gives an empty string, or what is wrong.
std::string settle_shaping(options& out, const raw_options& raw)
{
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
    if (out.markup && !out.styles.empty()) return "--style does not work with --markup: give its settings as tags";
    return {};
}

/// Chooses between --font, --family and --svg. Gives an empty string, or what is wrong.
std::string settle_font(options& out, const raw_options& raw)
{
    if (!out.svg.empty()) return refused_drawing(out, raw);
    if (raw.family.empty() && out.font.empty()) return "there is no font: give --font or --family";
    if (!raw.family.empty() && !out.font.empty()) return "--family does not work with --font: give one of them";
    out.family = !raw.family.empty();
    if (out.family) out.font = raw.family;
    for (const std::string& name : out.fallback)
        if (name.empty()) return "--fallback must be a font, not an empty name";
    return {};
}

/// Why the fonts of styles are refused, or an empty string.
std::string refused_faces(const options& o, const raw_options&)
{
    const std::size_t fonts = o.fallback.size() + 1;
    for (const styled_range& r : o.styles)
        if (r.style.face >= fonts)
            return "--style: font=" + std::to_string(r.style.face + 1) + " needs another --fallback, because there " +
                   (fonts == 1 ? "is only 1 font" : "are only " + std::to_string(fonts) + " fonts");
    return {};
}

/// Why there can be no drawings in the text, or an empty string.
std::string refused_icons(const options& o, const raw_options&)
{
    if (o.icons.empty()) return {};
    if (!o.markup) return "--icon needs --markup, and a tag [box=W,H] for each file";
    if (o.discretiser != discretiser_name::certified) return "--icon needs --discretiser certified";
    if (o.show_contours || o.show_points || o.show_control)
        return "--show contours, points and control do not work with --icon";
    return {};
}

}  // namespace

std::string settle_text(options& out, const raw_options& raw)
{
    return settle_all(out, raw, settle_shaping, refused_icons, settle_font, settle_lines, refused_columns,
                      refused_faces);
}

std::string settle_source(options& out, const raw_options& raw)
{
    if (!out.svg.empty()) return {};
    const bool file = !out.text_file.empty(), batch = !out.batch.empty();
    if (!is_given(raw, "TEXT") && !file && !batch) return "there is no text: give TEXT, --text-file, --batch or --svg";
    if (is_given(raw, "TEXT") && (file || batch))
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

}  // namespace text_to_mesh
