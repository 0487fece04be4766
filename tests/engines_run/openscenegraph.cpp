// SPDX-License-Identifier: MIT
//
// OpenSceneGraph's own eyes on what the recipe in docs/engines.md has put into an osg::Geometry.

#include <osg/CullFace>
#include <osg/Geode>
#include <osg/Geometry>
#include <osg/TriangleFunctor>
#include <osgViewer/Viewer>

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include "engines/recipe_laws.hpp"

typemesh::error openscenegraph_snippet(const typemesh::result<typemesh::text_plan<typemesh::extruded<>>>& plan,
                                       osg::Geometry* geometry);

using namespace recipes;

namespace {

text_options options()
{
    text_options o;
    o.frame = right_handed_z_up;
    o.frame.uv = uv_origin::bottom_left;
    return o;
}

/// What OpenSceneGraph finds when it goes through the triangles.
struct collected {
    double volume = 0.0, area = 0.0;
    std::size_t triangles = 0;
    std::map<std::pair<osg::Vec3, osg::Vec3>, int> edges;  ///< how often more along than back

    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c, bool = false)
    {
        const osg::Vec3d p{a}, q{b}, r{c}, across = (q - p) ^ (r - p);
        volume += (p * across) / 6.0;
        area += across.length() / 2.0;
        ++triangles;
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}})
            from < to ? ++edges[{from, to}] : --edges[{to, from}];
    }
};

/// A picture of a geometry, drawn away from any screen.
osg::ref_ptr<osg::Image> drawn(osg::Geometry* geometry, osg::ref_ptr<osg::StateAttribute> culling)
{
    osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
    traits->readDISPLAY();
    traits->setUndefinedScreenDetailsToDefaultScreen();
    traits->width = 640, traits->height = 320, traits->pbuffer = true, traits->alpha = 8;
    osg::ref_ptr<osg::GraphicsContext> context = osg::GraphicsContext::createGraphicsContext(traits);
    REQUIRE(context.valid());
    osgViewer::Viewer viewer;
    viewer.setThreadingModel(osgViewer::Viewer::SingleThreaded);
    osg::Camera* camera = viewer.getCamera();
    camera->setGraphicsContext(context);
    camera->setViewport(0, 0, 640, 320);
    camera->setClearColor({0, 0, 0, 0});
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(640, 320, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    camera->attach(osg::Camera::COLOR_BUFFER, image);
    const osg::BoundingBox box = geometry->getBoundingBox();
    camera->setProjectionMatrixAsPerspective(30.0, 2.0, 0.5, 50.0);
    camera->setViewMatrixAsLookAt(box.center() + osg::Vec3d{1.5, -5.0, 1.6}, box.center(), osg::Vec3d{0, 0, 1});
    osg::ref_ptr<osg::Geode> node = new osg::Geode;
    node->addDrawable(geometry);
    if (culling.valid()) node->getOrCreateStateSet()->setAttributeAndModes(culling);
    viewer.setSceneData(node);
    viewer.realize();
    viewer.frame();
    viewer.frame();
    return image;
}

bool covered(const osg::Image& image, unsigned x, unsigned y) { return image.data(x, y)[3] != 0; }

}  // namespace

TEST_CASE("OpenSceneGraph's arrays hold a mesh with z up, counter-clockwise, v upwards", "[engines]")
{
    bench b;
    const auto plan = b.mesher.plan(word, options());
    REQUIRE(plan);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    REQUIRE_FALSE(openscenegraph_snippet(plan, geometry));
    seen mesh;
    const auto* places = static_cast<const osg::Vec3Array*>(geometry->getVertexArray());
    const auto* normals = static_cast<const osg::Vec3Array*>(geometry->getNormalArray());
    const auto* uvs = static_cast<const osg::Vec2Array*>(geometry->getTexCoordArray(0));
    REQUIRE(geometry->getNumPrimitiveSets() == 1);
    const osg::PrimitiveSet* corners = geometry->getPrimitiveSet(0);
    REQUIRE(corners->getMode() == GL_TRIANGLES);
    for (const osg::Vec3& p : *places) mesh.position.push_back({p.x(), p.y(), p.z()});
    for (const osg::Vec3& n : *normals) mesh.normal.push_back({n.x(), n.y(), n.z()});
    for (const osg::Vec2& t : *uvs) mesh.uv.push_back({t.x(), t.y()});
    for (unsigned i = 0; i < corners->getNumIndices(); ++i) mesh.index.push_back(corners->index(i));
    engine is = cad;
    is.v_down = false;
    obeys(mesh, *plan, is);
}

