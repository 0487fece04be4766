// SPDX-License-Identifier: MIT
#pragma once

#include "text_to_mesh/model.hpp"

#include <cmath>
#include <cstdint>

/// A letter O for tests: radii 1 and 0.5, front at z = 0, back at -depth, closed, 8 triangles a step. Its name is hostile to writers.
inline text_to_mesh::model extruded_ring(std::uint32_t steps = 24, float depth = 0.5F)
{
    text_to_mesh::model ring;
    ring.name = "O\nring \xC3\xA9 \xFF";
    const auto vertex = [&](double radius, std::uint32_t step, float z, int normal) {
        const double angle = 2.0 * 3.14159265358979323846 * (step % steps) / steps;
        const auto c = static_cast<float>(std::cos(angle)), s = static_cast<float>(std::sin(angle));
        const auto r = static_cast<float>(radius);
        const auto sign = static_cast<float>(normal == 2 ? 1 : -1);  // 0 front, 1 back, 2 outwards, 3 inwards
        ring.vertices.push_back({{r * c, r * s, z},
                                 {normal < 2 ? 0.0F : sign * c, normal < 2 ? 0.0F : sign * s,
                                  normal == 0 ? 1.0F : (normal == 1 ? -1.0F : 0.0F)},
                                 {0.5F + 0.5F * r * c, 0.5F - 0.5F * r * s}});
        return static_cast<std::uint32_t>(ring.vertices.size() - 1);
    };
    const auto quad = [&](double r0, float z0, double r1, float z1, int normal, std::uint32_t i) {
        const std::uint32_t a = vertex(r0, i, z0, normal), b = vertex(r1, i, z1, normal),
                            c = vertex(r1, i + 1, z1, normal), d = vertex(r0, i + 1, z0, normal);
        for (const std::uint32_t index : {a, b, c, a, c, d}) ring.indices.push_back(index);
    };
    const auto part = [&](const char* name, auto&& fill) {
        const std::size_t first = ring.indices.size();
        for (std::uint32_t i = 0; i < steps; ++i) fill(i);
        ring.parts.push_back({name, first, ring.indices.size() - first});
    };
    part("front", [&](std::uint32_t i) { quad(0.5, 0.0F, 1.0, 0.0F, 0, i); });
    part("back", [&](std::uint32_t i) { quad(1.0, -depth, 0.5, -depth, 1, i); });
    part("side", [&](std::uint32_t i) {
        quad(1.0, 0.0F, 1.0, -depth, 2, i);
        quad(0.5, -depth, 0.5, 0.0F, 3, i);
    });
    return ring;
}
