// SPDX-License-Identifier: MIT
#pragma once

// The core: text to triangles, without third-party headers. Fonts come from one of the adapters
// (<typemesh/adapt/harfbuzz.hpp>, <typemesh/adapt/freetype.hpp> or <typemesh/adapt/directwrite.hpp>) or from your own
// outlines.
//
// Not included: <typemesh/compat/d3dx_text.hpp>.

#include <typemesh/core/version.hpp>

#include <typemesh/outline/font_options.hpp>
#include <typemesh/outline/outline_source.hpp>
#include <typemesh/outline/recorded_outlines.hpp>
#include <typemesh/outline/transformed_outlines.hpp>

#include <typemesh/layout/layout.hpp>

#include <typemesh/discretise/adaptive_subdivision.hpp>
#include <typemesh/discretise/certified.hpp>
#include <typemesh/discretise/discretise.hpp>
#include <typemesh/discretise/quality.hpp>
#include <typemesh/discretise/thesis_quality.hpp>
#include <typemesh/discretise/two_lines.hpp>

#include <typemesh/fill/fill.hpp>
#include <typemesh/fill/outer_of.hpp>

#include <typemesh/triangulate/constrained_delaunay.hpp>
#include <typemesh/triangulate/monotone.hpp>
#include <typemesh/triangulate/triangle_quality.hpp>

#include <typemesh/vertex/colour.hpp>
#include <typemesh/vertex/computed_stream.hpp>
#include <typemesh/vertex/frame.hpp>
#include <typemesh/vertex/growing_sink.hpp>
#include <typemesh/vertex/half.hpp>
#include <typemesh/vertex/normalised.hpp>
#include <typemesh/vertex/octahedral.hpp>
#include <typemesh/vertex/octahedral_tangent.hpp>
#include <typemesh/vertex/position_box.hpp>
#include <typemesh/vertex/stream_sink.hpp>
#include <typemesh/vertex/ten_bit.hpp>

#include <typemesh/extrude/averaged_normals.hpp>
#include <typemesh/extrude/cap_normals.hpp>
#include <typemesh/extrude/creased_normals.hpp>
#include <typemesh/extrude/curve_normals.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/extrude/flat.hpp>
#include <typemesh/extrude/shared_normals.hpp>

#include <typemesh/glyph/glyph_cache.hpp>
#include <typemesh/text/flipped_triangles.hpp>
#include <typemesh/text/letter_motions.hpp>
#include <typemesh/text/shaped_by.hpp>
#include <typemesh/text/text_chunks.hpp>
#include <typemesh/text/text_mesher.hpp>

#if defined(TYPEMESH_COMPILED)  // see compiled/harfbuzz.hpp
#include <typemesh/compiled/harfbuzz.hpp>
#endif
