// SPDX-License-Identifier: MIT
#include "svg_drawing.hpp"

#ifdef TEXT_TO_MESH_PUGIXML

#include "svg_pen.hpp"
#include "svg_shapes.hpp"
#include "svg_style.hpp"
#include "svg_values.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace text_to_mesh {
namespace {

using typemesh::affine;
using typemesh::box;
using typemesh::point;

constexpr std::size_t max_elements = 200'000, max_depth = 200;

/// The name of an element without a prefix of SVG's; empty for elements of other languages.
std::string_view name_of(const pugi::xml_node& node)
{
    const std::string_view name = node.name();
    const auto colon = name.find(':');
    if (colon == std::string_view::npos) return name;
    return name.substr(0, colon) == "svg" ? name.substr(colon + 1) : std::string_view{};
}

std::string_view href_of(const pugi::xml_node& node)
{
    const pugi::xml_attribute plain = node.attribute("href");
    return plain ? plain.value() : node.attribute("xlink:href").value();
}

double diagonal_of(const box& port) { return std::hypot(port.width(), port.height()) / std::sqrt(2.0); }

/// What elements inherit.
struct surroundings {
    svg_look look;
    affine map;  ///< of user units to the drawing's
    box port;    ///< in user units; percentages are of it
    std::size_t clip = svg_drawing::no_clip;
    std::size_t depth = 0;
};

class reader {
public:
    reader(const pugi::xml_document& file, const svg_options& how, svg_drawing& out)
        : file_{file}, how_{how}, out_{out}, pen_{out, how.tolerance, how.max_curves}
    {
    }

    /// Gives an empty string, or the end of a sentence.
    std::string read()
    {
        const pugi::xml_node root = file_.document_element();
        if (name_of(root) != "svg") return " is not an SVG file: its root is <" + std::string{root.name()} + ">.";
        collect(root);
        if (!sheet_.finish()) return " has more than 100000 style rules, which is too much.";
        box view = view_of(root);
        const bool measured = view.empty();
        for (const bool first : {true, false}) {
            if (first && !measured) continue;
            surroundings around;
            around.look.colour = how_.colour;
            around.port = view.empty() ? box{{0.0, 0.0}, {300.0, 150.0}} : view;
            const double larger = std::max(around.port.width(), around.port.height());
            const double scale = first ? 1.0 : svg_drawing::units_per_em / larger;
            around.map = {
                .xx = scale, .dx = -scale * around.port.low.x, .yy = -scale, .dy = scale * around.port.high.y};
            clear();
            element(root, around);
            if (!trouble_.empty()) return trouble_;
            if (measured && first) {
                for (const svg_drawing::item& i : out_.items) out_.view.merge(out_.shapes[i.shape].bounds);
                if (out_.view.empty() || !(out_.view.width() + out_.view.height() > 0.0)) return {};
                view = {{out_.view.low.x, 150.0 - out_.view.high.y}, {out_.view.high.x, 150.0 - out_.view.low.y}};
            } else if (!measured) {
                out_.view = {{0.0, 0.0}, {scale * view.width(), scale * view.height()}};
            }
        }
        return {};
    }

private:
    /// The part of the plane that a file shows; empty if it does not say so.
    static box view_of(const pugi::xml_node& root)
    {
        const auto view = read_view_box(root.attribute("viewBox").value());
        const auto side = [&](const char* name) {
            const std::string_view text = root.attribute(name).value();
            return text.empty() || text.ends_with('%') ? std::nullopt : read_length(text, 0.0);
        };
        const auto width = side("width"), height = side("height");
        if (width && height && *width > 0.0 && *height > 0.0) return {{0.0, 0.0}, {*width, *height}};
        return view ? box{{0.0, 0.0}, view->high - view->low} : box{};
    }

    void clear()
    {
        out_.shapes.clear();
        out_.clips.clear();
        out_.items.clear();
        out_.view = {};
        elements_ = steps_ = 0;
        pen_.clear();
    }

    /// Counts work, which <use> can multiply. False if it is too much.
    bool spend(std::size_t steps)
    {
        steps_ += steps;
        if (steps_ > how_.max_steps && trouble_.empty())
            trouble_ = " repeats its elements or its style rules so often that it takes too long to draw.";
        return trouble_.empty();
    }

