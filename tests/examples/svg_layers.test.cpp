// SPDX-License-Identifier: MIT

// Files of SVG have the areas of their shapes, whichever way they are written.

#include "text_to_mesh/svg/svg_layers.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <vector>

#include "fuzz/replay.hpp"
#include "fuzz/svg.hpp"
#include "scratch_folder.hpp"
#include "support/catch.hpp"

using namespace text_to_mesh;

namespace {

constexpr double pi = 3.14159265358979323846;

double area_of(const typemesh::outline& o)
{
    double area = 0.0;
    for (const typemesh::curve& c : o.curves)
        for (int k = 0; k < 200; ++k) area += 0.5 * cross(c.at(k / 200.0), c.at((k + 1) / 200.0));
    return area;
}

/// What a file of a view box of 100 x 100 covers, in its own units; the last number is the silhouette.
struct read_file_of {
    std::string trouble;
    std::vector<double> areas;
    std::vector<typemesh::box> bounds;
    std::vector<rgb_colour> colours;

    explicit read_file_of(const std::string& body, const std::string& head = "viewBox='0 0 100 100'")
    {
        const scratch_folder folder;
        const std::string path = folder.file("drawing.svg");
        std::ofstream{path} << "<svg xmlns='http://www.w3.org/2000/svg' " << head << ">" << body << "</svg>";
        svg_layers layers;
        trouble = layers.open(path, 1e-5, typemesh::layer_cut::visible, rgb_colour{{1, 2, 3}});
        typemesh::glyph_run run;
        if (!trouble.empty() || !layers.lay_out(run, true)) return;
        typemesh::outline found;
        typemesh::glyph_id last = 0;
        for (const typemesh::placed_glyph& g : run.glyphs) {
            REQUIRE(layers.boundary(g.id, found));
            areas.push_back(area_of(found) / 100.0);
            bounds.push_back(found.bounds);
            colours.push_back(*layers.colour_of(run.glyph_styles[g.glyph_style].style));
        }
        REQUIRE(layers.lay_out(run, false));
        for (const typemesh::placed_glyph& g : run.glyphs) last = g.id;
        if (run.glyphs.empty()) return;
        REQUIRE(layers.boundary(last, found));
        areas.push_back(area_of(found) / 100.0);
    }
    [[nodiscard]] double all() const { return areas.empty() ? 0.0 : areas.back(); }
};

/// False, with a warning, where nothing can be tested because the program was built without pugixml.
bool reads_svg()
{
    svg_drawing none;
    if (read_svg("-.svg", {}, none).find("not built in") == std::string::npos) return true;
    WARN("SVG is not tested: pugixml is not there");
    return false;
}

std::string repeated(const std::string& what, std::size_t times)
{
    std::string made;
    made.reserve(what.size() * times);
    for (std::size_t i = 0; i < times; ++i) made += what;
    return made;
}

/// A file as it is read, before its layers are cut.
struct drawing_of {
    svg_drawing drawing;
    std::string trouble;

    explicit drawing_of(const std::string& body, const svg_options& how = {})
    {
        const scratch_folder folder;
        const std::string path = folder.file("drawing.svg");
        std::ofstream{path} << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'>" << body << "</svg>";
        trouble = read_svg(path, how, drawing);
    }
    [[nodiscard]] bool says(const std::string& what) const { return trouble.find(what) != std::string::npos; }
};

void check_area(const std::string& body, double wanted)
{
    const read_file_of file{body};
    INFO(body);
    CHECK(file.trouble.empty());
    CHECK(file.all() == Approx(wanted).epsilon(1e-4).margin(1e-6));
}

}  // namespace

