// SPDX-License-Identifier: MIT
//
// The lines of docs/engines.md for OGRE: tests/run.sh --with engines compiles and runs them.

#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/stream_sink.hpp>

#include <Ogre.h>

#include <cstddef>
#include <cstdint>
#include <span>

using plan_type = typemesh::result<typemesh::text_plan<typemesh::extruded<>>>;

struct vertex {
    typemesh::vec3 position, normal;
    typemesh::vec2 uv;
};

template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal, s.uv}; }
};

typemesh::error ogre_snippet(const plan_type& plan);
typemesh::error ogre_snippet(const plan_type& plan)
{
const auto size = plan->size();
auto& buffers = Ogre::HardwareBufferManager::getSingleton();
auto vertices = buffers.createVertexBuffer(sizeof(vertex), size.vertices, Ogre::HBU_GPU_ONLY);
auto indices = buffers.createIndexBuffer(Ogre::HardwareIndexBuffer::IT_32BIT, size.indices(), Ogre::HBU_GPU_ONLY);
auto written = plan->write(typemesh::into(
    std::span{static_cast<vertex*>(vertices->lock(Ogre::HardwareBuffer::HBL_WRITE_ONLY)), size.vertices},
    std::span{static_cast<std::uint32_t*>(indices->lock(Ogre::HardwareBuffer::HBL_WRITE_ONLY)), size.indices()}));
vertices->unlock();
indices->unlock();

auto mesh = Ogre::MeshManager::getSingleton().createManual("text", Ogre::RGN_DEFAULT);
auto* data = mesh->sharedVertexData = new Ogre::VertexData;
data->vertexCount = size.vertices;
data->vertexBufferBinding->setBinding(0, vertices);
data->vertexDeclaration->addElement(0, offsetof(vertex, position), Ogre::VET_FLOAT3, Ogre::VES_POSITION);
data->vertexDeclaration->addElement(0, offsetof(vertex, normal), Ogre::VET_FLOAT3, Ogre::VES_NORMAL);
data->vertexDeclaration->addElement(0, offsetof(vertex, uv), Ogre::VET_FLOAT2, Ogre::VES_TEXTURE_COORDINATES);
for (auto part : plan->parts()) {                        // front, back, side, bevels: a material for each
    if (plan->range(part).index_count == 0) continue;
    auto* sub = mesh->createSubMesh();
    sub->indexData->indexBuffer = indices;
    sub->indexData->indexStart = plan->range(part).first_index;
    sub->indexData->indexCount = plan->range(part).index_count;
}
const auto [low, high] = plan->bounds();
mesh->_setBounds({Ogre::Vector3{low.x, low.y, low.z}, Ogre::Vector3{high.x, high.y, high.z}});
mesh->load();
    return written.error();
}
