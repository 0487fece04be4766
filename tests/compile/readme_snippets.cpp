// SPDX-License-Identifier: MIT
//
// Every line of C++ in README.md and docs/ that any system can compile: snippet_lines.cmake looks for them here and in
// windows_snippets.cpp. Nothing is run. What the guide shows can be pasted into the main() of
// README.md: here, too, nothing is used without typemesh::, and functions return int.

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/adapt/harfbuzz_axis.hpp>
#include <typemesh/adapt/harfbuzz_colours.hpp>
#include <typemesh/adapt/threads.hpp>
#include <typemesh/bend/along_curve.hpp>
#include <typemesh/bend/arc.hpp>
#include <typemesh/bend/on_cylinder.hpp>
#include <typemesh/bend/twist.hpp>
#include <typemesh/bend/warped.hpp>
#include <typemesh/bend/wave.hpp>
#include <typemesh/colour/colour_outlines.hpp>
#include <typemesh/extrude/bent.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/carved.hpp>
#include <typemesh/extrude/embolden.hpp>
#include <typemesh/extrude/flat_curved.hpp>
#include <typemesh/extrude/one_of.hpp>
#include <typemesh/extrude/outlined.hpp>
#include <typemesh/extrude/inflated.hpp>
#include <typemesh/extrude/refined.hpp>
#include <typemesh/extrude/tapered.hpp>
#include <typemesh/glyph/coarsened.hpp>
#include <typemesh/inspect/closedness.hpp>
#include <typemesh/inspect/normal_check.hpp>
#include <typemesh/layout/inline_box_place.hpp>
#include <typemesh/layout/select_glyphs.hpp>
#include <typemesh/markup/markup_styles.hpp>
#include <typemesh/morph/axis_morph.hpp>
#include <typemesh/outline/stroked.hpp>
#include <typemesh/outline/stroked_outlines.hpp>
#include <typemesh/extrude/tubed.hpp>
#include <typemesh/text/line_tubes.hpp>
#include <typemesh/outline/svg_path.hpp>
#include <typemesh/paragraph/fit_size.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/highlight_writer.hpp>
#include <typemesh/paragraph/ruby_writer.hpp>
#include <typemesh/paragraph/total_fit.hpp>
#include <typemesh/plate/name_plate.hpp>
#include <typemesh/text/font_cascade.hpp>
#include <typemesh/text/font_list.hpp>
#include <typemesh/text/on_path.hpp>
#include <typemesh/text/picked_character.hpp>
#include <typemesh/text/level_mesher.hpp>
#include <typemesh/typemesh.hpp>
#if __has_include(<fontconfig/fontconfig.h>)
#include <typemesh/adapt/fontconfig_fallback.hpp>
#endif
#include <typemesh/unicode/hyphenating.hpp>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

struct vertex { typemesh::vec3 position, normal; typemesh::vec2 uv; };          // yours, whatever it looks like

template <>
struct typemesh::vertex_traits<vertex> {                                        // once for each vertex type
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal, s.uv}; }
};

struct curved_vertex {
    typemesh::vec3 position, curve;
};
template <>
struct typemesh::vertex_traits<curved_vertex> {
    static constexpr auto wants = attribute::position | attribute::curve;
    curved_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.curve}; }
};

