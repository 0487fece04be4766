// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"

#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <cstring>
#include <string>

namespace fuzz {

/// Letters that the toy font has, lacks, or cannot draw, and line ends.
inline std::string read_letters(values& in, std::uint32_t most)
{
    std::string text;
    for (std::uint32_t left = in.below(most + 1); left > 0; --left) text += "oooEExxi   ~?\n"[in.below(14)];
    return text;
}

inline typemesh::text_options read_options(values& in)
{
    using namespace typemesh;
    static constexpr frame frames[] = {right_handed_y_up, left_handed_y_up, right_handed_z_up, left_handed_z_up};
    const std::uint32_t bits = in.byte(), more = in.byte();
    text_options how;
    how.frame = frames[more & 3];
    if ((more & 4) != 0) how.frame.winding = -1;
    if ((more & 8) != 0) how.depth_in = depth_unit::output;
    how.texture_over = static_cast<texture_box>((more >> 4) % 3);
    how.tolerance = in.one_of({quality::high, quality::normal, quality::low, 0.05});
    how.unit = static_cast<output_unit>(bits & 3);
    how.merge = (bits & 4) != 0;
    how.reuse = (bits & 8) == 0;
    how.draw_missing = (bits & 16) != 0;
    if ((bits & 32) != 0) how.fill = fill_rule::even_odd;
    if ((bits & 64) != 0) how.shape.letter_spacing = in.between(-0.6, 0.3);
    if ((bits & 128) != 0) how.size = in.between(0.01, 100.0);
    return how;
}

inline bool same_bits(const test::full_mesh& a, const test::full_mesh& b)
{
    return a.indices == b.indices && a.vertices.size() == b.vertices.size() &&
           (a.vertices.empty() ||
            std::memcmp(a.vertices.data(), b.vertices.data(), a.vertices.size() * sizeof(test::full_vertex)) == 0);
}

}  // namespace fuzz
