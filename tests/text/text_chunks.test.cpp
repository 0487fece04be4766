// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/counted_output.hpp"
#include "support/counting_memory.hpp"
#include "support/executors.hpp"
#include "support/mesh_laws.hpp"
#include "support/required.hpp"
#include "support/toy_font.hpp"
#include "support/written_mesh.hpp"

#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

using namespace typemesh;
using test::full_mesh;
using test::full_vertex;

namespace {

/// Every triangle by the bytes of its three vertices, sorted: what a mesh looks like, however it is numbered.
using seen_triangle = std::array<unsigned char, 3 * sizeof(full_vertex)>;

template <class Index>
void see(std::vector<seen_triangle>& out, const full_vertex* vertices, const Index* indices, std::size_t count)
{
    for (std::size_t i = 0; i < count; i += 3) {
        seen_triangle t;
        for (std::size_t k = 0; k < 3; ++k)
            std::memcpy(t.data() + k * sizeof(full_vertex), vertices + indices[i + k], sizeof(full_vertex));
        out.push_back(t);
    }
}

template <class Plan>
std::vector<seen_triangle> glyph_style_of(const Plan& plan)
{
    const full_mesh m = test::written<full_mesh>(plan);
    std::vector<seen_triangle> all;
    see(all, m.vertices.data(), m.indices.data(), m.indices.size());
    std::sort(all.begin(), all.end());
    return all;
}

/// All the laws of a cut text.
template <class Plan>
void check_chunks(const Plan& plan, std::uint32_t most)
{
    text_chunks chunks;
    REQUIRE(chunks.cut(plan, most));
    test::counted_output out;
    REQUIRE(chunks.write(plan, test::counted_sink{out}));
    REQUIRE(mesh_size{out.vertices.size(), out.indices.size() / 3} == chunks.size());
    CHECK(out.each_once());

    std::vector<seen_triangle> glyph_style;
    std::uint32_t vertex = 0, index = 0, glyph = 0;
    for (std::size_t k = 0; k < chunks.view().size(); ++k) {
        const text_chunk& c = chunks.view()[k];
        const bool split = c.piece != text_chunk::whole_glyphs;
        CHECK(c.range() == mesh_range{vertex, c.range().vertex_count, index, c.range().index_count});
        CHECK(c.size().vertices <= most);
        CHECK(c.size().vertices > 0);
        CHECK((split ? c.first_glyph <= glyph : c.first_glyph == glyph));
        glyph = c.first_glyph + c.glyph_count;
        std::vector<bool> used(c.size().vertices, false);
        for (const part p : all_parts) {
            const mesh_range r = c.range(p);
            CHECK(r.first_vertex == vertex);
            CHECK(r.first_index == index);
            vertex += r.vertex_count;
            index += r.index_count;
            for (std::uint32_t i = r.first_index; i < index; ++i) {
                REQUIRE(out.indices[i] < c.size().vertices);
                used[out.indices[i]] = true;
            }
        }
        if (split) CHECK(std::count(used.begin(), used.end(), false) == 0);
        see(glyph_style, out.vertices.data() + c.first_vertex, out.indices.data() + c.first_index,
            c.range().index_count);

        // The same chunk alone.
        full_mesh m;
        REQUIRE(chunks.write(plan, k, into(m.vertices, m.indices)));
        REQUIRE(m.vertices.size() == c.size().vertices);
        CHECK(std::memcmp(m.vertices.data(), out.vertices.data() + c.first_vertex,
                          m.vertices.size() * sizeof(full_vertex)) == 0);
        CHECK(std::equal(m.indices.begin(), m.indices.end(), out.indices.begin() + c.first_index));
    }
    CHECK(vertex == chunks.size().vertices);
    CHECK(index == plan.size().indices());
    CHECK(glyph == plan.glyphs().size());

    // Nothing that is drawn differs from the text in one piece.
    std::sort(glyph_style.begin(), glyph_style.end());
    CHECK(glyph_style == glyph_style_of(plan));

    // Several workers write the same.
    for (const std::size_t workers : {2u, 5u}) {
        test::scrambled_workers several{workers};
        test::counted_output other;
        REQUIRE(chunks.write(plan, test::counted_sink{other}, several));
        CHECK(other.each_once());
        CHECK(other.indices == out.indices);
        CHECK(std::memcmp(other.vertices.data(), out.vertices.data(), out.vertices.size() * sizeof(full_vertex)) == 0);
    }
}

/// A cog of so many teeth, all straight lines and hard corners: 8 points a tooth.
recorded_outlines cog(int teeth)
{
    recorded_outlines drawing{1000.0};
    const auto made = drawing.add([&](auto& pen) {
        const double turn = 6.283185307179586 / teeth;
        for (int i = 0; i < teeth; ++i) {
            const double a = i * turn, b = a + 0.5 * turn;
            const auto at = [](double angle, double r) { return point{r * std::cos(angle), r * std::sin(angle)}; };
            if (i == 0)
                pen.move(at(a, 30000));
            else
                pen.line(at(a, 30000));
            pen.line(at(b, 30000)), pen.line(at(b, 20000)), pen.line(at(a + turn, 20000));
        }
        pen.close();
    });
    REQUIRE(made);
    return drawing;
}

}  // namespace

