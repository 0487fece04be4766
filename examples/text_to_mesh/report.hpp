// SPDX-License-Identifier: MIT
#pragma once

#include "text_fonts.hpp"

#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <span>
#include <string>

namespace text_to_mesh {

/// The error's sentence; places in the text are bytes, for the text is UTF-8.
[[nodiscard]] std::string in_words(const typemesh::error& e);

/// What is not in the mesh, and what is not as it was asked for, a line each; empty if there is nothing of the kind.
[[nodiscard]] std::string in_words(const typemesh::text_report& report, bool several_fonts = false,
                                   const std::string& who = "text_to_mesh: ");

// What a user should know about a text that is drawn nevertheless, one line each on standard error; `who` begins it.

/// What in_words() says of the report; true when it says something.
bool name_losses(const typemesh::text_report& report, bool several_fonts = false,
                 const std::string& who = "text_to_mesh: ");

/// Features that are to be on and that no font has: neither among its substitutions nor its positions. True where
/// there is one.
bool name_missing_features(const font_set& fonts, std::span<const typemesh::feature> wanted, const std::string& who);

/// Triangles that 32-bit positions flip or flatten: typemesh::flipped_triangles. True where there are some.
/// `instances_help` where --instances can be given.
bool name_flipped_triangles(std::uint64_t flipped, bool instances_help, const std::string& who);

}  // namespace text_to_mesh
