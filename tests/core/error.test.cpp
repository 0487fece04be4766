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

TEST_CASE("an error keeps what is said of its place", "[core][error]")
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
          "glyph 37, cluster 4: Contours of the outline cross, touch or overlap.");
    CHECK(std::string{describe(error{error::unknown_glyph}.at(37, no_cluster), room)}.rfind("glyph 37: ", 0) == 0);
    CHECK(std::string{describe(error{error::needs_shaping}.at(no_glyph, 9), room)}.rfind("cluster 9: ", 0) == 0);
    CHECK(std::string{describe(error{error::no_such_face, 2}, room)} ==
          "There is no face with that number in the font file or among the given fonts. (faces: 2)");
    CHECK(std::string{describe(error{error::font_library_failed, 22}, room)} ==
          "The font library refused the request. (its error: 22)");
    CHECK(std::string{describe(error::short_of("indices", 720), room)} ==
          "The caller's buffer is too small for the mesh. (needed: 720 indices)");
    CHECK(std::string{describe(error::no_axis("wdth"), room)} == "The font has no such variation axis. (wdth)");
    CHECK(error::no_axis("wdth").count == 0x77647468);
    CHECK(std::string{describe(error::bad("depth"), room)} == "An option is outside its range. (depth)");
    CHECK(error::bad("depth") == error::bad_option);
    CHECK(std::string{describe(error{}, room)} == "No error.");
}

TEST_CASE("a description is cut where it does not fit, and always ended", "[core][error]")
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
