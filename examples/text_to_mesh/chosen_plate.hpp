// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/plate/plate_options.hpp>

#include <optional>
#include <string>

namespace text_to_mesh {

/// The options for plates as they were given; empty: not given.
struct plate_words {
    std::string plate, backing, engrave, stencil, keyring, fillet;
    bool cut = false, inlay = false, stamp = false, open_counters = false;
};

/// A plate that is chosen at run time.
struct chosen_plate {
    bool is_on = false;
    bool follows = false;  ///< it follows the letters' outline: --backing
    float growth = 0.0f;   ///< em; how far that outline lies around the letters
    typemesh::plate_options how;
};

/// The options that do not work with a plate.
inline constexpr std::initializer_list<const char*> not_with_plates = {
    "--bevel-out", "--bevel-sides", "--bevel-mode", "--bevel-steps",   "--bevel-depth", "--carve",
    "--outline",   "--refine",      "--inflate",    "--segments",      "--normals",     "--crease",
    "--uv",        "--no-merge",    "--lod",        "--morph",         "--instances",   "--letters",
    "--markup",    "--taper",       "--per-letter", "--colour-layers", "--tube",        "--svg"};

/// Reads the options for plates. Gives an empty string, or one sentence of what is wrong.
///
///     depth    of --depth, in em, if it was given
[[nodiscard]] std::string read_plate(const plate_words& words, std::optional<float> depth, chosen_plate& out);

}  // namespace text_to_mesh
