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

/// Maps what is drawn, as long as passes() says that it may be drawn.
template <outline_sink Sink, class Passes>
struct mapped_pen {
    Sink& to;
    affine map;
    Passes passes;

    void move(point p) noexcept
    {
        if (passes()) to.move(map(p));
    }
    void line(point p) noexcept
    {
        if (passes()) to.line(map(p));
    }
    void quadratic(point c, point p) noexcept
    {
        if (passes()) to.quadratic(map(c), map(p));
    }
    void cubic(point a, point b, point p) noexcept
    {
        if (passes()) to.cubic(map(a), map(b), map(p));
    }
    void close() noexcept { to.close(); }
};

/// A pen that takes each piece from the allowance.
auto taking_pen(outline_recorder& to, const affine& map, svg_allowance& left)
{
    const auto passes = [&left]() noexcept { return left.take(); };
    return mapped_pen<outline_recorder, decltype(passes)>{to, map, passes};
}

/// Path data as a source of one glyph, as far as they can be read.
struct data_source {
    std::string_view data;
    double tolerance;
    const svg_allowance& left;

    [[nodiscard]] double units_per_em() const noexcept { return 1.0; }
    [[nodiscard]] fill_rule fill() const noexcept { return fill_rule::non_zero; }
    template <outline_sink Sink>
    error outline(glyph_id, Sink& sink) const noexcept
    {
        const auto passes = [this]() noexcept { return !left.is_over; };
        mapped_pen<Sink, decltype(passes)> to{sink, {}, passes};
        (void)draw_svg_path(data, tolerance, to);
        return {};
    }
};

}  // namespace

error svg_pen::keep(outline& made, fill_rule rule)
{
    if (left_.is_over) return {error::too_many_points, max_pieces_};
    made.rule = rule;
    out_.shapes.push_back(std::move(made));
    return {};
}

error svg_pen::fill(std::string_view data, const affine& map, fill_rule rule)
{
    outline made;
    outline_recorder recorder{made};
    auto pen = taking_pen(recorder, map, left_);
    if (!is_flat(map) && !draw_svg_path(data, tolerance_ / stretch_of(map), pen)) has_mistake_ = true;
    if (error e = recorder.finish()) return e;
    return keep(made, rule);
}

error svg_pen::stroke(std::string_view data, const affine& map, const svg_look& look)
{
    stroke_style style{.width = look.width,
                       .cap = look.cap,
                       .join = look.join,
                       .mitre_limit = look.mitre_limit,
                       .dashes = look.dashes,
                       .dash_offset = look.dash_offset};
    outline made;
    if (is_flat(map)) return keep(made, fill_rule::non_zero);
    const double tolerance = 0.5 * tolerance_ / stretch_of(map);
    data_source source{data, tolerance, left_};
    const auto draw = [&]() -> error {
        outline_recorder recorder{made};
        auto pen = taking_pen(recorder, map, left_);
        stroked_outlines lines{source, style, tolerance};
        if (error e = lines.outline(0, pen)) return e;
        return recorder.finish();
    };
    const svg_allowance before = left_;
    error e = draw();
    if (e == error::bad_option && std::string_view{e.option} == "dashes") {
        has_too_many_dashes_ = true;
        style.dashes = {};
        left_ = before;
        e = draw();
    }
    return e ? e : keep(made, fill_rule::non_zero);
}

}  // namespace text_to_mesh
