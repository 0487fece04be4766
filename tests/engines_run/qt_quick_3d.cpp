// SPDX-License-Identifier: MIT
//
// What a QQuick3DGeometry holds when the recipe in docs/engines.md has filled it.

#include <QVector3D>
#include <QtQuick3D/QQuick3DGeometry>

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "engines/recipe_laws.hpp"

using plan_type = typemesh::result<typemesh::text_plan<typemesh::extruded<>>>;

class text_geometry : public QQuick3DGeometry {  // as in tests/compile/qt_snippets.cpp
public:
    typemesh::error show(const plan_type& plan);
};

using namespace recipes;

TEST_CASE("Qt Quick 3D's bytes hold the mesh, as its attributes describe them", "[engines]")
{
    bench b;
    text_options o;
    o.frame.uv = uv_origin::bottom_left;
    const auto plan = b.mesher.plan(word, o);
    REQUIRE(plan);
    text_geometry geometry;
    REQUIRE_FALSE(geometry.show(plan));

    using attribute_of_qt = QQuick3DGeometry::Attribute;
    const QByteArray vertices = geometry.vertexData(), indices = geometry.indexData();
    const auto stride = static_cast<std::size_t>(geometry.stride());
    REQUIRE(geometry.primitiveType() == QQuick3DGeometry::PrimitiveType::Triangles);
    REQUIRE(static_cast<std::size_t>(vertices.size()) == stride * plan->size().vertices);
    REQUIRE(static_cast<std::size_t>(indices.size()) == 4 * plan->size().indices());
    seen mesh;
    REQUIRE(geometry.attributeCount() == 4);
    for (int k = 0; k < 4; ++k) {
        const attribute_of_qt a = geometry.attribute(k);
        if (a.semantic == attribute_of_qt::IndexSemantic) {
            REQUIRE(a.componentType == attribute_of_qt::U32Type);
            continue;
        }
        REQUIRE(a.componentType == attribute_of_qt::F32Type);
        for (std::size_t i = 0; i < plan->size().vertices; ++i) {
            float v[3] = {};
            std::memcpy(v, vertices.constData() + i * stride + static_cast<std::size_t>(a.offset),
                        a.semantic == attribute_of_qt::TexCoord0Semantic ? 8 : 12);
            if (a.semantic == attribute_of_qt::PositionSemantic)
                mesh.position.push_back({v[0], v[1], v[2]});
            else if (a.semantic == attribute_of_qt::NormalSemantic)
                mesh.normal.push_back({v[0], v[1], v[2]});
            else
                mesh.uv.push_back({v[0], v[1]});
        }
    }
    mesh.index.resize(plan->size().indices());
    std::memcpy(mesh.index.data(), indices.constData(), mesh.index.size() * 4);
    obeys(mesh, *plan, opengl);

    const bounds3 said = plan->bounds();
    CHECK(geometry.boundsMin() == QVector3D(said.low.x, said.low.y, said.low.z));
    CHECK(geometry.boundsMax() == QVector3D(said.high.x, said.high.y, said.high.z));
}
