// SPDX-License-Identifier: MIT
#include "svg_style.hpp"

#include "svg_values.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace text_to_mesh {
namespace {

constexpr std::string_view properties[] = {"clip-path",
                                           "clip-rule",
                                           "color",
                                           "display",
                                           "fill",
                                           "fill-opacity",
                                           "fill-rule",
                                           "filter",
                                           "marker",
                                           "marker-end",
                                           "marker-mid",
                                           "marker-start",
                                           "mask",
                                           "mix-blend-mode",
                                           "opacity",
                                           "overflow",
                                           "paint-order",
                                           "stop-color",
                                           "stop-opacity",
                                           "stroke",
                                           "stroke-dasharray",
                                           "stroke-dashoffset",
                                           "stroke-linecap",
                                           "stroke-linejoin",
                                           "stroke-miterlimit",
                                           "stroke-opacity",
                                           "stroke-width",
                                           "transform-origin",
                                           "vector-effect",
                                           "visibility"};

std::string without_comments(std::string_view css)
{
    std::string made;
    for (;;) {
        const auto begin = css.find("/*");
        made += css.substr(0, begin);
        if (begin == std::string_view::npos) return made;
        const auto end = css.find("*/", begin + 2);
        if (end == std::string_view::npos) return made;
        css.remove_prefix(end + 2);
    }
}

bool is_name_character(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

/// Calls each(name) for the names of a list of classes, until it returns true. Whether it did.
template <class Each>
bool any_class(std::string_view classes, const Each& each)
{
    for (classes = trimmed(classes); !classes.empty(); classes = trimmed(classes)) {
        const auto end = std::min(classes.find_first_of(" \t\r\n\f"), classes.size());
        if (each(classes.substr(0, end))) return true;
        classes.remove_prefix(end);
    }
    return false;
}

void set_opacity(double& out, std::string_view text, double factor = 1.0)
{
    if (const auto value = read_length(text, 1.0)) out = factor * std::clamp(*value, 0.0, 1.0);
}

void set_rule(typemesh::fill_rule& out, std::string_view text)
{
    if (text == "nonzero") out = typemesh::fill_rule::non_zero;
    if (text == "evenodd") out = typemesh::fill_rule::even_odd;
}

/// A paint that is no reference.
void set_plain_paint(svg_paint& out, std::string_view text)
{
    if (text == "none") {
        out = {.is_none = true};
    } else if (lower(text) == "currentcolor" || text == "context-fill" || text == "context-stroke") {
        out = {.is_current = true};
    } else if (const auto colour = read_svg_colour(text)) {
        out = {.colour = *colour};
    }
}

/// A paint, or a reference with one paint behind it that stands in for it.
void set_paint(svg_paint& out, std::string_view text)
{
    if (!text.starts_with("url(")) return set_plain_paint(out, text);
    const auto end = text.find(')');
    out = {.is_none = true};
    if (end != std::string_view::npos) set_plain_paint(out, trimmed(text.substr(end + 1)));
    out.reference = name_of_reference(text);
}

void set_dashes(std::vector<double>& out, std::string_view text, double diagonal)
{
    if (text == "none") return out.clear();
    std::vector<double> made;
    while (!text.empty()) {
        const auto end = std::min(text.find_first_of(", \t\r\n"), text.size());
        const auto length = read_length(text.substr(0, end), diagonal);
        if (!length || *length < 0.0) return;
        made.push_back(*length);
        text.remove_prefix(end);
        while (!text.empty() && (text.front() == ',' || trimmed(text.substr(0, 1)).empty())) text.remove_prefix(1);
    }
    out = made;
}

}  // namespace

std::string_view value_of(const svg_properties& all, std::string_view name)
{
    for (auto at = all.rbegin(); at != all.rend(); ++at)
        if (at->first == name) return at->second;
    return {};
}

void read_declarations(std::string_view text, svg_properties& out)
{
    svg_properties important;
    while (!text.empty()) {
        const auto end = std::min(text.find(';'), text.size());
        const std::string_view one = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const auto colon = one.find(':');
        if (colon == std::string_view::npos) continue;
        std::string_view value = trimmed(one.substr(colon + 1));
        const auto mark = value.find('!');
        svg_properties& to = mark == std::string_view::npos ? out : important;
        to.emplace_back(lower(trimmed(one.substr(0, colon))), trimmed(value.substr(0, mark)));
    }
    out.insert(out.end(), important.begin(), important.end());
}

bool is_property(std::string_view name)
{
    return std::binary_search(std::begin(properties), std::end(properties), name);
}

bool svg_stylesheet::read_selector(std::string_view text, rule& out)
{
    text = trimmed(text);
    if (text.empty()) return false;
    if (text.front() == '*') text.remove_prefix(1);
    while (!text.empty()) {
        const char kind = text.front() == '.' || text.front() == '#' ? text.front() : ' ';
        if (kind != ' ') text.remove_prefix(1);
        std::size_t length = 0;
        while (length < text.size() && is_name_character(text[length])) ++length;
        if (length == 0) return false;
        const std::string name{text.substr(0, length)};
        text.remove_prefix(length);
        if (kind == '.') out.classes.push_back(name);
        if (kind == '#') out.id = name;
        if (kind == ' ') out.name = name;
        out.specificity += kind == '#' ? 10000u : kind == '.' ? 100u : 1u;
    }
    return true;
}

bool svg_stylesheet::read(std::string_view css)
{
    const std::string clean = without_comments(css);
    std::string_view text = trimmed(clean);
    bool all_read = true;
    while (!text.empty()) {
        if (text.front() == '@') {  // to the end of its block, or of its statement
            all_read = false;
            const auto stop = std::min(text.find_first_of("{;"), text.size());
            std::size_t end = stop + 1;
            if (stop < text.size() && text[stop] == '{') {
                std::size_t depth = 1;
                for (; end < text.size() && depth > 0; ++end)
                    depth = text[end] == '{' ? depth + 1 : text[end] == '}' ? depth - 1 : depth;
            }
            text = trimmed(text.substr(std::min(end, text.size())));
            continue;
        }
        const auto open = text.find('{');
        if (open == std::string_view::npos) return false;
        const auto close = std::min(text.find('}', open), text.size());
        std::string_view selectors = text.substr(0, open);
        declarations& block = blocks_.emplace_back();
        block.bytes = close - open;
        read_declarations(text.substr(open + 1, close - open - 1), block.all);
        while (!selectors.empty() && rules_.size() <= max_rules) {
            const auto comma = std::min(selectors.find(','), selectors.size());
            rule made;
            if (read_selector(selectors.substr(0, comma), made)) {
                made.block = blocks_.size() - 1;
                rules_.push_back(std::move(made));
            } else {
                all_read = false;
            }
            selectors.remove_prefix(std::min(comma + 1, selectors.size()));
        }
        text = trimmed(text.substr(std::min(close + 1, text.size())));
    }
    return all_read;
}

bool svg_stylesheet::finish()
{
    if (rules_.size() > max_rules) return false;
    std::stable_sort(rules_.begin(), rules_.end(),
                     [](const rule& a, const rule& b) { return a.specificity < b.specificity; });
    std::map<std::string_view, std::size_t> uses;  // of classes, in rules
    for (const rule& r : rules_)
        for (const std::string& one : r.classes) ++uses[one];
    std::uint32_t number = 0;
    for (const rule& r : rules_) {
        const auto rarest =
            std::min_element(r.classes.begin(), r.classes.end(),
                             [&](const std::string& a, const std::string& b) { return uses[a] < uses[b]; });
        std::vector<std::uint32_t>& named = !r.id.empty()        ? by_id_[r.id]
                                            : !r.classes.empty() ? by_class_[*rarest]
                                                                 : by_name_[r.name];
        named.push_back(number++);
    }
    return true;
}

bool svg_stylesheet::fits(const rule& r, const svg_identity& of)
{
    if (!r.name.empty() && r.name != of.name) return false;
    if (!r.id.empty() && r.id != of.id) return false;
    return std::all_of(r.classes.begin(), r.classes.end(), [&](const std::string& name) {
        return any_class(of.classes, [&](std::string_view own) { return own == name; });
    });
}

void svg_stylesheet::add(const svg_identity& of, svg_properties& out,
                         const std::function<bool(std::size_t)>& spend) const
{
    if (rules_.empty()) return;
    std::vector<std::uint32_t> candidates;
    bool goes_on = spend(of.classes.size());
    const auto take = [&](const rule_index& from, std::string_view name) {
        const auto found = from.find(name);
        if (found == from.end() || !goes_on) return;
        goes_on = spend(8 * found->second.size());
        candidates.insert(candidates.end(), found->second.begin(), found->second.end());
    };
    if (!of.id.empty()) take(by_id_, of.id);
    any_class(of.classes, [&](std::string_view name) { return take(by_class_, name), !goes_on; });
    take(by_name_, of.name);
    if (!of.name.empty()) take(by_name_, "");
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    for (const std::uint32_t number : candidates) {
        const rule& r = rules_[number];
        if (!goes_on || !spend(r.classes.size() * (1 + of.classes.size()))) return;
        if (!fits(r, of)) continue;
        const declarations& block = blocks_[r.block];
        if (!spend(block.bytes)) return;
        out.insert(out.end(), block.all.begin(), block.all.end());
    }
}

void svg_look::apply(const svg_properties& all, double diagonal)
{
    using namespace typemesh;
    const double around = opacity;
    for (const auto& [name, written] : all) {
        const std::string_view value = written;
        if (value == "inherit") continue;
        if (name == "color") {
            if (const auto read = read_svg_colour(value)) colour = *read;
        } else if (name == "fill") {
            set_paint(fill, value);
        } else if (name == "stroke") {
            set_paint(stroke, value);
        } else if (name == "fill-rule") {
            set_rule(rule, value);
        } else if (name == "clip-rule") {
            set_rule(clip_rule, value);
        } else if (name == "fill-opacity") {
            set_opacity(fill_opacity, value);
        } else if (name == "stroke-opacity") {
            set_opacity(stroke_opacity, value);
        } else if (name == "opacity") {
            set_opacity(opacity, value, around);
        } else if (name == "stroke-width") {
            if (const auto length = read_length(value, diagonal); length && *length >= 0.0) width = *length;
        } else if (name == "stroke-miterlimit") {
            if (const auto limit = read_length(value, 1.0); limit && *limit >= 1.0) mitre_limit = *limit;
        } else if (name == "stroke-dashoffset") {
            if (const auto length = read_length(value, diagonal)) dash_offset = *length;
        } else if (name == "stroke-dasharray") {
            set_dashes(dashes, value, diagonal);
        } else if (name == "stroke-linecap") {
            cap = value == "round" ? stroke_cap::round : value == "square" ? stroke_cap::square : stroke_cap::butt;
        } else if (name == "stroke-linejoin") {
            join = value == "round" ? stroke_join::round : value == "bevel" ? stroke_join::bevel : stroke_join::mitre;
        } else if (name == "visibility") {
            is_visible = value == "visible";
        } else if (name == "paint-order") {
            const auto at = value.find("stroke"), fills = value.find("fill");
            stroke_is_below = at != std::string_view::npos && at < fills;
        }
    }
}

}  // namespace text_to_mesh
