// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/error.hpp>

#include <cstring>
#include <set>
#include <string>

using namespace typemesh;

TEST_CASE("every error has a sentence of its own", "[core][error]")
{
    std::set<std::string> sentences;
    for (int code = error::none; code <= error::refused_by_user; ++code) {
        const std::string words = error{static_cast<error::kind>(code)}.message();
        INFO(words);
        CHECK(words.size() > 5);
        CHECK(words.back() == '.');
        CHECK(words != "Unknown error.");
        CHECK(sentences.insert(words).second);
    }
    CHECK(std::string{error{static_cast<error::kind>(200)}.message()} == "Unknown error.");
}

TEST_CASE("only error::none is no error", "[core][error]")
{
    CHECK(!error{});
    CHECK(!error{error::none});
    for (int code = error::none + 1; code <= error::refused_by_user; ++code)
        CHECK(error{static_cast<error::kind>(code)});
    CHECK(error{error::too_large} == error::too_large);
    CHECK(!(error{error::too_large} == error::none));
}

TEST_CASE("an error keeps its glyph, its cluster and its count", "[core][error]")
{
    const error e = error{error::crossing_contours, 7}.at(37, 4);
    CHECK(e == error::crossing_contours);
    CHECK(e.glyph == 37);
    CHECK(e.cluster == 4);
    CHECK(e.count == 7);
}

TEST_CASE("a description names glyph, cluster, count and option where they are known", "[core][error]")
{
    char room[300];
    const auto text_of = [&room](const error& e) { return std::string{describe(e, room)}; };
    CHECK(text_of(error{error::crossing_contours}.at(37, 4)) ==
          "glyph 37, cluster 4: Contours of the outline cross, touch or overlap.");
    CHECK(text_of(error{error::unknown_glyph}.at(37, no_cluster)).rfind("glyph 37: ", 0) == 0);
    CHECK(text_of(error{error::needs_shaping}.at(no_glyph, 9)).rfind("cluster 9: ", 0) == 0);
    CHECK(text_of({error::no_such_face, 2}) ==
          "There is no face with that number in the font file or among the given fonts. (faces: 2)");
    CHECK(text_of({error::font_library_failed, 22}) == "The font library refused the request. (its error: 22)");
    CHECK(text_of(error::short_of("indices", 720)) ==
          "The caller's buffer is too small for the mesh. (needed: 720 indices)");
    CHECK(text_of(error::no_axis("wdth")) == "The font has no such variation axis. (wdth)");
    CHECK(error::no_axis("wdth").count == 0x77647468);
    CHECK(text_of(error::bad("depth")) == "An option is outside its range. (depth)");
    CHECK(error::bad("depth") == error::bad_option);
    CHECK(text_of({}) == "No error.");
}

TEST_CASE("a description that does not fit is cut and terminated", "[core][error]")
{
    char room[64];
    for (std::size_t size = 1; size <= sizeof room; ++size) {
        std::memset(room, 'x', sizeof room);
        const char* words = describe(error{error::too_large}.at(1, 2), {room, size});
        CHECK(std::strlen(words) < size);
        if (size < sizeof room) CHECK(room[size] == 'x');
    }
    CHECK(std::strlen(describe(error{error::too_large}, {})) == 0);
}
