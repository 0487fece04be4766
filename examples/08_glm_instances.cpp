// SPDX-License-Identifier: MIT
//
// GLM: a sign that leans back, each of its letters written once, and a matrix for every place where one is drawn.
//
//     08_glm_instances FONT TEXT

#include <typemesh/adapt/glm.hpp>
#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

struct vertex {
    glm::vec3 position, normal;
    glm::vec4 tangent;  ///< bitangent = tangent.w * glm::cross(normal, glm::vec3(tangent))
    glm::vec2 uv;
};

template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::tangent | attribute::uv;
    vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {to_glm(s.position), to_glm(s.normal), to_glm(s.tangent), to_glm(s.uv)};
    }
};

int main(int argc, char** argv)
{
    if (argc != 3) return std::puts("usage: 08_glm_instances FONT TEXT"), 2;
    auto font = typemesh::harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;

    // Where the text runs, stands and faces: the columns of a rotation by 30 degrees about x.
    const float c = std::cos(0.5235988f), s = std::sin(0.5235988f);
    const glm::mat3 leaning{{1.0f, 0.0f, 0.0f}, {0.0f, c, -s}, {0.0f, s, c}};
    typemesh::text_options options;
    options.frame = typemesh::frame_from_glm(leaning);
    options.frame.uv = typemesh::uv_origin::bottom_left;  // as in OpenGL

    typemesh::text_mesher mesher{*font};
    auto plan = mesher.plan(argv[2], options);
    if (!plan) return std::puts(plan.error().message()), 1;

    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
    if (const auto written = plan->write_meshes(typemesh::into(vertices, indices)); !written)
        return std::puts(written.error().message()), 1;
    std::vector<glm::mat4> models;  // first the places of mesh 0, then the places of mesh 1
    models.reserve(plan->glyphs().size());
    plan->write_instances([&](const typemesh::glyph_instance& i) noexcept {
        models.push_back(typemesh::translation_matrix(i.translation));
    });

    // One instanced call per letter and part, with the matrices from first_instance on as an instanced attribute.
    for (std::size_t k = 0; k < plan->meshes().size(); ++k) {
        const auto& letter = plan->meshes()[k];
        const auto front = plan->mesh_part(k, typemesh::part::front);
        const glm::vec4 at = models[letter.first_instance][3];
        std::printf("glyph %u: %u times, front of %u indices from %u, first at %g %g %g\n",
                    static_cast<unsigned>(letter.id), letter.glyph_count, front.index_count, front.first_index,
                    double{at.x}, double{at.y}, double{at.z});
    }
    std::printf("%zu vertices, %zu indices, %zu matrices\n", vertices.size(), indices.size(), models.size());
}
