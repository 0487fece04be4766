// SPDX-License-Identifier: MIT
#include "svg_pen.hpp"

#include "svg_values.hpp"

#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/stroked_outlines.hpp>
#include <typemesh/outline/svg_path.hpp>

#include <utility>

namespace text_to_mesh {
namespace {

using namespace typemesh;

/// Maps what is drawn.
struct mapped_pen {
    outline_recorder& to;
    affine map;

    void move(point p) noexcept { to.move(map(p)); }
    void line(point p) noexcept { to.line(map(p)); }
    void quadratic(point c, point p) noexcept { to.quadratic(map(c), map(p)); }
    void cubic(point a, point b, point p) noexcept { to.cubic(map(a), map(b), map(p)); }
    void close() noexcept { to.close(); }
};

/// Path data as a source of one glyph, as far as they can be read.
struct data_source {
    std::string_view data;
    double tolerance;

    [[nodiscard]] double units_per_em() const noexcept { return 1.0; }
    [[nodiscard]] fill_rule fill() const noexcept { return fill_rule::non_zero; }
    template <outline_sink Sink>
    error outline(glyph_id, Sink& sink) const noexcept
    {
        (void)draw_svg_path(data, tolerance, sink);
        return {};
    }
};

}  // namespace

error svg_pen::fill(std::string_view data, const affine& map, fill_rule rule)
{
    outline made;
    outline_recorder recorder{made};
    mapped_pen pen{recorder, map};
    const double scale = scale_of(map);
    if (scale > 0.0 && !draw_svg_path(data, tolerance_ / scale, pen)) has_mistake_ = true;
    if (error e = recorder.finish()) return e;
    made.rule = rule;
    out_.shapes.push_back(std::move(made));
    return {};
}

error svg_pen::stroke(std::string_view data, const affine& map, const svg_look& look)
{
    stroke_style style{.width = look.width,
                       .cap = look.cap,
                       .join = look.join,
                       .mitre_limit = look.mitre_limit,
                       .dashes = look.dashes,
                       .dash_offset = look.dash_offset};
    const double scale = scale_of(map);
    outline made;
    if (scale > 0.0) {
        data_source source{data, 0.5 * tolerance_ / scale};
        const auto draw = [&]() -> error {
            outline_recorder recorder{made};
            mapped_pen pen{recorder, map};
            stroked_outlines lines{source, style, 0.5 * tolerance_ / scale};
            if (error e = lines.outline(0, pen)) return e;
            return recorder.finish();
        };
        error e = draw();
        if (e == error::bad_option && std::string_view{e.option} == "dashes") {
            has_too_many_dashes_ = true;
            style.dashes = {};
            e = draw();
        }
        if (e) return e;
    }
    made.rule = fill_rule::non_zero;
    out_.shapes.push_back(std::move(made));
    return {};
}

}  // namespace text_to_mesh