TEMPLATE_TEST_CASE("chunks draw what the text in one piece draws, and none is larger than allowed", "[text][chunks]",
                   flat, extruded<curve_normals>, extruded<creased_normals>, extruded<averaged_normals>,
                   extruded<shared_normals>)
{
    test::toy_font font;
    TestType how;
    how.texture = GENERATE(from_range(std::begin(texture_mappings), std::end(texture_mappings)));
    auto mesher = text_mesher{font}.with(how);
    const auto frame = GENERATE(right_handed_y_up, left_handed_z_up);
    auto plan = test::required(mesher.plan("oEi x\nEoo", {.tolerance = quality::low, .frame = frame}));
    for (const std::uint32_t most : {3u, 4u, 7u, 30u, 64u, 100u, 1000u, 65535u}) {
        INFO("at most " << most);
        check_chunks(*plan, most);
    }
}

TEST_CASE("text that fits is one chunk, and glyphs that fit are not split", "[text][chunks]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan("oEi x\nEoo"));
    text_chunks chunks;
    REQUIRE(chunks.cut(*plan));
    REQUIRE(chunks.view().size() == 1);
    full_mesh whole, m;
    REQUIRE(plan->write(into(whole.vertices, whole.indices)));
    REQUIRE(chunks.write(*plan, into(m.vertices, m.indices)));
    CHECK(m.indices == whole.indices);
    CHECK(std::memcmp(m.vertices.data(), whole.vertices.data(), m.vertices.size() * sizeof(full_vertex)) == 0);

    std::uint64_t largest = 0;
    for (std::size_t g = 0; g < plan->glyphs().size(); ++g) {
        std::uint64_t own = 0;
        for (const part p : all_parts) own += plan->range(g, p).vertex_count;
        largest = std::max(largest, own);
    }
    REQUIRE(chunks.cut(*plan, static_cast<std::uint32_t>(largest)));
    CHECK(chunks.view().size() > 1);
    CHECK(chunks.size() == plan->size());
    for (const text_chunk& c : chunks.view()) CHECK(c.piece == text_chunk::whole_glyphs);
}

