// SPDX-License-Identifier: MIT
#include "picture.hpp"

#include "painter.hpp"
#include "view.hpp"

#include <algorithm>

namespace text_to_mesh {

double pixels_per_unit(const model& mesh, const picture_options& options)
{
    const camera from = view_of(mesh, {}, options).from;
    double most = 0.0;
    each_point(mesh, {}, [&](vec3 p) { most = (std::max)(most, from.pixels * from.project(p).inverse); });
    return most;
}

std::vector<unsigned char> draw(const model& mesh, const overlay& over, const picture_options& options, int& w, int& h)
{
    painter one(mesh, over, options);
    w = one.width();
    h = one.height();
    return one.paint();
}

}  // namespace text_to_mesh
