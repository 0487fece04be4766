// SPDX-License-Identifier: MIT
#pragma once

#include "../model.hpp"

#include <typemesh/core/fill_rule.hpp>
#include <typemesh/outline/stroke_style.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace text_to_mesh {

/// Properties and their values, as they are written; of equal ones the last one counts.
using svg_properties = std::vector<std::pair<std::string, std::string>>;

/// The value of a property; empty if it is not there.
[[nodiscard]] std::string_view value_of(const svg_properties& all, std::string_view name);

/// Adds "fill: red; stroke: none", with important ones behind the others.
void read_declarations(std::string_view text, svg_properties& out);

/// Whether an attribute of that name is a property, too: "fill", "stroke-width", ...
[[nodiscard]] bool is_property(std::string_view name);

/// What selectors ask for of an element.
struct svg_identity {
    std::string_view name, id, classes;
};

/// The rules of <style>. Selectors are names, .classes and #ids, also several together: "path.dark#a, .b".
class svg_stylesheet {
public:
    /// Reads the contents of one element. False if it has rules or selectors of other kinds, which are left out.
    bool read(std::string_view css);

    /// Sorts the rules by their specificity, after all of them are read. False if there are more than 100,000.
    [[nodiscard]] bool finish();

    /// Adds what the rules say of an element, by specificity. Only rules that name its id, one of its classes or its
    /// name are compared, and those that name nothing. Stops when `spend`, which gets the work, about a byte each,
    /// refuses.
    void add(const svg_identity& of, svg_properties& out, const std::function<bool(std::size_t)>& spend) const;

private:
    struct rule {
        std::string name, id;
        std::vector<std::string> classes;
        unsigned specificity = 0;
        std::size_t block = 0;  ///< its declarations, which several selectors share
    };
    [[nodiscard]] static bool read_selector(std::string_view text, rule& out);
    [[nodiscard]] static bool fits(const rule& r, const svg_identity& of);

    /// The numbers of the rules that name something, in ascending order.
    using rule_index = std::map<std::string, std::vector<std::uint32_t>, std::less<>>;

    static constexpr std::size_t max_rules = 100'000;

    std::vector<rule> rules_;  // by specificity, then as they are written
    struct declarations {
        svg_properties all;
        std::size_t bytes = 0;
    };
    std::vector<declarations> blocks_;
    rule_index by_id_, by_class_, by_name_;  // each rule once; rules for any element have the empty name
};

/// What a shape is filled or stroked with.
struct svg_paint {
    bool is_none = false;
    bool is_current = false;  ///< the colour of the property `color`
    rgb_colour colour{{0, 0, 0}};
    std::string reference = {};  ///< the id of a gradient or pattern; `colour` or `is_none` stands in for it
};

/// How a shape looks: what elements inherit, in user units.
struct svg_look {
    rgb_colour colour{{0, 0, 0}};
    svg_paint fill, stroke{.is_none = true};
    typemesh::fill_rule rule = typemesh::fill_rule::non_zero, clip_rule = typemesh::fill_rule::non_zero;
    double fill_opacity = 1.0, stroke_opacity = 1.0;
    double opacity = 1.0;  ///< of all elements around it, multiplied
    double width = 1.0, mitre_limit = 4.0, dash_offset = 0.0;
    typemesh::stroke_cap cap = typemesh::stroke_cap::butt;
    typemesh::stroke_join join = typemesh::stroke_join::mitre;
    std::vector<double> dashes;
    bool is_visible = true;
    bool stroke_is_below = false;

    /// Applies properties; values that are malformed change nothing. Percentages of strokes are of `diagonal`.
    void apply(const svg_properties& all, double diagonal);
};

}  // namespace text_to_mesh
