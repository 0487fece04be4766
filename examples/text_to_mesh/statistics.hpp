// SPDX-License-Identifier: MIT
#pragma once

#include "mesh_facts.hpp"
#include "model.hpp"
#include "policies.hpp"

#include <typemesh/typemesh.hpp>

#include <cstdio>
#include <string>
#include <vector>

namespace text_to_mesh {

/// The triangles of the front, as they lie in the mesh.
[[nodiscard]] inline typemesh::triangle_quality quality_of_front(const model& mesh)
{
    std::vector<typemesh::point> points;
    for (const model_vertex& v : mesh.vertices) points.push_back({double{v.position[0]}, double{v.position[1]}});
    std::vector<typemesh::triangle> triangles;
    for (const auto& part : mesh.parts)
        if (part.kind() == "front")
            for (std::size_t i = part.first_index; i < part.first_index + part.index_count; i += 3)
                triangles.push_back({mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    typemesh::triangle_quality q;
    typemesh::add_triangles<typemesh::point>(q, points, triangles);
    return q;
}

/// One line of JSON, with its end. `size` is the mesh's.
template <class Plan>
[[nodiscard]] std::string stats_of(const Plan& plan, const typemesh::mesh_size& size,
                                   const typemesh::triangle_quality& q, const mesh_facts& facts, bool printed,
                                   const stage_clock& clock)
{
    const auto& report = plan.report();
    std::string line = "{";
    const auto add = [&line](const char* key, auto value) {
        line += (line.back() == '{' ? "\"" : ",\"") + std::string{key} + "\":" + std::to_string(value);
    };
    const auto add_measure = [&line](const char* key, double value) {
        char digits[64];
        std::snprintf(digits, sizeof digits, ",\"%s\":%.4g", key, value);
        line += digits;
    };
    add("glyphs", report.glyphs);
    add("refused", report.refused);
    add("missing", report.missing);
    add("contour_points", plan.contour_points());
    add("hard_edges", plan.hard_edges());
    add("vertices", size.vertices);
    add("triangles", size.triangles);
    add("corners_moved", report.corners_moved);
    line += in_json(facts, printed) + ",\"front\":{";
    add("triangles", q.triangles);
    add_measure("smallest_angle", q.smallest_angle);
    add_measure("angle_5_percent", q.angle_at(0.05));
    add_measure("angle_median", q.angle_at(0.5));
    add_measure("largest_aspect", q.largest_aspect);
    line += "},\"nanoseconds\":{";
    const char* names[] = {"shape", "outline", "discretise", "fill", "triangulate", "extrude"};
    for (int i = 0; i < 6; ++i) add(names[i], clock.nanoseconds[i]);
    return line + "}}\n";
}

}  // namespace text_to_mesh
