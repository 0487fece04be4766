// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/affine.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/core/point.hpp>
#include <typemesh/core/result.hpp>
#include <typemesh/outline/impl/dxf_frame.hpp>
#include <typemesh/outline/impl/fixed_point.hpp>
#include <typemesh/outline/outline_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace typemesh::inline TYPEMESH_ABI {

/// An outline sink that writes a drawing for machines that cut and engrave: a DXF file of AutoCAD 2000 (AC1015), in
/// ASCII.
///
///     dxf_writer drawing{{.xx = 10.0, .yy = 10.0}};    // ten millimetres per unit
///     each_outline(*plan, drawing);
///     if (auto done = drawing.finish(); !done) ...
///     fwrite(drawing.text().data(), 1, drawing.text().size(), file);
///
/// Lines are entities LINE, and each curve is one SPLINE of its own degree without inner knots, so it is exact up to
/// the rounding of its points. The pieces of a contour follow each other, and each begins with the same digits with
/// which the one before it ends. A piece whose points are all one after the rounding is left out. Everything lies on
/// the layer 0 in the model space; the unit is the millimetre, by name.
///
/// The file has the sections, tables and dictionaries of a drawing of that version. Older programs, which read only
/// version R12, know no SPLINE: flatten the outlines for them.
///
/// From  AutoCAD 2000 DXF Reference, chapters 2 to 7
class dxf_writer {
public:
    /// `map` is applied to each point. Numbers have six digits after the point.
    explicit dxf_writer(const affine& map = {}, memory source = heap()) noexcept : text_{source}, map_{map} { begin(); }

    void move(point p) noexcept
    {
        close();
        start_ = current_ = rounded(p);
        open_ = true;
    }
    void line(point p) noexcept { add_line(rounded(p)); }
    void quadratic(point control, point p) noexcept { spline({current_, rounded(control), rounded(p)}); }
    void cubic(point control1, point control2, point p) noexcept
    {
        spline({current_, rounded(control1), rounded(control2), rounded(p)});
    }
    void close() noexcept
    {
        if (open_) add_line(start_);
        open_ = false;
    }

    /// Begins a new drawing, and keeps the memory.
    void clear() noexcept
    {
        text_.clear();
        error_ = {};
        open_ = false;
        handle_ = first_handle;
        begin();
    }

    /// Closes the last contour and ends the file; call it once.
    ///
    /// Fails  error::outline_not_finite; error::too_large: a number has more than 9 digits before the point;
    ///        error::bad_outline: a contour does not begin with move(); error::out_of_memory. The text is then
    ///        meaningless
    [[nodiscard]] result<void> finish() noexcept
    {
        close();
        put(detail::dxf_end);
        return error_;
    }

    /// The file so far, which the next call may move.
    [[nodiscard]] std::string_view text() const noexcept { return {text_.data(), text_.size()}; }

private:
    static constexpr std::uint32_t first_handle = 0x100;

    /// A point in millionths of the unit, as it is written.
    struct place {
        std::int64_t x = 0, y = 0;
        friend constexpr bool operator==(place, place) = default;
    };
    [[nodiscard]] place rounded(point p) noexcept
    {
        place made;
        p = map_(p);
        if (const error e = numbers_.round(p.x, made.x)) refuse(e);
        if (const error e = numbers_.round(p.y, made.y)) refuse(e);
        return made;
    }
    void begin() noexcept { put(detail::dxf_begin); }
    void put(std::string_view words) noexcept
    {
        if (error_) return;
        for (const char c : words)
            if (!text_.push_back(c)) {
                error_ = error::out_of_memory;
                return;
            }
    }
    void put_integer(const char* code, std::uint64_t number, std::uint64_t base = 10) noexcept
    {
        put(code);
        char digits[24], *first = digits + 24;
        do *--first = "0123456789ABCDEF"[number % base];
        while ((number /= base) != 0);
        put({first, static_cast<std::size_t>(digits + 24 - first)});
        put("\n");
    }
    void put_number(const char* code, std::int64_t number) noexcept
    {
        put(code);
        put(numbers_.text(number, true));
        put("\n");
    }
    void put_point(const char* x, const char* y, const char* z, place p) noexcept
    {
        put_number(x, p.x);
        put_number(y, p.y);
        put(z);
        put("0.0\n");
    }
    void entity(const char* name, const char* subclass) noexcept
    {
        put("0\n");
        put(name);
        put_integer("\n5\n", handle_++, 16);
        put("330\n");
        put(detail::dxf_model_space);
        put("\n100\nAcDbEntity\n8\n0\n100\n");
        put(subclass);
    }
    void add_line(place p) noexcept
    {
        if (!open_) return refuse(error::bad_outline);
        if (p == current_) return;
        entity("LINE", "AcDbLine\n");
        put_point("10\n", "20\n", "30\n", current_);
        put_point("11\n", "21\n", "31\n", p);
        current_ = p;
    }
    /// A Bezier curve is a spline whose knots are 0 and 1 only, as often as it has points.
    void spline(std::initializer_list<place> points) noexcept
    {
        if (!open_) return refuse(error::bad_outline);
        bool is_point = true;
        for (const place p : points) is_point = is_point && p == current_;
        if (is_point) return;
        const std::uint64_t count = points.size();
        entity("SPLINE", "AcDbSpline\n210\n0.0\n220\n0.0\n230\n1.0\n70\n8\n");
        put_integer("71\n", count - 1);
        put_integer("72\n", 2 * count);
        put_integer("73\n", count);
        put("74\n0\n");
        for (std::uint64_t k = 0; k < 2 * count; ++k) put(k < count ? "40\n0.0\n" : "40\n1.0\n");
        for (const place p : points) put_point("10\n", "20\n", "30\n", current_ = p);
    }
    void refuse(const error& e) noexcept
    {
        if (!error_) error_ = e;
    }

    buffer<char> text_;
    affine map_;
    detail::fixed_point numbers_{6};
    place start_, current_;
    std::uint32_t handle_ = first_handle;
    bool open_ = false;
    error error_;
};
static_assert(outline_sink<dxf_writer>);

}  // namespace typemesh::inline TYPEMESH_ABI
