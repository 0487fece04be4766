// SPDX-License-Identifier: MIT
//
// The lines of docs/engines.md for OpenSceneGraph: tests/run.sh --with engines compiles and runs them.

#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/stream_sink.hpp>

#include <osg/Geometry>

#include <cstddef>
#include <cstdint>
#include <span>

using plan_type = typemesh::result<typemesh::text_plan<typemesh::extruded<>>>;

typemesh::error openscenegraph_snippet(const plan_type& plan, osg::Geometry* geometry);
typemesh::error openscenegraph_snippet(const plan_type& plan, osg::Geometry* geometry)
{
const auto vertex_count = unsigned(plan->size().vertices), index_count = unsigned(plan->size().indices());
osg::ref_ptr<osg::Vec3Array> positions = new osg::Vec3Array(vertex_count), normals = new osg::Vec3Array(vertex_count);
osg::ref_ptr<osg::Vec2Array> uvs = new osg::Vec2Array(vertex_count);
osg::ref_ptr<osg::DrawElementsUInt> corners = new osg::DrawElementsUInt(GL_TRIANGLES, index_count);
auto written = plan->write(typemesh::stream_sink{std::span{corners->asVector()},
                                               typemesh::stream<typemesh::attribute::position, osg::Vec3>{positions->asVector()},
                                               typemesh::stream<typemesh::attribute::normal, osg::Vec3>{normals->asVector()},
                                               typemesh::stream<typemesh::attribute::uv, osg::Vec2>{uvs->asVector()}});
geometry->setVertexArray(positions.get());
geometry->setNormalArray(normals.get(), osg::Array::BIND_PER_VERTEX);
geometry->setTexCoordArray(0, uvs.get());
geometry->addPrimitiveSet(corners.get());
    return written.error();
}
