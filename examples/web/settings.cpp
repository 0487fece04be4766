// SPDX-License-Identifier: MIT
#include "settings.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace typemesh_web {
namespace {

using namespace text_to_mesh;
using kind = option_kind;

/// Choices stand in the order of their enumeration.
template <auto Member>
void set_choice(settings& to, double value)
{
    auto& member = to.chosen.*Member;
    member = static_cast<std::remove_reference_t<decltype(member)>>(static_cast<int>(value));
}
template <auto Struct, auto Member>
void set_inner_choice(settings& to, double value)
{
    auto& member = to.chosen.*Struct.*Member;
    member = static_cast<std::remove_reference_t<decltype(member)>>(static_cast<int>(value));
}
template <auto Member>
void set_number(settings& to, double value)
{
    auto& member = to.chosen.*Member;
    member = static_cast<std::remove_reference_t<decltype(member)>>(value);
}
template <auto Struct, auto Member>
void set_inner_number(settings& to, double value)
{
    auto& member = to.chosen.*Struct.*Member;
    member = static_cast<std::remove_reference_t<decltype(member)>>(value);
}
template <auto Member>
void set_ascii(settings& to, std::u16string_view text)
{
    std::string& member = to.chosen.*Member;
    member.clear();
    for (const char16_t unit : text) member += unit < 128 ? static_cast<char>(unit) : '?';
}

template <auto Member>
void set_bend(settings& to, double value)
{
    to.bend.*Member = value;
}

void set_quality(settings& to, double value)
{
    constexpr double tolerances[] = {typemesh::quality::high, typemesh::quality::low, typemesh::quality::normal,
                                     typemesh::quality::best};
    constexpr preset presets[] = {preset::high, preset::low, preset::normal, preset::best};
    const auto which = std::min<std::size_t>(static_cast<std::size_t>(value), 3);
    to.chosen.quality = presets[which];
    to.chosen.tolerance = tolerances[which];
}

void set_fill(settings& to, double value)
{
    to.chosen.fill = {};
    if (value > 0.0) to.chosen.fill = value > 1.0 ? typemesh::fill_rule::even_odd : typemesh::fill_rule::non_zero;
}

void set_normals(settings& to, double value)  // the best first, unlike the enumeration
{
    to.chosen.normals = static_cast<normals_name>(4 - std::min(static_cast<int>(value), 4));
}

void set_mapping(settings& to, double value)
{
    using typemesh::texture_mapping;
    to.chosen.uv = value > 1.0   ? texture_mapping::cylindrical
                   : value > 0.0 ? texture_mapping::box
                                 : texture_mapping::em;
}

void set_place(settings& to, double value)
{
    using typemesh::outline_place;
    constexpr outline_place places[] = {outline_place::inner, outline_place::outer, outline_place::centre};
    to.chosen.outline.place = places[std::min<std::size_t>(static_cast<std::size_t>(value), 2)];
}

void set_wrap(settings& to, double value)
{
    using typemesh::wrap_mode;
    constexpr wrap_mode modes[] = {wrap_mode::word_or_grapheme, wrap_mode::word, wrap_mode::grapheme, wrap_mode::none};
    to.chosen.lines.wrap = modes[std::min<std::size_t>(static_cast<std::size_t>(value), 3)];
}

using paragraph = typemesh::layout_options;

constexpr option table[] = {
    {"size", kind::number, "", "1", set_number<&options::size>},
    {"depth", kind::number, "", "0.2", set_number<&options::depth>},
    {"quality", kind::choice, "high|low|normal|best", "", set_quality},
    {"tolerance", kind::number, "", "", set_number<&options::tolerance>},
    {"discretiser", kind::choice, "certified|two_lines|adaptive", "", set_choice<&options::discretiser>},
    {"triangulator", kind::choice, "monotone|delaunay", "", set_choice<&options::triangulator>},
    {"fill", kind::choice, "font|non_zero|even_odd", "", set_fill},
    {"normals", kind::choice, "curve|creased|averaged|shared|cap", "", set_normals},
    {"crease", kind::number, "", "", [](settings& to, double n) { to.chosen.crease = static_cast<float>(n); }},
    {"uv", kind::choice, "em|box|cylindrical", "", set_mapping},
    {"bevel.width", kind::number, "", "0", set_inner_number<&options::bevel, &bevel_options::width>},
    {"bevel.depth", kind::number, "", "", [](settings& to, double n) { to.bevel_depth = static_cast<float>(n); }},
    {"bevel.profile", kind::choice, "chamfer|round|concave|stepped|engraved|points", "",
     set_inner_choice<&options::bevel, &bevel_options::profile>},
    {"bevel.points", kind::numbers, "", "",
     [](settings& to, double n) { to.profile.push_back(static_cast<float>(n)); }},
    {"bevel.steps", kind::number, "", "0", set_inner_number<&options::bevel, &bevel_options::steps>},
    {"bevel.mode", kind::choice, "clip|fit|fit_text", "", set_inner_choice<&options::bevel, &bevel_options::mode>},
    {"bevel.sides", kind::choice, "both|front|back", "", set_inner_choice<&options::bevel, &bevel_options::sides>},
    {"bevel.outward", kind::boolean, "", "0", set_inner_number<&options::bevel, &bevel_options::outward>},
    {"embolden", kind::number, "", "0", set_number<&options::embolden>},
    {"outline.width", kind::number, "", "0", set_inner_number<&options::outline, &outline_options::width>},
    {"outline.place", kind::choice, "inner|outer|centre", "", set_place},
    {"outline.letter", kind::boolean, "", "0", set_inner_number<&options::outline, &outline_options::letter>},
    {"bend.cylinder", kind::number, "", "0", set_bend<&bends::cylinder>},
    {"bend.radius", kind::number, "", "", set_bend<&bends::radius>},
    {"bend.twist", kind::number, "", "0", set_bend<&bends::twist>},
    {"bend.wave", kind::number, "", "0", set_bend<&bends::wave>},
    {"warp.arc", kind::number, "", "0", set_bend<&bends::arc>},
    {"warp.flag", kind::number, "", "0", set_bend<&bends::flag>},
    {"path.ring", kind::number, "", "0", set_bend<&bends::ring>},
    {"path.wave", kind::number, "", "0", set_bend<&bends::path_wave>},
    {"inflate.height", kind::number, "", "0", set_inner_number<&options::inflate, &inflate_options::height>},
    {"inflate.form", kind::choice, "balloon|dome", "", set_inner_choice<&options::inflate, &inflate_options::form>},
    {"tube.radius", kind::number, "", "0", set_inner_number<&options::tube, &chosen_tube::radius>},
    {"merge", kind::boolean, "", "", [](settings& to, double n) { to.merge = n != 0.0; }},
    {"width", kind::number, "", "", set_inner_number<&options::lines, &paragraph::width>},
    {"wrap", kind::choice, "word_or_grapheme|word|grapheme|none", "", set_wrap},
    {"align", kind::choice, "start|end|left|centre|right|justify", "",
     set_inner_choice<&options::lines, &paragraph::align>},
    {"justify", kind::choice, "auto|spaces|letters|kashida", "",
     set_inner_choice<&options::lines, &paragraph::justify>},
    {"breaker", kind::choice, "first_fit|total_fit", "", set_number<&options::even_lines>},
    {"anchor", kind::choice, "first_baseline|last_baseline|top|middle|bottom", "",
     set_inner_choice<&options::lines, &paragraph::anchor>},
    {"direction", kind::choice, "automatic|ltr|rtl|ttb", "", set_choice<&options::direction>},
    {"letterSpacing", kind::number, "", "", [](settings& to, double n) { to.letter_spacing = n; }},
    {"lineSpacing", kind::number, "", "1", set_inner_number<&options::lines, &paragraph::line_spacing>},
    {"indent", kind::number, "", "0", set_inner_number<&options::lines, &paragraph::indent>},
    {"maxLines", kind::number, "", "", set_inner_number<&options::lines, &paragraph::max_lines>},
    {"ellipsis", kind::string, "", "", nullptr, [](settings& to, std::u16string_view s) { to.ellipsis = s; }},
    {"features", kind::features},
    {"language", kind::string, "", "", nullptr, set_ascii<&options::language>},
    {"script", kind::string, "", "", nullptr, set_ascii<&options::script>},
    {"markup", kind::boolean, "", "0", [](settings& to, double n) { to.markup = n != 0.0; }},
    {"letters", kind::boolean, "", "0", [](settings& to, double n) { to.letters = n != 0.0; }},
    {"cached", kind::boolean, "", "1", [](settings& to, double n) { to.cached = n != 0.0; }},
};

/// The number of a choice, or -1.
int choice_of(std::string_view choices, std::string_view name)
{
    for (int number = 0;; ++number) {
        const auto end = choices.find('|');
        if (choices.substr(0, end) == name) return number;
        if (end == std::string_view::npos) return -1;
        choices.remove_prefix(end + 1);
    }
}

bool set_features(settings& to, std::string_view written)  // "smcp:1,liga:0"
{
    while (!written.empty()) {
        const auto one = written.substr(0, written.find(','));
        if (one.size() < 6 || one[4] != ':') return false;
        const char tag[5] = {one[0], one[1], one[2], one[3], '\0'};
        add_feature(to, tag, static_cast<std::uint32_t>(std::strtoul(one.data() + 5, nullptr, 10)));
        written.remove_prefix(std::min(written.size(), one.size() + 1));
    }
    return true;
}

bool set_numbers(settings& to, const option& of, std::string_view written)  // "0;0;0.2;0.8;1;1"
{
    while (!written.empty()) {
        const auto one = written.substr(0, written.find(';'));
        of.set(to, std::strtod(std::string{one}.c_str(), nullptr));
        written.remove_prefix(std::min(written.size(), one.size() + 1));
    }
    return true;
}

}  // namespace

