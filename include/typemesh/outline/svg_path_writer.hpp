// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/finite.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include <cmath>
#include <cstddef>
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
        : text_{source}, map_{map}
    {
        if (decimals < 0 || decimals > 9) error_ = error::bad("decimals");
        for (int i = 0; i < decimals && i < 9; ++i) scale_ *= 10;
    }

    void move(point p) noexcept { put('M', p); }
    void line(point p) noexcept { put('L', p); }
    void quadratic(point control, point p) noexcept
    {
        put('Q', control);
        put(' ', p);
    }
    void cubic(point control1, point control2, point p) noexcept
    {
        put('C', control1);
        put(' ', control2);
        put(' ', p);
    }
    void close() noexcept { put('Z'); }

    /// Empties the text and keeps its memory. An error of the constructor stays.
    void clear() noexcept
    {
        text_.clear();
        if (!(error_ == error::bad_option)) error_ = {};
    }

    /// Fails  error::bad_option: "decimals"; error::outline_not_finite; error::too_large: a number has more than 15
    ///        digits; error::out_of_memory. The text is then meaningless
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
        const double wanted = std::floor(value * static_cast<double>(scale_) + 0.5);
        if (!is_finite(wanted)) return refuse(error::outline_not_finite);
        if (!(std::fabs(wanted) < 1e15)) return refuse(error::too_large);
        const auto cells = static_cast<std::int64_t>(wanted);
        if (cells < 0) put('-');
        std::int64_t left = cells < 0 ? -cells : cells;
        put_digits(left / scale_, 1);
        left %= scale_;
        if (left == 0) return;
        put('.');
        std::int64_t unit = scale_;
        while (left % 10 == 0) {
            left /= 10;
            unit /= 10;
        }
        put_digits(left, unit);
    }
    /// As many digits as `unit` has zeros, at least one.
    void put_digits(std::int64_t number, std::int64_t unit) noexcept
    {
        char digits[20];
        std::size_t count = 0;
        do {
            digits[count++] = static_cast<char>('0' + number % 10);
            number /= 10;
            unit /= 10;
        } while (number != 0 || unit > 1);
        while (count > 0) put(digits[--count]);
    }
    void refuse(error::kind k) noexcept
    {
        if (!error_) error_ = k;
    }

    buffer<char> text_;
    affine map_;
    std::int64_t scale_ = 1;
    error error_;
};
static_assert(outline_sink<svg_path_writer>);

}  // namespace typemesh::inline TYPEMESH_ABI
