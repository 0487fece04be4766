// SPDX-License-Identifier: MIT
#pragma once

#include "text_fonts.hpp"

#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace text_to_mesh {

/// The error's sentence; places in the text are bytes, for the text is UTF-8.
[[nodiscard]] std::string in_words(const typemesh::error& e);

/// What is not in the mesh, and what is not as requested, a line each; empty if there is nothing of the kind. `missing`
/// are the characters without a glyph, if they are known.
[[nodiscard]] std::string in_words(const typemesh::text_report& report, bool several_fonts = false,
                                   const std::string& who = "text_to_mesh: ", std::u32string_view missing = {});

/// The characters of the text that no font has, each once and in the order of the text. `run` is its layout.
[[nodiscard]] std::u32string missing_characters(const typemesh::glyph_run& run, const std::string& text,
                                                const font_set& fonts);

/// "U+00E9" and a letter e with an acute accent: the number of a character, and the character itself if it can be printed.
[[nodiscard]] std::string name_of(char32_t character);

// What a user should know about a text that is drawn nevertheless, one line each on standard error; `who` begins it.

/// Prints in_words(); true if there is something to print.
bool name_losses(const typemesh::text_report& report, bool several_fonts = false,
                 const std::string& who = "text_to_mesh: ", std::u32string_view missing = {});

/// Features that are to be on and that no font has: neither among its substitutions nor its positions. True where
/// there is one.
bool name_missing_features(const font_set& fonts, std::span<const typemesh::feature> wanted, const std::string& who);

/// Triangles that 32-bit positions flip or flatten: typemesh::flipped_triangles. True where there are some.
/// `instances_help` where --instances can be given.
bool name_flipped_triangles(std::uint64_t flipped, bool instances_help, const std::string& who);

}  // namespace text_to_mesh
