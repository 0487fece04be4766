// SPDX-License-Identifier: MIT
#pragma once

#include "fonts.hpp"
#include "mesh_arrays.hpp"
#include "settings.hpp"
#include "text_maker.hpp"

#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/total_fit.hpp>

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

namespace typemesh_web {

/// Fonts, options, built letters and the last mesh: what JavaScript calls a mesher.
class session {
public:
    /// At least one font.
    explicit session(std::vector<shared_font> fonts);

    /// Takes options for the texts that follow.
    void set(const settings& how);

    /// Fills arrays().
    [[nodiscard]] typemesh::error make(std::u16string_view text, bool instances);

    [[nodiscard]] const mesh_arrays& arrays() const noexcept { return arrays_; }
    void clear_cache() noexcept { cache_.clear(); }

private:
    template <class Breaker>
    using words_of = typemesh::paragraph<font_set, typemesh::unicode_analyser, Breaker>;
    using first_fit_words = words_of<typemesh::first_fit>;
    using total_fit_words = words_of<typemesh::total_fit>;

    template <class Words>
    [[nodiscard]] typemesh::error lay_out(Words& words, std::u16string_view text);

    std::vector<shared_font> fonts_;
    font_set set_;
    settings how_;
    text_to_mesh::options options_;
    typemesh::glyph_cache<> cache_;
    std::unique_ptr<first_fit_words> words_;
    std::unique_ptr<total_fit_words> even_words_;
    typemesh::glyph_run page_;
    std::unique_ptr<text_maker> maker_;
    mesh_arrays arrays_;
};

}  // namespace typemesh_web
