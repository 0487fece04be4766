// SPDX-License-Identifier: MIT
#include "placing.hpp"

#include "option_values.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace text_to_mesh {
namespace {

constexpr std::string_view forms =
    "must be some of left, centre, right; baseline, bottom, middle, top; front, halfway, base, joined by commas, not ";

/// Takes a word. Gives which axis it is for, or none (3).
std::size_t take(std::string_view word, placing& out)
{
    using across = placing::across;
    using upwards = placing::upwards;
    using depth = placing::depth;
    if (word == "left") return out.x = across::left, 0;
    if (word == "centre" || word == "center") return out.x = across::centre, 0;
    if (word == "right") return out.x = across::right, 0;
    if (word == "baseline") return out.y = upwards::baseline, 1;
    if (word == "bottom") return out.y = upwards::bottom, 1;
    if (word == "middle") return out.y = upwards::middle, 1;
    if (word == "top") return out.y = upwards::top, 1;
    if (word == "front") return out.z = depth::front, 2;
    if (word == "halfway") return out.z = depth::halfway, 2;
    if (word == "base") return out.z = depth::base, 2;
    return 3;
}

}  // namespace

std::string read_anchor(std::string_view written, placing& out)
{
    std::array<bool, 3> given{};
    for (std::string_view rest = written;;) {
        const auto comma = rest.find(',');
        const std::size_t axis = take(rest.substr(0, comma), out);
        if (axis == 3) return std::string{forms} + std::string{written};
        if (given[axis]) return "may have only one word for each direction, not " + std::string{written};
        given[axis] = true;
        if (comma == std::string_view::npos) return {};
        rest.remove_prefix(comma + 1);
    }
}

std::string read_origin(std::string_view written, placing& out)
{
    const std::string wrong =
        "must be two or three numbers from -1000000 to 1000000, such as 10,20 or 0,0,5, not " + std::string{written};
    std::size_t count = 0;
    for (std::string_view rest = written;; ++count) {
        const auto comma = rest.find(',');
        const auto number = decimal(rest.substr(0, comma));
        if (count == 3 || !number || std::fabs(*number) > 1e6) return wrong;
        out.at[count] = *number;
        if (comma == std::string_view::npos) return count == 0 ? wrong : std::string{};
        rest.remove_prefix(comma + 1);
    }
}

shift shift_of(const placing& p, const typemesh::bounds3& bounds)
{
    const auto between = [](float low, float high, double share) {
        return double{low} + share * (double{high} - double{low});
    };
    const auto x = [&](double share) { return p.at[0] - between(bounds.low.x, bounds.high.x, share); };
    const auto y = [&](double share) { return p.at[1] - between(bounds.low.y, bounds.high.y, share); };
    const auto z = [&](double share) { return p.at[2] - between(bounds.low.z, bounds.high.z, share); };
    shift by{p.at[0], p.at[1], p.at[2]};
    switch (p.x) {
    case placing::across::left: by.x = x(0.0); break;
    case placing::across::centre: by.x = x(0.5); break;
    case placing::across::right: by.x = x(1.0); break;
    case placing::across::own: break;
    }
    switch (p.y) {
    case placing::upwards::bottom: by.y = y(0.0); break;
    case placing::upwards::middle: by.y = y(0.5); break;
    case placing::upwards::top: by.y = y(1.0); break;
    case placing::upwards::baseline: break;
    }
    switch (p.z) {
    case placing::depth::front: by.z = z(1.0); break;
    case placing::depth::halfway: by.z = z(0.5); break;
    case placing::depth::base: by.z = z(0.0); break;
    case placing::depth::automatic: break;
    }
    return by;
}

bool lift(model& mesh, double by)
{
    if (by == 0.0) return true;
    const auto moved = [by](float z) { return static_cast<float>(double{z} + by); };
    if (!mesh.places.empty()) {
        for (model::place& p : mesh.places) p.at[2] = moved(p.at[2]);
        return true;
    }
    using corner = std::array<float, 3>;
    std::vector<corner> corners;
    corners.reserve(mesh.vertices.size());
    for (model_vertex& v : mesh.vertices) {
        corners.push_back({v.position[0], v.position[1], v.position[2]});
        v.position[2] = moved(v.position[2]);
    }
    for (model::vertex_letter& l : mesh.vertex_letters) l.pivot[2] = moved(l.pivot[2]);
    std::sort(corners.begin(), corners.end());
    return std::adjacent_find(corners.begin(), corners.end(), [&](const corner& a, const corner& b) {
               return a[0] == b[0] && a[1] == b[1] && a[2] != b[2] && moved(a[2]) == moved(b[2]);
           }) == corners.end();
}

}  // namespace text_to_mesh
