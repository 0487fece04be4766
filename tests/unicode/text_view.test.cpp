// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/unicode/text_view.hpp>

#include <string>

using namespace typemesh;

TEST_CASE("a text view refers to text of every string type in place", "[layout][text_view]")
{
    const std::string bytes = "na\xC3\xAFve";
    const std::u8string typed = u8"na\u00EFve";
    const std::u16string wide = u"na\u00EFve";

    const text_view a = bytes, b = typed, c = wide, d = "na\xC3\xAFve", e = u8"na\u00EFve", f = u"na\u00EFve",
                    g = std::u16string_view{wide};
    CHECK(a.utf8() == bytes.data());
    CHECK(c.utf16() == wide.data());
    for (const text_view& eight : {a, b, d, e}) {
        CHECK(eight.encoding() == encoding::utf8);
        REQUIRE(eight.size() == 6);
        CHECK(eight.unit(2) == 0xC3);  // not negative where char is signed
    }
    for (const text_view& sixteen : {c, f, g}) {
        CHECK(sixteen.encoding() == encoding::utf16);
        REQUIRE(sixteen.size() == 5);
        CHECK(sixteen.unit(2) == 0xEF);
    }
    CHECK(text_view{}.empty());
    CHECK(text_view{""}.empty());
}
