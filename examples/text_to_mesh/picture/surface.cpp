// SPDX-License-Identifier: MIT
#include "surface.hpp"

#include "part_colours.hpp"
#include "raster.hpp"
#include "srgb.hpp"

#include <bit>
#include <cmath>

namespace text_to_mesh {

surface::surface(const model& mesh, const picture_options& options, const camera& from)
    : mesh_(mesh), options_(options), from_(from)
{
    for (const model::part& part : mesh.parts) colours_.push_back(to_linear(colour_of(part).rgb));
    if (colours_.empty()) colours_.push_back(to_linear(colour_of("")));
}

vec3 surface::shade(const flat_triangle& t, double x, double y, int px, int py, unsigned mask) const
{
    const weights w = weigh(t, x, y);
    const double sign = t.turned_away ? -1.0 : 1.0;
    light lit;
    if (options_.shading == shading::flat) {
        const vec3 a = to_vec3(corner(t, 0).position);
        const vec3 n = cross(to_vec3(corner(t, 1).position) - a, to_vec3(corner(t, 2).position) - a);
        lit = light_on(sign * normalised(n));
    } else if (options_.shading == shading::gouraud) {
        for (std::size_t i = 0; i < 3; ++i) {
            const light at = light_on(sign * normalised(to_vec3(corner(t, i).normal)));
            lit.diffuse = lit.diffuse + w.of[i] * at.diffuse;
            lit.gloss = lit.gloss + w.of[i] * at.gloss;
        }
    } else {
        vec3 n;
        for (std::size_t i = 0; i < 3; ++i) n = n + w.of[i] * to_vec3(corner(t, i).normal);
        lit = light_on(sign * normalised(n));
    }
    vec3 base = colours_[t.part];
    if (options_.texture == texture::checker)
        base = mix(mix(base, {0.85, 0.85, 0.85}, 0.85), 0.55 * base, checker(t, px, py, mask));
    return base * lit.diffuse + lit.gloss;
}

double surface::checker(const flat_triangle& t, int px, int py, unsigned mask) const
{
    int dark = 0;
    const int count = std::popcount(mask);
    for (; mask != 0; mask &= mask - 1) {
        const int s = std::countr_zero(mask);
        const weights w = weigh(t, double(px) * pixel_steps + sample_x[s], double(py) * pixel_steps + sample_y[s]);
        double u = 0.0, v = 0.0;
        for (std::size_t i = 0; i < 3; ++i) {
            u += w.of[i] * double{corner(t, i).uv[0]};
            v += w.of[i] * double{corner(t, i).uv[1]};
        }
        const double squares = std::floor(u * double{options_.checks}) + std::floor(v * double{options_.checks});
        dark += squares - 2.0 * std::floor(squares / 2.0) > 0.5 ? 1 : 0;
    }
    return double(dark) / count;
}

}  // namespace text_to_mesh
