// SPDX-License-Identifier: MIT
#pragma once

// Texts of real fonts that are built in several ways.

#include "opened_font.hpp"
#include "support/executors.hpp"

#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <string>

namespace test {

/// A text in font units has the same mesh by itself, from a cache, and from workers. `written` reads a plan's mesh.
template <class Write, class... Policies>
void check_same_meshes(const std::string& path, const std::string& text, const Write& written,
                       const Policies&... policies)
{
    using namespace typemesh;
    const text_options options{.unit = output_unit::font_units};
    harfbuzz_font font = opened(path);
    text_mesher mesher{font, policies...};
    const auto plan = mesher.plan(text, options);
    REQUIRE(plan);
    const auto expected = written(*plan);

    glyph_cache cache;
    text_mesher cached{font, policies..., cached_in{cache, 1}};
    for (int i = 0; i < 2; ++i) {
        const auto again = cached.plan(text, options);
        REQUIRE(again);
        CHECK(written(*again) == expected);
    }
    CHECK(cache.statistics().hits > 0);

    scrambled_workers pool;
    auto team = workers_of(pool, [&](std::size_t) noexcept { return harfbuzz_font::open(path.c_str()); });
    REQUIRE(team);
    const auto shared = mesher.plan(text, options, *team);
    REQUIRE(shared);
    auto m = expected;
    m.vertices.clear(), m.indices.clear();
    REQUIRE(shared->write(into(m.vertices, m.indices), pool));
    CHECK(m == expected);
}

}  // namespace test
