// SPDX-License-Identifier: MIT
#include "backdrop.hpp"

#include "studio.hpp"

namespace text_to_mesh {

backdrop::backdrop(const model& mesh, const picture_options& options, const view& seen)
    : kind_(options.background), seen_(seen)
{
    if (kind_ == background::studio && !is_flat(mesh)) shadow_ = floor_shadow(mesh);
}

vec3 backdrop::at(int x, int y) const
{
    if (kind_ == background::white) return {1, 1, 1};
    const vec3 plain = studio_backdrop((y + 0.5) / seen_.height);
    const double lit = shadow_.light_along(seen_.from.eye, seen_.from.ray(x + 0.5, y + 0.5));
    return plain * mix(vec3{0.03, 0.04, 0.07}, {1, 1, 1}, lit);  // shadows in daylight are a little blue
}

}  // namespace text_to_mesh
