// SPDX-License-Identifier: MIT
#pragma once

#include "paths.hpp"
#include "values.hpp"

#include "text_to_mesh/svg/svg_drawing.hpp"
#include "text_to_mesh/svg/svg_glyph.hpp"

#include <typemesh/colour/layer_regions.hpp>
#include <typemesh/inspect/polyline.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// Whole files of SVG -> shapes, clips, colours -> visible layers. The program text_to_mesh reads them.
namespace fuzz {

namespace svg_laws {

using namespace typemesh;

/// Elements in each other with their attributes, style sheets, and now and then any byte.
class file_writer {
public:
    explicit file_writer(values& in) : in_{in} {}

    std::string write()
    {
        text_ = "<svg xmlns='http://www.w3.org/2000/svg'";
        add_attributes();
        text_ += ">";
        while (!in_.empty() && text_.size() < 3000) {
            const std::uint32_t what = in_.byte() % 32;
            if (what < 18) {
                add_element();
            } else if (what < 24) {
                close();
            } else if (what < 28) {
                add_rules();
            } else if (what < 31) {
                text_ += in_.one_of(loose);
            } else {
                text_ += static_cast<char>(in_.byte());
            }
        }
        while (!open_.empty()) close();
        return text_ + "</svg>";
    }

private:
    static constexpr std::string_view names[] = {
        "path",           "rect",           "circle", "ellipse",  "line",  "polyline", "polygon", "g",     "use",
        "defs",           "symbol",         "svg",    "clipPath", "a",     "switch",   "title",   "style", "mask",
        "linearGradient", "radialGradient", "stop",   "text",     "svg:g", "x:g"};
    static constexpr std::string_view attributes[] = {"d",
                                                      "x",
                                                      "y",
                                                      "width",
                                                      "height",
                                                      "cx",
                                                      "cy",
                                                      "r",
                                                      "rx",
                                                      "ry",
                                                      "x1",
                                                      "y1",
                                                      "x2",
                                                      "y2",
                                                      "points",
                                                      "fill",
                                                      "stroke",
                                                      "stroke-width",
                                                      "stroke-dasharray",
                                                      "transform",
                                                      "style",
                                                      "class",
                                                      "id",
                                                      "href",
                                                      "clip-path",
                                                      "viewBox",
                                                      "opacity",
                                                      "offset",
                                                      "display",
                                                      "color",
                                                      "mask",
                                                      "fill-rule",
                                                      "stroke-linejoin",
                                                      "overflow",
                                                      "preserveAspectRatio",
                                                      "pathLength",
                                                      "xlink:href",
                                                      "clipPathUnits",
                                                      "stop-color",
                                                      "visibility",
                                                      "stroke-dashoffset"};
    static constexpr std::string_view pieces[] = {
        "10",   "0",     "50%",  "-5",        "1e9",     "1e-9",    "1e309",   "3mm",         " ",       ",",
        "red",  "none",  "#a",   "url(#a)",   "#b",      "url(#b)", "a",       "b",           "a b",     "currentColor",
        "#123", "#zz",   "rgb(", "1,2,3)",    "hsl(0 ",  "scale(",  "rotate(", "matrix(",     "2)",      "1 0 0 1 5 5)",
        "0 0 ", "9 9",   "20 7", "fill:red;", "stroke:", "inherit", "evenodd", "!important;", "visible", "hidden",
        "100",  "round", "1 2",  "skewX(89)", ";",       ":",       "nan",     "translate("};
    static constexpr std::string_view loose[] = {"&amp;", "<!---->", "<![CDATA[", "]]>", "&#9;",
                                                 "<?a?>", "<",       ">",         "\n"};
    static constexpr std::string_view selectors[] = {"rect",   "*",    ".a",  ".b", "#a", "#b",
                                                     "path.a", ".a.b", "g#a", ",",  " ",  "@x"};

