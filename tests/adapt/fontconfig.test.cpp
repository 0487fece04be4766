// SPDX-License-Identifier: MIT
#ifdef TYPEMESH_TEST_WITH_FONTCONFIG
#include "support/catch.hpp"
#include "support/required.hpp"

#include <typemesh/adapt/fontconfig.hpp>
#include <typemesh/adapt/harfbuzz.hpp>

#include <hb-ot.h>

#include <string>
#include <string_view>

using namespace typemesh;

namespace {

std::string file_of(const installed_font& font)
{
    const std::string_view path{font.path()};
    return std::string{path.substr(path.find_last_of('/') + 1)};
}

}  // namespace

TEST_CASE("an installed font is found by its family and style", "[adapt][fontconfig]")
{
    auto fonts = test::required(fontconfig_fonts::open());
    installed_font found;
    CHECK(std::string_view{found.path()}.empty());
    REQUIRE(fonts->find("DejaVu Sans", found));
    CHECK(file_of(found) == "DejaVuSans.ttf");
    CHECK(found.options().face == 0);
    CHECK(found.options().variations.empty());
    CHECK(found.named_instance() == 0);
    REQUIRE(harfbuzz_font::open(found.path(), found.options()));
    REQUIRE(fonts->find("dejavu sans:bold", found));  // letters count as on paper
    CHECK(file_of(found) == "DejaVuSans-Bold.ttf");
    REQUIRE(fonts->find("Liberation Serif:bold:italic", found));
    CHECK(file_of(found) == "LiberationSerif-BoldItalic.ttf");
    REQUIRE(fonts->find("Comic Neue:style=Light Italic", found));
    CHECK(file_of(found) == "ComicNeue-LightItalic.otf");
    REQUIRE(fonts->find("WenQuanYi Micro Hei Mono", found));
    CHECK(found.options().face == 1);  // of a collection
}

TEST_CASE("where aliases are asked for, what the system binds to a family stands in for it, and nothing else",
          "[adapt][fontconfig]")
{
    auto fonts = test::required(fontconfig_fonts::open());
    installed_font found;
    CHECK(std::string_view{found.family()}.empty());
    CHECK(fonts->find("Arial", found) == error::no_such_family);
    REQUIRE(fonts->find("Arial", found, family_names::aliases));
    CHECK(file_of(found) == "LiberationSans-Regular.ttf");
    CHECK(std::string_view{found.family()} == "Liberation Sans");
    REQUIRE(fonts->find("Times New Roman:bold:italic", found, family_names::aliases));
    CHECK(file_of(found) == "LiberationSerif-BoldItalic.ttf");
    for (const char* generic : {"sans-serif", "Serif", "monospace"}) {
        REQUIRE(fonts->find(generic, found, family_names::aliases));
        CHECK(harfbuzz_font::open(found.path(), found.options()));
    }
    CHECK(fonts->find("Nobodys Sans", found, family_names::aliases) == error::no_such_family);
    CHECK(fonts->find("Arial:condensed", found, family_names::aliases) == error::no_such_style);
    REQUIRE(fonts->find("DejaVu Sans", found, family_names::aliases));
    CHECK(file_of(found) == "DejaVuSans.ttf");
}

TEST_CASE("no font stands in for one that is not installed", "[adapt][fontconfig]")
{
    auto fonts = test::required(fontconfig_fonts::open());
    installed_font found;
    CHECK(fonts->find("No Family Of This Name", found) == error::no_such_family);
    CHECK(fonts->find("", found) == error::bad_option);
    CHECK(fonts->find(":bold", found) == error::bad_option);
    const error weight = fonts->find("DejaVu Sans:black", found).error();
    REQUIRE(weight == error::no_such_style);
    CHECK(std::string_view{weight.option} == "weight");
    CHECK(fonts->find("DejaVu Sans:style=Ornate", found) == error::no_such_style);
    CHECK(std::string_view{found.path()}.empty());
}

TEST_CASE("a found font says where on its axes it lies", "[adapt][fontconfig]")
{
    FcPattern* match = FcPatternCreate();
    const void* words[] = {"/fonts/a.ttf", "wght=700,wdth=87.5"};
    FcPatternAddString(match, FC_FILE, static_cast<const FcChar8*>(words[0]));
    FcPatternAddString(match, FC_FONT_VARIATIONS, static_cast<const FcChar8*>(words[1]));
    FcPatternAddInteger(match, FC_INDEX, 0x8000 << 16 | 2);
    installed_font font;
    REQUIRE_FALSE(font.take(match));
    FcPatternDestroy(match);
    CHECK(std::string_view{font.path()} == "/fonts/a.ttf");
    const font_options options = font.options();
    CHECK(options.face == 2);
    CHECK(font.named_instance() == 0);
    REQUIRE(options.variations.size() == 2);
    CHECK(std::string_view{options.variations[0].tag} == "wght");
    CHECK(options.variations[0].value == 700.0f);
    CHECK(std::string_view{options.variations[1].tag} == "wdth");
    CHECK(options.variations[1].value == 87.5f);
}
#endif
