// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/executors.hpp"
#include "support/laid_paragraph.hpp"
#include "support/lit_mesh.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"

#include <typemesh/bend/plane_path.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/paragraph/highlight_writer.hpp>
#include <typemesh/text/on_path.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <vector>

using namespace typemesh;

namespace {

constexpr const char* moving_text = "oEi x\nEoo ixE";

/// A turn, a shift, a mirror image, a shear and nothing, letter by letter.
struct mixed_motion {
    affine3 operator()(const letter_place& l) const noexcept
    {
        switch (l.index % 5) {
        case 0: return turned({0.6f, 0.0f, 0.8f}, 0.3 * l.index).about(l.letter.pivot);
        case 1: return shifted({0.5f, -2.0f, 1.0f});
        case 2: return affine3{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}}.about(l.letter.centre);
        case 3: return affine3{{1, 0, 0.25f}, {0.5f, 1, 0}, {0, 0, 2}, {}}.about(l.word.pivot);
        default: return {};
        }
    }
};

struct no_motion {
    affine3 operator()(const letter_place&) const noexcept { return {}; }
};

/// Writes like a file: vertices first, then triangles.
struct file_like_sink {
    static constexpr auto wants = attribute::position | attribute::normal;
    std::size_t vertices = 0, triangles = 0, late = 0;

    error begin(mesh_size) noexcept { return {}; }
    void vertex(const surface_point<wants>&) noexcept
    {
        ++vertices;
        late += triangles != 0;
    }
    void triangle(std::uint32_t, std::uint32_t, std::uint32_t) noexcept { ++triangles; }
    void end() noexcept {}
};

template <class Plan>
test::lit_mesh moved_mesh(const Plan& plan, auto motion)
{
    test::lit_mesh m;
    REQUIRE(plan.write(into(m.vertices, m.indices), motion));
    return m;
}

/// Two lines: a word with a background, an inline box, and a background over both words of the second line.
struct boxed_page {
    std::u16string text = u"oE \uFFFC xi oo EE";
    inline_box icon{.unit = 3, .width = 1.5, .ascent = 1.0, .descent = 0.25};
    test::laid_paragraph<test::toy_font> p;

    explicit boxed_page(bool with_backgrounds = true)
        : p{text, {.width = 5.5, .align = alignment::left}, {.boxes = {&icon, 1}}}
    {
        REQUIRE(p.run.lines.size() == 2);
        const text_highlight spans[] = {{0, 2, style_id{1}}, {8, 13, style_id{1}}};
        highlight_writer backgrounds;
        if (with_backgrounds) REQUIRE(backgrounds.write(p.font, p.laid(), spans, {.pad_along = 0.1}, p.run));
    }
};

double distance(vec3 a, vec3 b)
{
    return std::fmax(std::fabs(double(a.x) - b.x),
                     std::fmax(std::fabs(double(a.y) - b.y), std::fabs(double(a.z) - b.z)));
}

}  // namespace

TEMPLATE_TEST_CASE("the identity writes the plan's mesh bit for bit", "[letters]", flat, extruded<>, bevelled)
{
    test::toy_font font;
    text_mesher mesher{font, TestType{}};
    const auto plan = test::required(mesher.plan(moving_text, {.merge = GENERATE(false, true)}));
    REQUIRE(plan->find_letters(moving_text));
    CHECK(moved_mesh(*plan, no_motion{}) == test::written(*plan));
    CHECK(plan->moved_bounds(no_motion{}).low == plan->bounds().low);
    CHECK(plan->moved_bounds(no_motion{}).high == plan->bounds().high);
}