    void add_value(std::string_view name)
    {
        if (name == "d") {
            for (const char c : path_laws::read_data(in_, 1 + in_.byte() % 64))
                if (c != '\'' && c != '<' && c != '&') text_ += c;
            return;
        }
        for (std::uint32_t i = 1 + in_.byte() % 4; i-- > 0;) text_ += in_.one_of(pieces);
    }
    void add_attributes()
    {
        for (std::uint32_t i = in_.byte() % 5; i-- > 0;) {
            const std::string_view name = in_.one_of(attributes);
            text_ += " " + std::string{name} + "='";
            add_value(name);
            text_ += '\'';
        }
    }
    void add_element()
    {
        const std::string_view name = in_.one_of(names);
        text_ += "<" + std::string{name};
        add_attributes();
        text_ += '>';
        open_.emplace_back(name);
    }
    void close()
    {
        if (open_.empty()) return;
        text_ += "</" + open_.back() + ">";
        open_.pop_back();
    }
    void add_rules()
    {
        text_ += "<style>";
        for (std::uint32_t i = in_.byte() % 4; i-- > 0;) {
            for (std::uint32_t k = 1 + in_.byte() % 3; k-- > 0;) text_ += in_.one_of(selectors);
            text_ += "{" + std::string{in_.one_of(attributes)} + ":";
            add_value("");
            text_ += in_.flag() ? "}" : ";}";
        }
        text_ += "</style>";
    }

    values& in_;
    std::string text_;
    std::vector<std::string> open_;
};

inline broken_law of_drawing(const text_to_mesh::svg_drawing& made, const text_to_mesh::svg_options& how)
{
    using text_to_mesh::svg_drawing;
    std::size_t curves = 0;
    for (const outline& o : made.shapes) {
        curves += o.curves.size();
        for (const curve& c : o.curves)
            for (std::uint32_t i = 0; i <= c.degree; ++i)
                if (!std::isfinite(c.p[i].x) || !std::isfinite(c.p[i].y)) return "a shape is not finite";
    }
    if (curves > 2 * how.max_curves) return "there are more curves than allowed";  // a line closes each contour
    const auto is_clip = [&](std::size_t c, std::size_t last) { return c == svg_drawing::no_clip || c < last; };
    for (std::size_t k = 0; k < made.clips.size(); ++k) {
        if (!is_clip(made.clips[k].inside, k)) return "a clip is inside of a later one";
        for (const auto& s : made.clips[k].shapes)
            if (s.shape >= made.shapes.size() || !is_clip(s.within, k)) return "a clip names what is not there";
    }
    for (const svg_drawing::item& i : made.items) {
        if (i.shape >= made.shapes.size() || !is_clip(i.within, made.clips.size()))
            return "a shape names what is not there";
        if (i.colour.alpha == 0) return "a shape is invisible";
    }
    if (std::set<std::string>(made.warnings.begin(), made.warnings.end()).size() != made.warnings.size())
        return "a warning is given twice";
    return {};
}

/// The visible layers add up to the silhouette, as integers; or an error says why there are none.
inline broken_law of_layers(const text_to_mesh::svg_drawing& drawing)
{
    text_to_mesh::svg_shape_source source{drawing.shapes};
    colour_glyph glyph;
    std::vector<text_to_mesh::rgb_colour> colours;
    if (!text_to_mesh::write_layers(drawing, glyph, colours)) return "no memory";
    if (colours.size() != glyph.layers.size()) return "a layer has no colour";
    layer_regions regions;
    if (!regions.build(source, 0, glyph, 1e-3, layer_cut::visible, 20'000)) return {};
    contours loops;
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < regions.layer_count(); ++i) {
        const auto layer = regions.layer(i, loops);
        if (!layer) return "no memory";
        sum += inspect::doubled_area(*layer);
    }
    const auto whole = regions.silhouette(loops);
    return whole && sum == inspect::doubled_area(*whole) ? broken_law{} : "the layers are not the silhouette";
}

}  // namespace svg_laws

inline broken_law svg(values in)
{
    const text_to_mesh::svg_options how{.tolerance = 1.0, .max_curves = 20'000, .max_steps = 2'000'000};
    text_to_mesh::svg_drawing made, again;
    const std::string file = svg_laws::file_writer{in}.write(), trouble = read_svg_text(file, how, made);
    if (!trouble.empty() && (!trouble.ends_with('.') || trouble.find('\n') != std::string::npos))
        return "a refusal is no sentence: " + trouble;
    if (broken_law broken = svg_laws::of_drawing(made, how); !broken.empty()) return broken;
    if (read_svg_text(file, how, again) != trouble || again.shapes.size() != made.shapes.size() ||
        again.items.size() != made.items.size())
        return "a file is read in two ways";
    return trouble.empty() ? svg_laws::of_layers(made) : broken_law{};
}

}  // namespace fuzz