TEST_CASE("a glyph too large for 16 bits is split, and the greatest index is 65,534", "[text][chunks]")
{
    const auto drawing = cog(6000);
    glyph_run run;
    for (cluster_id i = 0; i < 3; ++i)
        REQUIRE(run.glyphs.push_back({.id = 0, .cluster = i, .origin = {70000.0 * i, 0}}));
    text_mesher mesher{drawing};
    auto plan = test::required(mesher.plan(run));
    REQUIRE(plan->size().vertices == 3 * 6 * 24'000);  // 4N + 2H, all points hard
    check_chunks(*plan, text_chunks::max_for_16_bits);

    text_chunks chunks;
    REQUIRE(chunks.cut(*plan));
    CHECK(chunks.size().vertices > plan->size().vertices);
    CHECK(chunks.size().vertices < plan->size().vertices * 101 / 100);  // few are repeated
    CHECK(chunks.size().triangles == plan->size().triangles);
    std::vector<full_vertex> vertices(chunks.size().vertices + 2);
    std::vector<std::uint16_t> indices(chunks.size().indices() + 2, 0xABCD);
    REQUIRE(chunks.write(*plan, into(std::span{vertices}.subspan(1, vertices.size() - 2),
                                     std::span{indices}.subspan(1, indices.size() - 2))));
    CHECK(indices.front() == 0xABCD);
    CHECK(indices.back() == 0xABCD);
    CHECK(*std::max_element(indices.begin() + 1, indices.end() - 1) == 65'534);
}

TEST_CASE("every sink over memory takes chunks, and writes the same", "[text][chunks]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan("oEio"));
    text_chunks chunks;
    REQUIRE(chunks.cut(*plan, 200));
    REQUIRE(chunks.view().size() > 2);
    const auto size = chunks.size();

    std::vector<full_vertex> grown;
    std::vector<std::uint8_t> grown_indices;
    REQUIRE(chunks.write(*plan, into(grown, grown_indices)));
    std::vector<full_vertex> array(size.vertices);
    std::vector<std::uint8_t> array_indices(size.indices());
    REQUIRE(chunks.write(*plan, into(std::span{array}, std::span{array_indices})));
    std::vector<vec3> positions(size.vertices);
    std::vector<std::uint8_t> stream_indices(size.indices());
    test::scrambled_workers several{4};
    REQUIRE(chunks.write(*plan, stream_sink{std::span{stream_indices}, stream<attribute::position, vec3>{positions}},
                         several));
    CHECK(array_indices == grown_indices);
    CHECK(stream_indices == grown_indices);
    CHECK(std::memcmp(array.data(), grown.data(), size.vertices * sizeof(full_vertex)) == 0);
    for (std::size_t i = 0; i < size.vertices; ++i) REQUIRE(positions[i] == grown[i].position);
}

TEST_CASE("what cannot be cut or does not fit is refused before anything is written", "[text][chunks]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan("oEio"));
    text_chunks chunks;
    for (const std::uint32_t most : {0u, 1u, 2u}) {
        const error e = chunks.cut(*plan, most).error();
        CHECK(e == error::bad_option);
        CHECK(std::string{e.option} == "most");
        CHECK(chunks.view().empty());
        CHECK(chunks.size() == mesh_size{});
    }
    REQUIRE(chunks.cut(*plan, 200));
    const auto size = chunks.size();
    std::vector<full_vertex> vertices(size.vertices);
    std::vector<std::uint8_t> indices(size.indices(), 77);
    const std::vector<std::uint8_t> untouched = indices;

    error e = chunks.write(*plan, into(std::span{vertices}.first(size.vertices - 1), std::span{indices})).error();
    CHECK(e == error::buffer_too_small);
    CHECK(e.count == size.vertices);
    e = chunks.write(*plan, into(std::span{vertices}, std::span{indices}.first(size.indices() - 1))).error();
    CHECK(e == error::buffer_too_small);
    CHECK(e.count == size.indices());
    e = chunks.write(*plan, into(std::span{vertices}, std::span{indices}, 100u)).error();  // base vertex 100
    CHECK(e == error::index_overflow);
    CHECK(indices == untouched);
    for (const full_vertex& v : vertices) REQUIRE(v.position == vec3{});

    REQUIRE(chunks.cut(*plan, 600));  // some chunk needs more than 8 bits
    const error too_many = chunks.write(*plan, into(std::span{vertices}, std::span{indices})).error();
    CHECK(too_many == error::index_overflow);
    CHECK(too_many.count > 255);
    CHECK(indices == untouched);
}

TEST_CASE("a text without glyphs has no chunks, and writes nothing", "[text][chunks]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan("  "));
    text_chunks chunks;
    REQUIRE(chunks.cut(*plan));
    CHECK(chunks.view().empty());
    full_mesh m = {{{}, {}}, {1, 2, 3}};
    REQUIRE(chunks.write(*plan, into(m.vertices, m.indices)));
    CHECK(m.vertices.empty());
    CHECK(m.indices.empty());
}

TEST_CASE("cutting again needs no memory, and memory that fails leaves no chunks", "[text][chunks]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto plan = test::required(mesher.plan("oEi ooE"));
    {
        test::counting_memory counted;
        text_chunks chunks{counted.source()};
        for (int i = 0; i < 2; ++i) REQUIRE(chunks.cut(*plan, 50));
        const std::size_t before = counted.requests;
        REQUIRE(before > 0);
        test::counted_output out;
        REQUIRE(chunks.cut(*plan, 50));
        REQUIRE(chunks.write(*plan, test::counted_sink{out}));
        CHECK(counted.requests == before);
    }
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 100; ++n) {
        test::counting_memory counted{.fail_at = n, .fail_once = true};
        text_chunks chunks{counted.source()};
        const error e = chunks.cut(*plan, 50).error();
        if (e) {
            ++failures;
            CHECK(e == error::out_of_memory);
            CHECK(chunks.view().empty());
        }
        REQUIRE(chunks.cut(*plan, 50));
        CHECK(chunks.view().size() > 7);
        if (counted.requests < n) break;
    }
    CHECK(failures >= 4);
}
