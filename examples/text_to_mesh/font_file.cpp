// SPDX-License-Identifier: MIT
#include "font_file.hpp"

#include "option_values.hpp"

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

/// What the asked name's words after its colons get wrong: "DejaVu Sans:bold:slant=0". fontconfig passes over those
/// that it does not know. Gives an empty string, or one sentence.
std::string unknown_words(const std::string& name)
{
    std::string_view left{name};
    while (true) {
        std::size_t colon = left.find(':');
        while (colon != std::string_view::npos && colon > 0 && left[colon - 1] == '\\')
            colon = left.find(':', colon + 1);
        if (colon == std::string_view::npos) return {};
        left.remove_prefix(colon + 1);
        const std::string word{left.substr(0, left.find(':'))};
        const auto known = [](const std::string& w) {
            return FcNameGetConstant(reinterpret_cast<const FcChar8*>(w.c_str())) != nullptr;
        };
        const auto equals = word.find('=');
        if (equals == std::string::npos) {
            if (!known(word))
                return name + ": fontconfig knows no style \"" + word + "\"; bold, italic or light are such.";
            continue;
        }
        const std::string key = word.substr(0, equals), value = word.substr(equals + 1);
        const FcObjectType* const type = FcNameGetObjectType(key.c_str());
        if (type == nullptr || type->type == FcTypeUnknown)
            return name + ": fontconfig knows no \"" + key + "\"; --variation sets the axes of a variable font.";
        if ((type->type == FcTypeInteger || type->type == FcTypeDouble || type->type == FcTypeRange) && !known(value) &&
            !decimal(value))
            return name + ": fontconfig knows no " + key + " \"" + value + "\".";
    }
}

std::string find_family(const std::string& name, font_file& out)
{
    if (std::string trouble = unknown_words(name); !trouble.empty()) return trouble;
    const auto fonts = typemesh::fontconfig_fonts::open();
    if (!fonts) return name + " cannot be looked for: fontconfig finds no configuration.";
    typemesh::installed_font found;
    const typemesh::error e = fonts->find(name.c_str(), found);
    if (e == typemesh::error::no_such_style)
        return name + ": no installed font of this family has that " + e.option + "; `fc-list \"" +
               name.substr(0, name.find(':')) + "\" style` lists the styles.";
    if (e) return name + " is neither a file nor an installed family; `fc-list : family` lists those.";
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
           " is no file, and this program was built without fontconfig, which finds families: "
           "`fc-match --format '%{file}' \"" +
           name + "\"` may tell the file.";
}

#endif

}  // namespace

std::string find_font(const std::string& name, font_file& out)
{
    out.path = name;
    return is_a_file(name) ? std::string{} : find_family(name, out);
}

}  // namespace text_to_mesh
