// SPDX-License-Identifier: MIT
//
// OGRE's own eyes on the mesh that the recipe in docs/engines.md makes. No render system is needed: OGRE's buffers lie in
// the processor's memory then.

#include <Ogre.h>
#include <OgreDefaultHardwareBufferManager.h>
#include <OgreEdgeListBuilder.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "engines/recipe_laws.hpp"

typemesh::error ogre_snippet(const typemesh::result<typemesh::text_plan<typemesh::extruded<>>>& plan);

using namespace recipes;

namespace {

/// OGRE without a window, a configuration or a log file.
struct session {
    session()
    {
        log.createLog("", true, false, true);
        root = new Ogre::Root("", "", "");
        buffers = new Ogre::DefaultHardwareBufferManager;
        Ogre::MeshManager::getSingleton().setBoundsPaddingFactor(0.0f);  // boxes as they were told
    }
    ~session()
    {
        Ogre::MeshManager::getSingleton().removeAll();
        delete buffers;
        delete root;
    }
    Ogre::LogManager log;
    Ogre::Root* root;
    Ogre::DefaultHardwareBufferManager* buffers;
};

/// Calls `use` for each value of an attribute in the vertices that all submeshes share.
template <class Use>
void each(const Ogre::VertexData& data, Ogre::VertexElementSemantic semantic, Use use)
{
    const Ogre::VertexElement* element = data.vertexDeclaration->findElementBySemantic(semantic);
    REQUIRE(element != nullptr);
    const auto buffer = data.vertexBufferBinding->getBuffer(element->getSource());
    auto* bytes = static_cast<unsigned char*>(buffer->lock(Ogre::HardwareBuffer::HBL_READ_ONLY));
    for (std::size_t i = 0; i < data.vertexCount; ++i) {
        float values[3] = {};
        std::memcpy(values, bytes + i * buffer->getVertexSize() + element->getOffset(), element->getSize());
        use(values);
    }
    buffer->unlock();
}

}  // namespace

TEST_CASE("OGRE's buffers hold the mesh, a submesh for each part, and OGRE finds it closed", "[engines]")
{
    const session s;
    bench b;
    const auto plan = b.mesher.plan(word, {});
    REQUIRE(plan);
    REQUIRE_FALSE(ogre_snippet(plan));
    const Ogre::MeshPtr mesh = Ogre::MeshManager::getSingleton().getByName("text", Ogre::RGN_DEFAULT);
    REQUIRE(mesh);
    REQUIRE(mesh->isLoaded());

    seen held;
    const Ogre::VertexData& vertices = *mesh->sharedVertexData;
    each(vertices, Ogre::VES_POSITION, [&](const float* v) { held.position.push_back({v[0], v[1], v[2]}); });
    each(vertices, Ogre::VES_NORMAL, [&](const float* v) { held.normal.push_back({v[0], v[1], v[2]}); });
    each(vertices, Ogre::VES_TEXTURE_COORDINATES, [&](const float* v) { held.uv.push_back({v[0], v[1]}); });
    REQUIRE(mesh->getNumSubMeshes() == plan->parts().size());
    for (std::size_t i = 0; i < plan->parts().size(); ++i) {
        const Ogre::SubMesh& part_mesh = *mesh->getSubMesh(i);
        const auto range = plan->range(plan->parts()[i]);
        REQUIRE(part_mesh.useSharedVertices);
        CHECK(part_mesh.indexData->indexStart == range.first_index);
        CHECK(part_mesh.indexData->indexCount == range.index_count);
        const auto indices = part_mesh.indexData->indexBuffer;
        REQUIRE(indices->getType() == Ogre::HardwareIndexBuffer::IT_32BIT);
        auto* numbers = static_cast<std::uint32_t*>(indices->lock(Ogre::HardwareBuffer::HBL_READ_ONLY));
        held.index.insert(held.index.end(), numbers + part_mesh.indexData->indexStart,
                          numbers + part_mesh.indexData->indexStart + part_mesh.indexData->indexCount);
        indices->unlock();
    }
    obeys(held, *plan, gltf);

    // OGRE joins vertices in one place by itself, for its shadows.
    mesh->buildEdgeList();
    const Ogre::EdgeData* edges = mesh->getEdgeList();
    REQUIRE(edges != nullptr);
    CHECK(edges->isClosed);
    CHECK(edges->triangles.size() == plan->size().triangles);

    const bounds3 said = plan->bounds();
    CHECK(mesh->getBounds().getMinimum() == Ogre::Vector3(said.low.x, said.low.y, said.low.z));
    CHECK(mesh->getBounds().getMaximum() == Ogre::Vector3(said.high.x, said.high.y, said.high.z));
}
