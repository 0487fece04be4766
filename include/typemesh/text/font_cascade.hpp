// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/layout/fallback_shaping.hpp>
#include <typemesh/layout/item_shaper.hpp>
#include <typemesh/layout/shaper.hpp>
#include <typemesh/text/font_faces.hpp>

#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Several fonts of which each has what those before it lack:
///
///     font_cascade fonts{latin, arabic, cjk};              // all must outlive it
///     text_mesher mesher{fonts};
///     auto plan = mesher.plan(text);
///
/// Text that the first font has is shaped by it alone, once, as without the others. Glyphs of the others are as large
/// as the first one's em, and lines stand as far apart as the first one says, in a
/// paragraph as those say that stand in them, unless its options want uniform ones. How holes are found and filled:
/// fallback_shaping.hpp; fonts whose number is known only at run time: font_list.hpp.
///
/// Move-only. Used by one thread at a time.
template <outline_source... Fonts>
    requires(item_shaper<Fonts> && ...)
class font_cascade : public font_faces<Fonts...> {
    using faces = font_faces<Fonts...>;
    static_assert(!(face_source<Fonts> || ...), "typemesh: a font_cascade takes fonts of one face each");

public:
    explicit font_cascade(Fonts&... fonts) noexcept : faces{fonts...} {}
    template <class... Given>
        requires(is_result<Given> || ...)  // one without its `*` will not do
    explicit font_cascade(Given&... given) noexcept : font_cascade{refuse_result(given)...}
    {
    }

    /// See shaper and item_shaper.
    result<point> shape(text_view text, std::size_t first, std::size_t last, const shape_options& options,
                        glyph_run& run) noexcept
    {
        const faces& all = *this;
        return shaping_.shape(all, text, first, last, options, run);
    }
    error shape_item(text_view text, const text_item& item, const shape_options& options,
                     buffer<shaped_glyph>& glyphs) noexcept
    {
        const faces& all = *this;
        return shaping_.shape_item(all, text, item, options, glyphs);
    }

private:
    fallback_shaping shaping_;
};

template <class... Given>
    requires(is_result<Given> || ...)
font_cascade(Given&...) -> font_cascade<std::remove_reference_t<decltype(refuse_result(std::declval<Given&>()))>...>;

}  // namespace typemesh::inline TYPEMESH_ABI
