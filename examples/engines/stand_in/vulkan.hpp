// SPDX-License-Identifier: MIT
#pragma once

// What the recipe takes from <vulkan/vulkan.h>, by the names and values of the specification.

#include <cstdint>

enum VkFormat {
    VK_FORMAT_A2B10G10R10_SNORM_PACK32 = 65,
    VK_FORMAT_R16G16_SFLOAT = 83,
    VK_FORMAT_R32G32B32_SFLOAT = 106,
};
enum VkVertexInputRate { VK_VERTEX_INPUT_RATE_VERTEX = 0 };

struct VkVertexInputBindingDescription {
    std::uint32_t binding;
    std::uint32_t stride;
    VkVertexInputRate inputRate;
};
struct VkVertexInputAttributeDescription {
    std::uint32_t location;
    std::uint32_t binding;
    VkFormat format;
    std::uint32_t offset;
};
