// SPDX-License-Identifier: MIT
#pragma once

#include "text_fonts.hpp"

#include <typemesh/core/box.hpp>
#include <typemesh/layout/glyph_run.hpp>

#include <cstdint>
#include <map>
#include <utility>

namespace text_to_mesh {

/// The box of what is seen of texts, as far as control points reach, which is enough to compare layouts by. It remembers
/// the letters that it has met.
class ink {
public:
    explicit ink(font_set& font) : font_{&font} {}

    /// In em; empty if nothing is seen.
    [[nodiscard]] typemesh::box of(const typemesh::glyph_run& run);

private:
    font_set* font_;
    std::map<std::pair<std::uint32_t, typemesh::glyph_id>, typemesh::box> letters_;  // by face, in its font units
};

}  // namespace text_to_mesh