namespace readme {

int main()
{
    auto font = typemesh::harfbuzz_font::open("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf");
    if (!font) return std::puts(font.error().message()), 1;

    typemesh::text_mesher mesher{*font};
    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
    auto made = mesher.build("Hello world!", typemesh::into(vertices, indices));
    if (!made) return std::puts(made.error().message()), 1;
    if (!made->complete()) std::printf("not complete: %u characters missing, %u glyphs refused\n", made->missing, made->refused);
    std::printf("%zu vertices, %zu triangles\n", vertices.size(), indices.size() / 3);
    return 0;
}

void draw(std::uint32_t, typemesh::vec3) noexcept {}
void draw(std::uint32_t, std::uint32_t, std::uint32_t) noexcept {}

struct my_patterns {
    void hyphenate(typemesh::text_view text, typemesh::text_range word, std::string_view language, auto put) noexcept;  // put(place) ...
};
void my_patterns::hyphenate(typemesh::text_view, typemesh::text_range, std::string_view, auto) noexcept {}

template <class... T>
void use(const T&...)
{
}

int more(typemesh::result<typemesh::harfbuzz_font>& font, std::span<vertex> mapped_vertices,
         std::span<std::uint32_t> mapped_indices, std::span<std::uint16_t> mapped_short_indices, std::string_view text)
{
    typemesh::text_mesher mesher{*font};
    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
    {
auto plan = mesher.plan(u8"مرحبا بالعالم!", {.tolerance = typemesh::quality::best, .frame = typemesh::left_handed_y_up});
if (!plan) return std::puts(plan.error().message()), 1;     // the plan refers to its mesher: keep both
auto size = plan->size();                                   // exact: map buffers of size.vertices and size.indices()
auto written = plan->write(typemesh::into(mapped_vertices, mapped_indices));    // two spans
auto front = plan->range(typemesh::part::front);            // first_index, index_count, first_vertex, vertex_count
use(size, written, front);
    }
typemesh::text_mesher delaunay{*font, typemesh::constrained_delaunay{}};
    use(delaunay);
typemesh::text_mesher flat_text{*font, typemesh::flat{}};
typemesh::text_mesher blocky{*font, typemesh::two_lines{}, typemesh::extruded<typemesh::creased_normals>{.depth = 0.5f}};
    use(flat_text, blocky);
typemesh::text_mesher curved_text{*font, typemesh::flat_curved{}};
    use(curved_text);
struct headline {
    typemesh::text_mesher<typemesh::flat> mesher;              // the same type for any font and triangulator
};
headline shown;
shown.mesher.use(*font);
shown.mesher.use(typemesh::constrained_delaunay{});           // ends the mesher's plan
    use(shown);
auto chamfered = typemesh::text_mesher{*font, typemesh::bevelled{.width = 0.02f, .bevel_depth = 0.02f}};
auto rounded   = typemesh::text_mesher{*font, typemesh::bevelled{.profile = typemesh::round_profile(4)}};
auto moulded   = typemesh::text_mesher{*font, typemesh::bevelled{.profile = {{0, 0}, {0.2f, 0.8f}, {1, 1}}}};
auto ogee      = typemesh::sampled_profile([](float t) noexcept { return t * t * (3 - 2 * t); }, 8);        // an S
auto swung     = typemesh::text_mesher{*font, typemesh::bevelled{.width = 0.04f, .profile = ogee}};
    use(chamfered, rounded, moulded, swung);
auto bolder = typemesh::text_mesher{*font, typemesh::embolden{.by = 0.015f}, typemesh::bevelled{.width = 0.01f}};
auto hollow = typemesh::text_mesher{*font, typemesh::outlined<>{.width = 0.02f}};
auto framed = typemesh::text_mesher{*font, typemesh::outlined<typemesh::extruded<>, typemesh::extruded<>>{
    .place = typemesh::outline_place::outer, .letter = {.depth = 0.1f}}};
auto spaced = bolder.plan("Hamburg", {.shape = {.letter_spacing = 2 * 0.015}});
    use(bolder, hollow, framed, spaced);
auto short_edges = typemesh::text_mesher{*font, typemesh::refined<>{.how = {.max_edge = 0.05f}}};
auto fine_flat = typemesh::text_mesher{*font, typemesh::refined<typemesh::flat>{.how = {.min_angle = 30.0f}}};
    use(short_edges, fine_flat);
auto carved_sign = typemesh::text_mesher{*font, typemesh::carved{.tool_angle = 60.0f, .max_depth = 0.05f}};
    use(carved_sign);
auto moulded_sign = typemesh::text_mesher{*font, typemesh::tapered{.depth = 0.3f, .degrees = 5.0f}};
    use(moulded_sign);
    {
        auto plan = mesher.plan("Anna");
        if (!plan) return 1;
typemesh::name_plate plate;
if (auto done = plate.plan(*plan, {.style = typemesh::plate_style::engraved, .radius = 0.05f}, typemesh::monotone{}); !done)
    return std::puts(done.error().message()), 1;
for (std::size_t k = 0; k < plate.solid_count(); ++k)                          // an inlay has two, all others one
    if (auto written = plate.write(k, typemesh::into(vertices, indices)); !written) return std::puts(written.error().message()), 1;
    }
auto tick = typemesh::svg_path{"M4 12l5 5L20 6", 24};   // the side of its view box: one em
auto neon  = typemesh::stroked_outlines{tick, {.width = 0.1, .cap = typemesh::stroke_cap::round}};
auto wired = typemesh::text_mesher{*font, typemesh::stroked{{.width = 0.03, .join = typemesh::stroke_join::round}}};
    use(neon);
    use(wired);
auto open_sign = typemesh::text_mesher{*font, typemesh::tubed{.radius = 0.02f}};
auto inset = typemesh::text_mesher{*font, typemesh::tubed{.radius = 0.01f}, typemesh::embolden{.by = -0.03f}};
auto wire = typemesh::line_tubes{};
wire.begin(24.0);                                       // units per em
auto drawn = typemesh::draw_svg_path("M4 12 L9 17 L20 6", 1e-3, wire);
auto tubes = wire.plan({.radius = 0.04f, .end = typemesh::tube_end::round});
if (drawn && tubes) (void)wire.write(typemesh::into(vertices, indices), wire.placed(2.0));  // an em is 2 units long
    use(open_sign, inset);
auto balloon = typemesh::text_mesher{*font, typemesh::inflated{}};
auto pillow = typemesh::text_mesher{*font, typemesh::inflated{.limit = 0.05f}};
auto dome = typemesh::text_mesher{*font, typemesh::inflated{.height = 0.5f, .form = typemesh::inflated_form::dome, .depth = 0.1f}};
    use(balloon, pillow, dome);
    {
typemesh::text_mesher lod{*font};
typemesh::level_mesher levels{lod};
std::vector<vertex> level_vertices[4];
std::vector<std::uint32_t> level_indices[4];
const double tolerance_of_level[] = {0.0, 1.0 / 160, 1.0 / 60, 1.0 / 25};                // in em; level 0 has the text's own
auto level = levels.plan("Hello world!", {.tolerance = typemesh::quality::high});
for (std::size_t k = 0; level && k < 4; ++k) {
    if (k != 0) level = levels.coarser(tolerance_of_level[k]);
    if (level) (void)level->write(typemesh::into(level_vertices[k], level_indices[k]));
}
if (!level) return std::puts(level.error().message()), 1;
    }
typemesh::text_mesher one_level{*font, typemesh::coarsened{.tolerances = {1.0 / 160, 1.0 / 60}, .level = 2}};
    use(one_level);
auto cup = typemesh::text_mesher{*font, typemesh::bent<typemesh::on_cylinder>{.how = {.radius = 1.5}}};
auto flag = typemesh::text_mesher{*font, typemesh::bent<typemesh::displaced<typemesh::wave>>{.how = {{.height = 0.2}}}};
auto screw = typemesh::text_mesher{*font, typemesh::bent<typemesh::twist, typemesh::bevelled>{.how = {.degrees_per_em = 15.0}}};
    use(cup, flag, screw);
    {
const typemesh::double3 bends[] = {{0, 0, 0}, {2, 0, 0.5}, {4, 0.5, 0}, {6, 0, -0.5}};
typemesh::text_path path;
if (auto e = path.through(bends)) return std::puts(e.message()), 1;
auto along = typemesh::text_mesher{*font, typemesh::bent<typemesh::along_curve>{.how = {.path = &path}}};
        use(along);
    }
    {
constexpr typemesh::text_view moving = "Hello world!";
auto plan = mesher.plan(moving);
if (!plan) return std::puts(plan.error().message()), 1;
if (auto found = plan->find_letters(moving); !found) return std::puts(found.error().message()), 1;
const double t = 0.5;                                        // the time
auto spin = [t](const typemesh::letter_place& l) noexcept {
    return typemesh::turned({0, 0, 1}, t * l.index).about(l.letter.pivot);
};
auto written = plan->write(typemesh::into(vertices, indices), spin);
auto typed = plan->write(typemesh::into(vertices, indices), typemesh::reveal{.share = t});
    use(written, typed);
    }
auto rainbow = typemesh::text_mesher{*font, typemesh::bevelled{}, typemesh::warped{typemesh::arc{.degrees = 120}}};
    use(rainbow);
typemesh::plane_path ring;
ring.circle({0.0, 0.0}, 2.0);
auto around = typemesh::text_mesher{*font, typemesh::on_path{&ring, {.anchor = typemesh::path_anchor::middle}}};
    use(around);
typemesh::text_mesher over_the_text{*font, typemesh::extruded<>{.texture = typemesh::texture_mapping::box}};
    use(over_the_text);

auto lines = mesher.plan("one\nanother", {.layout = {.align = typemesh::alignment::centre}});
const typemesh::variation bold[] = {{"wght", 700}};
auto inter = typemesh::harfbuzz_font::open("Inter.var.ttf", {.face = 0, .variations = bold});

    {
typemesh::paragraph words{*font};
if (auto set = words.set("In the beginning the Universe was created."); !set) return std::puts(set.error().message()), 1;
typemesh::glyph_run page;
if (auto laid = words.lay_out({.width = 9.0, .align = typemesh::alignment::justify}, page); !laid) return std::puts(laid.error().message()), 1;
auto column = mesher.plan(page);
auto em = fit_size(words, 30.0, 10.0);                                          // of a box in the mesh: 30 along the lines, 10 across
if (!em) return std::puts(em.error().message()), 1;
if (auto laid = words.lay_out({.width = 30.0 / *em}, page); !laid) return std::puts(laid.error().message()), 1;
auto sign = mesher.plan(page, {.size = *em});
    use(carved_sign);
typemesh::paragraph even{*font, typemesh::heap(), typemesh::unicode_analyser{}, typemesh::total_fit{.tolerance = 0.8}};
    use(even);
typemesh::paragraph parted{*font, typemesh::heap(), typemesh::hyphenating{typemesh::unicode_analyser{}, my_patterns{}}};
    use(parted);
const typemesh::style_span spans[] = {
    {6, 11, {.decorations = typemesh::decoration::underline, .style = typemesh::style_id{1}}},
    {11, 12, {.size = 1.5, .style = typemesh::style_id{2}}},
};
if (auto set = words.set("Hello world!", {.styles = spans}); !set) return std::puts(set.error().message()), 1;
if (auto laid = words.lay_out({.width = 9.0}, page); !laid) return std::puts(laid.error().message()), 1;
auto styled = mesher.plan(page);
if (!styled) return std::puts(styled.error().message()), 1;
    const std::uint32_t triangle = 0;
    const typemesh::vec3 point{};
    const auto draw = [](const typemesh::box&) noexcept {};
typemesh::caret here = words.laid().caret_at(7);                                // line, place on its baseline, direction
typemesh::text_place there = words.laid().caret_from({3.0, -1.2});              // the position in the text, and the side of it that was hit
words.laid().boxes_of(3, 16, [&](const typemesh::box& b) { draw(b); });         // several boxes per line if directions are mixed
typemesh::mesh_hit what = styled->hit(typemesh::part::front, triangle);         // the triangle's number within range(part::front)
typemesh::picked_character letter = character_at(*styled, what, point, words.laid());   // point: where the ray met it
if (!letter.where.empty()) draw(letter.where);                                  // letter.text is its place in the text
use(column, here, there);
auto coloured = mesher.plan("Hello world!", {.shape = {.styles = spans}});
    use(coloured);
    const auto draw_range = [](std::uint32_t, const typemesh::mesh_range&) noexcept {};
    const auto draw_icon = [](std::uint32_t, const typemesh::affine&) noexcept {};
typemesh::markup marked;                                                        // markup_utf16 for UTF-16
typemesh::markup_styles tagged;
if (auto read = marked.read("[b]Bold[/b] and [colour=#c33][size=1.5]red[/][/], [depth=0.5]deep[/]"); !read)
    return std::printf("%u: %s\n", read.error().cluster, read.error().option), 1;   // its place in the source, and what is wrong
if (auto set = tagged.set(marked); !set) return std::puts(set.error().message()), 1;
if (auto set = words.set(marked.text(), {.styles = tagged.spans()}); !set) return std::puts(set.error().message()), 1;
if (auto laid = words.lay_out({.width = 9.0}, page); !laid) return std::puts(laid.error().message()), 1;
std::vector<typemesh::ruby_span> small_texts;
marked.each_ruby([&](std::uint32_t first, std::uint32_t last, std::string_view ruby, std::uint32_t look) {
    small_texts.push_back({first, last, ruby, tagged.style_of(look)});
});
typemesh::ruby_writer rubies;
typemesh::highlight_writer backgrounds;
auto rooms = rubies.rooms(*font, marked.text(), small_texts, {});
if (!rooms) return std::puts(rooms.error().message()), 1;
auto beside = words.set(marked.text(), {.styles = tagged.spans(), .boxes = marked.boxes(), .rooms = *rooms});
if (beside) beside = words.lay_out({.width = 20.0}, page);
if (beside) beside = backgrounds.write(*font, words.laid(), tagged.marks(), {.pad_along = 0.1, .radius = 0.15}, page);
if (beside) beside = rubies.write(*font, words.laid(), small_texts, {}, page);
if (!beside) return std::puts(beside.error().message()), 1;
typemesh::each_inline_box(page, [&](const typemesh::inline_box_place& b) { draw_icon(b.index, b.map); });
auto painted = mesher.plan(page);
if (!painted) return std::puts(painted.error().message()), 1;
for (typemesh::style_id style : painted->styles()) {
    const typemesh::markup_paint& paint = tagged.paints()[std::size_t(style)];
    if (paint.has(typemesh::markup_tag::colour)) draw_range(paint.colour, painted->range(style, typemesh::part::front));
}
    const auto draw_layer = [](const typemesh::palette_colour&, const typemesh::mesh_range&) noexcept {};
typemesh::colour_outlines colours{*font};                                             // with the text's own tolerance
auto tables = typemesh::harfbuzz_colours::of(*font);                                  // the bytes; they must stay alive
if (!tables || !colours.use(0, tables->tables())) return 1;                           // of face 0
typemesh::text_mesher coloured_mesher{colours};
auto smile = coloured_mesher.plan("\U0001F600", {}, colours.edit());
if (!smile) return 1;
for (typemesh::style_id style : smile->styles())
    if (const typemesh::colour_style* own = colours.style_of(style))
        draw_layer(own->paint.colour, smile->range(style, typemesh::part::front));    // sRGB, with straight alpha
auto weight = typemesh::harfbuzz_axis::open(*font, "wght");              // of a variable font
if (!weight) return std::puts(weight.error().message()), 1;
typemesh::axis_morph morph{*weight};
auto breathing = morph.plan("breathe", {.from = 100, .to = 900, .depth = 0.1f});
if (!breathing) return std::puts(breathing.error().message()), 1;
std::vector<typemesh::vec3> places;
std::vector<std::uint32_t> corners;
auto written = breathing->write_at(weight->coordinate(550), typemesh::into(places, corners));   // each frame, at any weight
if (!written) return std::puts(written.error().message()), 1;
for (std::uint32_t solid = 0; solid < tagged.solids().size(); ++solid) {
    typemesh::glyph_run letters;
    const auto is_its = [&](typemesh::style_id s) noexcept { return tagged.solid_of(s) == solid; };
    if (auto done = select_glyphs(page, is_its, letters); !done) return std::puts(done.error().message()), 1;
    const typemesh::markup_solid& wanted = tagged.solids()[solid];
    mesher.solid().depth = wanted.has(typemesh::markup_tag::depth) ? float(wanted.depth) : 0.2f;
    std::vector<vertex> own_vertices;                                        // each build replaces what its vectors held
    std::vector<std::uint32_t> own_indices;
    if (auto built = mesher.build(letters, typemesh::into(own_vertices, own_indices)); !built) return std::puts(built.error().message()), 1;
    use(own_vertices);
}
    }
    {
auto plan = mesher.plan("Hello", {.merge = true, .corners = typemesh::touching::part});
    use(plan);
    }
    {
typemesh::glyph_run run;
if (auto laid = layout(*font, "Hello", {}, {}, run); !laid) return std::puts(laid.error().message()), 1;
auto slanted = run.number_of({.map = {.xy = 0.2}, .style = typemesh::style_id{7}});   // 7: your number for a material
if (!slanted) return std::puts(slanted.error().message()), 1;
run.glyphs[0].glyph_style = *slanted;
auto initial = mesher.plan(run);
if (!initial) return std::puts(initial.error().message()), 1;
auto its_front = initial->range(typemesh::style_id{7}, typemesh::part::front);
    use(its_front);
    }
    {
typemesh::text_mesher<typemesh::one_of<typemesh::flat, typemesh::extruded<>, typemesh::bevelled>> any{*font};
any.use(typemesh::bevelled{.width = 0.03f});
    }
    {
auto wave = mesher.plan("wave", {}, [](typemesh::glyph_run& run) noexcept {
    for (auto& g : run.glyphs) g.origin.y += 200.0 * std::sin(g.origin.x / 500.0);       // in font units
});
    use(wave);
    }
    {
constexpr auto wants = typemesh::attribute::position | typemesh::attribute::normal;
auto half = mesher.build("Hello", typemesh::into(vertices, indices, [](const typemesh::surface_point<wants>& s) noexcept {
    return vertex{{0.5f * s.position.x, s.position.y, s.position.z}, s.normal, {}};
}));
std::vector<typemesh::vec3> points;
auto bare = mesher.build("Hello", typemesh::into(points, indices));
    use(half, bare);
    }
    {
        auto arabic = typemesh::harfbuzz_font::open("Amiri-Regular.ttf"), cjk = typemesh::harfbuzz_font::open("CJK.ttc");
typemesh::font_cascade fonts{*font, *arabic, *cjk};
typemesh::text_mesher in_any_script{fonts};
auto greeting = in_any_script.plan("Hello, مرحبا, 你好");
        use(greeting);
#if __has_include(<fontconfig/fontconfig.h>)
auto fonts_here = typemesh::fontconfig_fonts::open();
if (!fonts_here) return std::puts(fonts_here.error().message()), 1;
typemesh::fontconfig_fallback<typemesh::harfbuzz_font> installed{*fonts_here, "Noto Sans"};   // a family to resemble
typemesh::font_list any{*font, installed};
        use(any);
#endif
    }
auto word = mesher.plan("مرحبا", {.merge = true});
    use(lines, inter, word);

typemesh::glyph_cache<> cache{8u << 20};                     // bytes; the letters unused for longest go first
auto score = typemesh::text_mesher{*font, typemesh::cached_in{cache, 1}};  // 1: your number for this font
auto frame = score.plan("Score 1270");
auto unique = frame->write_meshes(typemesh::into(vertices, indices));
frame->write_instances([&](const typemesh::glyph_instance& i) noexcept { draw(i.mesh, i.translation); });
    use(unique);
    {
    const auto is_unseen = [](const typemesh::glyph_shape&) noexcept { return true; };
    const auto add_instance = [](const typemesh::glyph_shape&, typemesh::vec3) noexcept {};
    const auto add_letter = [](const typemesh::glyph_shape&, typemesh::mesh_range) noexcept {};
    const auto free_vertices = mapped_vertices;
    const auto free_indices = mapped_indices;
    const std::uint32_t first_free_vertex = 0;
auto label = score.plan("Label 7");                                             // a label has come
if (!label) return std::puts(label.error().message()), 1;
typemesh::glyph_run unseen;                                                     // the letters that no label has had yet
for (std::size_t k = 0; k < label->meshes().size(); ++k)
    if (is_unseen(label->shape_of(k)) && !unseen.add(label->shape_of(k))) return 1;     // your set of shapes
label->write_instances([&](const typemesh::glyph_instance& i) noexcept {
    add_instance(label->shape_of(i.mesh), i.translation);                       // your list for this label
});
auto letters = score.plan(unseen);                                              // `label` is now invalid
if (!letters) return std::puts(letters.error().message()), 1;
auto appended = letters->write_meshes(typemesh::into(free_vertices, free_indices, first_free_vertex));
for (std::size_t k = 0; k < letters->meshes().size(); ++k)                      // with this range you draw the letter
    add_letter(letters->shape_of(k), letters->mesh_part(k, typemesh::part::front));
use(appended);
    }
    {
auto title = mesher.plan("Hello", {.shape = {.language = "tr"}, .layout = {.line_spacing = 1.2}, .tolerance = typemesh::quality::best});
typemesh::text_mesher deep{*font, typemesh::extruded<>{.depth = 0.5f}};           // the options of the solid
    use(title, deep);
char sentence[200];                                                             // 200 characters always suffice
if (auto wide = mesher.plan("Hello", {.layout = {.width = 9.0}}); !wide) std::puts(describe(wide.error(), sentence));
    }

    {
typemesh::thread_pool pool;                                  // as many workers as the machine has
auto workers = typemesh::workers_of(pool, [&](std::size_t) noexcept { return typemesh::harfbuzz_font::wrap(font->handle()); });
if (!workers) return std::puts(workers.error().message()), 1;   // FreeType: open the file again for each worker
auto plan = mesher.plan(text, {}, *workers);
if (!plan) return std::puts(plan.error().message()), 1;
auto written = plan->write(typemesh::into(vertices, indices), pool);
    use(written);
        {
typemesh::text_chunks chunks;
if (auto cut = chunks.cut(*plan); !cut) return std::puts(cut.error().message()), 1;               // at most 65,535 vertices each
auto size = chunks.size();                                                      // exact, as ever
auto stored = chunks.write(*plan, typemesh::into(mapped_vertices, mapped_short_indices));
for (const auto& c : chunks.view()) draw(c.range().first_index, c.range().index_count, c.first_vertex);
    use(size, stored);
        }
    }
    return 0;
}

void laws(const std::vector<vertex>& vertices, const std::vector<std::uint32_t>& indices)
{
typemesh::inspect::mesh_view mesh{vertices, indices};            // or {vertices, indices, &my_vertex::place}
assert(check_closedness(mesh).is_closed());                      // every directed edge is matched by its reverse
assert(check_normals(mesh, &vertex::normal).is_right());         // of unit length, out of their walls
    use(mesh);
}

void engines()
{
typemesh::text_options o;
o.frame = {.right = {1, 0, 0}, .up = {0, -1, 0}, .toward = {0, 0, -1}, .winding = 1};   // y down, as in 2D canvases
    use(o);
}

}  // namespace readme
