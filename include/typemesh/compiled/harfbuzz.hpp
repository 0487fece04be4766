// SPDX-License-Identifier: MIT
#pragma once

// The default mesher over HarfBuzz, compiled once for a program: link typemesh::compiled. That target adds
// harfbuzz.cpp, beside this file, to your own sources, to be compiled with your own flags, and defines
// TYPEMESH_COMPILED, with which <typemesh/typemesh.hpp> includes this file. Without CMake: do both yourself, the
// definition for all files of a program.
//
// Everything else stays in headers: other policies and fonts, and what depends on your vertices.

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/text/text_mesher.hpp>

namespace typemesh::inline TYPEMESH_ABI {

using harfbuzz_mesher = text_mesher<harfbuzz_font>;
using harfbuzz_worker = lone_worker<harfbuzz_font, no_observer>;

extern template result<harfbuzz_mesher::plan_type> harfbuzz_mesher::plan_text(text_view, const text_options&,
                                                                              harfbuzz_worker&) noexcept;
extern template result<harfbuzz_mesher::plan_type> harfbuzz_mesher::plan_run(const glyph_run&, const text_options&,
                                                                             harfbuzz_worker&) noexcept;

}  // namespace typemesh::inline TYPEMESH_ABI
