// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/error.hpp>
#include <typemesh/core/fill_rule.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/impl/mixed_key.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/outline/impl/elliptical_arc.hpp>
#include <typemesh/outline/impl/path_numbers.hpp>
#include <typemesh/outline/impl/variation_key.hpp>
#include <typemesh/outline/outline_sink.hpp>
#include <typemesh/outline/outline_source.hpp>

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// What happens to path data with a mistake.
enum class path_mistakes : std::uint8_t {
    refuse,        ///< it is an error
    draw_up_to_it  ///< the segments before the one with the mistake are drawn, as SVG 2 tells programs that draw
};

namespace detail {

/// Reads path data and draws it into a sink, in one pass.
template <outline_sink Sink>
class path_reader {
public:
    path_reader(std::string_view data, Sink& sink, double tolerance) noexcept
        : in_{data}, to_{sink}, tolerance_{tolerance}
    {
    }

    /// Draws all segments before the first mistake. Returns the mistake, or none.
    [[nodiscard]] error read() noexcept
    {
        in_.skip_space();
        while (!in_.at_end() && mistake_ == nullptr) {
            const char command = in_.next();
            const char upper = command >= 'a' && command <= 'z' ? static_cast<char>(command - 'a' + 'A') : command;
            relative_ = command != upper;
            if (arguments_of(upper) < 0)
                fail("a command is one of the letters MLHVCSQTAZ");
            else if (!begun_ && upper != 'M')
                fail("the first command must be M or m");
            else
                read_segments(upper);
            in_.skip_space();
        }
        error e;
        if (mistake_ != nullptr) {
            e = {error::bad_path, place_ + 1};
            e.option = mistake_;
        }
        return e;
    }

private:
    /// The number of numbers that a segment has; -1 if there is no such command.
    [[nodiscard]] static constexpr int arguments_of(char upper) noexcept
    {
        switch (upper) {
        case 'Z': return 0;
        case 'H':
        case 'V': return 1;
        case 'M':
        case 'L':
        case 'T': return 2;
        case 'S':
        case 'Q': return 4;
        case 'C': return 6;
        case 'A': return 7;
        default: return -1;
        }
    }

    /// Reads a command and all its segments.
    void read_segments(char upper) noexcept
    {
        in_.step();
        in_.skip_space();
        if (upper == 'Z') return close();
        for (bool first = true, comma = false; first || comma || in_.begins_number(); first = false) {
            if (!read_arguments(upper)) return;
            draw(upper);
            last_ = upper;
            if (upper == 'M') upper = 'L';
            comma = in_.skip_comma();
        }
    }

    [[nodiscard]] bool read_arguments(char upper) noexcept
    {
        const int count = arguments_of(upper);
        for (int i = 0; i < count; ++i) {
            if (i != 0) (void)in_.skip_comma();
            if (upper == 'A' && (i == 3 || i == 4)) {
                if (!in_.read_flag(flags_[i - 3])) return fail("a flag of an arc must be 0 or 1");
            } else {
                const std::size_t begin = in_.place();
                if (!in_.begins_number() || !in_.read(numbers_[i])) return fail("a number is missing or malformed");
                if (!is_finite(numbers_[i])) return fail("a number is too large", begin);
            }
        }
        return true;
    }

    bool fail(const char* what) noexcept { return fail(what, in_.place()); }
    bool fail(const char* what, std::size_t place) noexcept
    {
        mistake_ = what;
        place_ = place;
        return false;
    }

    /// The point that two numbers give.
    [[nodiscard]] point at(int first) const noexcept
    {
        const point p{numbers_[first], numbers_[first + 1]};
        return relative_ ? current_ + p : p;
    }

    void draw(char upper) noexcept
    {
        const point from = current_;
        switch (upper) {
        case 'M': move(at(0)); break;
        case 'L': line(at(0)); break;
        case 'H': line({relative_ ? from.x + numbers_[0] : numbers_[0], from.y}); break;
        case 'V': line({from.x, relative_ ? from.y + numbers_[0] : numbers_[0]}); break;
        case 'C': cubic(at(0), at(2), at(4)); break;
        case 'S': cubic(last_ == 'C' || last_ == 'S' ? reflected() : from, at(0), at(2)); break;
        case 'Q': quadratic(at(0), at(2)); break;
        case 'T': quadratic(last_ == 'Q' || last_ == 'T' ? reflected() : from, at(0)); break;
        default: arc(at(5)); break;
        }
    }

    [[nodiscard]] point reflected() const noexcept { return current_ + (current_ - control_); }

    void move(point p) noexcept
    {
        begun_ = true;
        closed_ = false;
        start_ = current_ = p;
        to_.move(p);
    }
    /// Begins a contour where the last one began, if that has been closed.
    void go_on() noexcept
    {
        if (closed_) to_.move(current_);
        closed_ = false;
    }
    void line(point p) noexcept
    {
        go_on();
        to_.line(p);
        current_ = p;
    }
    void quadratic(point control, point p) noexcept
    {
        go_on();
        to_.quadratic(control, p);
        control_ = control;
        current_ = p;
    }
    void cubic(point control1, point control2, point p) noexcept
    {
        go_on();
        to_.cubic(control1, control2, p);
        control_ = control2;
        current_ = p;
    }
    void arc(point p) noexcept
    {
        if (p == current_) return;
        const auto own =
            elliptical_arc::between(current_, p, {numbers_[0], numbers_[1]}, numbers_[2], flags_[0], flags_[1]);
        if (!(own.radius > 0.0)) return line(p);
        go_on();
        own.cubics(p, tolerance_, [&](point c1, point c2, point end) noexcept { to_.cubic(c1, c2, end); });
        current_ = p;
    }
    void close() noexcept
    {
        if (!closed_) to_.close();
        closed_ = true;
        current_ = start_;
        last_ = 'Z';
    }

