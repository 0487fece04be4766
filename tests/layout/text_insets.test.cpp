// SPDX-License-Identifier: MIT
#include "support/counting_memory.hpp"
#include "support/laid_paragraph.hpp"

#include <typemesh/layout/impl/text_insets.hpp>

#include <limits>
#include <string>
#include <vector>

using namespace typemesh;

namespace {

struct read_insets {
    text_analysis found;
    text_insets insets;
    error failure;

    read_insets(text_view text, const shape_options& how, std::vector<std::uint32_t> borders = {})
    {
        unicode_analyser analyser;
        REQUIRE_FALSE(analyser.analyse(text, {}, found));
        failure = insets.read(how, text, borders, found);
    }
    [[nodiscard]] std::string option() const { return failure == error::bad_option ? failure.option : ""; }
};

std::vector<std::uint32_t> borders_of(const read_insets& r, const std::vector<std::uint32_t>& others)
{
    const auto all = r.insets.borders(others);
    return {all.begin(), all.end()};
}

}  // namespace

TEST_CASE("boxes and rooms divide a text for shaping, and rooms have no place where a line may end", "[layout]")
{
    const inline_box boxes[] = {{.unit = 7}, {.unit = 2}};
    const text_room rooms[] = {{4, 6, 1.0}};
    const std::vector<std::uint32_t> others{1, 5};
    const read_insets r{u"ab\uFFFCd e f\uFFFC", {}, others};
    CHECK(borders_of(r, others) == others);
    const read_insets all{u"ab\uFFFCde\u6F22f\uFFFC", {.boxes = boxes, .rooms = rooms}, others};
    REQUIRE_FALSE(all.failure);
    CHECK(borders_of(all, others) == std::vector<std::uint32_t>{1, 2, 3, 4, 5, 6, 7, 8});
    CHECK(all.insets.box_at(2)->index == 1);
    CHECK(all.insets.box_at(7)->index == 0);
    CHECK(all.insets.box_at(3) == nullptr);
    CHECK(all.insets.room_at(4) == all.insets.room_at(5));
    CHECK(all.insets.room_at(3) == nullptr);
    CHECK(all.insets.room_at(6) == nullptr);
    CHECK_FALSE(all.insets.keeps(4));
    CHECK(all.insets.keeps(5));
    CHECK_FALSE(all.insets.keeps(6));
    CHECK_FALSE(has(all.found.marks[5], text_mark::may_break));  // before the ideograph
    CHECK(has(all.found.marks[6], text_mark::may_break));
}

TEST_CASE("a box is a grapheme of its own, and rooms cover whole graphemes", "[layout]")
{
    const inline_box box{.unit = 1};
    const text_room rooms[] = {{5, 6, 1.0}, {3, 5, 1.0}};
    const read_insets r{u"a\uFFFC\u0301e\u0301\u0302f", {.boxes = {&box, 1}, .rooms = rooms}};
    REQUIRE_FALSE(r.failure);
    CHECK(has(r.found.marks[1], text_mark::grapheme));
    CHECK(has(r.found.marks[2], text_mark::grapheme));
    CHECK(r.insets.room_at(5)->first ==
          3);  // the first room has the whole grapheme, so that nothing is left of the other
    CHECK(r.insets.room_at(5)->last == 6);
    CHECK(r.insets.room_at(6) == nullptr);
}

TEST_CASE("boxes and rooms that cannot be are refused by name", "[layout]")
{
    const auto box = [](const inline_box& b) { return read_insets{u"a\uFFFCb", {.boxes = {&b, 1}}}.option(); };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    CHECK(box({.unit = 1}).empty());
    CHECK(box({.unit = 1, .width = 0.0, .ascent = -1.0, .descent = 1.0}).empty());
    CHECK(box({.unit = 0}) == "boxes");
    CHECK(box({.unit = 3}) == "boxes");
    CHECK(box({.unit = 1, .width = -0.1}) == "boxes");
    CHECK(box({.unit = 1, .width = nan}) == "boxes");
    CHECK(box({.unit = 1, .ascent = inf}) == "boxes");
    CHECK(box({.unit = 1, .ascent = 1e308, .descent = 1e308}) == "boxes");
    CHECK(box({.unit = 1, .ascent = 1.0, .descent = -1.5}) == "boxes");
    const inline_box twice[] = {{.unit = 1}, {.unit = 1}};
    CHECK(read_insets{u"a\uFFFCb", {.boxes = twice}}.option() == "boxes");
    CHECK(read_insets{"a\xEF\xBF\xBC", {.boxes = {twice, 1}}}.option().empty());
    const auto room = [](const text_room& r) { return read_insets{u"abc", {.rooms = {&r, 1}}}.option(); };
    CHECK(room({0, 3, 1.0, 1.0}).empty());
    CHECK(room({2, 1, 1.0, 1.0}) == "rooms");
    CHECK(room({2, 4, 1.0, 1.0}) == "rooms");
    CHECK(room({0, 1, -1.0, 1.0}) == "rooms");
    CHECK(room({0, 1, nan, 1.0}) == "rooms");
    CHECK(room({0, 1, 1.0, inf}) == "rooms");
    const text_room crossed[] = {{1, 3, 1.0}, {0, 2, 1.0}};
    const read_insets r{u"abc", {.rooms = crossed}};
    CHECK(r.failure == error::overlapping_spans);
    CHECK(r.failure.cluster == 1);
    CHECK(r.insets.empty());
}

TEST_CASE("a paragraph with boxes and rooms says when memory fails, and allocates nothing after warm-up", "[layout]")
{
    const std::u16string text = u"ab\uFFFC \u6F22\u5B57 cd\uFFFC";
    const inline_box boxes[] = {{.unit = 2}, {.unit = 9, .width = 0.5}};
    const text_room rooms[] = {{4, 6, 3.0, 0.4}};
    const shape_options how{.boxes = boxes, .rooms = rooms};
    test::toy_shaper font;
    std::size_t failures = 0;
    for (std::size_t n = 1; n < 200; ++n) {
        test::counting_memory failing{.fail_at = n};
        paragraph words{font, failing.source()};
        glyph_run run{failing.source()};
        auto done = words.set(text, how);
        if (done) done = words.lay_out({.width = 3.0}, run);
        if (done) break;
        ++failures;
        CHECK(done == error::out_of_memory);
        CHECK(run.glyphs.empty());
    }
    CHECK(failures > 15);
    test::counting_memory counted;
    paragraph words{font, counted.source()};
    glyph_run run{counted.source()};
    std::size_t requests = 0;
    for (int i = 0; i < 3; ++i) {
        if (i == 1) requests = counted.requests;
        REQUIRE(words.set(text, how));
        REQUIRE(words.lay_out({.width = 3.0}, run));
    }
    CHECK(counted.requests == requests);
}
