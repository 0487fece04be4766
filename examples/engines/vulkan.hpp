// SPDX-License-Identifier: MIT
#pragma once

// Vulkan: one interleaved vertex of 24 bytes, written into mapped, write-combined memory, several texts in one buffer.
// Vulkan has no world space of its own; this recipe's is right-handed with y up, v downwards as images lie in memory.
// In clip space y points down: with the customary flipped viewport (negative height, VK_KHR_maintenance1, core since
// 1.1) the front faces are VK_FRONT_FACE_COUNTER_CLOCKWISE.
//
// VK_FORMAT_A2B10G10R10_SNORM_PACK32 is not a format that every device must support for vertices: query
// vkGetPhysicalDeviceFormatProperties(...).bufferFeatures for VK_FORMAT_FEATURE_VERTEX_BUFFER_BIT once, and if it is
// missing use snorm8 x 4 instead (VK_FORMAT_R8G8B8A8_SNORM, which every device has; the same 4 bytes).
//
// Include <vulkan/vulkan.h> first.
//
//     engines::vulkan::room room{mapped_vertices, mapped_indices};          // spans of bytes
//     auto plan = mesher.plan("Hello", engines::vulkan::options());
//     if (!plan) return plan.error();
//     auto hello = room.add(*plan);
//     if (!hello) return hello.error();
//     vkCmdDrawIndexed(commands, hello->index_count, 1, hello->first_index, 0, 0);

#include <typemesh/core/result.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/half.hpp>
#include <typemesh/vertex/ten_bit.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace engines::vulkan {

struct vertex {
    float position[3];
    typemesh::snorm10 normal;
    typemesh::snorm10 tangent;
    typemesh::half uv[2];
};
static_assert(sizeof(vertex) == 24);

inline constexpr VkVertexInputBindingDescription binding{0, sizeof(vertex), VK_VERTEX_INPUT_RATE_VERTEX};
inline constexpr VkVertexInputAttributeDescription attributes[] = {
    {0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0},
    {1, 0, VK_FORMAT_A2B10G10R10_SNORM_PACK32, 12},
    {2, 0, VK_FORMAT_A2B10G10R10_SNORM_PACK32, 16},
    {3, 0, VK_FORMAT_R16G16_SFLOAT, 20},
};

[[nodiscard]] inline typemesh::text_options options() noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::right_handed_y_up;
    return o;
}

/// Two mapped buffers that fill up with texts. Indices have 32 bits and count from the first vertex of the buffer, so
/// that texts can be drawn together.
struct room {
    struct drawn {
        std::uint32_t first_index = 0, index_count = 0;
    };

    std::span<std::byte> vertices;
    std::span<std::byte> indices;
    std::uint32_t vertex_count = 0;
    std::uint32_t index_count = 0;

    template <class Plan>
    [[nodiscard]] typemesh::result<drawn> add(const Plan& plan) noexcept;
};

}  // namespace engines::vulkan

template <>
struct typemesh::vertex_traits<engines::vulkan::vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::tangent | attribute::uv;
    engines::vulkan::vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {{s.position.x, s.position.y, s.position.z},
                {s.normal.x, s.normal.y, s.normal.z},
                {s.tangent.x, s.tangent.y, s.tangent.z, s.tangent.w},
                {s.uv.x, s.uv.y}};
    }
};

/// Fails as array_sink does; the room is then unchanged.
template <class Plan>
typemesh::result<engines::vulkan::room::drawn> engines::vulkan::room::add(const Plan& plan) noexcept
{
    const std::span all_vertices{reinterpret_cast<vertex*>(vertices.data()), vertices.size() / sizeof(vertex)};
    const std::span all_indices{reinterpret_cast<std::uint32_t*>(indices.data()), indices.size() / 4};
    if (const auto written = plan.write(
            typemesh::into(all_vertices.subspan(vertex_count), all_indices.subspan(index_count), vertex_count));
        !written)
        return written.error();
    const drawn here{index_count, static_cast<std::uint32_t>(plan.size().indices())};
    vertex_count += static_cast<std::uint32_t>(plan.size().vertices);
    index_count += here.index_count;
    return here;
}
