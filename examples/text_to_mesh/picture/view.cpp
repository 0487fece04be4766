// SPDX-License-Identifier: MIT
#include "view.hpp"

#include "view_fit.hpp"

#include <algorithm>
#include <optional>

namespace text_to_mesh {
namespace {

/// Half the picture's longer side at distance one: a long lens, so that all letters show about the same walls.
constexpr double lens = 0.14;

struct extent {
    double left = 1e30, right = -1e30, top = 1e30, bottom = -1e30;

    void add(double x, double y)
    {
        left = (std::min)(left, x);
        right = (std::max)(right, x);
        top = (std::min)(top, y);
        bottom = (std::max)(bottom, y);
    }
};

extent extent_of(const model& mesh, const overlay& over, const camera& from)
{
    extent e;
    each_point(mesh, over, [&](vec3 p) {
        const camera::projected q = from.project(p);
        e.add(q.x, q.y);
    });
    return e;
}

/// Turned as asked, or so that the text shows its walls; wide texts climb too much across the picture when turned far.
camera turned_camera(const model& mesh, const overlay& over, const picture_options& options)
{
    const bool flat = is_flat(mesh);
    double ratio = 0.0;
    if (!mesh.indices.empty()) {
        extent front;
        each_point(mesh, over, [&](vec3 p) { front.add(p.x, p.y); });
        if (front.bottom > front.top) ratio = (front.right - front.left) / (front.bottom - front.top);
    }
    const double wide = clamp01((ratio - 3.0) / 6.0), very_wide = clamp01((ratio - 9.0) / 30.0);
    const auto angle = [&](const std::optional<float>& asked, double usual) {
        return asked ? double{*asked} : (flat ? 0.0 : usual);
    };
    return camera::turned(angle(options.yaw, -26.0 + 4.0 * wide + 8.0 * very_wide),
                          angle(options.pitch, 12.0 - 3.0 * wide - 3.0 * very_wide));
}

/// How high to wide the model is, seen from there.
double ratio_seen(const model& mesh, const overlay& over, camera from)
{
    view_fit square(from, lens, lens);
    each_point(mesh, over, [&](vec3 p) { square.add(p); });
    if (square.empty()) return 9.0 / 16.0;
    from.eye = square.eye();
    const extent seen = extent_of(mesh, over, from);
    if (seen.right > seen.left) return (seen.bottom - seen.top) / (seen.right - seen.left);
    return seen.bottom > seen.top ? 1e6 : 9.0 / 16.0;
}

}  // namespace

bool is_flat(const model& mesh)
{
    for (const std::uint32_t i : mesh.indices)
        if (mesh.vertices[i].position[2] != mesh.vertices[mesh.indices[0]].position[2]) return false;
    return true;
}

view view_of(const model& mesh, const overlay& over, const picture_options& options)
{
    view out;
    out.from = turned_camera(mesh, over, options);
    const double border = double{options.margin};
    const double ratio = ratio_seen(mesh, over, out.from);

    out.width = options.width > 0 ? (std::min)(options.width, 8192) : 1280;
    out.height = (std::min)(options.height, 8192);
    if (out.height <= 0) {
        const double free = 2.0 * border * out.width;
        out.height = static_cast<int>((std::max)(360.0, (std::min)(960.0, ratio * (out.width - free) + free)));
        if (options.width <= 0 && out.height == 960) {
            const double upright_free = 2.0 * border * 960.0;
            out.width =
                static_cast<int>((std::max)(480.0, (std::min)(1280.0, (960.0 - upright_free) / ratio + upright_free)));
        }
    }

    const double longer = (std::max)(out.width, out.height);
    out.from.pixels = longer / 2.0 / lens;
    out.from.centre_x = out.width / 2.0;
    out.from.centre_y = out.height / 2.0;
    const auto usable = [&](int side) {
        return (std::max)(0.1 * side, side / 2.0 - border * longer) / out.from.pixels;
    };
    view_fit fit(out.from, usable(out.width), usable(out.height));
    each_point(mesh, over, [&](vec3 p) { fit.add(p); });
    if (fit.empty()) return out;
    out.from.eye = fit.eye();
    const extent seen = extent_of(mesh, over, out.from);  // the looser direction is centred by shifting the lens
    out.from.centre_x += (out.width - seen.left - seen.right) / 2.0;
    out.from.centre_y += (out.height - seen.top - seen.bottom) / 2.0;
    return out;
}

}  // namespace text_to_mesh
