// SPDX-License-Identifier: MIT
#include "compiled/text_hash.hpp"
#include "support/catch.hpp"
#include "support/font_file.hpp"

#include <typemesh/compiled/harfbuzz.hpp>

#ifndef TYPEMESH_COMPILED
#error "this unit is to be compiled with typemesh::compiled"
#endif

TEST_CASE("a unit with typemesh::compiled and one without make the same meshes in one program, and share nothing",
          "[compiled]")
{
    const std::string font = font_file("truetype/dejavu/DejaVuSans.ttf");
    for (const char* text : {"", "Hello world!", "W\u00E4re\n\u0634\u0643\u0644\nAV %\u2117"}) {
        const test::text_hash own = hash_of(font.c_str(), text);
        const test::text_hash other = test::hash_of_header_only_unit(font.c_str(), text);
        CAPTURE(text);
        CHECK(own.hash == other.hash);
        CHECK(own.vertices == other.vertices);
        CHECK((*text == 0) == (own.vertices == 0));
        CHECK(own.own_place != other.own_place);
    }
}