TEMPLATE_TEST_CASE("moved letters are closed, lit from outside, within their bounds, and the same from several workers",
                   "[letters]", extruded<>, bevelled)
{
    const auto axes = GENERATE(right_handed_y_up, left_handed_z_up);
    test::toy_font font;
    text_mesher mesher{font, TestType{}};
    const auto plan = test::required(mesher.plan(moving_text, {.frame = axes}));
    REQUIRE(plan->find_letters(moving_text));
    const test::lit_mesh m = moved_mesh(*plan, mixed_motion{});
    CHECK(inspect::check_closedness(m.view()).is_closed());
    CHECK(inspect::check_normals(m.view(), &test::lit_vertex::normal, axes.winding).is_right());
    CHECK(inspect::measure(m.view()).volume * axes.winding > 0.0);
    const bounds3 box = plan->moved_bounds(mixed_motion{});
    for (const test::lit_vertex& v : m.vertices) REQUIRE(box.holds(v.place));

    test::scrambled_workers several{3};
    test::lit_mesh other;
    REQUIRE(plan->write(into(other.vertices, other.indices), mixed_motion{}, several));
    CHECK(other == m);

    // Each letter that a chunk splits or keeps is moved in the same way: its vertices are among the whole's.
    text_chunks chunks;
    for (const std::uint32_t most : {60u, 1000u}) {
        REQUIRE(chunks.cut(*plan, most));
        test::lit_mesh pieces;
        REQUIRE(chunks.write(*plan, into(pieces.vertices, pieces.indices), mixed_motion{}));
        for (std::size_t k = 0; k < chunks.view().size(); ++k) {
            file_like_sink file;
            mixed_motion motion;
            REQUIRE(chunks.write(*plan, k, plan->moved(file, motion)));
            CHECK(file.vertices == chunks.view()[k].range().vertex_count);
            CHECK(file.late == 0);
        }
        test::lit_mesh all{pieces.vertices, {}};
        for (const text_chunk& c : chunks.view())
            for (std::uint32_t i = 0; i < c.range().index_count; ++i)
                all.indices.push_back(c.first_vertex + pieces.indices[c.range().first_index + i]);
        CHECK(inspect::check_closedness(all.view()).is_closed());
        CHECK(inspect::measure(all.view()).volume == Catch::Approx(inspect::measure(m.view()).volume));
    }
}

TEST_CASE("a rigid motion and its inverse return the mesh within a float's step", "[letters]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto plan = test::required(mesher.plan(moving_text));
    REQUIRE(plan->find_letters(moving_text, {.pivot = letter_pivot::centre}));
    const test::lit_mesh still = test::written(*plan);
    // An inverse of a turn about a pivot is the opposite turn about it.
    const auto motion = [](double sign) {
        return [sign](const letter_place& l) noexcept {
            return turned({0.0f, 0.6f, 0.8f}, sign * (1.0 + 0.7 * l.index)).about(l.letter.pivot);
        };
    };
    std::vector<affine3> back;
    (void)plan->moved_bounds([&](const letter_place& l) noexcept {
        back.push_back(motion(-1.0)(l));
        return affine3{};
    });
    const test::lit_mesh moved = moved_mesh(*plan, motion(1.0));
    const double step = std::fmax(plan->position_step(), 0x1p-22);  // the farthest coordinate is below 4
    std::size_t far_off = 0, tilted = 0;
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g)
        for (const part p : plan->parts()) {
            const mesh_range r = plan->range(g, p);
            const affine3& inverse = back[plan->letter_of(g)];
            for (std::size_t i = r.first_vertex; i < r.first_vertex + r.vertex_count; ++i) {
                const test::lit_vertex &was = still.vertices[i], &is = moved.vertices[i];
                far_off += distance(inverse(is.place), was.place) > step + 0x1p-22 ? 1u : 0u;
                tilted += distance(inverse.direction(is.normal), was.normal) > 1e-6 ? 1u : 0u;
            }
        }
    CHECK(far_off == 0);
    CHECK(tilted == 0);
}

TEST_CASE("a moved instance is the moved glyph", "[letters]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto plan = test::required(mesher.plan(moving_text));
    REQUIRE(plan->find_letters(moving_text));
    const test::lit_mesh whole = moved_mesh(*plan, mixed_motion{});
    test::lit_mesh once;
    REQUIRE(plan->write_meshes(into(once.vertices, once.indices)));
    std::size_t instances = 0, wrong = 0;
    plan->write_instances(mixed_motion{}, [&](const glyph_instance& drawn, const affine3& map) noexcept {
        ++instances;
        for (const part p : plan->parts()) {
            const mesh_range from = plan->mesh_part(drawn.mesh, p), to = plan->range(drawn.glyph, p);
            for (std::uint32_t i = 0; i < to.vertex_count; ++i) {
                const vec3 is = map(once.vertices[from.first_vertex + i].place);
                wrong += distance(is, whole.vertices[to.first_vertex + i].place) > 2e-6 ? 1u : 0u;
            }
        }
    });
    CHECK(instances == plan->glyphs().size());
    CHECK(wrong == 0);
}

