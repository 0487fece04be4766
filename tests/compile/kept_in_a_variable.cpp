// SPDX-License-Identifier: MIT

// Must not compile, and each message names what must outlive what refers to it.

#include "../support/toy_font.hpp"

#include <typemesh/compat/d3dx_text.hpp>
#include <typemesh/typemesh.hpp>

#include <utility>

using namespace typemesh;

void refer(test::toy_font& font, text_mesher<>& mesher, glyph_run& run)
{
    text_mesher of_a_temporary{test::toy_font{}};
    mesher.use(test::toy_font{});
    (void)mesher.plan(std::move(run));
    (void)text_mesher{font}.plan("o");
    (void)d3dx_text{font}.plan("o");
}