    void warn(const std::string& what)
    {
        if (warned_.insert(what).second) out_.warnings.push_back(what);
    }

    /// Finds ids and style sheets.
    void collect(const pugi::xml_node& root)
    {
        for (pugi::xml_node node = root; node;) {
            if (const pugi::xml_attribute id = node.attribute("id")) ids_.emplace(id.value(), node);
            if (name_of(node) == "style") {
                std::string css;
                for (const pugi::xml_node& text : node.children()) css += text.value();
                if (!sheet_.read(css)) warn("style rules other than for names, classes and ids are left out");
            }
            if (node.first_child()) {
                node = node.first_child();
                continue;
            }
            while (node && node != root && !node.next_sibling()) node = node.parent();
            node = node == root ? pugi::xml_node{} : node.next_sibling();
        }
    }

    [[nodiscard]] svg_properties properties_of(const pugi::xml_node& node)
    {
        svg_properties all;
        for (const pugi::xml_attribute& a : node.attributes())
            if (is_property(a.name())) all.emplace_back(a.name(), trimmed(a.value()));
        const std::string name{name_of(node)};
        const svg_identity identity{name, node.attribute("id").value(), node.attribute("class").value()};
        sheet_.add(identity, all, [this](std::size_t steps) { return spend(steps); });
        read_declarations(node.attribute("style").value(), all);
        spend(std::string_view{node.attribute("style").value()}.size());
        return all;
    }

    [[nodiscard]] pugi::xml_node named(std::string_view reference) const
    {
        const auto found = ids_.find(name_of_reference(reference));
        return found == ids_.end() ? pugi::xml_node{} : found->second;
    }

    /// Takes an element's properties into account. False if it is not drawn.
    bool enter(const pugi::xml_node& node, surroundings& in)
    {
        if (!trouble_.empty()) return false;
        if (++elements_ > max_elements) {
            trouble_ = " draws more than 200000 elements, which is too much.";
            return false;
        }
        if (++in.depth > max_depth) {
            trouble_ = " has elements in each other, or <use> of each other, more than 200 levels deep.";
            return false;
        }
        const svg_properties all = properties_of(node);
        if (value_of(all, "display") == "none") return false;
        in.look.apply(all, diagonal_of(in.port));
        if (!spend(in.look.fill.reference.size() + in.look.stroke.reference.size() + 8 * in.look.dashes.size()))
            return false;  // each element in it copies them
        if (const pugi::xml_attribute turned = node.attribute("transform")) {
            if (const auto map = read_transform(turned.value()))
                in.map = after(in.map, *map);
            else
                warn("malformed transforms are left out");
        }
        const auto is_on = [&](const char* name) {
            const std::string_view value = value_of(all, name);
            return !value.empty() && value != "none" && value != "normal";
        };
        if (is_on("mask")) warn("masks are not drawn");
        if (is_on("filter")) warn("filters are not drawn");
        if (is_on("mix-blend-mode")) warn("colours do not blend");
        if (is_on("transform")) warn("transforms in styles are left out");
        if (is_on("transform-origin")) warn("origins of transforms are left out");
        if (is_on("vector-effect")) warn("vector effects are left out");
        if (is_on("marker") || is_on("marker-start") || is_on("marker-mid") || is_on("marker-end"))
            warn("markers are not drawn");
        if (is_on("clip-path")) clip(value_of(all, "clip-path"), in);
        return true;
    }

    /// Counts an element with its attributes, whether it is drawn or not.
    bool spend(const pugi::xml_node& node)
    {
        std::size_t steps = 256;
        for (const pugi::xml_attribute& a : node.attributes()) steps += 16 + std::string_view{a.value()}.size();
        return spend(steps);
    }

