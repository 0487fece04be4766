// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/mesh_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace stranger {

/// A binary PLY file. An error of the disk is reported at the end. For little-endian machines. Written only from the comment
/// on mesh_sink.
class ply_sink {
public:
    static constexpr auto wants = typemesh::attribute::position;

    explicit ply_sink(std::FILE* file) noexcept : file_{file} {}

    typemesh::error begin(typemesh::mesh_size exact) noexcept
    {
        char header[300];
        const int length = std::snprintf(header, sizeof header,
                                         "ply\nformat binary_little_endian 1.0\nelement vertex %llu\nproperty float x\n"
                                         "property float y\nproperty float z\nelement face %llu\n"
                                         "property list uchar uint vertex_indices\nend_header\n",
                                         static_cast<unsigned long long>(exact.vertices),
                                         static_cast<unsigned long long>(exact.triangles));
        append(header, static_cast<std::size_t>(length));
        return {};
    }
    void vertex(const typemesh::surface_point<wants>& s) noexcept
    {
        const float place[3] = {s.position.x, s.position.y, s.position.z};
        append(place, sizeof place);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        const std::uint8_t three = 3;
        const std::uint32_t corners[3] = {a, b, c};
        append(&three, 1);
        append(corners, sizeof corners);
    }
    typemesh::error end() noexcept
    {
        const bool whole = std::fflush(file_) == 0 && std::ferror(file_) == 0;
        return whole ? typemesh::error{} : typemesh::error{typemesh::error::not_written};
    }

private:
    void append(const void* bytes, std::size_t count) noexcept { std::fwrite(bytes, 1, count, file_); }

    std::FILE* file_;
};
static_assert(typemesh::mesh_sink<ply_sink>);

}  // namespace stranger
