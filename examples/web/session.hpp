// SPDX-License-Identifier: MIT
#pragma once

#include "fonts.hpp"
#include "mesh_arrays.hpp"
#include "settings.hpp"
#include "text_maker.hpp"
#include "weight_morph.hpp"

#include <typemesh/paragraph/paragraph.hpp>
#include <typemesh/paragraph/total_fit.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace typemesh_web {

/// One of the ways to break lines, chosen at run time.
struct chosen_breaker {
    typemesh::first_fit first;
    typemesh::total_fit even{.emergency_stretch = 0.5};  // lines of few words have few spaces to stretch
    bool is_even = false;

    typemesh::error break_lines(std::span<const typemesh::break_piece> pieces, const typemesh::line_room& room,
                                typemesh::buffer<std::uint32_t>& ends) noexcept
    {
        return is_even ? even.break_lines(pieces, room, ends) : first.break_lines(pieces, room, ends);
    }
};

/// Fonts, options, built letters and the last mesh: what JavaScript calls a mesher.
class session {
public:
    /// At least one font.
    explicit session(std::vector<shared_font> fonts);

    /// Takes options for the texts that follow.
    void set(const settings& how);

    /// Fills arrays(). Needs options that are not refused().
    [[nodiscard]] typemesh::result<void> make(std::u16string_view text, bool instances);

    /// Plans a text that moves along an axis of the first font, such as "wght". Tags are read and have no effect;
    /// bevels and bends are left out.
    [[nodiscard]] typemesh::result<void> plan_morph(std::u16string_view text, const char (&axis)[5]);
    /// Fills arrays() with the planned text at a value of the axis. Needs plan_morph().
    [[nodiscard]] typemesh::result<void> write_morph(double value) { return morph_->write(value, arrays_); }
    [[nodiscard]] bool has_morph() const noexcept { return morph_ != nullptr; }

    /// One sentence if the options cannot be had together, else null.
    [[nodiscard]] const char* refused() const noexcept { return how_.refused(); }
    /// A sentence about what make() refused, if the library's own would not help here; else null.
    [[nodiscard]] const char* explained(const typemesh::error& e);

    [[nodiscard]] const mesh_arrays& arrays() const noexcept { return arrays_; }
    void clear_cache() noexcept { cache_.clear(); }

private:
    using page_words = typemesh::paragraph<font_set, typemesh::unicode_analyser, chosen_breaker>;

    [[nodiscard]] typemesh::result<void> lay_out(std::u16string_view text, const typemesh::layout_options& lines);

    std::vector<shared_font> fonts_;
    font_set set_;
    settings how_;
    text_to_mesh::options options_;
    typemesh::glyph_cache<> cache_;
    page_words words_{set_};
    typemesh::glyph_run page_;
    text_maker maker_{set_, cache_};
    marked_words tags_;
    std::unique_ptr<weight_morph> morph_;
    mesh_arrays arrays_;
    std::string sentence_;
};

}  // namespace typemesh_web