    /// Draws an element, which inherits from those around it.
    void element(const pugi::xml_node& node, const surroundings& around)
    {
        if (!spend(node)) return;
        const std::string_view name = name_of(node);
        constexpr std::string_view silent[] = {"",        "defs",   "title",          "desc",           "metadata",
                                               "style",   "symbol", "linearGradient", "radialGradient", "clipPath",
                                               "pattern", "marker", "mask",           "filter",         "solidColor",
                                               "view"};
        if (std::find(std::begin(silent), std::end(silent), name) != std::end(silent)) return;
        const bool is_group = name == "g" || name == "a" || name == "switch";
        if (!is_group && name != "svg" && name != "use" && !is_shape(name))
            return warn("<" + std::string{name} + "> is not drawn");
        surroundings in = around;
        if (name == "svg" && !viewport(node, node, in)) return;
        if (!enter(node, in)) return;
        if (is_shape(name)) return shape(node, in);
        if (name == "use") return use(node, in);
        for (const pugi::xml_node& child : node.children()) {
            if (!spend(std::size_t{16})) return;
            if (child.type() != pugi::node_element || (name == "switch" && !is_choice(child))) continue;
            element(child, in);
            if (name == "switch") return;
        }
    }

    /// Whether a <switch> may choose an element.
    static bool is_choice(const pugi::xml_node& child)
    {
        constexpr std::string_view passed_over[] = {"", "foreignObject", "title", "desc", "metadata", "defs", "style"};
        const auto same = [&](std::string_view name) { return name == name_of(child); };
        if (std::any_of(std::begin(passed_over), std::end(passed_over), same)) return false;
        return !child.attribute("requiredExtensions") && !child.attribute("systemLanguage");
    }

    /// Enters the viewport of an <svg> or <symbol>, whose place and size `from` may say. False if it has no size.
    bool viewport(const pugi::xml_node& node, const pugi::xml_node& from, surroundings& in)
    {
        const bool is_root = node == file_.document_element() && in.depth == 0;
        const auto length = [&](const char* name, double whole, double otherwise) {
            const pugi::xml_attribute own = from.attribute(name), there = node.attribute(name);
            return read_length(own ? own.value() : there.value(), whole).value_or(otherwise);
        };
        box port = in.port;
        if (!is_root) {
            const bool placed = node == from;
            const point at{placed ? length("x", in.port.width(), 0.0) : 0.0,
                           placed ? length("y", in.port.height(), 0.0) : 0.0};
            port = {at, at + point{length("width", in.port.width(), in.port.width()),
                                   length("height", in.port.height(), in.port.height())}};
            if (!(port.width() > 0.0) || !(port.height() > 0.0)) return false;
            const svg_properties all = properties_of(node);
            const std::string_view overflow = value_of(all, "overflow");
            if (overflow != "visible" && overflow != "auto") clip_to(port, in);
        }
        const auto view = read_view_box(node.attribute("viewBox").value());
        if (view) in.map = after(in.map, view_map(*view, port, node.attribute("preserveAspectRatio").value()));
        if (!view && !is_root) in.map = after(in.map, {.dx = port.low.x, .dy = port.low.y});
        in.port = view ? *view : box{{0.0, 0.0}, port.high - port.low};
        if (is_root && !view) in.port = port;
        return true;
    }

    void use(const pugi::xml_node& node, surroundings in)
    {
        const std::string_view reference = href_of(node);
        const pugi::xml_node target = named(reference);
        if (!target) {
            if (!reference.starts_with('#')) warn("<use> of other files is not drawn");
            return;
        }
        const auto length = [&](const char* name, double whole) {
            return read_length(node.attribute(name).value(), whole).value_or(0.0);
        };
        in.map = after(in.map, {.dx = length("x", in.port.width()), .dy = length("y", in.port.height())});
        if (std::find(used_.begin(), used_.end(), target) != used_.end())
            return warn("<use> of an element within itself is not drawn");
        used_.push_back(target);
        const std::string_view name = name_of(target);
        if (name == "symbol" || name == "svg") {
            if (viewport(target, node, in) && enter(target, in))
                for (const pugi::xml_node& child : target.children())
                    if (child.type() == pugi::node_element) element(child, in);
        } else {
            element(target, in);
        }
        used_.pop_back();
    }

    // --- shapes

