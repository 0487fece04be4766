// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/array_view.hpp>
#include <typemesh/core/impl/same.hpp>
#include <typemesh/core/point.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace typemesh::inline TYPEMESH_ABI {

/// A colour of a font's palette, in sRGB. Its alpha is straight (the colour is not multiplied by it), from 0 to 1.
struct palette_colour {
    std::uint8_t red = 0;    ///< from 0 to 255
    std::uint8_t green = 0;  ///< from 0 to 255
    std::uint8_t blue = 0;   ///< from 0 to 255
    float alpha = 1.0f;      ///< 0: invisible, 1: opaque

    friend constexpr bool operator==(const palette_colour& a, const palette_colour& b) noexcept
    {
        return a.red == b.red && a.green == b.green && a.blue == b.blue && same(as_double(a.alpha), as_double(b.alpha));
    }
};

/// The palette entry that stands for the colour of the text itself.
inline constexpr std::uint16_t text_colour_entry = 0xFFFF;

/// Instead of a palette entry: a colour that was mixed from several ones.
inline constexpr std::uint16_t mixed_colour_entry = 0xFFFE;

/// The ways to paint a layer of a colour glyph.
enum class paint_kind : std::uint8_t { solid, linear, radial, sweep };

/// What a gradient does outside its stops: it keeps the last colour, repeats, or runs back and forth.
enum class gradient_extend : std::uint8_t { pad, repeat, reflect };

/// A colour at a place of a gradient. Stops ascend.
struct gradient_stop {
    double at = 0.0;  ///< usually from 0 to 1
    palette_colour colour = {};
    std::uint16_t entry = text_colour_entry;  ///< the palette entry that it was made from
};

/// What a layer is painted with. The geometry of a gradient is in its own space, which `placed` maps to font units.
///
///     linear   the colours run from `from` to `to`, and are constant along the direction of `across` - `from`
///     radial   they run from the circle (from, from_radius) to the circle (to, to_radius)
///     sweep    they run around `from`, from the angle from_turn to to_turn
struct glyph_paint {
    /// The kind of the paint, which decides which of the other members count.
    paint_kind kind = paint_kind::solid;
    std::uint16_t entry = text_colour_entry;  ///< of a solid paint: the palette entry
    palette_colour colour = {};               ///< of a gradient: the mean of its colours, for who does not shade
    /// The colours beyond the first and the last stop.
    gradient_extend extend = gradient_extend::pad;
    point from = {}, to = {}, across = {};
    double from_radius = 0.0, to_radius = 0.0;
    double from_turn = 0.0, to_turn = 0.0;  ///< in half turns, counter-clockwise from the x axis
    affine placed = {};
    std::uint32_t first_stop = 0;  ///< the first stop of a gradient, in colour_glyph::stops
    std::uint32_t stop_count = 0;  ///< the number of its stops

    /// Whether it is the colour of the text itself, with any alpha.
    [[nodiscard]] constexpr bool is_text_colour() const noexcept
    {
        return kind == paint_kind::solid && entry == text_colour_entry;
    }
};

namespace detail {

/// The greatest t at which the point lies on the circle between the two of a radial gradient, if any: it solves
/// |p - c0 - t (c1 - c0)| = r0 + t (r1 - r0) for a radius that is not negative.
[[nodiscard]] inline std::optional<double> radial_place(const glyph_paint& g, point p) noexcept
{
    const point d = g.to - g.from, q = p - g.from;
    const double dr = g.to_radius - g.from_radius;
    const double a = dot(d, d) - dr * dr, b = dot(q, d) + g.from_radius * dr,
                 c = dot(q, q) - g.from_radius * g.from_radius;
    const auto fits = [&](double t) noexcept { return g.from_radius + t * dr >= 0.0; };
    if (is_zero(a)) {
        if (is_zero(b)) return {};
        const double t = c / (2.0 * b);
        return fits(t) ? std::optional{t} : std::nullopt;
    }
    const double inside = b * b - a * c;
    if (inside < 0.0) return {};
    const double root = std::sqrt(inside), one = (b + root) / a, other = (b - root) / a;
    const double high = one > other ? one : other, low = one > other ? other : one;
    if (fits(high)) return high;
    return fits(low) ? std::optional{low} : std::nullopt;
}

}  // namespace detail

/// The place along a gradient at which a point of the glyph (in font units) is painted, as stops count it, before
/// `extend`: the texture coordinate of a ramp of its stops. Of a solid paint it is 0. Empty: the gradient does not
/// paint the point at all (outside a cone of circles, or its geometry is degenerate).
[[nodiscard]] inline std::optional<double> gradient_place(const glyph_paint& paint, point at) noexcept
{
    if (paint.kind == paint_kind::solid) return 0.0;
    const affine& m = paint.placed;
    const double scale = m.xx * m.yy - m.xy * m.yx;
    if (is_zero(scale)) return {};
    const double x = at.x - m.dx, y = at.y - m.dy;
    const point p{(m.yy * x - m.xy * y) / scale, (m.xx * y - m.yx * x) / scale};
    if (paint.kind == paint_kind::radial) return detail::radial_place(paint, p);
    if (paint.kind == paint_kind::sweep) {
        const double whole = paint.to_turn - paint.from_turn;
        double turn = std::atan2(p.y - paint.from.y, p.x - paint.from.x) * 0.31830988618379067154;  // 1 / pi
        if (turn < 0.0) turn += 2.0;
        if (is_zero(whole)) return {};
        return (turn - paint.from_turn) / whole;
    }
    // A line through `from` along `across` has one colour: only the way at right angles to it counts.
    const point along = paint.across - paint.from, way{along.y, -along.x}, line = paint.to - paint.from;
    const double whole = dot(line, way);
    if (is_zero(whole)) return {};
    return dot(p - paint.from, way) / whole;
}

/// The colour of stops at a place of gradient_place(), between two stops in proportion, beyond them by `extend`.
/// Black without stops.
[[nodiscard]] inline palette_colour gradient_colour(array_view<const gradient_stop> stops, gradient_extend extend,
                                                    double place) noexcept
{
    if (stops.empty()) return {};
    const double first = stops.front().at, length = stops.back().at - first;
    if (extend != gradient_extend::pad && length > 0.0) {
        double away = (place - first) / length;
        const double period = std::floor(away);
        away -= period;
        if (extend == gradient_extend::reflect && !is_zero(period - 2.0 * std::floor(period / 2.0))) away = 1.0 - away;
        place = first + away * length;
    }
    if (place < first) return stops.front().colour;
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const gradient_stop &a = stops[i - 1], &b = stops[i];
        if (!(place < b.at)) continue;
        const double share = (place - a.at) / (b.at - a.at);
        const auto mixed = [share](double low, double high) noexcept { return low + share * (high - low); };
        const auto byte = [&](std::uint8_t low, std::uint8_t high) noexcept {
            return static_cast<std::uint8_t>(mixed(low, high) + 0.5);
        };
        return {byte(a.colour.red, b.colour.red), byte(a.colour.green, b.colour.green),
                byte(a.colour.blue, b.colour.blue),
                static_cast<float>(mixed(as_double(a.colour.alpha), as_double(b.colour.alpha)))};
    }
    return stops.back().colour;
}

}  // namespace typemesh::inline TYPEMESH_ABI
