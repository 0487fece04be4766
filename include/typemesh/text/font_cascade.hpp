// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/fallback_shaping.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/text/font_faces.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Several fonts used as one, in which each font supplies the glyphs that the fonts before it lack:
///
///     font_cascade fonts{latin, arabic, cjk};              // all must outlive it
///     text_mesher mesher{fonts};
///     auto plan = mesher.plan(text);
///
/// Text that the first font supports is shaped once, by the first font only, and the result is as without the other
/// fonts. Glyphs of the other fonts are scaled to the first font's em. The fonts used in a line set its spacing, unless
/// the lines are uniform (line_box::uniform). fallback_shaping.hpp says how missing glyphs are found and replaced.
/// font_list.hpp is for fonts whose number is known only at run time.
///
/// Move-only. Used by one thread at a time.
template <outline_source... Fonts>
    requires(shaper<Fonts> && ...)
class font_cascade : public font_faces<Fonts...> {
    using faces = font_faces<Fonts...>;
    static_assert(!(face_source<Fonts> || ...), "typemesh: a font_cascade needs fonts of one face each");

public:
    explicit font_cascade(Fonts&... fonts) noexcept : faces{fonts...} {}
    template <class... Given>
        requires(is_result<Given> || ...)  // refuses a result without its `*`
    explicit font_cascade(Given&... given) noexcept : font_cascade{refuse_result(given)...}
    {
    }

    /// See shaper.
    error shape(text_view text, const text_item& item, const shape_options& options,
                buffer<shaped_glyph>& glyphs) noexcept
    {
        const faces& all = *this;
        return shaping_.shape(all, text, item, options, glyphs);
    }

private:
    fallback_shaping shaping_;
};

template <class... Given>
    requires(is_result<Given> || ...)
font_cascade(Given&...) -> font_cascade<std::remove_reference_t<decltype(refuse_result(std::declval<Given&>()))>...>;

}  // namespace typemesh::inline TYPEMESH_ABI
