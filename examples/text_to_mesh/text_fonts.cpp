// SPDX-License-Identifier: MIT
#include "text_fonts.hpp"

#include "font_file.hpp"
#include "report.hpp"

#include <utility>

namespace text_to_mesh {

#ifdef TEXT_TO_MESH_FONTCONFIG

std::string installed_fallback::open(const std::string& like)
{
    auto fonts = typemesh::fontconfig_fonts::open();
    if (!fonts) return "--family: fontconfig has no configuration.";
    fonts_.emplace(std::move(*fonts));
    found_.emplace(*fonts_, like.c_str());
    return {};
}

typemesh::result<typemesh::harfbuzz_font*> installed_fallback::font_for(typemesh::text_view text,
                                                                        typemesh::text_range grapheme,
                                                                        std::uint32_t script,
                                                                        std::string_view language) noexcept
{
    return found_ ? found_->font_for(text, grapheme, script, language) : nullptr;
}

#else

std::string installed_fallback::open(const std::string&)
{
    return "--family: this program was built without fontconfig, which finds families: give a file with --font.";
}

typemesh::result<typemesh::harfbuzz_font*> installed_fallback::font_for(typemesh::text_view, typemesh::text_range,
                                                                        std::uint32_t, std::string_view) noexcept
{
    return nullptr;
}

#endif

std::string text_fonts::open(const options& o)
{
    if (!o.svg.empty()) {  // no text: an empty font stands in
        auto none = typemesh::harfbuzz_font::wrap(hb_font_get_empty());
        if (!none) return in_words(none.error());
        opened_.push_back(std::move(*none));
        set_.emplace(opened_.back(), installed_);
        return {};
    }
    if (o.family && is_a_file(o.font)) return "--family must be an installed family, not the file " + o.font;
    if (o.family)
        if (std::string trouble = installed_.open(o.font); !trouble.empty()) return trouble;
    const auto open_one = [this](const std::string& name, const options* first) -> std::string {
        font_file found;
        if (std::string trouble = find_font(name, found); !trouble.empty()) return trouble;
        if (first != nullptr) {
            found.variations.insert(found.variations.end(), first->variations.begin(), first->variations.end());
            found.face = first->face.value_or(found.face);
        }
        auto font =
            typemesh::harfbuzz_font::open(found.path.c_str(), {.face = found.face, .variations = found.variations});
        if (!font && first != nullptr && first->face && font.error() == typemesh::error::no_such_face)
            return "--face " + std::to_string(*first->face) + ": " + found.path + " has only " +
                   std::to_string(font.error().count) + (font.error().count == 1 ? " face" : " faces") +
                   ", counted from 0.";
        if (!font) return found.path + ": " + in_words(font.error());
        opened_.push_back(std::move(*font));
        return {};
    };
    if (std::string trouble = open_one(o.font, &o); !trouble.empty()) return (o.family ? "--family: " : "") + trouble;
    set_.emplace(opened_.back(), installed_);
    for (const std::string& name : o.fallback) {
        if (std::string trouble = open_one(name, nullptr); !trouble.empty()) return "--fallback: " + trouble;
        if (const auto added = set_->add(opened_.back()); !added) return in_words(added.error());
    }
    return {};
}

}  // namespace text_to_mesh
