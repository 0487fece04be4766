// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"

#include <typemesh/markup/markup_styles.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace text_to_mesh {

struct options;

/// A text of --markup: what its tags say of it.
struct marked_text {
    std::string source;
    typemesh::markup read;
    typemesh::markup_styles styles;
};

/// Reads the tags of o.text, which is then the text without them. Gives an empty string, or one sentence.
[[nodiscard]] std::string read_markup(options& o);

/// The colour of a style's number; nothing if it has none of its own.
[[nodiscard]] std::optional<rgb_colour> colour_of_style(const options& o, typemesh::style_id style);
/// The number of [style=...] of a style's number.
[[nodiscard]] std::optional<std::uint32_t> tag_of_style(const options& o, typemesh::style_id style);

/// How many different solids the tags ask for, with the usual one. Solid 0 is the usual one.
[[nodiscard]] std::uint32_t solids_of(const options& o);
/// The number of the solid of a style; of a drawing in a box, by the box.
[[nodiscard]] std::uint32_t solid_of_style(const options& o, typemesh::style_id style);
/// The options with which a solid is made. `o` has a marked text.
[[nodiscard]] options options_of_solid(const options& o, std::uint32_t solid);

/// Replaces the styles of a run by one for each solid, for files without colours.
void keep_only_solids(const options& o, typemesh::glyph_run& run);

}  // namespace text_to_mesh