std::span<const option> all_options() { return table; }

void add_feature(settings& to, const char (&tag)[5], std::uint32_t value)
{
    typemesh::feature f{{}, value};
    std::copy_n(tag, 5, f.tag);
    to.chosen.features.push_back(f);
}

bool set_by_name(settings& to, std::string_view written)
{
    const auto equals = written.find('=');
    if (equals == std::string_view::npos) return false;
    const std::string_view name = written.substr(0, equals), value = written.substr(equals + 1);
    const auto* found =
        std::find_if(std::begin(table), std::end(table), [&](const option& o) { return name == o.name; });
    if (found == std::end(table)) return false;
    switch (found->kind) {
    case kind::features: return set_features(to, value);
    case kind::numbers: return set_numbers(to, *found, value);
    case kind::string: return found->set_text(to, std::u16string(value.begin(), value.end())), true;
    case kind::choice: {
        const int choice = choice_of(found->choices, value);
        if (choice >= 0) found->set(to, choice);
        return choice >= 0;
    }
    case kind::boolean: return found->set(to, value == "true" || value == "1" ? 1.0 : 0.0), true;
    case kind::number: break;
    }
    return found->set(to, std::strtod(std::string{value}.c_str(), nullptr)), true;
}

options settings::settled() const
{
    options o = chosen;
    if (o.depth == 0.0f) o.bevel.width = 0.0f;  // what is flat has no edges to bevel
    for (std::size_t i = 0; i < profile.size(); i += 2)
        o.bevel.points.add(
            {profile[i], i + 1 < profile.size() ? profile[i + 1] : -1.0f});  // an odd number is no profile
    o.path.curve = bend.path();
    o.bevel.depth = bevel_depth.value_or(o.bevel.width);
    using typemesh::outline_place;
    const double width = static_cast<double>(o.outline.width), bolder = static_cast<double>(o.embolden);
    const double around = o.outline.place == outline_place::outer    ? width
                          : o.outline.place == outline_place::centre ? 0.5 * width
                                                                     : 0.0;
    const double wider = 2.0 * (bolder + around + static_cast<double>(o.tube.radius));
    o.letter_spacing = letter_spacing.value_or(wider);
    o.columns.combined_gap = wider;
    const bool edges_move = o.bevel.width > 0.0f || o.outline.width > 0.0f || o.embolden != 0.0f;
    o.keeps_apart = merge == false;
    o.merge = merge.value_or(edges_move || o.inflate.height > 0.0f || o.tube.radius > 0.0f);
    return o;
}

