// SPDX-License-Identifier: MIT
#pragma once

// A wavefront before it moves, without the joins and levels that sweep_inwards() adds, and what is true of its links.

#include <typemesh/core/workspace.hpp>
#include <typemesh/fill/fill.hpp>
#include <typemesh/offset/impl/wavefront.hpp>
#include <typemesh/triangulate/monotone.hpp>

#include "support/regions.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace test {

using typemesh::detail::kinetic_triangles;
using typemesh::detail::wavefront;

/// All is one component.
inline void set_up(wavefront& front, const shape& s)
{
    using namespace typemesh;
    contours loops = contours_of(s);
    workspace space;
    triangle_list triangles;
    const auto filled = fill(loops, fill_rule::non_zero, space);
    if (!filled || monotone{}(*filled, space, triangles)) throw std::runtime_error("no region: " + s.name);
    kinetic_triangles& mesh = front.mesh;
    const region& r = *filled;
    bool fits = true;
    for (std::uint32_t loop = 0; loop < r.loop_count(); ++loop) {
        const std::uint32_t first = r.starts()[loop], end = r.starts()[loop + 1];
        for (std::uint32_t i = first; i < end; ++i) {
            const std::uint32_t next = i + 1 == end ? first : i + 1, last = i == first ? end - 1 : i - 1;
            const grid_point p = r.points()[i], q = r.points()[next];
            fits = fits &&
                   mesh.lines.push_back({detail::unit_along({std::int64_t{q.x} - p.x, std::int64_t{q.y} - p.y})}) &&
                   mesh.vertices.push_back({{detail::place_of(p), 0, {}}, last, i}) &&
                   mesh.segments.push_back({i, i, next, 0, 0, true}) && front.nodes.push_back({p}) &&
                   front.node_of.push_back(i) && front.ends_of.push_back({});
        }
    }
    const auto corners = static_cast<std::uint32_t>(r.points().size());
    for (auto& v : mesh.vertices) v.moves.speed = detail::speed_of(mesh.lines[v.before], mesh.lines[v.after], false);
    for (const triangle t : triangles) fits = fits && mesh.triangles.push_back({{t.a, t.b, t.c}});
    if (!fits || !front.live.push_back(corners)) throw std::runtime_error("no memory for the test's own wavefront");
    std::vector<std::uint32_t> scratch(2 * corners + 3 * mesh.triangles.size());
    mesh.link_all(corners, scratch.data());
}

/// What is wrong with the links of the living; empty if nothing is. All that is adjacent says so mutually and has the
/// same corners.
inline std::string broken_link(const kinetic_triangles& mesh)
{
    const auto at = [](const char* what, std::uint32_t i) { return what + (" " + std::to_string(i)); };
    for (std::uint32_t h = 0; h < 3 * mesh.triangles.size(); ++h) {
        if (!mesh.triangles[h / 3].alive) continue;
        const std::uint32_t link = mesh.link(h), to = mesh.origin(kinetic_triangles::next(h));
        if (kinetic_triangles::is_segment(link)) {
            const auto& s = mesh.segments[kinetic_triangles::segment_in(link)];
            if (!s.alive) return at("a dead segment at half-edge", h);
            if (s.half != h) return at("a segment does not know half-edge", h);
            if (s.from != mesh.origin(h) || s.to != to) return at("a segment has other corners than half-edge", h);
        } else {
            if (!mesh.triangles[link / 3].alive) return at("a dead twin of half-edge", h);
            if (mesh.link(link) != h) return at("a twin does not know half-edge", h);
            if (mesh.origin(link) != to || mesh.origin(kinetic_triangles::next(link)) != mesh.origin(h))
                return at("a twin has other corners than half-edge", h);
        }
    }
    for (std::uint32_t s = 0; s < mesh.segments.size(); ++s) {
        const auto& one = mesh.segments[s];
        if (!one.alive) continue;
        if (mesh.link(one.half) != kinetic_triangles::to_segment(s)) return at("no half-edge knows segment", s);
        if (mesh.vertices[one.from].after != s) return at("no corner begins segment", s);
        if (mesh.vertices[one.to].before != s) return at("no corner ends segment", s);
    }
    return {};
}

}  // namespace test
