// SPDX-License-Identifier: MIT
//
// The lines of docs/engines.md for Qt Quick 3D: tests/run.sh --with engines compiles and runs them.

#include <typemesh/text/text_mesher.hpp>
#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/stream_sink.hpp>

#include <QByteArray>
#include <QVector3D>
#include <QtQuick3D/QQuick3DGeometry>

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

class text_geometry : public QQuick3DGeometry {
public:
    typemesh::error show(const plan_type& plan);
};

typemesh::error text_geometry::show(const plan_type& plan)
{
const auto size = plan->size();
QByteArray vertices{qsizetype(size.vertices * sizeof(vertex)), Qt::Uninitialized};
QByteArray indices{qsizetype(size.indices() * sizeof(quint32)), Qt::Uninitialized};
auto written = plan->write(typemesh::into(std::span{reinterpret_cast<vertex*>(vertices.data()), size.vertices},
                                        std::span{reinterpret_cast<quint32*>(indices.data()), size.indices()}));
setVertexData(vertices);
setIndexData(indices);
setStride(sizeof(vertex));
setPrimitiveType(PrimitiveType::Triangles);
addAttribute(Attribute::PositionSemantic, offsetof(vertex, position), Attribute::F32Type);
addAttribute(Attribute::NormalSemantic, offsetof(vertex, normal), Attribute::F32Type);
addAttribute(Attribute::TexCoord0Semantic, offsetof(vertex, uv), Attribute::F32Type);
addAttribute(Attribute::IndexSemantic, 0, Attribute::U32Type);
const auto [low, high] = plan->bounds();
setBounds({low.x, low.y, low.z}, {high.x, high.y, high.z});
update();
    return written.error();
}