TEST_CASE("a motion is asked once for each letter in reading order, and is told where the letter stands", "[letters]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const auto plan = test::required(mesher.plan(moving_text));
    REQUIRE(plan->find_letters(moving_text));
    std::uint32_t asked = 0;
    const auto motion = [&](const letter_place& l) noexcept {
        CHECK(l.index == asked);
        CHECK(&l.letter == &plan->letters().letters[asked]);
        CHECK(l.index - l.word.first < l.word.count);
        CHECK(l.index - l.line.first < l.line.count);
        CHECK(l.whole.count == 10);
        CHECK(l.words == 4);
        CHECK(l.lines == 2);
        CHECK(l.paragraphs == 2);
        CHECK(l.graphemes == 13);
        ++asked;
        return affine3{};
    };
    (void)moved_mesh(*plan, motion);
    CHECK(asked == 10);
}

TEST_CASE("moving letters allocates nothing", "[letters]")
{
    test::counting_memory counted;
    test::toy_font font;
    text_mesher mesher{font, counted.source()};
    for (int round = 0; round < 3; ++round) {
        const std::size_t before = counted.requests;
        const auto plan = test::required(mesher.plan(moving_text));
        REQUIRE(plan->find_letters(moving_text));
        const std::size_t planned = counted.requests;
        (void)moved_mesh(*plan, mixed_motion{});
        (void)plan->moved_bounds(mixed_motion{});
        CHECK(counted.requests == planned);
        if (round != 0) CHECK(planned == before);
    }
}

TEST_CASE("letters that a path turns move from where they stand", "[letters][path]")
{
    test::toy_font font;
    plane_path round_path;
    round_path.circle({0.3, 0.2}, 1.5);
    text_mesher mesher{font, extruded<>{}, on_path{&round_path, {.anchor = path_anchor::middle}}};
    const auto plan = test::required(mesher.plan("oEi xE", {.merge = false}));
    REQUIRE(plan->find_letters("oEi xE"));
    const test::lit_mesh still = test::written(*plan);
    CHECK(moved_mesh(*plan, no_motion{}) == still);

    const affine3 rigid = shifted({0.5f, -1.0f, 2.0f}) * turned({0.6f, 0.0f, 0.8f}, 0.9);
    const auto motion = [&](const letter_place&) noexcept { return rigid; };
    const test::lit_mesh moved = moved_mesh(*plan, motion);
    REQUIRE(moved.vertices.size() == still.vertices.size());
    const bounds3 around = plan->moved_bounds(motion);
    for (std::size_t i = 0; i < still.vertices.size(); ++i) {
        const vec3 at = moved.vertices[i].place;
        CHECK(distance(at, rigid(still.vertices[i].place)) < 4e-6);
        CHECK(distance(moved.vertices[i].normal, rigid.direction(still.vertices[i].normal)) < 4e-6);
        CHECK(around.holds(at));
    }
    // Each letter stands in its own box, and turns about the middle of that box.
    for (const text_letter& l : plan->letters().letters) {
        CHECK(l.pivot == l.centre);
        CHECK(l.bounds.holds(l.centre));
    }
    std::size_t instances = 0;
    plan->write_instances(motion, [&](const glyph_instance& drawn, const affine3& map) noexcept {
        ++instances;
        CHECK(distance(map.origin, rigid(drawn.translation)) < 4e-6);
        CHECK(distance(map.x, rigid.direction(drawn.x)) < 4e-6);
        CHECK(std::fabs(drawn.x.y) > 1e-3f);
    });
    CHECK(instances == 5);
}

TEST_CASE("the pivots of letters that a path moves lie in their boxes", "[letters][path]")
{
    test::toy_font font;
    plane_path high;
    high.move({0, 5}), high.line({10, 5});
    text_mesher mesher{font, extruded<>{}, on_path{&high}};
    const auto plan = test::required(mesher.plan("oEi"));
    REQUIRE(plan->find_letters("oEi"));
    for (const text_letter& l : plan->letters().letters) CHECK(l.bounds.holds(l.pivot));
}