    void shape(const pugi::xml_node& node, const surroundings& in)
    {
        const std::string data = data_of(
            name_of(node), [&node](const char* name) { return std::string_view{node.attribute(name).value()}; },
            in.port);
        if (data.empty() || !in.look.is_visible || !spend(data.size())) return;
        if (clipping_ != nullptr) {
            add(pen_.fill(data, in.map, in.look.clip_rule));
            const bool is_cut = in.clip != clipping_->inside;
            if (trouble_.empty())
                clipping_->shapes.push_back({out_.shapes.size() - 1, is_cut ? in.clip : svg_drawing::no_clip});
        } else {
            if (!in.look.dashes.empty() && node.attribute("pathLength")) warn("pathLength is left out");
            if (in.look.stroke_is_below) stroke(data, in);
            if (const auto colour = colour_of(in.look.fill, in.look, in.look.fill_opacity))
                if (add(pen_.fill(data, in.map, in.look.rule))) paint(*colour, in);
            if (!in.look.stroke_is_below) stroke(data, in);
        }
        if (pen_.has_mistake()) warn("malformed path data are drawn up to the mistake");
        if (pen_.has_too_many_dashes()) warn("strokes of more than 10000 dashes have no gaps");
    }
    void stroke(const std::string& data, const surroundings& in)
    {
        if (!(in.look.width > 0.0)) return;
        if (const auto colour = colour_of(in.look.stroke, in.look, in.look.stroke_opacity))
            if (add(pen_.stroke(data, in.map, in.look))) paint(*colour, in);
    }
    bool add(const typemesh::error& e)
    {
        if (e == typemesh::error::too_many_points)
            trouble_ = " draws more than " + std::to_string(how_.max_curves) + " curves, which is too much.";
        else if (e)
            trouble_ = ": a shape cannot be drawn: " + std::string{e.message()};
        return !e;
    }
    void paint(const rgb_colour& colour, const surroundings& in)
    {
        if (out_.shapes.back().curves.empty())
            out_.shapes.pop_back();
        else
            out_.items.push_back({out_.shapes.size() - 1, in.clip, colour});
    }

    // --- colours

    std::optional<rgb_colour> colour_of(const svg_paint& p, const svg_look& look, double opacity)
    {
        rgb_colour made = p.is_current ? look.colour : p.colour;
        bool is_none = p.is_none;
        if (!p.reference.empty())
            if (const auto mean = mean_colour(p.reference, look)) {
                made = *mean;
                is_none = false;
            }
        const double alpha = made.alpha * opacity * look.opacity;
        made.alpha = static_cast<unsigned char>(std::lround(alpha));
        if (is_none || made.alpha == 0) return {};
        return made;
    }

    /// The mean colour of a gradient.
    std::optional<rgb_colour> mean_colour(const std::string& id, const svg_look& look)
    {
        pugi::xml_node node = named("#" + id);
        if (name_of(node) == "pattern") {
            warn("patterns are not drawn");
            return {};
        }
        const auto is_gradient = [&] { return name_of(node) == "linearGradient" || name_of(node) == "radialGradient"; };
        for (int hops = 0; hops < 16 && is_gradient(); ++hops) {
            double sum[4] = {}, before[4] = {}, place = 0.0;
            std::size_t count = 0;
            for (const pugi::xml_node& stop : node.children()) {
                if (!spend(std::size_t{16})) return {};
                if (name_of(stop) != "stop") continue;
                double now[4];
                read_stop(stop, look, now);
                const double wanted = read_length(stop.attribute("offset").value(), 1.0).value_or(0.0);
                const double at = std::max(place, std::clamp(wanted, 0.0, 1.0));
                for (int i = 0; i < 4; ++i) {
                    sum[i] += count == 0 ? at * now[i] : 0.5 * (at - place) * (before[i] + now[i]);
                    before[i] = now[i];
                }
                place = at;
                ++count;
            }
            if (count != 0) {
                warn("gradients have their mean colour");
                for (int i = 0; i < 4; ++i) sum[i] += (1.0 - place) * before[i];
                const auto byte = [&](int i) { return static_cast<unsigned char>(std::lround(sum[i])); };
                return rgb_colour{{byte(0), byte(1), byte(2)}, byte(3)};
            }
            node = named(href_of(node));
        }
        return {};
    }
    void read_stop(const pugi::xml_node& stop, const svg_look& look, double (&out)[4])
    {
        const svg_properties all = properties_of(stop);
        const std::string_view written = value_of(all, "stop-color");
        const rgb_colour colour =
            lower(written) == "currentcolor" ? look.colour : read_svg_colour(written).value_or(rgb_colour{});
        for (int i = 0; i < 3; ++i) out[i] = written.empty() ? 0.0 : 1.0 * colour.rgb[i];
        const double opacity = read_length(value_of(all, "stop-opacity"), 1.0).value_or(1.0);
        out[3] = (written.empty() ? 255.0 : 1.0 * colour.alpha) * std::clamp(opacity, 0.0, 1.0);
    }

