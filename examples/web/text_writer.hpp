// SPDX-License-Identifier: MIT
#pragma once

#include "mesh_arrays.hpp"
#include "text_maker.hpp"

namespace typemesh_web {

/// Adds what a plan writes. Compiled apart, for speed, as this runs for each vertex of each text; what builds letters is compiled for
/// size.
[[nodiscard]] typemesh::result<void> write_whole(const web_plan& plan, mesh_arrays& out) noexcept;

/// Tells each vertex of what write_whole() has written last, from vertex `first` on, the row of its letter. Needs the
/// plan's letters.
[[nodiscard]] typemesh::result<void> name_letters(const web_plan& plan, std::uint32_t first, mesh_arrays& out) noexcept;

/// Likewise the colour that tags give it.
[[nodiscard]] typemesh::result<void> name_tints(const web_plan& plan, const marked_words& words, std::uint32_t first,
                                                mesh_arrays& out) noexcept;

/// The same as different letters and where they stand.
[[nodiscard]] typemesh::result<void> write_letters(const web_plan& plan, mesh_arrays& out) noexcept;

}  // namespace typemesh_web
