// SPDX-License-Identifier: MIT

// Must not compile: an extruder without a depth for what Direct3D extrudes.

#include "../support/toy_font.hpp"

#include <typemesh/compat/d3dx_text.hpp>
#include <typemesh/extrude/flat.hpp>

using namespace typemesh;

void exchange(test::toy_font& font) { auto flat_maker = d3dx_text{font}.with(flat{}); }