    // --- clips

    void clip_to(const box& port, surroundings& in)
    {
        char data[160];
        std::snprintf(data, sizeof data, "M%.17g %.17gH%.17gV%.17gH%.17gZ", port.low.x, port.low.y, port.high.x,
                      port.high.y, port.low.x);
        if (!add(pen_.fill(data, in.map, typemesh::fill_rule::non_zero))) return;
        in.clip = keep({{{out_.shapes.size() - 1}}, in.clip});
    }

    std::size_t keep(svg_drawing::clip made)
    {
        out_.clips.push_back(std::move(made));
        return out_.clips.size() - 1;
    }

    /// The clip-rule that a <clipPath> inherits from where it is written.
    typemesh::fill_rule clip_rule_around(const pugi::xml_node& node)
    {
        for (pugi::xml_node around = node.parent(); around && spend(around); around = around.parent()) {
            const svg_properties all = properties_of(around);
            const std::string_view rule = value_of(all, "clip-rule");
            if (rule == "evenodd") return typemesh::fill_rule::even_odd;
            if (rule == "nonzero") break;
        }
        return typemesh::fill_rule::non_zero;
    }

    void clip(std::string_view reference, surroundings& in)
    {
        const pugi::xml_node node = named(reference);
        if (name_of(node) != "clipPath") {
            if (!reference.starts_with("url(")) warn("clip paths that are not <clipPath> are left out");
            return;
        }
        if (std::string_view{node.attribute("clipPathUnits").value()} == "objectBoundingBox")
            return warn("clip paths in units of a bounding box are left out");
        if (std::find(used_.begin(), used_.end(), node) != used_.end())
            return warn("a clip path within itself is left out");
        used_.push_back(node);
        surroundings inner;
        inner.map = in.map;
        inner.port = in.port;
        inner.clip = in.clip;
        inner.depth = in.depth;
        inner.look.clip_rule = clip_rule_around(node);
        svg_drawing::clip made, *const outer = clipping_;
        if (enter(node, inner)) {
            made.inside = inner.clip;
            clipping_ = &made;
            for (const pugi::xml_node& child : node.children())
                if (child.type() == pugi::node_element) element(child, inner);
            clipping_ = outer;
        }
        used_.pop_back();
        made.inside = inner.clip;
        in.clip = keep(std::move(made));
    }

    const pugi::xml_document& file_;
    const svg_options& how_;
    svg_drawing& out_;
    svg_pen pen_;
    std::map<std::string, pugi::xml_node> ids_;
    svg_stylesheet sheet_;
    std::set<std::string> warned_;
    std::vector<pugi::xml_node> used_;       // the elements of <use> that are being drawn
    svg_drawing::clip* clipping_ = nullptr;  // shapes belong to it
    std::size_t elements_ = 0, steps_ = 0;
    std::string trouble_;
};

}  // namespace

std::string read_svg_text(const std::string& text, const svg_options& how, svg_drawing& out)
{
    if (text.starts_with("\x1F\x8B")) return " is compressed: unpack it with gunzip first.";
    pugi::xml_document file;
    const pugi::xml_parse_result read = file.load_buffer(text.data(), text.size());
    if (read) return reader{file, how, out}.read();
    const auto end = text.begin() + std::min<std::ptrdiff_t>(read.offset, static_cast<std::ptrdiff_t>(text.size()));
    return ", line " + std::to_string(1 + std::count(text.begin(), end, '\n')) +
           ": this is not XML: " + read.description() + ".";
}

}  // namespace text_to_mesh

#endif
