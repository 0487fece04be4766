// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/extruder.hpp>

#include <cmath>
#include <cstdint>

namespace stranger {

/// Letters that turn about their own origin and become thinner towards the back, in so many steps. Points are computed once,
/// in plan(), so that all writers write the same ones. Written only from extruder's, plan_arrays' and placement's comments.
struct tapering_twist {
    double depth = 0.3;              ///< em
    double turn = 0.2, taper = 0.8;  ///< at the back: radians, and the scale
    std::uint32_t steps = 4;

    using plan_data = typemesh::plan_arrays<typemesh::solid_point>;  // [ level 0: a point each | level 1: ... | ... ]

    typemesh::option_bits cache_key() const noexcept { return {depth, turn, taper, steps}; }

    typemesh::result<typemesh::solid_plan> plan(const typemesh::region& r, plan_data& data) const noexcept
    {
        using typemesh::part;
        if (!(depth > 0.0) || steps == 0 || steps > 1000) return typemesh::error::bad("steps");
        const std::uint64_t n = r.points().size();
        if (n * (steps + 1) > 0xFFFF'FFFFu) return typemesh::error::too_large;
        auto& levels = data.of<typemesh::solid_point>();
        if (!levels.reserve(n * (steps + 1))) return typemesh::error::out_of_memory;
        typemesh::solid_plan made;
        for (std::uint32_t level = 0; level <= steps; ++level) {
            const double share = double(level) / steps, scale = 1.0 + (taper - 1.0) * share;
            const double c = scale * std::cos(turn * share), s = scale * std::sin(turn * share);
            for (const auto p : r.points()) {
                levels.push_back_unchecked({c * p.x - s * p.y, s * p.x + c * p.y, -depth * share});
                made.around.add({levels.back().x, levels.back().y});
            }
        }
        auto& sizes = made.sizes;
        sizes.vertices[part::front] = sizes.vertices[part::back] = static_cast<std::uint32_t>(n);
        sizes.triangles[part::front] = sizes.triangles[part::back] = r.triangle_count();
        sizes.vertices[part::side] = static_cast<std::uint32_t>(n * (steps + 1));
        sizes.triangles[part::side] = static_cast<std::uint32_t>(2 * n * steps);
        return made;
    }
    typemesh::height_range heights() const noexcept { return {-depth, 0.0}; }

    template <typemesh::attribute Wants, class Emit>
    void vertices(typemesh::part p, const typemesh::solid_with<plan_data>& s, const typemesh::placement& at,
                  Emit&& emit) const noexcept
    {
        using typemesh::attribute;
        const auto levels = s.data.of<typemesh::solid_point>();
        const auto put = [&](std::uint32_t i, std::uint32_t level, const auto& normal) noexcept {
            typemesh::surface_point<Wants> v;
            if constexpr (has(Wants, attribute::position))
                v.position = at.position(levels[level * s.points.size() + i]);
            if constexpr (has(Wants, attribute::normal)) v.normal = at.direction(normal());
            if constexpr (has(Wants, attribute::uv)) v.uv = {static_cast<float>(i), static_cast<float>(level)};
            emit(v);
        };
        if (p != typemesh::part::side) {
            const bool front = p == typemesh::part::front;
            for (std::uint32_t i = 0; i < s.points.size(); ++i)
                put(i, front ? 0 : steps, [&]() noexcept { return typemesh::vec3{0.0f, 0.0f, front ? 1.0f : -1.0f}; });
            return;
        }
        for (std::size_t k = 0; k + 1 < s.starts.size(); ++k) {
            const std::uint32_t first = s.starts[k], end = s.starts[k + 1];
            for (std::uint32_t i = first; i < end; ++i) {
                const std::uint32_t before = i == first ? end - 1 : i - 1, after = i + 1 == end ? first : i + 1;
                for (std::uint32_t level = 0; level <= steps; ++level) {
                    const auto* here = levels.data() + level * s.points.size();
                    put(i, level, [&]() noexcept { return slanted(here[before], here[i], here[after], level, at); });
                }
            }
        }
    }
    template <class Emit>
    void triangles(typemesh::part p, const typemesh::solid& s, const typemesh::first_vertices& first,
                   Emit&& emit) const noexcept
    {
        const std::uint32_t base = first[p];
        if (p == typemesh::part::front)
            for (const typemesh::triangle t : s.triangles) emit(base + t.a, base + t.b, base + t.c);
        if (p == typemesh::part::back)
            for (const typemesh::triangle t : s.triangles) emit(base + t.a, base + t.c, base + t.b);
        if (p != typemesh::part::side) return;
        const std::uint32_t row = steps + 1;
        for (std::size_t k = 0; k + 1 < s.starts.size(); ++k) {
            for (std::uint32_t i = s.starts[k]; i < s.starts[k + 1]; ++i) {
                const std::uint32_t j = i + 1 == s.starts[k + 1] ? s.starts[k] : i + 1;
                for (std::uint32_t level = 0; level < steps; ++level) {
                    const std::uint32_t a = base + row * i + level, b = base + row * j + level;
                    emit(a, a + 1, b + 1);
                    emit(a, b + 1, b);
                }
            }
        }
    }

private:
    /// A normal to the direction along the contour and to the direction down.
    [[nodiscard]] typemesh::vec3 slanted(const typemesh::solid_point& before, const typemesh::solid_point& p,
                                         const typemesh::solid_point& after, std::uint32_t level,
                                         const typemesh::placement& at) const noexcept
    {
        const double tx = after.x - before.x, ty = after.y - before.y, scale = 1.0 + (taper - 1.0) * level / steps;
        const double shrink = (taper - 1.0) / scale, down = depth * at.cells_per_depth();
        const double dx = shrink * p.x - turn * p.y, dy = shrink * p.y + turn * p.x;
        const double x = ty * down, y = -tx * down, z = dy * tx - dx * ty,
                     l = std::sqrt(x * x + y * y + z * z) + 1e-300;
        return {static_cast<float>(x / l), static_cast<float>(y / l), static_cast<float>(-z / l)};
    }
};
static_assert(typemesh::extruder<tapering_twist>);

}  // namespace stranger