TEST_CASE("OpenSceneGraph's own functor finds a closed solid of the right volume and box", "[engines]")
{
    bench b;
    const auto plan = b.mesher.plan(word, options());
    REQUIRE(plan);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    REQUIRE_FALSE(openscenegraph_snippet(plan, geometry));
    osg::TriangleFunctor<collected> all;
    geometry->accept(all);
    CHECK(all.triangles == plan->size().triangles);
    std::size_t open = 0;
    for (const auto& [edge, surplus] : all.edges) open += surplus == 0 ? 0u : 1u;
    CHECK(open == 0);

    // A prism: its volume is its front's area times its depth.
    const auto& places = *static_cast<const osg::Vec3Array*>(geometry->getVertexArray());
    const auto& corners = *static_cast<const osg::DrawElementsUInt*>(geometry->getPrimitiveSet(0));
    const auto front = plan->range(part::front);
    double area = 0.0;
    for (std::uint32_t i = front.first_index; i < front.first_index + front.index_count; i += 3) {
        const osg::Vec3d a{places[corners[i]]}, b_a = osg::Vec3d{places[corners[i + 1]]} - a;
        area += (b_a ^ (osg::Vec3d{places[corners[i + 2]]} - a)).length() / 2.0;
    }
    CHECK(all.volume == Catch::Approx(0.2 * area).epsilon(1e-5));
    CHECK(all.area > 2.0 * area);

    const osg::BoundingBox box = geometry->getBoundingBox();
    const bounds3 said = plan->bounds();
    CHECK(box._min == osg::Vec3(said.low.x, said.low.y, said.low.z));
    CHECK(box._max == osg::Vec3(said.high.x, said.high.y, said.high.z));
}

// At an edge that passes a pixel's middle either face may be drawn: tests/engines_run/opengl.cpp looks at these one by one.
TEST_CASE("OpenSceneGraph draws the same whether back faces are culled or not", "[engines]")
{
    bench b;
    const auto plan = b.mesher.plan(word, options());
    REQUIRE(plan);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    REQUIRE_FALSE(openscenegraph_snippet(plan, geometry));
    const auto all = drawn(geometry, nullptr), fronts = drawn(geometry, new osg::CullFace(osg::CullFace::BACK)),
               backs = drawn(geometry, new osg::CullFace(osg::CullFace::FRONT));
    std::size_t count = 0, changed = 0, one_sided = 0;
    for (unsigned y = 0; y < 320; ++y) {
        for (unsigned x = 0; x < 640; ++x) {
            count += covered(*all, x, y) ? 1u : 0u;
            changed += std::memcmp(all->data(x, y), fronts->data(x, y), 4) == 0 ? 0u : 1u;
            one_sided += covered(*fronts, x, y) == covered(*backs, x, y) ? 0u : 1u;
        }
    }
    CHECK(count > 10'000);
    CHECK(changed <= count / 10'000);
    CHECK(one_sided == 0);
    if (const char* folder = std::getenv("TYPEMESH_KEEP_PICTURES")) {
        std::FILE* file = std::fopen((std::string{folder} + "/openscenegraph.ppm").c_str(), "wb");
        REQUIRE(file != nullptr);
        std::fprintf(file, "P6\n640 320\n255\n");
        for (unsigned y = 320; y-- > 0;)
            for (unsigned x = 0; x < 640; ++x) std::fwrite(all->data(x, y), 1, 3, file);
        std::fclose(file);
    }
}
