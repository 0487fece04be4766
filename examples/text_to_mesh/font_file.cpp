// SPDX-License-Identifier: MIT
#include "font_file.hpp"

#include "option_values.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>
#include <system_error>

#ifdef TEXT_TO_MESH_FONTCONFIG
#include <typemesh/adapt/fontconfig.hpp>

#include <hb-ot.h>
#endif

namespace text_to_mesh {

bool is_a_file(const std::string& name)
{
    std::error_code ignored;
    if (std::filesystem::exists(name, ignored)) return true;
    if (name.find_first_of("/\\") != std::string::npos) return true;
    const std::string_view end{name.size() > 4 ? std::string_view{name}.substr(name.size() - 4) : ""};
    for (const std::string_view known : {".ttf", ".otf", ".ttc", ".otc", ".TTF", ".OTF", ".TTC", ".OTC"})
        if (end == known) return true;
    return false;
}

namespace {

#ifdef TEXT_TO_MESH_FONTCONFIG

void add_named_instance(unsigned number, font_file& out)
{
    hb_blob_t* blob = hb_blob_create_from_file(out.path.c_str());
    hb_face_t* face = hb_face_create(blob, out.face);
    std::vector<hb_ot_var_axis_info_t> axes(hb_ot_var_get_axis_count(face));
    unsigned count = static_cast<unsigned>(axes.size());
    hb_ot_var_get_axis_infos(face, 0, &count, axes.data());
    std::vector<float> places(axes.size());
    count = static_cast<unsigned>(places.size());
    hb_ot_var_named_instance_get_design_coords(face, number - 1, &count, places.data());
    for (std::size_t i = 0; i < axes.size() && i < count; ++i) {
        typemesh::variation v;
        hb_tag_to_string(axes[i].tag, v.tag);
        v.value = places[i];
        out.variations.push_back(v);
    }
    hb_face_destroy(face);
    hb_blob_destroy(blob);
}

bool is_constant(const std::string& word)
{
    return FcNameGetConstant(reinterpret_cast<const FcChar8*>(word.c_str())) != nullptr;
}

/// "Bold Oblique" as fontconfig writes it, "bold:oblique"; of words that are not all fontconfig's, as a style's name:
/// "style=Semi Condensed".
std::string style_words(const std::string& style)
{
    std::string words;
    for (std::string_view rest = style; !rest.empty();) {
        const std::string word{rest.substr(0, rest.find(' '))};
        rest.remove_prefix(std::min(rest.size(), word.size() + 1));
        if (word.empty()) continue;
        if (!is_constant(word)) return "style=" + style;
        words += (words.empty() ? "" : ":") + word;
    }
    return words;
}

/// What one word after a name's colons gets wrong: fontconfig passes over those that it does not know. Gives an empty
/// string, or one sentence; `word` may become what fontconfig takes.
std::string refused_word(const std::string& name, std::string& word)
{
    const auto equals = word.find('=');
    if (equals == std::string::npos) {
        if (!is_constant(word) && word.find(' ') == std::string::npos)
            return name + ": fontconfig has no style \"" + word + "\": use for example bold, italic or light.";
        word = style_words(word);
        return {};
    }
    const std::string key = word.substr(0, equals), value = word.substr(equals + 1);
    const FcObjectType* const type = FcNameGetObjectType(key.c_str());
    if (type == nullptr || type->type == FcTypeUnknown)
        return name + ": fontconfig has no property \"" + key + "\": set the axes of a variable font with --variation.";
    if ((type->type == FcTypeInteger || type->type == FcTypeDouble || type->type == FcTypeRange) &&
        !is_constant(value) && !decimal(value))
        return name + ": fontconfig has no " + key + " \"" + value + "\": use one of its names or a number.";
    return {};
}

/// Writes a name as fontconfig takes it. Gives an empty string, or one sentence.
std::string read_name(const std::string& name, std::string& out)
{
    const auto colon_of = [](std::string_view in) {
        std::size_t colon = in.find(':');
        while (colon != std::string_view::npos && colon > 0 && in[colon - 1] == '\\') colon = in.find(':', colon + 1);
        return colon;
    };
    std::string_view left{name};
    std::size_t colon = colon_of(left);
    out = left.substr(0, colon);
    while (colon != std::string_view::npos) {
        left.remove_prefix(colon + 1);
        colon = colon_of(left);
        std::string word{left.substr(0, colon)};
        if (std::string trouble = refused_word(name, word); !trouble.empty()) return trouble;
        out += ":" + word;
    }
    return {};
}

std::string find_family(const std::string& name, font_file& out)
{
    std::string words;
    if (std::string trouble = read_name(name, words); !trouble.empty()) return trouble;
    const auto fonts = typemesh::fontconfig_fonts::open();
    if (!fonts) return name + " cannot be found: fontconfig has no configuration.";
    typemesh::installed_font found;
    const auto match = fonts->find(words.c_str(), found, typemesh::family_names::aliases);
    if (match == typemesh::error::no_such_style)
        return name + ": no installed font of this family has that " + match.error().option +
               ": list its styles with `fc-list \"" + name.substr(0, name.find(':')) + "\" style`.";
    if (!match) return name + " is neither a file nor an installed family: list the families with `fc-list : family`.";
    out.path = found.path();
    const typemesh::font_options options = found.options();
    out.face = options.face;
    out.variations.assign(options.variations.begin(), options.variations.end());
    if (found.named_instance() != 0) add_named_instance(found.named_instance(), out);
    return {};
}

#else

std::string find_family(const std::string& name, font_file&)
{
    return name +
           " is not a file, and this program was built without fontconfig, which finds families: find the file with "
           "`fc-match --format '%{file}' \"" +
           name + "\"`.";
}

#endif

}  // namespace

std::string find_font(const std::string& name, font_file& out)
{
    out.path = name;
    return is_a_file(name) ? std::string{} : find_family(name, out);
}

}  // namespace text_to_mesh
