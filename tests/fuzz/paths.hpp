// SPDX-License-Identifier: MIT
#pragma once

#include "values.hpp"

#include <typemesh/outline/draw_outline.hpp>
#include <typemesh/outline/outline_recorder.hpp>
#include <typemesh/outline/stroked_outlines.hpp>
#include <typemesh/outline/svg_path.hpp>
#include <typemesh/outline/svg_path_writer.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Path data of SVG -> calls of a sink; written again; stroked.
namespace fuzz {

namespace path_laws {

using namespace typemesh;

/// Counts calls, and the laws of an outline_sink.
struct counting_sink {
    std::size_t moves = 0, others = 0;
    bool open = false, broken = false;

    void move(point) noexcept { ++moves, open = true; }
    void line(point) noexcept { ++others, broken |= !open; }
    void quadratic(point, point) noexcept { ++others, broken |= !open; }
    void cubic(point, point, point) noexcept { ++others, broken |= !open; }
    void close() noexcept { broken |= !open, open = false; }
};

/// Commands, numbers and what stands between them; any byte stands anywhere.
inline std::string read_data(values& in, std::size_t most)
{
    static constexpr std::string_view pieces[] = {
        "M",      "m",         "L",     "l",    "H",   "h",     "V",     "v",    "C",     "c",
        "S",      "s",         "Q",     "q",    "T",   "t",     "A",     "a",    "Z",     "z",
        " ",      ",",         "\n",    "-",    "+",   ".",     "0",     "1",    "2",     "5",
        "10",     ".5",        "-1",    "1.5",  "1e2", "-1E-3", "1e309", "1e-9", "01",    "M0 0",
        "1 1 ",   "a1 1 0 01", "2.5.5", "360 ", "e",   "zm",    "0,",    "1e9",  " 1 0 ", "M1 2C3 4 5 6 7 8",
        "1e150 ", "0 0 0 "};
    std::string data = in.flag() ? "M1 2" : "";
    while (!in.empty() && data.size() < most) {
        const std::uint32_t byte = in.byte();
        if (byte < 0xE0)
            data += pieces[byte % std::size(pieces)];
        else
            data += static_cast<char>(in.byte());
    }
    return data;
}

/// Whether nothing but rounding tells two points apart.
inline bool near(point a, point b) { return length(a - b) <= 1e-6 * (1.0 + length(a)); }

inline broken_law of_written(const outline& drawn)
{
    double farthest = 0.0;
    for (const curve& c : drawn.curves)
        for (std::uint32_t i = 0; i <= c.degree; ++i)
            farthest = (std::max)({farthest, std::fabs(c.p[i].x), std::fabs(c.p[i].y)});
    if (!(farthest < 1e5)) return {};
    svg_path_writer text{affine{}, 9};
    draw_outline(drawn, text);
    if (!text.finish()) return "a path cannot be written";
    std::size_t next = 0;
    broken_law broken;
    struct comparing {
        const outline& drawn;
        std::size_t& next;
        broken_law& broken;

        void compare(std::uint32_t degree, point p) noexcept
        {
            if (next >= drawn.curves.size())
                broken = "more is read than was written";
            else if (drawn.curves[next].degree != degree || !near(drawn.curves[next].end(), p))
                broken = "what is written is read as something else";
            ++next;
        }
        void move(point) noexcept {}
        void line(point p) noexcept { compare(1, p); }
        void quadratic(point, point p) noexcept { compare(2, p); }
        void cubic(point, point, point p) noexcept { compare(3, p); }
        void close() noexcept {}
    } again{drawn, next, broken};
    if (!draw_svg_path(text.text(), 1e-3, again)) return "what is written cannot be read";
    return next == drawn.curves.size() ? broken : "less is read than was written";
}

/// Strokes of a finite path are finite, or refused for numbers that are too large.
inline broken_law of_strokes(const std::string& data)
{
    svg_path source{data, 24.0, fill_rule::non_zero, path_mistakes::draw_up_to_it};
    const double dashes[] = {0.1, 0.0, 0.25};
    if (data.size() > 80) return {};
    const auto kind = static_cast<std::uint8_t>(data.size() % 3);
    stroke_style style{
        .width = kind == 0 ? 0.01 : 0.3, .cap = static_cast<stroke_cap>(kind), .join = static_cast<stroke_join>(kind)};
    if (data.size() % 2 == 0) style.dashes = dashes;
    stroked_outlines lines{source, style, 0.01};
    outline stroke;
    const auto done = record(lines, 0, stroke, 1'000'000);
    if (!done && !(done == error::outline_beyond_grid) && !(done == error::bad_option) &&
        !(done == error::too_many_points))
        return "a stroke fails";
    for (const curve& c : stroke.curves)
        for (std::uint32_t i = 0; i <= c.degree && done; ++i)
            if (!is_finite(c.p[i].x) || !is_finite(c.p[i].y)) return "a stroke is not finite";
    return {};
}

inline broken_law of_data(const std::string& data)
{
    counting_sink seen;
    const auto done = draw_svg_path(data, 1e-3, seen);
    if (seen.broken) return "a segment stands before any move, or after a close";
    if (!done) {
        const error e = done.error();
        if (e != error::bad_path || e.option == nullptr || e.count == 0 || e.count > data.size() + 1)
            return "an error without place";
    }
    if (seen.moves + seen.others > 4096 * (data.size() + 1)) return "too many calls";
    // A mistake changes nothing of what stands before it.
    const svg_path strict{data, 24.0}, lenient{data, 24.0, fill_rule::non_zero, path_mistakes::draw_up_to_it};
    counting_sink again, third;
    if (!(strict.outline(0, again) == done.error().code)) return "another error as a font";
    if (lenient.outline(0, third) != error::none) return "a mistake is refused though it must not be";
    if (third.moves != seen.moves) return "not everything before the mistake is drawn";
    outline drawn;
    outline_recorder to{drawn};
    (void)lenient.outline(0, to);
    const error recorded = to.finish();
    if (recorded != error::none && recorded != error::outline_not_finite) return "a path that cannot be recorded";
    if (recorded != error::none) return {};
    if (broken_law broken = of_written(drawn); !broken.empty()) return broken;
    return of_strokes(data);
}

/// Takes out one byte at each mistake, which leaves data without any.
inline std::string mended(std::string data)
{
    ignore_outline nowhere;
    for (;;) {
        const auto done = draw_svg_path(data, 1e-3, nowhere);
        if (done || data.empty()) return data;
        const std::uint64_t place = done.error().count - 1;
        data.erase(place < data.size() ? place : data.size() - 1, 1);
    }
}

}  // namespace path_laws

inline broken_law paths(values in)
{
    using namespace path_laws;
    const std::string data = read_data(in, 1000);
    if (broken_law broken = of_data(data); !broken.empty()) return broken;
    return of_data(mended(data));
}

}  // namespace fuzz
