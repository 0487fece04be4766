// SPDX-License-Identifier: MIT
#ifdef TYPEMESH_TEST_WITH_FONTCONFIG
#include "support/catch.hpp"
#include "support/font_file.hpp"
#include "support/required.hpp"

#include <typemesh/adapt/fontconfig_fallback.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/text/font_list.hpp>
#include <typemesh/typemesh.hpp>

#include <string>

using namespace typemesh;

static_assert(fallback_provider<fontconfig_fallback<harfbuzz_font>, harfbuzz_font>);

TEST_CASE("an installed font with all of a grapheme is found, and is the same the next time",
          "[adapt][fontconfig][fallback]")
{
    auto fonts = test::required(fontconfig_fonts::open());
    fontconfig_fallback<harfbuzz_font> installed{*fonts};
    const std::u16string graphemes[] = {u"a", u"\u05D0", u"\u0628\u064E", u"\u0915\u093F", u"\u4E00\uFE00", u"\u0E01"};
    for (const std::u16string& g : graphemes) {
        const text_range whole{0, static_cast<std::uint32_t>(g.size())};
        const auto found = test::required(installed.font_for(g, whole, 0, {}));
        REQUIRE(*found != nullptr);
        for (const char16_t c : g) {
            hb_codepoint_t id = 0;
            CHECK((is_default_ignorable(c) || hb_font_get_nominal_glyph((*found)->handle(), c, &id) != 0));
        }
        CHECK(*test::required(installed.font_for(g, whole, 0, {})) == *found);
    }
    for (const std::u16string_view nobody : {u"\uFFFE", u"a\uFFFE"}) {
        const auto none = installed.font_for(nobody, {0, static_cast<std::uint32_t>(nobody.size())}, 0, {});
        REQUIRE(none);
        CHECK(*none == nullptr);
    }
    REQUIRE(*installed.font_for(u"a", {0, 1}, 0, {}) != nullptr);  // what is nowhere beside it does not count
}

TEST_CASE("the font that is found resembles the one that is named", "[adapt][fontconfig][fallback]")
{
    auto fonts = test::required(fontconfig_fonts::open());
    fontconfig_fallback<harfbuzz_font> plain{*fonts, "DejaVu Sans"}, bold{*fonts, "DejaVu Sans:bold"};
    auto sans = test::required(harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str()));
    auto heavy = test::required(harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans-Bold.ttf").c_str()));
    const auto found = plain.font_for("a", {0, 1}, 0, {}), found_bold = bold.font_for("a", {0, 1}, 0, {});
    REQUIRE((found && *found != nullptr));
    REQUIRE((found_bold && *found_bold != nullptr));
    CHECK((*found)->variation_key() == sans->variation_key());
    CHECK((*found_bold)->variation_key() == heavy->variation_key());
}

namespace {

/// A font that opens when it is asked to.
struct moody_font {
    static inline error answer = {};
    static inline int asked = 0;
    static inline std::string last = {};
    static result<moody_font> open(const char* path, const font_options&) noexcept
    {
        ++asked;
        last = path;
        if (answer) return answer;
        return moody_font{};
    }
};

}  // namespace

TEST_CASE("a font that lacked memory is opened the next time, and a broken one is not tried again",
          "[adapt][fontconfig][fallback]")
{
    auto fonts = test::required(fontconfig_fonts::open());
    fontconfig_fallback<moody_font> poor{*fonts}, broken{*fonts};
    moody_font::answer = error::out_of_memory;
    CHECK(poor.font_for("a", {0, 1}, 0, {}).error() == error::out_of_memory);
    CHECK(moody_font::asked == 1);
    const std::string first = moody_font::last;
    moody_font::answer = {};
    CHECK(*test::required(poor.font_for("a", {0, 1}, 0, {})) != nullptr);
    CHECK(moody_font::asked == 2);
    CHECK(moody_font::last == first);

    moody_font::answer = error::unreadable_file;
    for (int k = 0; k < 2; ++k) {
        CHECK(*test::required(broken.font_for("a", {0, 1}, 0, {})) == nullptr);
    }
    const int before = moody_font::asked;
    CHECK(*broken.font_for("b", {0, 1}, 0, {}) == nullptr);
    CHECK(moody_font::asked == before);
}

TEST_CASE("a list of fonts sets any script that is installed", "[adapt][fontconfig][fallback]")
{
    auto fonts = test::required(fontconfig_fonts::open());
    auto latin = test::required(harfbuzz_font::open(font_file("opentype/comic-neue/ComicNeue-Regular.otf").c_str()));
    fontconfig_fallback<harfbuzz_font> installed{*fonts, "Comic Neue"};
    font_list list{*latin, installed};
    text_mesher mesher{list};
    auto plan = test::required(mesher.plan(u"plain"));
    CHECK(list.face_count() == 1);
    plan = mesher.plan(u"tea \u05D0\u05D1 \u0628\u0628 \u4E00 \u0915\u093F \uFFFE");
    REQUIRE(plan);
    CHECK(plan->report().missing == 1);
    CHECK(plan->run().glyphs.back().missing);
    CHECK(list.face_count() >= 4);
    const std::uint32_t faces = list.face_count();
    plan = mesher.plan(u"\u0628\u0628 \u4E00");
    REQUIRE(plan);
    CHECK(plan->report().complete());
    CHECK(list.face_count() == faces);
}
#endif
