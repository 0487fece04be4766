// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/extrude/extruder.hpp>

#include <cmath>
#include <cstdint>

namespace stranger {

/// Letters that turn about their own origin and grow thinner towards the back, in so many steps: from the comment on
/// extruder alone. The points of the levels behind the front are rounded to the grid, which both sides of an edge share.
struct tapering_twist {
    double depth = 0.3;             ///< em
    double turn = 0.2, taper = 0.8; ///< at the back: radians, and the scale
    std::uint32_t steps = 4;

    typemesh::result<typemesh::part_sizes> plan(const typemesh::region& r,
                                                typemesh::buffer<typemesh::side_point>&) const noexcept
    {
        using typemesh::part;
        if (!(depth > 0.0) || steps == 0 || steps > 1000) return typemesh::error::bad("steps");
        const std::uint64_t n = r.points().size();
        if (n * (steps + 1) > 0xFFFF'FFFFu) return typemesh::error::too_large;
        typemesh::part_sizes sizes;
        sizes.vertices[part::front] = sizes.vertices[part::back] = static_cast<std::uint32_t>(n);
        sizes.triangles[part::front] = sizes.triangles[part::back] = r.triangle_count();
        sizes.vertices[part::side] = static_cast<std::uint32_t>(n * (steps + 1));
        sizes.triangles[part::side] = static_cast<std::uint32_t>(2 * n * steps);
        return sizes;
    }
    typemesh::height_range heights() const noexcept { return {-depth, 0.0}; }

    template <typemesh::attribute Wants, class Emit>
    void vertices(typemesh::part p, const typemesh::solid& s, const typemesh::placement& at, Emit&& emit) const noexcept
    {
        using typemesh::attribute;
        const auto put = [&](std::uint32_t i, std::uint32_t level, typemesh::vec3 normal) noexcept {
            typemesh::surface_point<Wants> v;
            const double share = double(level) / steps;
            if constexpr (has(Wants, attribute::position))
                v.position = at.position(turned(s.points[i], share), at.height(-depth * share));
            if constexpr (has(Wants, attribute::normal)) v.normal = normal;
            if constexpr (has(Wants, attribute::uv)) v.uv = {static_cast<float>(i), static_cast<float>(share)};
            emit(v);
        };
        if (p != typemesh::part::side) {
            const bool front = p == typemesh::part::front;
            const float out = front ? 1.0f : -1.0f;
            const typemesh::vec3 t = at.frame.toward, normal{out * t.x, out * t.y, out * t.z};
            for (std::uint32_t i = 0; i < s.points.size(); ++i) put(i, front ? 0 : steps, normal);
            return;
        }
        for (std::size_t k = 0; k + 1 < s.starts.size(); ++k) {
            const std::uint32_t first = s.starts[k], end = s.starts[k + 1];
            for (std::uint32_t i = first; i < end; ++i) {
                const auto before = s.points[i == first ? end - 1 : i - 1], after = s.points[i + 1 == end ? first : i + 1];
                const double x = double(after.y) - before.y, y = double(before.x) - after.x, l = std::hypot(x, y) + 1e-300;
                for (std::uint32_t level = 0; level <= steps; ++level) {
                    const double angle = turn * level / steps, c = std::cos(angle), sn = std::sin(angle);
                    put(i, level, at.normal({static_cast<float>((c * x - sn * y) / l), static_cast<float>((sn * x + c * y) / l)}));
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
    [[nodiscard]] typemesh::grid_point turned(typemesh::grid_point p, double share) const noexcept
    {
        const double scale = 1.0 + (taper - 1.0) * share, c = scale * std::cos(turn * share), s = scale * std::sin(turn * share);
        return {static_cast<std::int32_t>(std::lround(c * p.x - s * p.y)),
                static_cast<std::int32_t>(std::lround(s * p.x + c * p.y))};
    }
};
static_assert(typemesh::extruder<tapering_twist>);

}  // namespace stranger
