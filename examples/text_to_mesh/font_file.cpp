// SPDX-License-Identifier: MIT
#include "font_file.hpp"

#include "option_values.hpp"

#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>

#ifdef TEXT_TO_MESH_FONTCONFIG
#include <fontconfig/fontconfig.h>
#include <hb-ot.h>

#include <memory>
#endif

namespace text_to_mesh {
namespace {

bool looks_like_a_file(const std::string& name)
{
    std::error_code ignored;
    if (std::filesystem::exists(name, ignored)) return true;
    if (name.find_first_of("/\\") != std::string::npos) return true;
    const std::string_view end{name.size() > 4 ? std::string_view{name}.substr(name.size() - 4) : ""};
    for (const std::string_view known : {".ttf", ".otf", ".ttc", ".otc", ".TTF", ".OTF", ".TTC", ".OTC"})
        if (end == known) return true;
    return false;
}

#ifdef TEXT_TO_MESH_FONTCONFIG

using pattern = std::unique_ptr<FcPattern, void (*)(FcPattern*)>;

std::string word(const FcPattern* of, const char* object, int n = 0)
{
    FcChar8* found = nullptr;
    if (FcPatternGetString(of, object, n, &found) != FcResultMatch) return {};
    return reinterpret_cast<const char*>(found);
}

/// True where one of the match's families is the one asked for; fontconfig always finds something.
bool has_family(const FcPattern* match, const std::string& family)
{
    for (int n = 0;; ++n) {
        const std::string own = word(match, FC_FAMILY, n);
        if (own.empty()) return false;
        if (FcStrCmpIgnoreCase(reinterpret_cast<const FcChar8*>(own.c_str()),
                               reinterpret_cast<const FcChar8*>(family.c_str())) == 0)
            return true;
    }
}

/// "wght=700,wdth=75", and what the named instance behind a face's number adds.
void add_variations(const FcPattern* match, font_file& out)
{
    std::string written = word(match, FC_FONT_VARIATIONS);
    while (!written.empty()) {
        const auto comma = written.find(',');
        if (const auto v = read_variation(written.substr(0, comma))) out.variations.push_back(*v);
        written.erase(0, comma == std::string::npos ? comma : comma + 1);
    }
}

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

/// The style that was asked for and is not the match's: fontconfig gives the nearest that there is. Else nothing.
std::string style_not_found(const FcPattern* asked, const FcPattern* match)
{
    const std::string style = word(asked, FC_STYLE);
    bool has_style = style.empty();
    for (int n = 0; !has_style; ++n) {
        const std::string own = word(match, FC_STYLE, n);
        if (own.empty()) return style;
        has_style = FcStrCmpIgnoreCase(reinterpret_cast<const FcChar8*>(own.c_str()),
                                       reinterpret_cast<const FcChar8*>(style.c_str())) == 0;
    }
    for (const char* what : {FC_WEIGHT, FC_WIDTH, FC_SLANT}) {
        double wanted = 0.0, found = 0.0;
        if (FcPatternGetDouble(asked, what, 0, &wanted) != FcResultMatch ||
            FcPatternGetDouble(match, what, 0, &found) != FcResultMatch)
            continue;
        const bool slant = std::string_view{what} == FC_SLANT;  // oblique is as good as italic
        const bool same = slant ? (wanted > 0.0) == (found > 0.0) : std::abs(wanted - found) <= 5.0;  // book is regular
        if (!same) return what;
    }
    return {};
}

std::string find_family(const std::string& name, font_file& out)
{
    if (std::string trouble = unknown_words(name); !trouble.empty()) return trouble;
    const pattern asked{FcNameParse(reinterpret_cast<const FcChar8*>(name.c_str())), FcPatternDestroy};
    const std::string family = asked ? word(asked.get(), FC_FAMILY) : std::string{};
    const std::string nobody = name + " is neither a file nor an installed family; `fc-list : family` lists those.";
    if (family.empty()) return nobody;
    const pattern words{FcPatternDuplicate(asked.get()), FcPatternDestroy};
    FcPatternAddBool(asked.get(), FC_SCALABLE, FcTrue);
    FcConfigSubstitute(nullptr, asked.get(), FcMatchPattern);
    FcDefaultSubstitute(asked.get());
    FcResult result = FcResultNoMatch;
    const pattern match{FcFontMatch(nullptr, asked.get(), &result), FcPatternDestroy};
    if (!match || !has_family(match.get(), family)) return nobody;
    if (const std::string lacks = style_not_found(words.get(), match.get()); !lacks.empty())
        return name + ": no installed font of this family has that " +
               (lacks == FC_WEIGHT || lacks == FC_WIDTH || lacks == FC_SLANT ? lacks : "style") + "; `fc-list \"" +
               family + "\" style` lists the styles.";
    out.path = word(match.get(), FC_FILE);
    int index = 0;
    FcPatternGetInteger(match.get(), FC_INDEX, 0, &index);
    out.face = static_cast<unsigned>(index) & 0xFFFFu;
    add_variations(match.get(), out);
    const unsigned instance = static_cast<unsigned>(index) >> 16;
    if (out.variations.empty() && instance != 0 && instance != 0x8000u) add_named_instance(instance, out);
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
    return looks_like_a_file(name) ? std::string{} : find_family(name, out);
}

}  // namespace text_to_mesh
