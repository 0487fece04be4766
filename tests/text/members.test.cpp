// SPDX-License-Identifier: MIT

// Meshers and paragraphs as members of a caller's class, moved and swapped.

#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/one_of.hpp>
#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/typemesh.hpp>

#include <memory>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/lit_mesh.hpp"
#include "support/required.hpp"
#include "support/toy_covering_font.hpp"
#include "support/toy_runs.hpp"

using namespace typemesh;

namespace {

/// What a program's own class looks like: the font outlives the mesher, and stays where it is when a label moves.
class label {
public:
    explicit label(double width)
        : font_{std::make_unique<test::toy_covering_font>(U"E io")}, mesher_{*font_}, words_{*font_}, width_{width}
    {
    }

    /// The mesh of the text in lines.
    test::lit_mesh show(text_view text)
    {
        REQUIRE(words_.set(text));
        REQUIRE(words_.lay_out({.width = width_}, page_));
        const auto plan = test::required(mesher_.plan(page_));
        lines_ = page_.lines.size();
        return test::written(*plan);
    }
    [[nodiscard]] std::size_t lines() const { return lines_; }
    void bevel() { mesher_.use(bevelled{.width = 0.01f}); }

private:
    std::unique_ptr<test::toy_covering_font> font_;
    text_mesher<one_of<extruded<>, bevelled>> mesher_;
    paragraph<test::toy_covering_font> words_;
    glyph_run page_;
    double width_ = 0.0;
    std::size_t lines_ = 0;
};

}  // namespace

TEST_CASE("a class that holds a mesher and a paragraph shows one text after another, and moves", "[text][members]")
{
    label one{3.0};
    const test::lit_mesh first = one.show("EE EE EE EE");
    CHECK(one.lines() > 1);
    std::vector<label> labels;
    labels.push_back(std::move(one));
    labels.emplace_back(100.0);
    CHECK(labels[0].show("EE EE EE EE") == first);
    CHECK(labels[1].show("EE EE EE EE").vertices.size() == first.vertices.size());
    CHECK(labels[1].lines() == 1);
    labels[1].bevel();
    CHECK(labels[1].show("EE EE EE EE").vertices.size() > first.vertices.size());
    std::swap(labels[0], labels[1]);
    CHECK(labels[1].show("EE EE EE EE") == first);
}

TEST_CASE("two meshers are swapped with their fonts, policies and caches", "[text][members]")
{
    test::toy_font font;
    recorded_outlines drawings{1000.0};
    REQUIRE(drawings.add([](auto& pen) {
        pen.move({0, 0});
        for (const point p : {point{400, 0}, {400, 400}, {0, 400}}) pen.line(p);
        pen.close();
    }));
    glyph_cache<> cache;
    text_mesher letters{font, constrained_delaunay{}, cached_in{cache, 1}};
    text_mesher<> squares{drawings};
    const glyph_run run = test::row_of(0, {0.0});
    const auto mesh_of = [](text_mesher<>& mesher, const glyph_run& what) {
        return test::written(*test::required(mesher.plan(what)));
    };
    const test::lit_mesh letter = mesh_of(letters, run), square = mesh_of(squares, run);
    REQUIRE_FALSE(letter == square);
    std::swap(letters, squares);
    CHECK(mesh_of(letters, run) == square);
    CHECK(mesh_of(squares, run) == letter);
    CHECK(squares.policy<constrained_delaunay>() != nullptr);
    CHECK(letters.policy<constrained_delaunay>() == nullptr);
    CHECK(cache.statistics().hits > 0);
}
