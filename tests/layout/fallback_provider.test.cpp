// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/fallback_provider.hpp>

using namespace typemesh;

namespace {

struct own_font {};

struct own_provider {
    own_font font;
    result<own_font*> font_for(text_view text, text_range grapheme, std::uint32_t, std::string_view) noexcept
    {
        return text.unit(grapheme.first) == 'a' ? &font : nullptr;
    }
};

struct throwing_provider {
    result<own_font*> font_for(text_view, text_range, std::uint32_t, std::string_view) { return nullptr; }
};

}  // namespace

static_assert(fallback_provider<own_provider, own_font>);
static_assert(fallback_provider<no_fallback<own_font>, own_font>);
static_assert(!fallback_provider<own_provider, int>);
static_assert(!fallback_provider<throwing_provider, own_font>);

TEST_CASE("a provider has a font or none", "[layout][fallback]")
{
    own_provider provider;
    const auto some = provider.font_for("ab", {0, 1}, 0, {}), none = provider.font_for("ab", {1, 2}, 0, {});
    REQUIRE(some);
    REQUIRE(none);
    CHECK(*some == &provider.font);
    CHECK(*none == nullptr);
    const auto nothing = no_fallback<own_font>{}.font_for("ab", {0, 1}, 0, {});
    REQUIRE(nothing);
    CHECK(*nothing == nullptr);
}
