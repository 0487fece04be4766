// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/mesh_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>

namespace stranger {

/// A binary PLY file, written into memory that is as long as it may be (a mapped file): from the comment on mesh_sink alone.
/// For machines that keep the lowest byte first.
class ply_sink {
public:
    static constexpr auto wants = typemesh::attribute::position;

    explicit ply_sink(std::span<std::byte> file) noexcept : file_{file} {}

    typemesh::error begin(typemesh::mesh_size exact) noexcept
    {
        char header[300];
        const int length = std::snprintf(header, sizeof header,
                                         "ply\nformat binary_little_endian 1.0\nelement vertex %llu\nproperty float x\n"
                                         "property float y\nproperty float z\nelement face %llu\n"
                                         "property list uchar uint vertex_indices\nend_header\n",
                                         static_cast<unsigned long long>(exact.vertices),
                                         static_cast<unsigned long long>(exact.triangles));
        const std::uint64_t needed = static_cast<std::uint64_t>(length) + 12 * exact.vertices + 13 * exact.triangles;
        if (needed > file_.size()) return typemesh::error::short_of("bytes", needed);
        size_ = 0;
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
    void end() noexcept {}

    [[nodiscard]] std::size_t size() const noexcept { return size_; }  ///< of the file, in bytes

private:
    void append(const void* bytes, std::size_t count) noexcept
    {
        std::memcpy(file_.data() + size_, bytes, count);
        size_ += count;
    }

    std::span<std::byte> file_;
    std::size_t size_ = 0;
};
static_assert(typemesh::mesh_sink<ply_sink>);

}  // namespace stranger
