// SPDX-License-Identifier: MIT
#include "write_curves.hpp"

#include "colour_layers.hpp"
#include "marked_text.hpp"
#include "report.hpp"
#include "stages.hpp"
#include "svg/svg_layers.hpp"
#include "text_icons.hpp"

#include <typemesh/extrude/flat_outline.hpp>
#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/dxf_writer.hpp>
#include <typemesh/outline/svg_path_writer.hpp>
#include <typemesh/text/each_outline.hpp>
#include <typemesh/text/text_mesher.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace text_to_mesh {
namespace {

using namespace typemesh;

/// The curves of one colour, in the file's unit, y up. A curve has the degree of its points less one.
struct coloured_curves {
    struct piece {
        curve shape;
        bool begins;
    };
    std::optional<rgb_colour> colour;
    std::vector<piece> pieces;
    box bounds;
};

/// Grows a box by a curve: by its ends, and by where it turns round in x or in y.
void add_extent(box& to, const curve& c)
{
    to.add(c.start());
    to.add(c.end());
    if (c.degree < 2) return;
    const auto turn = [&](double a, double b, double d) {  // a t^2 + b t + d = 0
        const auto at = [&](double t) {
            if (t > 0.0 && t < 1.0) to.add(c.at(t));
        };
        const double inside = b * b - 4.0 * a * d;
        if (!(inside >= 0.0)) return;
        const double q = -0.5 * (b + std::copysign(std::sqrt(inside), b));
        at(q / a);
        at(d / q);
    };
    const auto both = [&](auto pick) {
        const double p0 = pick(c.p[0]), p1 = pick(c.p[1]), p2 = pick(c.p[2]);
        if (c.degree == 2) return turn(0.0, p0 - 2.0 * p1 + p2, p1 - p0);
        const double p3 = pick(c.p[3]);
        turn(p3 - 3.0 * p2 + 3.0 * p1 - p0, 2.0 * (p2 - 2.0 * p1 + p0), p1 - p0);
    };
    both([](point p) { return p.x; });
    both([](point p) { return p.y; });
}

/// An outline sink that keeps what it gets.
struct keeping_pen {
    coloured_curves& to;
    point start = {}, at = {};
    bool begins = false;

    void move(point p) noexcept { start = at = p, begins = true; }
    void line(point p) noexcept
    {
        if (!(p == at)) keep(curve::from(at, p));
    }
    void quadratic(point c, point p) noexcept { keep(curve::from(typemesh::quadratic{at, c, p})); }
    void cubic(point a, point b, point p) noexcept { keep(curve::from(typemesh::cubic{at, a, b, p})); }
    void close() noexcept { line(start); }