    path_numbers in_;
    Sink& to_;
    double tolerance_;
    const char* mistake_ = nullptr;
    std::size_t place_ = 0;  // of the mistake
    double numbers_[7] = {};
    bool flags_[2] = {};
    bool relative_ = false;
    bool begun_ = false;   // there was a move
    bool closed_ = false;  // the last command was Z
    char last_ = '\0';     // the last segment's command
    point start_, current_;
    point control_;  // the last curve's last control point
};

}  // namespace detail

/// Draws path data of SVG (the attribute `d` of a path) into a sink, with the numbers as they stand there: x to the
/// right, y down. A contour that the data does not close gets no close().
///
/// All commands are read: M L H V C S Q T A Z, absolute and relative. A command may be followed by the numbers of
/// several segments. Numbers need no separators where they are unambiguous: "1.5.5-2" are three, and "a1 1 0 01.5.5"
/// ends with the flags 0 and 1 and two numbers. Arcs become cubics. An arc to its own start is left out, one with a
/// radius of 0 is a line, and radii that are too small are enlarged, as SVG 2 says.
///
///     tolerance    the distance between an arc and its cubics, in the data's unit; positive. An arc has at most 4,096
///                  cubics, one for each quarter of its ellipse at least
///
/// Fails  error::bad_path: count is the place of the mistake (1 for the first byte), option says what it is. The
///        segments before the mistake are drawn
/// Cost   O(bytes); nothing is allocated
///
/// From  Scalable Vector Graphics (SVG) 2, sections 9.3 and 9.5, appendix B.2
template <outline_sink Sink>
[[nodiscard]] result<void> draw_svg_path(std::string_view data, double tolerance, Sink& sink) noexcept
{
    if (!is_finite(tolerance) || !(tolerance > 0.0)) return error::bad_tolerance;
    return detail::path_reader<Sink>{data, sink, tolerance}.read();
}

/// An outline source with one glyph, number 0, which is a path of SVG: an icon, a logo.
///
///     svg_path heart{"M12 21C5 15 2 12 2 8a5 5 0 0110-2 5 5 0 0110 2c0 4-3 7-10 13z"};
///     text_mesher mesher{heart};                            // a glyph_run with one glyph says where it stands
///
/// A square view box from (0, 0) to (size, size) becomes the em: its lower side is the baseline, and y grows upwards.
/// recorded_outlines keeps the glyphs of several paths: `icons.add([&](auto& pen) { return heart.outline(0, pen); })`.
///
/// Fails  in outline(): error::unknown_glyph for other glyphs; error::bad_option: "size" or "tolerance";
///        error::bad_path as draw_svg_path(), unless `mistakes` says otherwise
struct svg_path {
    std::string_view data;  ///< the path data, which the caller keeps
    double size = 24.0;     ///< the side of the view box, in the data's unit; positive
    fill_rule rule = fill_rule::non_zero;
    path_mistakes mistakes = path_mistakes::refuse;
    double tolerance = 1e-5;  ///< the distance between an arc and its cubics, in em; positive

    [[nodiscard]] double units_per_em() const noexcept { return size; }
    [[nodiscard]] fill_rule fill() const noexcept { return rule; }

    /// See outline_source. Covers the data and all options. O(bytes).
    [[nodiscard]] std::uint64_t variation_key() const noexcept
    {
        std::uint64_t key = std::uint64_t{data.size()} << 8 | static_cast<std::uint64_t>(rule) << 4 |
                            static_cast<std::uint64_t>(mistakes);
        for (const double number : {size, tolerance}) key = mixed_key(key, detail::bits_of(number));
        for (const char c : data) key = mixed_key(key, static_cast<unsigned char>(c));
        return key;
    }

    template <outline_sink Sink>
    error outline(glyph_id id, Sink& sink) const noexcept
    {
        if (id != 0) return error{error::unknown_glyph}.at(id, no_cluster);
        if (!is_finite(size) || !(size > 0.0)) return error::bad("size");
        if (!is_finite(tolerance) || !(tolerance > 0.0)) return error::bad("tolerance");
        upright<Sink> up{sink, size};
        const error e = draw_svg_path(data, tolerance * size, up).error();
        return mistakes == path_mistakes::draw_up_to_it && e == error::bad_path ? error{} : e;
    }

private:
    /// Turns y round.
    template <outline_sink Sink>
    struct upright {
        Sink& to;
        double size;

        [[nodiscard]] point own(point p) const noexcept { return {p.x, size - p.y}; }
        void move(point p) noexcept { to.move(own(p)); }
        void line(point p) noexcept { to.line(own(p)); }
        void quadratic(point c, point p) noexcept { to.quadratic(own(c), own(p)); }
        void cubic(point c1, point c2, point p) noexcept { to.cubic(own(c1), own(c2), own(p)); }
        void close() noexcept { to.close(); }
    };
};
static_assert(outline_source<svg_path>);

}  // namespace typemesh::inline TYPEMESH_ABI
