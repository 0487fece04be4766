// SPDX-License-Identifier: MIT
#pragma once

// three.js, typemesh compiled to WebAssembly: one typed array per attribute, in the module's memory. Right-handed, y
// up, front faces counter-clockwise; v upwards (Texture.flipY is true by default); bitangent = w * cross(normal,
// tangent).
//
//     // JavaScript
//     const geometry = new THREE.BufferGeometry();
//     for (const [name, size] of [['position', 3], ['normal', 3], ['tangent', 4], ['uv', 2]]) {
//         const at = module[`_${name}`]() / 4;                 // a pointer in bytes
//         geometry.setAttribute(name, new THREE.BufferAttribute(module.HEAPF32.slice(at, at + size * vertexCount), size));
//     }
//     geometry.setIndex(new THREE.BufferAttribute(module.HEAPU32.slice(index / 4, index / 4 + indexCount), 1));
//     groups.forEach((g, i) => geometry.addGroup(g.start, g.count, i));     // plan.parts(): one material each

#include <typemesh/text/text_options.hpp>
#include <typemesh/vertex/stream_sink.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace engines::three {

/// Five typed arrays of the caller's: Float32Array with 3, 3, 4 and 2 numbers per vertex, Uint32Array or Uint16Array.
template <class Index = std::uint32_t>
struct buffer_geometry {
    std::span<float> position, normal, tangent, uv;
    std::span<Index> index;
};

[[nodiscard]] inline typemesh::text_options options() noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::right_handed_y_up;
    o.frame.uv = typemesh::uv_origin::bottom_left;
    return o;
}

template <class Plan, class Index>
[[nodiscard]] typemesh::result<void> write(const Plan& plan, const buffer_geometry<Index>& to) noexcept
{
    using namespace typemesh;
    struct float2 {
        float x, y;
    };
    struct float3 {
        float x, y, z;
    };
    struct float4 {
        float x, y, z, w;
    };
    const auto bytes = [](std::span<float> numbers) noexcept { return std::as_writable_bytes(numbers); };
    return plan.write(stream_sink{to.index, stream<attribute::position, float3>::in(bytes(to.position), 0),
                                  stream<attribute::normal, float3>::in(bytes(to.normal), 0),
                                  stream<attribute::tangent, float4>::in(bytes(to.tangent), 0),
                                  stream<attribute::uv, float2>::in(bytes(to.uv), 0)});
}

}  // namespace engines::three
