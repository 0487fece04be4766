// SPDX-License-Identifier: MIT
#pragma once

#include "options.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/text/font_list.hpp>
#ifdef TEXT_TO_MESH_FONTCONFIG
#include <typemesh/adapt/fontconfig_fallback.hpp>
#endif

#include <list>
#include <optional>
#include <string>

namespace text_to_mesh {

/// Finds installed fonts, if it is to and fontconfig is there.
class installed_fallback {
public:
    using font_type = typemesh::harfbuzz_font;

    /// From now on; `like` is a family's name. Gives an empty string, or one sentence.
    [[nodiscard]] std::string open(const std::string& like);

    typemesh::result<font_type*> font_for(typemesh::text_view text, typemesh::text_range grapheme, std::uint32_t script,
                                          std::string_view language) noexcept;

private:
#ifdef TEXT_TO_MESH_FONTCONFIG
    std::optional<typemesh::fontconfig_fonts> fonts_;
    std::optional<typemesh::fontconfig_fallback<font_type>> found_;
#endif
};

using font_set = typemesh::font_list<typemesh::harfbuzz_font, installed_fallback>;

/// The fonts that a text is set in: the font of --font or --family, the fonts of --fallback and, with --family, whatever else
/// is installed.
class text_fonts {
public:
    /// Gives an empty string, or one sentence. Called once.
    [[nodiscard]] std::string open(const options& o);
    /// Needs open().
    [[nodiscard]] font_set& set() { return *set_; }

private:
    std::list<typemesh::harfbuzz_font> opened_;
    installed_fallback installed_;
    std::optional<font_set> set_;
};

}  // namespace text_to_mesh