TEST_CASE("the bounds of letters that are magnified far from the origin hold their vertices", "[letters]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const std::string text = std::string(60, ' ') + "oEi";
    const auto plan = test::required(mesher.plan(text, {.unit = output_unit::font_units}));
    REQUIRE(plan->find_letters(text));
    const auto larger = [](const letter_place& l) noexcept { return scaled(100.0f).about(l.letter.pivot); };
    const test::lit_mesh m = moved_mesh(*plan, larger);
    const bounds3 around = plan->moved_bounds(larger);
    std::size_t outside = 0;
    for (const test::lit_vertex& v : m.vertices) outside += !around.holds(v.place);
    CHECK(outside == 0);
    CHECK(m.vertices.size() > 20);
}

TEST_CASE("an inline box is a letter, whose map moves with it", "[letters]")
{
    boxed_page page{false};
    text_mesher mesher{page.p.font};
    const text_options twice{.unit = output_unit::em, .size = 2.0};
    const auto plan = test::required(mesher.plan(page.p.run, twice));
    REQUIRE(plan->find_letters(page.text));
    const letter_rows rows = plan->letters();
    REQUIRE(rows.letters.size() == 9);
    const text_letter& icon = rows.letters[2];
    CHECK(icon.bonds == letter_bond::inline_box);
    CHECK(icon.text.first == 3);
    CHECK(icon.text.last == 4);
    CHECK(icon.word == 1);
    CHECK(rows.words[1].count == 1);
    CHECK(rows.words.size() == 5);
    CHECK(double(icon.extent.x) == Approx(2.0 * 1.5));
    CHECK(double(icon.extent.y) == Approx(2.0 * 1.25));
    CHECK(same(icon.extent.z, rows.letters[0].extent.z));

    const auto map_of = [&](auto motion) {
        affine3 found;
        std::size_t boxes = 0;
        plan->each_moved_box(motion, [&](const inline_box_place& b, const affine3& map) noexcept {
            boxes += b.index == 0 && b.unit == 3 ? 1u : 0u;
            found = map;
        });
        CHECK(boxes == 1);
        return found;
    };
    const affine3 still = map_of(no_motion{});
    each_inline_box(page.p.run, [&](const inline_box_place& b) {
        for (const point corner : {point{0, 0}, point{1, 0}, point{0.25, 1}}) {
            const point em = b.map(corner);
            const vec3 placed{static_cast<float>(2.0 * em.x), static_cast<float>(2.0 * em.y), 0.0f};
            CHECK(distance(still({static_cast<float>(corner.x), static_cast<float>(corner.y), 0.0f}), placed) < 1e-6);
        }
    });
    CHECK(still.z == vec3{0, 0, 1});
    const affine3 turn = turned({0.6f, 0.0f, 0.8f}, 0.9).about(icon.pivot);
    const affine3 moved = map_of([&](const letter_place& l) noexcept { return l.index == 2 ? turn : affine3{}; });
    CHECK(moved == turn * still);
    const affine3 back = turned({0.6f, 0.0f, 0.8f}, -0.9).about(icon.pivot) * moved;
    for (const vec3 corner : {vec3{0, 0, 0}, vec3{1, 0, 0}, vec3{1, 1, 1}})
        CHECK(distance(back(corner), still(corner)) < 1e-6);
    CHECK(map_of(reveal{.graphemes = 3}).x == vec3{});
    CHECK(map_of(reveal{.graphemes = 4}) == still);

    // It has no vertices, so it does not count for the bounds, and where it stands no vertex is changed.
    CHECK(plan->moved_bounds(no_motion{}).high == plan->bounds().high);
    const auto far_away = [](const letter_place& l) noexcept { return l.index == 2 ? shifted({99, 0, 0}) : affine3{}; };
    CHECK(plan->moved_bounds(far_away).high == plan->bounds().high);
    CHECK(moved_mesh(*plan, far_away) == test::written(*plan));
}

