// SPDX-License-Identifier: MIT
#include "svg_shapes.hpp"

#include "svg_values.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <initializer_list>

namespace text_to_mesh {
namespace {

/// Writes path data.
class data_writer {
public:
    data_writer& operator()(char command, std::initializer_list<double> numbers)
    {
        text_ += command;
        for (const double n : numbers) {
            char digits[40];
            text_.append(digits, std::to_chars(digits, digits + sizeof digits, n).ptr);
            text_ += ' ';
        }
        return *this;
    }
    [[nodiscard]] std::string text() const { return text_; }

private:
    std::string text_;
};

/// The lengths of an element.
class lengths {
public:
    lengths(const svg_attributes& of, const typemesh::box& port) : of_{of}, port_{port} {}

    [[nodiscard]] double x(const char* name) const { return read(name, port_.width()).value_or(0.0); }
    [[nodiscard]] double y(const char* name) const { return read(name, port_.height()).value_or(0.0); }
    [[nodiscard]] double along(const char* name) const
    {
        return read(name, std::hypot(port_.width(), port_.height()) / std::sqrt(2.0)).value_or(0.0);
    }
    /// A radius along x or y: one that is not given is the other one.
    [[nodiscard]] std::optional<double> read(const char* name, double whole) const
    {
        const std::string_view text = of_(name);
        if (text.empty() || text == "auto") return {};
        return read_length(text, whole);
    }

private:
    const svg_attributes& of_;
    typemesh::box port_;
};

std::string rectangle(const lengths& of, const typemesh::box& port)
{
    const double x = of.x("x"), y = of.y("y"), w = of.x("width"), h = of.y("height");
    if (!(w > 0.0) || !(h > 0.0)) return {};
    const auto own_x = of.read("rx", port.width()), own_y = of.read("ry", port.height());
    const double rx = std::clamp(own_x.value_or(own_y.value_or(0.0)), 0.0, 0.5 * w);
    const double ry = std::clamp(own_y.value_or(own_x.value_or(0.0)), 0.0, 0.5 * h);
    data_writer to;
    if (!(rx > 0.0) || !(ry > 0.0)) return to('M', {x, y})('H', {x + w})('V', {y + h})('H', {x})('Z', {}).text();
    to('M', {x + rx, y})('H', {x + w - rx})('A', {rx, ry, 0, 0, 1, x + w, y + ry});
    to('V', {y + h - ry})('A', {rx, ry, 0, 0, 1, x + w - rx, y + h});
    to('H', {x + rx})('A', {rx, ry, 0, 0, 1, x, y + h - ry});
    return to('V', {y + ry})('A', {rx, ry, 0, 0, 1, x + rx, y})('Z', {}).text();
}

std::string ellipse(double cx, double cy, double rx, double ry)
{
    if (!(rx > 0.0) || !(ry > 0.0)) return {};
    data_writer to;
    to('M', {cx + rx, cy})('A', {rx, ry, 0, 0, 1, cx, cy + ry})('A', {rx, ry, 0, 0, 1, cx - rx, cy});
    return to('A', {rx, ry, 0, 0, 1, cx, cy - ry})('A', {rx, ry, 0, 0, 1, cx + rx, cy})('Z', {}).text();
}

/// As far as the points can be read.
std::string polygon(std::string_view points, bool closed)
{
    data_writer to;
    std::size_t count = 0;
    for (;; ++count) {
        const auto x = take_number(points), y = x ? take_number(points) : std::nullopt;
        if (!y) break;
        to(count == 0 ? 'M' : 'L', {*x, *y});
    }
    if (count < 2) return {};
    return closed ? to('Z', {}).text() : to.text();
}

}  // namespace

bool is_shape(std::string_view name)
{
    constexpr std::string_view known[] = {"path", "rect", "circle", "ellipse", "line", "polyline", "polygon"};
    return std::find(std::begin(known), std::end(known), name) != std::end(known);
}

std::string data_of(std::string_view name, const svg_attributes& of, const typemesh::box& port)
{
    const lengths own{of, port};
    if (name == "path") return std::string{of("d")};
    if (name == "rect") return rectangle(own, port);
    if (name == "circle") return ellipse(own.x("cx"), own.y("cy"), own.along("r"), own.along("r"));
    if (name == "ellipse") {
        const auto rx = own.read("rx", port.width()), ry = own.read("ry", port.height());
        return ellipse(own.x("cx"), own.y("cy"), rx.value_or(ry.value_or(0.0)), ry.value_or(rx.value_or(0.0)));
    }
    if (name == "line") return data_writer{}('M', {own.x("x1"), own.y("y1")})('L', {own.x("x2"), own.y("y2")}).text();
    return polygon(of("points"), name == "polygon");
}

}  // namespace text_to_mesh
