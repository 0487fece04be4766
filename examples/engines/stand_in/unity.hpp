// SPDX-License-Identifier: MIT
#pragma once

// UnityEngine's Mesh.MeshData as its documentation has it: it computes strides and sizes itself, from the descriptors.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace UnityEngine::Rendering {

enum class VertexAttribute { Position, Normal, Tangent, Color, TexCoord0 };
enum class VertexAttributeFormat { Float32, Float16, UNorm8, SNorm8, UNorm16, SNorm16 };
enum class IndexFormat { UInt16, UInt32 };

struct VertexAttributeDescriptor {
    VertexAttribute attribute;
    VertexAttributeFormat format;
    int dimension;
    int stream;

    [[nodiscard]] std::size_t bytes() const
    {
        const std::size_t one = format == VertexAttributeFormat::Float32 ? 4
                                : format == VertexAttributeFormat::UNorm8 || format == VertexAttributeFormat::SNorm8
                                    ? 1
                                    : 2;
        return one * static_cast<std::size_t>(dimension);
    }
};

class MeshData {
public:
    /// False where the documentation says that the layout is refused.
    bool SetVertexBufferParams(int count, const std::vector<VertexAttributeDescriptor>& attributes)
    {
        std::size_t stride[4] = {};
        for (std::size_t i = 0; i < attributes.size(); ++i) {
            if (attributes[i].bytes() % 4 != 0 || attributes[i].stream < 0 || attributes[i].stream > 3) return false;
            if (i > 0 && attributes[i].attribute <= attributes[i - 1].attribute) return false;
            stride[attributes[i].stream] += attributes[i].bytes();
        }
        for (std::size_t s = 0; s < 4; ++s)
            streams_[s].assign(stride[s] * static_cast<std::size_t>(count), std::byte{0xEE});
        return true;
    }
    void SetIndexBufferParams(int count, IndexFormat format)
    {
        indices_.assign(static_cast<std::size_t>(count) * (format == IndexFormat::UInt16 ? 2u : 4u), std::byte{0xEE});
    }
    std::vector<std::byte>& GetVertexData(std::size_t stream) { return streams_[stream]; }
    std::vector<std::byte>& GetIndexData() { return indices_; }

private:
    std::vector<std::byte> streams_[4];
    std::vector<std::byte> indices_;
};

}  // namespace UnityEngine::Rendering
