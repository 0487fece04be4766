// SPDX-License-Identifier: MIT

// Every operator new of this program is counted: see support/counted_allocations.hpp.

#include <typemesh/morph/axis_morph.hpp>
#include <typemesh/morph/morph_plan.hpp>
#include <typemesh/vertex/growing_sink.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "support/catch.hpp"
#include "support/counted_allocations.hpp"
#include "support/mesh_laws.hpp"
#include "toy_axis.hpp"

using namespace typemesh;

namespace {

struct morphed {
    vec3 position, normal;
};

}  // namespace

template <>
struct typemesh::vertex_traits<morphed> {
    static constexpr auto wants = attribute::position | attribute::normal;
    morphed operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal}; }
};

namespace {

struct mesh {
    std::vector<morphed> vertices;
    std::vector<std::uint32_t> indices;

    [[nodiscard]] inspect::closedness closed() const
    {
        return inspect::check_closedness(
            inspect::mesh_view{std::span<const morphed>{vertices}, std::span<const std::uint32_t>{indices}});
    }
    [[nodiscard]] double volume() const
    {
        return inspect::measure(
                   inspect::mesh_view{std::span<const morphed>{vertices}, std::span<const std::uint32_t>{indices}})
            .volume;
    }
};

}  // namespace

TEST_CASE("a morph is closed at every place and outside is outside, in any frame", "[morph]")
{
    test::toy_axis axis;
    axis_morph morph{axis};
    for (const frame& f : {right_handed_y_up, left_handed_y_up, right_handed_z_up, frame{.winding = -1}}) {
        auto plan = morph.plan("ox8qs", {.frame = f});
        REQUIRE(plan);
        REQUIRE(plan->section_count() == 1);
        const double facing = (f.mirrors() ? -1.0 : 1.0) * (f.turns_triangles() != f.mirrors() ? -1.0 : 1.0);
        for (int i = -8; i <= 8; ++i) {
            mesh m;
            REQUIRE(plan->write_at(2048.0 * i, into(m.vertices, m.indices)));
            CHECK(m.closed().unmatched_edges == 0);
            CHECK(m.volume() * facing * (f.mirrors() ? -1.0 : 1.0) > 0.0);
            for (std::size_t t = 0; t < m.indices.size() && i != -8; t += 3) {
                const morphed &a = m.vertices[m.indices[t]], &b = m.vertices[m.indices[t + 1]],
                              &c = m.vertices[m.indices[t + 2]];
                const test::cross_product n{test::subtract(b.position, a.position),
                                            test::subtract(c.position, a.position)};
                if (n.length() > 1e-6) CHECK(n.along(a.normal) * f.winding > 0.0);
            }
        }
    }
}

TEST_CASE("a base with weighted targets is the mesh at any place", "[morph]")
{
    test::toy_axis axis;
    axis_morph morph{axis};
    auto plan = morph.plan("or8x", {.depth = 0.3f});
    REQUIRE(plan);
    for (std::size_t s = 0; s < plan->section_count(); ++s) {
        const std::size_t targets = plan->keys(s).size() - 1;
        mesh base;
        REQUIRE(plan->write_base(s, into(base.vertices, base.indices)));
        CHECK(base.vertices.size() == plan->size(s).vertices);
        CHECK(base.indices.size() == plan->size(s).indices());
        std::vector<mesh> ways(targets);
        for (std::size_t k = 0; k < targets; ++k) {
            REQUIRE(plan->write_target(s, k + 1, into(ways[k].vertices, ways[k].indices)));
            CHECK(ways[k].indices.empty());
        }
        const double first = plan->keys(s)[0], last = plan->keys(s).back();
        for (int i = 0; i <= 16; ++i) {
            const double at = first + (last - first) * i / 16.0;
            std::vector<float> weights(targets);
            const auto section = plan->weights(at, weights);
            REQUIRE(section);
            REQUIRE(*section == s);
            mesh there;
            REQUIRE(plan->write_at(at, into(there.vertices, there.indices)));
            CHECK(there.indices == base.indices);
            double far = 0.0, turned = 0.0;
            for (std::size_t v = 0; v < base.vertices.size(); ++v) {
                vec3 p = base.vertices[v].position, n = base.vertices[v].normal;
                for (std::size_t k = 0; k < targets; ++k) {
                    const vec3 dp = ways[k].vertices[v].position, dn = ways[k].vertices[v].normal;
                    p = {p.x + weights[k] * dp.x, p.y + weights[k] * dp.y, p.z + weights[k] * dp.z};
                    n = {n.x + weights[k] * dn.x, n.y + weights[k] * dn.y, n.z + weights[k] * dn.z};
                }
                const vec3 d = test::subtract(p, there.vertices[v].position);
                far = std::max({far, std::fabs(as_double(d.x)), std::fabs(as_double(d.y)), std::fabs(as_double(d.z))});
                turned = std::max(turned, test::cross_product{n, there.vertices[v].normal}.length());
            }
            CHECK(far < 1e-6);
            CHECK(turned < 1e-5);
        }
    }
    std::vector<float> none;
    CHECK(plan->weights(0.0, none).error() == error::buffer_too_small);
    CHECK(plan->weights(INFINITY, none).error() == error::bad_option);
}

TEST_CASE("frames of a morph allocate nothing", "[morph]")
{
    CHECK(test::every_allocation_counts());
    test::toy_axis axis;
    axis_morph morph{axis};
    auto plan = morph.plan("oxo8", {});
    REQUIRE(plan);
    std::vector<morphed> vertices(plan->size(0).vertices);
    std::vector<std::uint32_t> indices(plan->size(0).indices());
    std::vector<float> weights(plan->keys(0).size() - 1);
    bool good = true;
    const std::size_t before = test::allocations;
    for (int i = -8; i <= 8; ++i) {
        const auto written = plan->write_at(2048.0 * i, into(std::span{vertices}, std::span{indices}));
        const auto weighted = plan->weights(2048.0 * i, weights);
        good = good && written && weighted;
    }
    CHECK(test::allocations == before);
    CHECK(good);
}

TEST_CASE("parts of a morph are contiguous, and a flat one has only a front", "[morph]")
{
    test::toy_axis axis;
    axis_morph morph{axis};
    const auto deep = morph.plan("o", {}), flat = morph.plan("o", {.depth = 0.0f});
    REQUIRE(deep);
    REQUIRE(flat);
    const mesh_range front = deep->range(0, part::front), back = deep->range(0, part::back),
                     side = deep->range(0, part::side);
    CHECK(back.first_vertex == front.vertex_count);
    CHECK(side.first_vertex == 2 * front.vertex_count);
    CHECK(side.first_vertex + side.vertex_count == deep->size(0).vertices);
    CHECK(side.first_index + side.index_count == deep->size(0).indices());
    CHECK(side.index_count == 6 * front.vertex_count);
    CHECK(flat->size(0).vertices == front.vertex_count);
    CHECK(flat->size(0).indices() == front.index_count);
    CHECK(flat->range(0, part::side) == mesh_range{});
}
