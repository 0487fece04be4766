// SPDX-License-Identifier: MIT
//
// A unit as users of Irrlicht have it: C++14, with irrlicht.h, which C++20 refuses.

#include "irrlicht_scene.hpp"

#include <irrlicht.h>

#include "engines/irrlicht.hpp"

#include <cmath>

namespace {

using namespace irr;

/// The null device: all of Irrlicht but its window.
struct device {
    IrrlichtDevice* held;
    device()
    {
        SIrrlichtCreationParameters wanted;
        wanted.DriverType = video::EDT_NULL;
        wanted.LoggingLevel = ELL_NONE;
        held = createDeviceEx(wanted);
    }
    ~device()
    {
        if (held) held->drop();
    }
};

const video::S3DVertex* vertices_of(const scene::IMeshBuffer& buffer)
{
    return static_cast<const video::S3DVertex*>(buffer.getVertices());
}

unsigned index_of(const scene::IMeshBuffer& buffer, u32 i)
{
    return buffer.getIndexType() == video::EIT_16BIT ? buffer.getIndices()[i]
                                                     : reinterpret_cast<const u32*>(buffer.getIndices())[i];
}

void read(const scene::IMeshBuffer& buffer, video::SColor colour, irrlicht_findings& found)
{
    for (u32 i = 0; i < buffer.getVertexCount(); ++i) {
        const video::S3DVertex& v = vertices_of(buffer)[i];
        for (const f32 x : {v.Pos.X, v.Pos.Y, v.Pos.Z}) found.positions.push_back(x);
        for (const f32 x : {v.Normal.X, v.Normal.Y, v.Normal.Z}) found.normals.push_back(x);
        for (const f32 x : {v.TCoords.X, v.TCoords.Y}) found.uvs.push_back(x);
        found.colours_wrong += v.Color == colour ? 0u : 1u;
    }
    for (u32 i = 0; i < buffer.getIndexCount(); ++i) found.indices.push_back(index_of(buffer, i));
    for (u32 i = 0; i < buffer.getIndexCount(); i += 3) {
        core::vector3df ours(0, 0, 0);
        for (u32 k = 0; k < 3; ++k) ours += vertices_of(buffer)[index_of(buffer, i + k)].Normal;
        const core::plane3df plane(vertices_of(buffer)[index_of(buffer, i)].Pos,
                                   vertices_of(buffer)[index_of(buffer, i + 1)].Pos,
                                   vertices_of(buffer)[index_of(buffer, i + 2)].Pos);
        found.turned += plane.Normal.dotProduct(ours) > 0.0f ? 0u : 1u;
    }
    const core::aabbox3df& box = buffer.getBoundingBox();
    found.low[0] = box.MinEdge.X, found.low[1] = box.MinEdge.Y, found.low[2] = box.MinEdge.Z;
    found.high[0] = box.MaxEdge.X, found.high[1] = box.MaxEdge.Y, found.high[2] = box.MaxEdge.Z;
}

/// Irrlicht's own ray, through the middle of the stem of DejaVu Sans' L.
bool hits_front(IrrlichtDevice& irrlicht, scene::IMeshBuffer& buffer)
{
    scene::SMesh* mesh = new scene::SMesh;
    mesh->addMeshBuffer(&buffer);
    mesh->recalculateBoundingBox();
    scene::ISceneManager* scene = irrlicht.getSceneManager();
    scene::IMeshSceneNode* node = scene->addMeshSceneNode(mesh);
    scene::ITriangleSelector* triangles = scene->createTriangleSelector(mesh, node);
    core::vector3df where;
    core::triangle3df which;
    scene::ISceneNode* whose = nullptr;
    const core::line3df ray(0.14f, 0.4f, -5.0f, 0.14f, 0.4f, 5.0f);
    const bool hit = scene->getSceneCollisionManager()->getCollisionPoint(ray, triangles, where, which, whose) &&
                     std::abs(where.Z) < 1e-5f && which.isFrontFacing(core::vector3df(0, 0, 1));
    triangles->drop();
    mesh->drop();
    return hit;
}

template <class Buffer>
void look(Buffer* buffer, IrrlichtDevice& irrlicht, engines::irrlicht::text& text, irrlicht_findings& found)
{
    const video::SColor colour(255, 10, 20, 30);
    if (const char* sentence = engines::irrlicht::write(text, *buffer, colour)) {
        found.failure = sentence;
        if (buffer->getVertexCount() != 0) found.failure += ", and the buffer is not empty";
    } else {
        read(*buffer, colour, found);
        // Irrlicht 1.8's selectors of triangles take indices for 16-bit ones, whatever they are
        found.front_hit = buffer->getIndexType() != video::EIT_16BIT || hits_front(irrlicht, *buffer);
    }
    buffer->drop();
}

}  // namespace

irrlicht_findings look_with_irrlicht(const char* font_file, const char* utf8, irrlicht_buffer kind)
{
    irrlicht_findings found;
    const device irrlicht;
    if (!irrlicht.held) return found.failure = "Irrlicht does not start", found;
    engines::irrlicht::text text;
    const char* sentence = text.open(font_file);
    if (!sentence) sentence = text.plan(utf8);
    if (sentence) return found.failure = sentence, found;
    if (kind == irrlicht_buffer::small)
        look(new scene::SMeshBuffer, *irrlicht.held, text, found);
    else
        look(new scene::CDynamicMeshBuffer(video::EVT_STANDARD, video::EIT_32BIT), *irrlicht.held, text, found);
    return found;
}