TEST_CASE("an inline box on a path moves from where the path puts it", "[letters][path]")
{
    boxed_page page{false};
    plane_path ring;
    ring.circle({0, 0}, 2.0);
    const on_path around{&ring};
    text_mesher mesher{page.p.font, extruded<>{}, around};
    const auto plan = test::required(mesher.plan(page.p.run));
    REQUIRE(plan->find_letters(page.text));
    std::vector<glyph_stand> stands(page.p.run.glyphs.size());
    REQUIRE_FALSE(around.place(page.p.run, 1000.0, stands.data()));
    const affine3 up = shifted({0, 0, 3});
    std::size_t boxes = 0;
    const auto motion = [&](const letter_place&) noexcept { return up; };
    plan->each_moved_box(motion, [&](const inline_box_place& b, const affine3& map) noexcept {
        ++boxes;
        each_inline_box(page.p.run, [&](const inline_box_place& flat_box) noexcept {
            const affine stood = box_on_stand(flat_box, page.p.run, stands[b.glyph]);
            for (const point corner : {point{0, 0}, point{1, 0}, point{1, 1}}) {
                const point em = stood(corner);
                const vec3 wanted{static_cast<float>(em.x), static_cast<float>(em.y), 3.0f};
                CHECK(distance(map({static_cast<float>(corner.x), static_cast<float>(corner.y), 0.0f}), wanted) < 2e-6);
            }
        });
        const text_letter icon = plan->letters().letters[2];
        CHECK(icon.bounds.holds(icon.pivot));
        CHECK(std::hypot(double(icon.pivot.x), double(icon.pivot.y)) == Approx(2.0 + 0.375).epsilon(0.05));
    });
    CHECK(boxes == 1);
}

TEST_CASE("backgrounds move with their lines, and with the word that they stand behind", "[letters]")
{
    boxed_page page;
    text_mesher mesher{page.p.font};
    const auto plan = test::required(mesher.plan(page.p.run));
    REQUIRE(plan->find_letters(page.text));
    const letter_rows rows = plan->letters();
    REQUIRE(rows.bars.size() == 2);
    CHECK(rows.bars[0].word == 0);
    CHECK(rows.bars[0].first_letter == 0);
    CHECK(rows.bars[0].letters == 2);
    CHECK(rows.bars[1].word == not_a_letter);  // of two words
    CHECK(rows.bars[1].first_letter == 5);
    CHECK(rows.bars[1].letters == 4);
    CHECK(rows.bars[1].line == 1);

    // All that stands in a line, or in a word, moves as one: its bounds are moved by the same map.
    const test::lit_mesh still = test::written(*plan);
    CHECK(moved_mesh(*plan, no_motion{}) == still);
    const auto by_line = [](const letter_place& l) noexcept {
        return turned({0.0f, 0.6f, 0.8f}, 1.0 + l.letter.line).about(l.line.pivot);
    };
    const auto by_word = [](const letter_place& l) noexcept {
        return l.word.count == 0 ? affine3{} : shifted({0.0f, 1.0f + static_cast<float>(l.letter.word), 0.0f});
    };
    const test::lit_mesh lines = moved_mesh(*plan, by_line), words = moved_mesh(*plan, by_word);
    double off = 0.0;
    std::size_t bars = 0, tilted = 0;
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
        const text_letter& row = plan->row_of(g);
        bars += has(row.bonds, letter_bond::bar) ? 1u : 0u;
        const affine3 turn = turned({0.0f, 0.6f, 0.8f}, 1.0 + row.line).about(rows.lines[row.line].pivot);
        const affine3 back = turned({0.0f, 0.6f, 0.8f}, -1.0 - row.line).about(rows.lines[row.line].pivot);
        const float lift = row.word == not_a_letter ? 0.0f : 1.0f + static_cast<float>(row.word);
        for (const part p : plan->parts()) {
            const mesh_range r = plan->range(g, p);
            for (std::size_t i = r.first_vertex; i < r.first_vertex + r.vertex_count; ++i) {
                const vec3 was = still.vertices[i].place;
                off = std::fmax(off, distance(lines.vertices[i].place, turn(was)));
                off = std::fmax(off, distance(back(lines.vertices[i].place), was));
                off = std::fmax(off, distance(words.vertices[i].place, {was.x, was.y + lift, was.z}));
                tilted += distance(back.direction(lines.vertices[i].normal), still.vertices[i].normal) > 1e-6;
            }
        }
    }
    CHECK(bars == 2);
    CHECK(off < 2e-6);
    CHECK(tilted == 0);
}