TEST_CASE("shapes of SVG have their areas", "[examples][svg]")
{
    if (!reads_svg()) return;
    check_area("<rect x='10' y='10' width='50' height='20'/>", 1000.0);
    check_area("<rect x='10' y='10' width='50' height='20' rx='5'/>", 1000.0 - (4.0 - pi) * 25.0);
    check_area("<rect x='10' y='10' width='50' height='20' rx='50' ry='5'/>", 1000.0 - (4.0 - pi) * 125.0);
    check_area("<rect x='10' y='10' width='0' height='20'/>", 0.0);
    check_area("<circle cx='50' cy='50' r='20'/>", pi * 400.0);
    check_area("<ellipse cx='50%' cy='50' rx='20' ry='10'/>", pi * 200.0);
    check_area("<polygon points='0,0 10,0 10 10'/><polyline points='50 50,60 50,60,60'/>", 100.0);
    check_area("<line x1='10' y1='50' x2='60' y2='50'/>", 0.0);
    check_area("<path d='M0 0h50v50h-50zM10 10h30v30h-30z' fill-rule='evenodd'/>", 1600.0);
    check_area("<path d='M0 0h50v50h-50zM10 10h30v30h-30z'/>", 2500.0);
    check_area("<path d='M0 0h50v50h-50z' fill='none'/>", 0.0);
    check_area("<path d='M0 0h50v50h-50z' display='none'/><path d='M0 0h9v9z' style='visibility:hidden'/>", 0.0);
    check_area("<rect x='-10' y='90' width='50' height='20'/>", 400.0);  // the view box cuts
}

TEST_CASE("strokes of SVG have their areas", "[examples][svg]")
{
    if (!reads_svg()) return;
    check_area("<path stroke='red' stroke-width='4' d='M10 50H60'/>", 200.0);
    check_area("<path stroke='red' stroke-width='4' stroke-linecap='square' d='M10 50H60'/>", 216.0);
    check_area("<path stroke='red' stroke-width='4' stroke-linecap='round' d='M10 50H60'/>", 200.0 + 4.0 * pi);
    check_area("<path stroke='red' stroke-width='4' stroke-dasharray='5 5' d='M10 50H60'/>", 100.0);
    check_area("<path stroke='red' stroke-width='4' stroke-dasharray='10%' d='M10 50H60'/>", 120.0);
    check_area("<rect fill='none' stroke='red' stroke-width='4' x='20' y='20' width='20' height='20'/>", 320.0);
    check_area(
        "<rect fill='none' stroke='red' stroke-width='4' stroke-linejoin='bevel' x='20' y='20' width='20' "
        "height='20'/>",
        320.0 - 8.0);
    check_area("<g stroke='red' stroke-width='2' transform='scale(2 1)'><path d='M10 50H30'/></g>", 80.0);
    // Values that are no numbers change nothing.
    for (const char* huge : {"1e308in", "1e999", "-1e999"})
        check_area("<path stroke='red' stroke-width='4' d='M10 50H60'/><path stroke='red' stroke-width='" +
                       std::string{huge} + "' d='M70 50h10'/>",
                   210.0);
    check_area("<g stroke='red' stroke-width='4' stroke-dasharray='1e308in 1'><path d='M10 50H60'/></g>", 200.0);
}

