// SPDX-License-Identifier: MIT
#include "write_stl.hpp"

#include "byte_writer.hpp"

#include <cmath>

namespace text_to_mesh {
namespace {

struct direction {
    float x, y, z;
};

/// In double, so that slivers still get the right normal.
direction facet_normal(const float* a, const float* b, const float* c)
{
    const double u[3] = {double(b[0]) - a[0], double(b[1]) - a[1], double(b[2]) - a[2]};
    const double v[3] = {double(c[0]) - a[0], double(c[1]) - a[1], double(c[2]) - a[2]};
    const double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(length > 0.0)) return {0.0F, 0.0F, 0.0F};
    return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length), static_cast<float>(n[2] / length)};
}

}  // namespace

std::string write_stl(const model& mesh, const std::string& path, file_set& files)
{
    byte_writer out;
    const std::size_t triangles = mesh.indices.size() / 3;
    out.reserve(84 + triangles * 50);
    // It must not begin with "solid", which announces the text form.
    std::string header = "binary STL written by typemesh";
    header.resize(80, ' ');
    out.text(header);
    out.u32(static_cast<std::uint32_t>(triangles));
    for (std::size_t t = 0; t < triangles; ++t) {
        const float* corner[3];
        for (std::size_t i = 0; i < 3; ++i) corner[i] = mesh.vertices[mesh.indices[3 * t + i]].position;
        const direction n = facet_normal(corner[0], corner[1], corner[2]);
        out.f32(n.x);
        out.f32(n.y);
        out.f32(n.z);
        for (const float* p : corner)
            for (int i = 0; i < 3; ++i) out.f32(p[i] + 0.0F);  // -0 becomes 0: some readers weld by bits
        out.u16(0);
    }
    return files.add(path, out.bytes());
}

}  // namespace text_to_mesh
