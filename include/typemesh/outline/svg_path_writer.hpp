// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/outline/impl/fixed_point.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include <cstdint>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// An outline sink that writes path data of SVG: the attribute `d` of a path, with the commands M, L, Q, C and Z.
///
///     svg_path_writer path{{.yy = -1.0, .dy = 1000.0}, 2};     // y grows downwards in SVG; two digits after the point
///     font.outline(id, path);
///     if (auto done = path.finish(); !done) ...
///     puts(path.text())                                        // "M12 990.25L40 900Z"
///
/// Reading the text again (svg_path.hpp) gives the same points, rounded to that many digits.
class svg_path_writer {
public:
    /// `map` is applied to each point. `decimals`, 0 to 9, is the number of digits after the point; zeros at the end
    /// are left out.
    explicit svg_path_writer(const affine& map = {.yy = -1.0}, int decimals = 3, memory source = heap()) noexcept
        : text_{source},
          map_{map},
          numbers_{decimals < 0   ? 0
                   : decimals > 9 ? 9
                                  : decimals}
    {
        if (decimals < 0 || decimals > 9) error_ = error::bad("decimals");
    }

    void move(point p) noexcept
    {
        open_ = true;
        put('M', p);
    }
    void line(point p) noexcept { go('L', p); }
    void quadratic(point control, point p) noexcept
    {
        go('Q', control);
        put(' ', p);
    }
    void cubic(point control1, point control2, point p) noexcept
    {
        go('C', control1);
        put(' ', control2);
        put(' ', p);
    }
    void close() noexcept
    {
        if (open_) put('Z');
        open_ = false;
    }

    /// Empties the text and keeps its memory. An error of the constructor stays.
    void clear() noexcept
    {
        text_.clear();
        open_ = false;
        if (!(error_ == error::bad_option)) error_ = {};
    }

    /// Fails  error::bad_option: "decimals"; error::bad_outline: a contour does not begin with move();
    ///        error::outline_not_finite; error::too_large: a number has more than 15 digits; error::out_of_memory. The
    ///        text is then meaningless
    [[nodiscard]] result<void> finish() const noexcept { return error_; }

    /// The text so far, which the next call may move.
    [[nodiscard]] std::string_view text() const noexcept { return {text_.data(), text_.size()}; }

private:
    void put(char c) noexcept
    {
        if (!error_ && !text_.push_back(c)) error_ = error::out_of_memory;
    }
    void put(char before, point p) noexcept
    {
        p = map_(p);
        put(before);
        put_number(p.x);
        put(' ');
        put_number(p.y);
    }
    void put_number(double value) noexcept
    {
        std::int64_t number = 0;
        if (const error e = numbers_.round(value, number)) return refuse(e);
        for (const char c : numbers_.text(number, false)) put(c);
    }
    /// Begins a segment, for which there must be a move.
    void go(char command, point p) noexcept
    {
        if (!open_) refuse(error::bad_outline);
        put(command, p);
    }
    void refuse(const error& e) noexcept
    {
        if (!error_) error_ = e;
    }

    buffer<char> text_;
    affine map_;
    detail::fixed_point numbers_;
    bool open_ = false;
    error error_;
};
static_assert(outline_sink<svg_path_writer>);

}  // namespace typemesh::inline TYPEMESH_ABI
