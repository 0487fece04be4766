// SPDX-License-Identifier: MIT
#include "option_values.hpp"

#include <typemesh/glyph/coarsened.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace text_to_mesh {
namespace {

template <std::size_t N>
bool copy_tag(std::string_view tag, char (&out)[N])
{
    if (tag.size() != 4) return false;
    std::copy(tag.begin(), tag.end(), out);
    return true;
}

}  // namespace

std::optional<double> decimal(std::string_view written)
{
    double value = 0.0;
    const char* const end = written.data() + written.size();
    const auto read = std::from_chars(written.data(), end, value);
    if (read.ec != std::errc{} || read.ptr != end || !std::isfinite(value)) return {};
    return value;
}

std::optional<typemesh::variation> read_variation(std::string_view written)
{
    const auto equals = written.find('=');
    typemesh::variation v;
    if (equals == std::string_view::npos || !copy_tag(written.substr(0, equals), v.tag)) return {};
    const auto value = decimal(written.substr(equals + 1));
    if (!value) return {};
    v.value = static_cast<float>(*value);
    if (!std::isfinite(v.value)) return {};
    return v;
}

std::optional<typemesh::feature> read_feature(std::string_view written)
{
    typemesh::feature f;
    if (!written.empty() && (written[0] == '-' || written[0] == '+')) {
        f.value = written[0] == '+';
        written.remove_prefix(1);
    } else if (const auto equals = written.find('='); equals != std::string_view::npos) {
        const auto value = decimal(written.substr(equals + 1));
        if (!value || *value < 0.0 || *value > 65535.0 || *value != std::floor(*value)) return {};
        f.value = static_cast<std::uint32_t>(*value);
        written = written.substr(0, equals);
    }
    if (!copy_tag(written, f.tag)) return {};
    return f;
}

std::string read_profile(std::string_view written, typemesh::profile_points& out)
{
    const std::string given = '"' + std::string{written} + '"';
    std::vector<typemesh::profile_point> points;
    for (;;) {
        const auto end = written.find(';'), comma = written.substr(0, end).find(',');
        const auto t = decimal(written.substr(0, comma));
        const auto h = comma == std::string_view::npos ? t : decimal(written.substr(0, end).substr(comma + 1));
        if (!t || !h || comma == std::string_view::npos)
            return "must be chamfer, round, concave, stepped, engraved or points such as 0,0;0.2,0.8;1,1, not " + given;
        const typemesh::profile_point p{static_cast<float>(*t), static_cast<float>(*h)};
        if (!points.empty() && p.t < points.back().t)
            return "must have rising t, but t falls at " + std::string{written.substr(0, end)} + " in " + given;
        if (!(p.h >= 0.0f && p.h <= 1.0f)) return "must have each h from 0 to 1, not " + given;
        points.push_back(p);
        if (end == std::string_view::npos) break;
        written.remove_prefix(end + 1);
    }
    out = typemesh::profile_points{points};
    if (points.size() > typemesh::profile_points::most)
        return "must have at most " + std::to_string(typemesh::profile_points::most) + " points, not " +
               std::to_string(points.size());
    return out.is_valid() ? std::string{} : "must begin at 0,0 and end at t = 1, not " + given;
}

std::string read_levels(std::string_view written, std::vector<double>& out)
{
    constexpr std::size_t most = typemesh::coarsened::max_levels;
    const std::string given = '"' + std::string{written} + '"';
    out.clear();
    for (;;) {
        const auto comma = written.find(',');
        const auto em = decimal(written.substr(0, comma));
        if (!em || !(*em > 0.0)) return "must be positive numbers such as 0.01,0.04, not " + given;
        if (!out.empty() && *em <= out.back()) return "must be rising numbers, not " + given;
        if (out.size() == most) return "must have at most " + std::to_string(most) + " levels, not " + given;
        out.push_back(*em);
        if (comma == std::string_view::npos) return {};
        written.remove_prefix(comma + 1);
    }
}

bool read_box(std::string_view written, double& width, double& height)
{
    const auto cross = written.find('x');
    if (cross == std::string_view::npos) return false;
    const auto w = decimal(written.substr(0, cross)), h = decimal(written.substr(cross + 1));
    width = w.value_or(0.0);
    height = h.value_or(0.0);
    return width > 0.0 && width <= 1e6 && height > 0.0 && height <= 1e6;
}

std::string with_line_breaks(std::string text)
{
    for (std::size_t i = 0; (i = text.find("\\n", i)) != std::string::npos; ++i) text.replace(i, 2, "\n");
    return text;
}

std::string joined(const std::vector<std::string>& names)
{
    std::string all;
    for (std::size_t i = 0; i < names.size(); ++i)
        all += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + names[i];
    return all;
}

}  // namespace text_to_mesh
