// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/error.hpp>

#include <cstring>
#include <set>
#include <string>

using namespace typemesh;

TEST_CASE("every error has a sentence of its own", "[core][error]")
{
    const std::string unknown = error{static_cast<error::kind>(200)}.message();
    CHECK(unknown == "The error's code is unknown: check where the error was made.");
    std::set<std::string> sentences;
    for (int code = error::none; code <= error::refused_by_user; ++code) {
        const std::string words = error{static_cast<error::kind>(code)}.message();
        INFO(words);
        CHECK(words.size() > 5);
        CHECK(words.back() == '.');
        CHECK(words != unknown);
        CHECK(words.find('.') == words.size() - 1);
        if (code != error::none) CHECK(words.find(": ") < words.size());  // what is wrong: what to do
        CHECK(sentences.insert(words).second);
    }
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

TEST_CASE("200 characters suffice for a description of every error", "[core][error]")
{
    char room[300];
    for (int code = error::none; code <= error::refused_by_user; ++code) {
        error e = error{static_cast<error::kind>(code), UINT64_MAX}.at(0xfffffffe, 0xfffffffe);
        if (code == error::buffer_too_small) e.option = "vertices";
        INFO(describe(e, room));
        CHECK(std::strlen(describe(e, room)) < 200);
    }
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
    CHECK(std::string{describe(error{error::crossing_contours}.at(37, 4), room)} ==
          "glyph 37, cluster 4: Contours of the outline cross, touch or overlap: resolve them first.");
    CHECK(std::string{describe(error{error::unknown_glyph}.at(37, no_cluster), room)}.rfind("glyph 37: ", 0) == 0);
    CHECK(std::string{describe(error{error::needs_shaping}.at(no_glyph, 9), room)}.rfind("cluster 9: ", 0) == 0);
    CHECK(std::string{describe(error{error::no_such_face, 2}, room)} ==
          "There is no face with that number: count faces from 0, and choose one that exists. (faces: 2)");
    CHECK(std::string{describe(error{error::font_library_failed, 22}, room)} ==
          "The font library refused the request: check the font. (its error: 22)");
    CHECK(std::string{describe(error::short_of("indices", 720), room)} ==
          "The buffer is too small for the mesh: give a larger one. (needed: 720 indices)");
    CHECK(std::string{describe(error::no_axis("wdth"), room)} ==
          "The font has no such variation axis: choose one of its own axes. (wdth)");
    CHECK(error::no_axis("wdth").count == 0x77647468);
    CHECK(std::string{describe(error::bad("depth"), room)} ==
          "An option is outside its range: give a value within the documented range. (depth)");
    CHECK(error::bad("depth") == error::bad_option);
    CHECK(std::string{describe(error{}, room)} == "There is no error.");
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