    void keep(const curve& c) noexcept
    {
        to.pieces.push_back({c, begins});
        add_extent(to.bounds, c);
        begins = false;
        at = c.end();
    }
};

/// The line that ends a loop is left to close().
template <outline_sink Sink>
void draw(const coloured_curves& from, Sink& to)
{
    for (std::size_t i = 0; i < from.pieces.size(); ++i) {
        const auto& [c, begins] = from.pieces[i];
        const bool is_last = i + 1 == from.pieces.size() || from.pieces[i + 1].begins;
        if (begins) to.move(c.start());
        if (c.degree != 1 || !is_last) draw_curve(c, to);
        if (is_last) to.close();
    }
}

/// The last entry if it has this colour, or a new one.
coloured_curves& of_colour(std::vector<coloured_curves>& all, const std::optional<rgb_colour>& colour)
{
    const auto code = [](const std::optional<rgb_colour>& c) {
        return c ? 1 + (c->rgb[0] + 256ll * c->rgb[1] + 65536ll * c->rgb[2] + 16777216ll * c->alpha) : 0;
    };
    if (all.empty() || code(all.back().colour) != code(colour))
        all.push_back({.colour = colour, .pieces = {}, .bounds = {}});
    return all.back();
}

/// The boundaries of a drawing's layers, mapped to where the run has them.
result<void> curves_of_drawing(const options& o, const glyph_run& page, double size, std::vector<coloured_curves>& out)
{
    outline found;
    for (const placed_glyph& g : page.glyphs) {
        if (const auto done = o.drawing->boundary(g.id, found); !done) return done.error();
        const style_id style = page.glyph_styles.empty() ? style_id{} : page.glyph_styles[g.glyph_style].style;
        keeping_pen pen{of_colour(out, colour_of_style(o, style))};
        const double scale = size / o.drawing->units_per_em();
        for (std::uint32_t k = 0; k < found.contour_count(); ++k)
            for (std::uint32_t i = found.starts[k]; i < found.starts[k + 1]; ++i) {
                curve c = found.curves[i];
                for (std::uint32_t p = 0; p <= c.degree; ++p) c.p[p] = scale * (c.p[p] + g.origin);
                if (i == found.starts[k]) pen.move(c.p[0]);
                pen.keep(c);
            }
    }
    return {};
}

result<void> curves_of_text(const options& o, font_set& font, const glyph_run& page, const text_options& how,
                            std::vector<coloured_curves>& out)
{
    text_mesher mesher{font, flat_outline{}};
    if (o.layers) mesher.use(o.layers->source());
    if (o.placed_icons) mesher.use(*o.placed_icons);
    use_stages(o, font.units_per_em(), mesher);
    if (o.path.curve) mesher.use(on_path{o.path.curve.get(), o.path.how});
    const auto plan = mesher.plan(page, how);
    if (!plan) return plan.error();
    for (std::size_t i = 0; i < plan->glyphs().size(); ++i) {
        const glyph_run& run = plan->run();
        const std::uint32_t number = run.glyphs[plan->glyphs()[i].glyph].glyph_style;
        const style_id style = run.glyph_styles.empty() ? style_id{} : run.glyph_styles[number].style;
        each_outline(*plan, i, keeping_pen{of_colour(out, colour_of_style(o, style))});
    }
    return {};
}

/// A number in at most `decimals` digits after the point, without zeros at the end.
std::string shortened(double value, int decimals)
{
    char text[64];
    std::snprintf(text, sizeof text, "%.*f", decimals, value);
    std::string made{text};
    if (made.find('.') == std::string::npos) return made;
    made.erase(made.find_last_not_of('0') + 1);
    if (made.ends_with('.')) made.pop_back();
    return made == "-0" ? "0" : made;
}

std::string fill_of(const std::optional<rgb_colour>& colour)
{
    if (!colour) return {};
    char text[64];
    std::snprintf(text, sizeof text, " fill=\"#%02x%02x%02x\"", colour->rgb[0], colour->rgb[1], colour->rgb[2]);
    std::string made{text};
    if (colour->alpha != 255) made += " fill-opacity=\"" + shortened(colour->alpha / 255.0, 3) + "\"";
    return made;
}

/// A unit is a millimetre. The last digit is at most 1/100000 em.
result<std::string> svg_text(const std::vector<coloured_curves>& all, const box& bounds, double size)
{
    int decimals = 0;
    for (double digit = 1.0; decimals < 9 && digit > 1.01e-5 * size; digit *= 0.1) ++decimals;
    const std::string w = shortened(bounds.width(), decimals), h = shortened(bounds.height(), decimals);
    std::string made = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "mm\" height=\"" + h +
                       "mm\" viewBox=\"" + shortened(bounds.low.x, decimals) + " " +
                       shortened(-bounds.high.y, decimals) + " " + w + " " + h + "\">\n";
    for (const coloured_curves& c : all) {
        if (c.pieces.empty()) continue;
        svg_path_writer path{{.yy = -1.0}, decimals};
        draw(c, path);
        if (const auto done = path.finish(); !done) return done.error();
        made += "<path" + fill_of(c.colour) + " d=\"" + std::string{path.text()} + "\"/>\n";
    }
    return made + "</svg>\n";
}

result<std::string> dxf_text(const std::vector<coloured_curves>& all)
{
    dxf_writer drawing;
    for (const coloured_curves& c : all) draw(c, drawing);
    if (const auto done = drawing.finish(); !done) return done.error();
    return std::string{drawing.text()};
}

}  // namespace

std::string write_curves(const options& o, font_set& font, const glyph_run& page, const text_options& how,
                         file_set& files, std::string& said)
{
    std::vector<coloured_curves> all;
    const auto found = o.drawing ? curves_of_drawing(o, page, how.size, all) : curves_of_text(o, font, page, how, all);
    if (!found) return in_words(found.error());
    box bounds;
    std::size_t count = 0;
    for (const coloured_curves& c : all) {
        bounds.merge(c.bounds);
        count += c.pieces.size();
    }
    if (count == 0) return "there are no outlines: nothing is written.";
    const auto text = o.kind == file_kind::svg ? svg_text(all, bounds, how.size) : dxf_text(all);
    if (!text) return in_words(text.error());
    said = std::to_string(count) + " curves and lines, " + shortened(bounds.width(), 3) + " x " +
           shortened(bounds.height(), 3) + " mm";
    const auto* const bytes = reinterpret_cast<const unsigned char*>(text->data());
    return files.add(o.output, {bytes, text->size()});
}

}  // namespace text_to_mesh
