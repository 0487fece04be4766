// SPDX-License-Identifier: MIT

// Must not compile: a policy for a mesher that is a variable already, a cache without the font's number.

#include "../support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

using namespace typemesh;

void exchange(test::toy_font& font, text_mesher<>& mesher, glyph_cache<>& cache)
{
    auto flat_text = mesher.with(flat{});
    auto quick_text = text_mesher{font}.with(cache);
}
