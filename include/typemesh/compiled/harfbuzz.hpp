// SPDX-License-Identifier: MIT
#pragma once

// What most programs use, compiled once for each: link typemesh::compiled. That target adds harfbuzz.cpp, beside this
// file, to your own sources, to be compiled with your own flags, and defines TYPEMESH_COMPILED, with which
// <typemesh/typemesh.hpp> includes this file. Without CMake: do both yourself, the definition for all units of a
// target.

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/text/text_mesher.hpp>

namespace typemesh::inline TYPEMESH_ABI {

using harfbuzz_mesher = text_mesher<harfbuzz_font>;
using harfbuzz_worker = lone_worker<harfbuzz_font, no_observer>;

// The default mesher over HarfBuzz: everything but the writing, which depends on your vertices.
extern template result<harfbuzz_mesher::plan_type> harfbuzz_mesher::plan_text(text_view, const text_options&,
                                                                              harfbuzz_worker&) noexcept;
extern template result<harfbuzz_mesher::plan_type> harfbuzz_mesher::plan_run(const glyph_run&, const text_options&,
                                                                             harfbuzz_worker&) noexcept;

// What other fonts and extruders share: curves to proven regions and triangles, by the default policies.
extern template error discretise(const outline&, const certified&, double, const grid&, contours&,
                                 std::span<const std::uint8_t>) noexcept;
extern template result<region> cap_builder::prove(const monotone&) noexcept;
extern template result<region> resolve(contours&, fill_rule, workspace&, accept_all_intersections&,
                                       const resolve_options&) noexcept;
extern template result<region> resolve(contours&, fill_rule, workspace&, crossing_refinement&,
                                       const resolve_options&) noexcept;
extern template error cut_region(const region&, const monotone&, workspace&, triangle_list&) noexcept;

}  // namespace typemesh::inline TYPEMESH_ABI