TEST_CASE("groups, uses and viewports of SVG nest", "[examples][svg]")
{
    if (!reads_svg()) return;
    check_area("<g transform='translate(50 50) rotate(30)scale(2,3)'><rect x='-5' y='-5' width='10' height='10'/></g>",
               600.0);
    check_area("<g transform='matrix(1 0 .5 1 0 0),skewX(10)'><rect width='10' height='10'/></g>", 100.0);
    check_area("<defs><rect id='r' width='10' height='10'/></defs><use href='#r'/><use href='#r' x='20'/>", 200.0);
    check_area(
        "<symbol id='s' viewBox='0 0 1 2'><rect width='1' height='2'/></symbol><use href='#s' width='40' height='40'/>",
        800.0);
    check_area("<svg x='10' y='10' width='20' height='20' viewBox='0 0 1 1'><rect width='5' height='.5'/></svg>",
               200.0);
    check_area(
        "<svg x='10' y='10' width='20' height='10' viewBox='0 0 1 1' preserveAspectRatio='none'><rect width='1' "
        "height='1'/></svg>",
        200.0);
    check_area(
        "<clipPath id='c'><circle cx='20' cy='20' r='10'/></clipPath><rect width='20' height='90' "
        "clip-path='url(#c)'/>",
        50.0 * pi);
    check_area("<clipPath id='c'/><rect width='20' height='90' clip-path='url(#c)'/>", 0.0);
    check_area("<g id='g'><use href='#g'/><rect width='10' height='10'/></g>", 100.0);
    // A switch takes the first child that can be drawn.
    check_area(
        "<switch><foreignObject requiredExtensions='x' width='1' height='1'/><title/><g systemLanguage='de'><rect "
        "width='9' height='9'/></g><g><rect width='10' height='10'/></g><rect width='20' height='20'/></switch>",
        100.0);
    // A child of a clip path has a clip of its own, and inherits the rule from where the clip path is written.
    check_area(
        "<clipPath id='d'><rect width='10' height='90'/></clipPath><clipPath id='c'><rect width='50' height='10' "
        "clip-path='url(#d)'/><rect y='50' width='50' height='10'/></clipPath><rect width='90' height='90' "
        "clip-path='url(#c)'/>",
        600.0);
    check_area(
        "<g clip-rule='evenodd'><clipPath id='c'><path d='M0 0h50v50h-50zM10 10h30v30h-30z'/></clipPath></g><rect "
        "width='90' height='90' clip-path='url(#c)'/>",
        1600.0);
    for (const char* seen : {"overflow='visible'", "style='overflow:visible'"})
        check_area(
            "<svg x='10' y='10' width='20' height='20' " + std::string{seen} + "><rect width='30' height='30'/></svg>",
            900.0);
}

TEST_CASE("colours of SVG cascade, and what covers others is cut out of them", "[examples][svg]")
{
    if (!reads_svg()) return;
    const read_file_of file{
        "<style>/* } */ rect { fill: red } .b { fill: #00f } #c { fill: rgb(0 50% 0) } @media print { rect { fill: "
        "none } }"
        "</style><rect width='40' height='40'/><rect class='a b' x='20' width='40' height='40'/>"
        "<rect id='c' class='b' x='50' width='40' height='40' fill='white'/>"
        "<rect class='b' style='fill:currentColor;fill-opacity:50%' y='60' width='10' height='10' opacity='.5'/>"};
    REQUIRE(file.colours.size() == 4);
    const auto is = [&](std::size_t i, int r, int g, int b, int a) {
        const rgb_colour& c = file.colours[i];
        return c.rgb[0] == r && c.rgb[1] == g && c.rgb[2] == b && c.alpha == a;
    };
    CHECK(is(0, 255, 0, 0, 255));
    CHECK(is(1, 0, 0, 255, 255));
    CHECK(is(2, 0, 128, 0, 255));
    CHECK(is(3, 1, 2, 3, 64));
    const double wanted[] = {800.0, 1200.0, 1600.0, 100.0, 3700.0};
    double sum = 0.0;
    for (std::size_t i = 0; i < 5; ++i) CHECK(file.areas[i] == Approx(wanted[i]));
    for (std::size_t i = 0; i < 4; ++i) sum += file.areas[i];
    CHECK(sum == Approx(file.all()));
    // The y axis is turned round: the square at the bottom is low.
    CHECK(file.bounds[3].low.y == Approx(300.0));
    CHECK(file.bounds[3].high.y == Approx(400.0));
}

