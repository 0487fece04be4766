// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/result.hpp>
#include <typemesh/unicode/text_range.hpp>
#include <typemesh/unicode/text_view.hpp>

#include <concepts>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// Finds fonts for text that the caller's fonts lack: among the installed fonts, or in any other source.
///
///     p.font_for(text, grapheme, script, language)    a font that has all of text[grapheme.first, grapheme.last), or
///                                                     null if there is none. The provider owns the font, which lives
///                                                     as long as the provider. Equal queries return the same font.
///                                                     `script` is as in text_item, `language` as in shape_options;
///                                                     they may decide between two fonts.
template <class P, class Font>
concept fallback_provider =
    requires(P& p, text_view text, text_range grapheme, std::uint32_t script, std::string_view language) {
        { p.font_for(text, grapheme, script, language) } noexcept -> std::same_as<result<Font*>>;
    };

/// A fallback_provider that has no font.
template <class Font>
struct no_fallback {
    result<Font*> font_for(text_view, text_range, std::uint32_t, std::string_view) noexcept { return nullptr; }
};

}  // namespace typemesh::inline TYPEMESH_ABI
