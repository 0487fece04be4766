// SPDX-License-Identifier: MIT

// Must not compile, with a sentence: a mesher's type names its solid, and another one is no option of it.

#include <typemesh/typemesh.hpp>

using namespace typemesh;

void choose(text_mesher<extruded<>>& mesher) { mesher.use(flat{}); }
