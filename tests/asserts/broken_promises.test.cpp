// SPDX-License-Identifier: MIT
#include "support/recorded_asserts.hpp"

#include "support/catch.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

using namespace typemesh;

namespace {

std::string asserted()
{
    std::string words = test::failed_asserts.empty() ? "" : test::failed_asserts.front();
    test::failed_asserts.clear();
    return words;
}

const char* const stale = "this text_plan is stale: its mesher has made another plan or was moved since";

/// A sink that keeps nothing.
struct nowhere {
    static constexpr auto wants = attribute::none;
    error begin(mesh_size) noexcept { return {}; }
    void vertex(const surface_point<wants>&) noexcept {}
    void triangle(std::uint32_t, std::uint32_t, std::uint32_t) noexcept {}
    void end() noexcept {}
};

}  // namespace

TEST_CASE("using a plan after its mesher's next plan is asserted", "[asserts]")
{
    test::toy_font font;
    text_mesher mesher{font};
    auto old = mesher.plan("E");
    (void)old->size();
    CHECK(asserted() == "");
    auto fresh = mesher.plan("EE");
    (void)old->size();
    CHECK(asserted() == stale);
    (void)fresh->size();
    CHECK(asserted() == "");
}

TEST_CASE("using a plan whose mesher was moved is asserted", "[asserts]")
{
    test::toy_font font;
    text_mesher mesher{font}, other{font};
    auto plan = mesher.plan("E");
    auto of_other = other.plan("o");
    other = std::move(mesher);
    (void)plan->size();
    CHECK(asserted() == stale);
    (void)of_other->size();
    CHECK(asserted() == stale);

    auto again = other.plan("E");
    auto flat_text = std::move(other).with(flat{});
    (void)again->size();
    CHECK(asserted() == stale);
    (void)flat_text.plan("E")->size();
    CHECK(asserted() == "");
}

TEST_CASE("using a plan after its workers have built another, or another plan's chunks, is asserted", "[asserts]")
{
    test::toy_font font;
    text_mesher mesher{font}, other{font};
    one_worker alone;
    auto team = workers_of(alone, [](std::size_t) noexcept { return result<test::toy_font>{test::toy_font{}}; });
    auto plan = mesher.plan("E", {}, *team);
    (void)plan->size();
    CHECK(asserted() == "");
    auto of_other = other.plan("o", {}, *team);
    (void)of_other->size();
    CHECK(asserted() == "");
    (void)plan->size();
    CHECK(asserted() == "this text_plan is stale: its glyph_workers has built another plan since");

    text_chunks chunks;
    CHECK(chunks.cut(*of_other));
    CHECK(chunks.write(*of_other, 0, nowhere{}));
    CHECK(asserted() == "");
    auto alike = mesher.plan("o");
    CHECK(chunks.write(*alike, 0, nowhere{}));
    CHECK(asserted() == "these text_chunks were cut from another plan");
}

TEST_CASE("reading an error as a value is asserted", "[asserts]")
{
    result<int> failed = error::out_of_memory;
    CHECK_FALSE(failed);
    (void)failed.error();
    CHECK(asserted() == "");
    result<int> nothing{error{}};
    CHECK(asserted() == "a result without a value must have an error");
}

TEST_CASE("moving a borrowed workspace is asserted", "[asserts]")
{
    workspace space;
    workspace other;
    {
        workspace::scope open{space};
        other = std::move(space);
        CHECK(asserted() == "a workspace was moved while a scope was open");
        space = std::move(other);
        test::failed_asserts.clear();
    }
}

TEST_CASE("reading a text in another encoding than its own is asserted", "[asserts]")
{
    (void)text_view{"abc"}.utf8();
    (void)text_view{u"abc"}.utf16();
    CHECK(asserted() == "");
    (void)text_view{"abc"}.utf16();
    CHECK(asserted() == "a text in UTF-8 was read as UTF-16");
    (void)text_view{u"abc"}.utf8();
    CHECK(asserted() == "a text in UTF-16 was read as UTF-8");
}

TEST_CASE("a frame that would distort the text is asserted", "[asserts]")
{
    test::toy_font font;
    text_mesher mesher{font};
    CHECK(mesher.plan("E", {.frame = {.up = {1.0f, 0.0f, 0.0f}}}));
    CHECK(asserted() == "a frame's axes must be unit vectors at right angles");
}
