// SPDX-License-Identifier: MIT
#pragma once

#include "model.hpp"
#include "policies.hpp"

#include <typemesh/typemesh.hpp>

#include <cstdio>
#include <string_view>
#include <vector>

namespace text_to_mesh {

/// The triangles of the front, as they lie in the mesh.
[[nodiscard]] inline typemesh::triangle_quality quality_of_front(const model& mesh)
{
    std::vector<typemesh::point> points;
    for (const model_vertex& v : mesh.vertices) points.push_back({double{v.position[0]}, double{v.position[1]}});
    std::vector<typemesh::triangle> triangles;
    for (const auto& part : mesh.parts)
        if (part.name == "front" || (part.colour && part.name.starts_with("front_") && part.name[6] <= '9'))
            for (std::size_t i = part.first_index; i < part.first_index + part.index_count; i += 3)
                triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    typemesh::triangle_quality q;
    typemesh::add_triangles<typemesh::point>(q, points, triangles);
    return q;
}

/// One line of JSON on standard output.
template <class Plan>
void print_stats(const Plan& plan, const typemesh::triangle_quality& q, const stage_clock& clock)
{
    const auto& report = plan.report();
    std::printf(
        "{\"glyphs\":%u,\"refused\":%u,\"missing\":%u,\"contour_points\":%llu,\"hard_edges\":%llu,\"vertices\":%llu,"
        "\"triangles\":%llu",
        report.glyphs, report.refused, report.missing, static_cast<unsigned long long>(plan.contour_points()),
        static_cast<unsigned long long>(plan.hard_edges()), static_cast<unsigned long long>(plan.size().vertices),
        static_cast<unsigned long long>(plan.size().triangles));
    std::printf(
        ",\"corners_moved\":%llu,\"front\":{\"triangles\":%llu,\"smallest_angle\":%.4g,\"angle_5_percent\":%.4g,"
        "\"angle_median\":%.4g,"
        "\"largest_aspect\":%.4g}",
        static_cast<unsigned long long>(report.corners_moved), static_cast<unsigned long long>(q.triangles),
        q.smallest_angle, q.angle_at(0.05), q.angle_at(0.5), q.largest_aspect);
    const char* names[] = {"shape", "outline", "discretise", "fill", "triangulate", "extrude"};
    std::printf(",\"nanoseconds\":{");
    for (int i = 0; i < 6; ++i)
        std::printf("%s\"%s\":%lld", i > 0 ? "," : "", names[i], static_cast<long long>(clock.nanoseconds[i]));
    std::puts("}}");
}

}  // namespace text_to_mesh