TEMPLATE_TEST_CASE("every vertex of a letter is where its map puts it, with its normal and its tangent", "[letters]",
                   flat, extruded<>, bevelled)
{
    const auto axes = GENERATE(right_handed_y_up, left_handed_z_up);
    const affine3 turn = turned({0.6f, 0.0f, 0.8f}, 1.1);
    const affine3 letter_maps[] = {turn,
                                   shifted({0.25f, -1.0f, 2.0f}),
                                   turned({0, 0, 1}, 2.0) * scaled(3.0f),
                                   scaled(0.125f) * turn,
                                   affine3{{-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {}} * turn,
                                   affine3{{2, 0, 0}, {0, 1, 0}, {0, 0.5f, 1}, {}}};
    test::toy_font font;
    text_mesher mesher{font, TestType{}};
    const auto plan = test::required(mesher.plan(moving_text, {.frame = axes}));
    REQUIRE(plan->find_letters(moving_text));
    const test::lit_mesh still = test::written(*plan);
    for (const affine3& map : letter_maps) {
        const letter_move exact{map};
        const bool mirrors = exact.mirrors();
        const test::lit_mesh is =
            moved_mesh(*plan, [&](const letter_place& l) noexcept { return map.about(l.letter.pivot); });
        double off = 0.0, tilted = 0.0, slid = 0.0;
        std::size_t other = 0;
        for (std::size_t g = 0; g < plan->glyphs().size(); ++g)
            for (const part p : plan->parts()) {
                const affine3 own = map.about(plan->row_of(g).pivot);
                const mesh_range r = plan->range(g, p);
                for (std::size_t i = r.first_vertex; i < r.first_vertex + r.vertex_count; ++i) {
                    const test::lit_vertex &a = still.vertices[i], &b = is.vertices[i];
                    const auto unit = [](vec3 v) noexcept {
                        const auto by = static_cast<float>(1.0 / std::hypot(double(v.x), double(v.y), double(v.z)));
                        return vec3{by * v.x, by * v.y, by * v.z};
                    };
                    off = std::fmax(off, distance(b.place, own(a.place)));
                    const vec3 n = exact.is_shift() ? a.normal : exact.normals().direction(a.normal);
                    tilted = std::fmax(tilted, distance(b.normal, unit(n)));
                    slid = std::fmax(slid, distance({b.tangent.x, b.tangent.y, b.tangent.z},
                                                    unit(own.direction({a.tangent.x, a.tangent.y, a.tangent.z}))));
                    other += !same(b.tangent.w, mirrors ? -a.tangent.w : a.tangent.w) || !(b.uv == a.uv) ? 1u : 0u;
                }
            }
        CHECK(off < 8e-6);
        CHECK(tilted < 2e-6);
        CHECK(slid < 2e-6);
        CHECK(other == 0);
    }
}

TEST_CASE("letters that nobody has looked for are neither moved nor named, and nothing is written", "[letters]")
{
    test::toy_font font;
    text_mesher mesher{font};
    std::vector<test::lit_vertex> vertices(1);
    std::vector<std::uint32_t> indices(1, 7u);
    const auto check = [&](const auto& plan) {
        text_chunks chunks;
        REQUIRE(chunks.cut(plan));
        std::vector<std::uint16_t> letters(plan.size().vertices, std::uint16_t{9});
        std::vector<std::uint32_t> corners(plan.size().indices(), 7u);
        const stream_sink naming{std::span{corners}, stream<attribute::letter, std::uint16_t>{std::span{letters}}};
        CHECK(plan.write(into(vertices, indices), mixed_motion{}).error() == error::unknown_letters);
        CHECK(plan.write(stream_sink{naming}).error() == error::unknown_letters);
        CHECK(chunks.write(plan, 0, stream_sink{naming}).error() == error::unknown_letters);
        CHECK((letters.front() == 9 && corners.front() == 7 && vertices.size() == 1 && indices.size() == 1));
    };
    check(*test::required(mesher.plan("oEi")));
    REQUIRE(test::required(mesher.plan("oE"))->find_letters("oE"));
    check(*test::required(mesher.plan("oEi")));  // the letters were another plan's
}