TEST_CASE("what is not drawn as it should be is named once for each kind", "[examples][svg]")
{
    if (!reads_svg()) return;
    const scratch_folder folder;
    const std::string path = folder.file("lossy.svg");
    std::ofstream{path}
        << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'><style>a > b { fill: red }</style>"
           "<rect width='9' height='9'/><rect width='5' height='5' opacity='.5' filter='url(#f)'/>"
           "<image/><image/><foo/><rect mask='url(#m)' width='1' height='1' transform='turn(3)'/>"
           "<path d='M0 0h3v3x'/><g style='transform:scale(2);transform-origin:1px 1px'/></svg>";
    svg_drawing drawing;
    REQUIRE(read_svg(path, {}, drawing).empty());
    CHECK(drawing.items.size() == 4);
    const std::vector<std::string> wanted = {"style rules other than for names, classes and ids are left out",
                                             "filters are not drawn",
                                             "<image> is not drawn",
                                             "<foo> is not drawn",
                                             "malformed transforms are left out",
                                             "masks are not drawn",
                                             "malformed path data are drawn up to the mistake",
                                             "transforms in styles are left out",
                                             "origins of transforms are left out"};
    CHECK(drawing.warnings == wanted);
    svg_layers layers;
    CHECK(layers.open(path, 1e-3, typemesh::layer_cut::visible, rgb_colour{{0, 0, 0}}).empty());
}

TEST_CASE("a file without a view box is as large as its shapes", "[examples][svg]")
{
    if (!reads_svg()) return;
    const read_file_of file{"<rect x='-30' y='7' width='200' height='50'/>", ""};
    REQUIRE(file.bounds.size() == 1);
    CHECK(file.bounds[0].low.x == Approx(0.0).margin(1e-6));
    CHECK(file.bounds[0].low.y == Approx(0.0).margin(1e-6));
    CHECK(file.bounds[0].high.x == Approx(1000.0));
    CHECK(file.bounds[0].high.y == Approx(250.0));
}