const char* settings::refused() const noexcept
{
    if (const char* why = bend.refused()) return why;
    const bool has_bevels = chosen.bevel.width > 0.0f && chosen.depth > 0.0f, has_ring = chosen.outline.width > 0.0f;
    if (bend.in_space() && has_ring) return "Hollow letters cannot be bent: leave out outline or bend.";
    const bool has_air = chosen.inflate.height > 0.0f;
    if (chosen.tube.radius > 0.0f) {
        if (bend.in_space()) return "Tubes cannot be bent: leave out tube or bend.";
        if (has_bevels) return "Tubes have no bevels: leave out tube or bevel.";
        if (has_ring) return "Tubes cannot be hollow: leave out tube or outline.";
        if (has_air) return "Tubes cannot be inflated: leave out tube or inflate.";
    }
    if (!has_air) return nullptr;
    if (bend.in_space()) return "Inflated letters cannot be bent: leave out inflate or bend.";
    if (has_bevels) return "Inflated letters have no bevels: leave out inflate or bevel.";
    if (has_ring) return "Inflated letters cannot be hollow: leave out inflate or outline.";
    if (chosen.inflate.form == typemesh::inflated_form::dome && chosen.depth == 0.0f)
        return "A dome stands on walls: give it a depth.";
    return nullptr;
}

}  // namespace typemesh_web
