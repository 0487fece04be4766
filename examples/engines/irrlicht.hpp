// SPDX-License-Identifier: MIT
#pragma once

// Irrlicht 1.8, whatever standard your sources are compiled as; see irrlicht_text.hpp. Include irrlicht.h first.
//
//     engines::irrlicht::text text;
//     if (const char* sentence = text.open("font.ttf")) ...
//     if (const char* sentence = text.plan("Hello")) ...
//     irr::scene::SMeshBuffer* buffer = new irr::scene::SMeshBuffer;
//     if (const char* sentence = engines::irrlicht::write(text, *buffer)) ...     // up to 65,535 vertices
//     mesh->addMeshBuffer(buffer), buffer->drop();                                // an irr::scene::SMesh
//
// For longer texts take CDynamicMeshBuffer{EVT_STANDARD, EIT_32BIT}.

#include "engines/irrlicht_text.hpp"

#include <cstddef>

namespace engines {
namespace irrlicht {

static_assert(sizeof(text_vertex) == sizeof(irr::video::S3DVertex) &&
                  offsetof(text_vertex, normal) == offsetof(irr::video::S3DVertex, Normal) &&
                  offsetof(text_vertex, colour) == offsetof(irr::video::S3DVertex, Color) &&
                  offsetof(text_vertex, uv) == offsetof(irr::video::S3DVertex, TCoords),
              "text_vertex must have the bytes of Irrlicht's vertex");

/// Fills a buffer with the text planned last, in place; nullptr, or a sentence, and the buffer is empty then.
inline const char* write(const text& planned, irr::scene::SMeshBuffer& buffer,
                         irr::video::SColor colour = irr::video::SColor(255, 255, 255, 255))
{
    buffer.Vertices.set_used(static_cast<irr::u32>(planned.vertices()));
    buffer.Indices.set_used(static_cast<irr::u32>(planned.indices()));
    const char* const failed = planned.write(reinterpret_cast<text_vertex*>(buffer.Vertices.pointer()),
                                             buffer.Indices.pointer(), colour.color);
    if (failed) buffer.Vertices.set_used(0), buffer.Indices.set_used(0);
    buffer.recalculateBoundingBox();
    return failed;
}

inline const char* write(const text& planned, irr::scene::CDynamicMeshBuffer& buffer,
                         irr::video::SColor colour = irr::video::SColor(255, 255, 255, 255))
{
    buffer.getVertexBuffer().set_used(static_cast<irr::u32>(planned.vertices()));
    buffer.getIndexBuffer().set_used(static_cast<irr::u32>(planned.indices()));
    const char* const failed =
        planned.write(static_cast<text_vertex*>(buffer.getVertexBuffer().getData()),
                      static_cast<std::uint32_t*>(buffer.getIndexBuffer().getData()), colour.color);
    if (failed) buffer.getVertexBuffer().set_used(0), buffer.getIndexBuffer().set_used(0);
    buffer.recalculateBoundingBox();
    return failed;
}

}  // namespace irrlicht
}  // namespace engines