TEST_CASE("paints of SVG have one paint that stands in for a reference", "[examples][svg]")
{
    if (!reads_svg()) return;
    const std::string square = "' d='M0 0h10v10h-10z'/>";
    check_area("<path fill='url(#a) red" + square, 100.0);
    check_area("<path fill='url(#a)none" + square, 0.0);
    check_area("<path fill='url(#a)" + square, 0.0);
    check_area("<path fill='" + repeated("url(#a)", 100'000) + square, 0.0);
}

TEST_CASE("all curves of a file of SVG are counted", "[examples][svg]")
{
    if (!reads_svg()) return;
    const std::string squares = "<defs><path id='p' d='" + repeated("M0 0h9v9h-9z", 1000) + "'/></defs>";
    const svg_options how{.max_curves = 10'000};
    const drawing_of two{squares + repeated("<use href='#p'/>", 2), how};
    CHECK(two.trouble.empty());
    const drawing_of three{squares + repeated("<use href='#p'/>", 100), how};
    CHECK(three.says(" draws more than 10000 curves, which is too much."));
    CHECK(three.drawing.shapes.size() == 2);
    const drawing_of dashes{
        "<path fill='none' stroke='red' stroke-dasharray='.01' d='" + repeated("M0 0h90", 1000) + "'/>", how};
    CHECK(dashes.says(" draws more than 10000 curves"));
    CHECK(dashes.drawing.shapes.empty());
    CHECK(svg_options{}.max_curves == typemesh::default_max_pieces);  // as many as can be cut
}

TEST_CASE("elements of SVG that are not drawn are work, and so are rules and dashes", "[examples][svg]")
{
    if (!reads_svg()) return;
    const svg_options how{.max_steps = 100'000};
    const auto used = [](const std::string& body) {
        return "<defs><g id='g'>" + body + "</g></defs>" + repeated("<use href='#g'/>", 100);
    };
    const std::string much = " takes too long to draw.";
    CHECK(drawing_of{used("<path d='M0 0h9v9z'/>"), how}.trouble.empty());
    CHECK(drawing_of{used(repeated("<desc/>", 1000)), how}.says(much));
    CHECK(drawing_of{used(repeated("<!---->x", 1000)), how}.says(much));
    CHECK(drawing_of{used("<path d='" + repeated(" ", 10'000) + "'/>"), how}.says(much));
    CHECK(drawing_of{"<g stroke-dasharray='" + repeated("1 ", 1000) + "'>" + repeated("<g/>", 100) + "</g>", how}.says(
        much));
    CHECK(drawing_of{"<style>" + repeated("*{fill:red}", 1000) + "</style>" + repeated("<g/>", 200), how}.says(much));
    CHECK(drawing_of{"<style>" + repeated("g,", 1000) + "g{" + repeated("fill:red;", 100) + "}</style><g/>", how}.says(
        much));
    CHECK(drawing_of{"<linearGradient id='s'>" + repeated("<stop/>", 100) + "</linearGradient>" +
                         repeated("<path fill='url(#s)' d='M0 0h9v9z'/>", 100),
                     how}
              .says(much));
}

TEST_CASE("only style rules that name an element of SVG are work for it", "[examples][svg]")
{
    if (!reads_svg()) return;
    std::string rules, elements;
    for (int i = 0; i < 1000; ++i) {
        const std::string n = std::to_string(i);
        rules += ".c" + n + ".d{fill:#123456}rect#i" + n + "{stroke:red}e" + n + "{fill:red}";
        elements += "<rect class='d c" + n + "' id='j" + n + "' width='1' height='1'/>";
    }
    // Each of 1000 rectangles and each of 3000 rules, once compared with each other, which was refused.
    const drawing_of file{"<style>" + rules + "rect.d{fill:blue}</style>" + elements, {.max_steps = 1'000'000}};
    CHECK(file.trouble.empty());
    REQUIRE(file.drawing.items.size() == 1000);
    for (const svg_drawing::item& one : file.drawing.items) REQUIRE(one.colour.rgb[0] == 0x12);
}

TEST_CASE("a file of SVG with too many points for its quality is told so", "[examples][svg]")
{
    if (!reads_svg()) return;
    const scratch_folder folder;
    const std::string path = folder.file("drawing.svg");
    std::ofstream{path} << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 100 100'><path d='"
                        << repeated("M50 50q40 40 0 40q-40-40 0-40", 7000) << "'/></svg>";
    svg_layers layers;
    CHECK(layers.open(path, 1e-9, typemesh::layer_cut::visible, {{0, 0, 0}}) ==
          path + " has more than 1000000 points at this quality: choose a coarser --quality, or divide the drawing.");
}

TEST_CASE("style sheets of SVG take memory in proportion to the file", "[examples][svg]")
{
    if (!reads_svg()) return;
    const drawing_of shared{"<style>" + repeated("a,", 10'000) + "b{" + repeated("x:y;", 10'000) + "}</style><b/>"};
    CHECK(shared.trouble.empty());  // once a copy for each selector, 7 GB
    const drawing_of rules{"<style>" + repeated("a,", 110'000) + "a{}</style>"};
    CHECK(rules.says(" has more than 100000 style rules, which is too much."));
    const drawing_of at_rules{"<style>" + repeated("@a{}", 50'000) + repeated("@a;", 50'000) + "</style>"};
    CHECK(at_rules.trouble.empty());
}

TEST_CASE("curves of SVG keep the tolerance under transforms that stretch one direction", "[examples][svg]")
{
    if (!reads_svg()) return;
    // A disc that becomes an ellipse of 500 by 0.05 units.
    const drawing_of file{"<circle transform='translate(50 50) scale(100 .01)' r='.5'/>", {.tolerance = 1e-3}};
    REQUIRE(file.drawing.shapes.size() == 1);
    double worst = 0.0;
    for (const typemesh::curve& c : file.drawing.shapes[0].curves)
        for (int k = 0; k <= 100; ++k) {
            const typemesh::point p = c.at(k / 100.0);
            worst = std::max(worst, 500.0 * std::abs(std::hypot((p.x - 500.0) / 500.0, (p.y - 500.0) / 0.05) - 1.0));
        }
    CHECK(worst < 1e-3);
}

TEST_CASE("kept and random files of SVG are read, and their layers are their silhouette", "[examples][svg][fuzz]")
{
    if (!reads_svg()) return;
    fuzz::replay("svg", fuzz::svg, 400, 400);
}
