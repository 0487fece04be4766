// SPDX-License-Identifier: MIT
#pragma once

// The laws of each engine's recipe, in that engine's own coordinates, for a mesh that is read back from its buffers.

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/extrude/extruded.hpp>
#include <typemesh/text/text_mesher.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/font_file.hpp"
#include "support/mesh_laws.hpp"

namespace recipes {

using namespace typemesh;

/// L first: its bar at the bottom and its stem at the left show whether anything is mirrored.
inline constexpr const char* word = "L\xC3\xA5&g";

/// A font, and a mesher over it whose requests for memory are counted.
template <class Extruder>
class bench_of {
public:
    bench_of() : font_{open()}, mesher{text_mesher{font_, memory.source()}.with(Extruder{})} {}

private:
    static harfbuzz_font open()
    {
        auto font = harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str());
        if (!font) FAIL(font.error().message());
        return std::move(*font);
    }
    harfbuzz_font font_;

public:
    test::counting_memory memory;
    text_mesher<Extruder> mesher;
};

/// With three parts and with five.
using bench = bench_of<extruded<>>;
using bevelled_bench = bench_of<bevelled>;
inline constexpr double bevel = 0.02;  // as wide and as deep

/// The plan of a text, by default of the word.
template <class Bench>
auto planned(Bench& b, const text_options& o, std::string_view text = word)
{
    auto plan = b.mesher.plan(text, o);
    REQUIRE(plan);
    return std::move(*plan);
}

/// A mesh read back from an engine's buffers.
struct seen {
    std::vector<vec3> position, normal;
    std::vector<vec4> tangent;  ///< may be empty
    std::vector<vec2> uv;       ///< may be empty
    std::vector<std::uint32_t> index;

    /// One vertex: three coordinates each, a tangent of four or none, and texture coordinates. They may be packed.
    template <class Normal, class Tangent, class Uv>
    void add(vec3 p, const Normal& n, const Tangent& t, const Uv& at)
    {
        const auto f = [](auto packed) { return static_cast<float>(packed); };
        position.push_back(p);
        normal.push_back({f(n[0]), f(n[1]), f(n[2])});
        if constexpr (!std::is_null_pointer_v<Tangent>) tangent.push_back({f(t[0]), f(t[1]), f(t[2]), f(t[3])});
        uv.push_back({f(at[0]), f(at[1])});
    }
};

/// The vertices of OpenGL's and Vulkan's recipes.
template <class Vertex>
seen read(std::span<const Vertex> vertices)
{
    seen mesh;
    for (const Vertex& v : vertices) {
        const vec4 n = v.normal.decoded();
        mesh.position.push_back({v.position[0], v.position[1], v.position[2]});
        mesh.normal.push_back({n.x, n.y, n.z});
        mesh.tangent.push_back(v.tangent.decoded());
        mesh.uv.push_back({static_cast<float>(v.uv[0]), static_cast<float>(v.uv[1])});
    }
    return mesh;
}

/// An engine's conventions, by its documentation.
struct engine {
    vec3 right, up, toward;      ///< where the text runs, stands and looks, in the engine's axes
    int winding;                 ///< the sign of dot(cross(b - a, c - a), n)
    bool v_down;                 ///< v = 0 at the top
    bool green_up = true;        ///< w * cross(normal, tangent) points up the image, else down
    double em = 1.0;             ///< units an em
    double off_position = 1e-6;  ///< errors of packing: in ems, as a sine, in [0, 1]
    double off_direction = 1e-6;
    double off_uv = 1e-6;
};

inline constexpr engine opengl{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, +1, false};
inline constexpr engine gltf{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, +1, true};
inline constexpr engine direct3d{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, +1, true, false};
inline constexpr engine unity{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}, +1, false};
inline constexpr engine unreal{{0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, -1, true, false, 100.0};
inline constexpr engine godot{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, -1, true};
inline constexpr engine cad{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}, +1, true};

inline double along(vec3 v, vec3 axis) { return test::dot(v, axis); }

/// A plan's write, and what it left behind.
template <class Plan>
void obeys(const seen& mesh, const Plan& plan, const engine& is)
{
    const mesh_size size = plan.size();
    REQUIRE(size.vertices > 100);
    REQUIRE(mesh.position.size() == size.vertices);
    REQUIRE(mesh.normal.size() == size.vertices);
    REQUIRE(mesh.index.size() == size.indices());

    // Every corner within the mesh; every triangle wound as the engine wants it, against its vertices' normals.
    std::size_t turned = 0, flat = 0;
    for (std::size_t t = 0; t < mesh.index.size(); t += 3) {
        vec3 p[3], n{};
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t i = mesh.index[t + k];
            REQUIRE(i < size.vertices);
            p[k] = mesh.position[i];
            n = {n.x + mesh.normal[i].x, n.y + mesh.normal[i].y, n.z + mesh.normal[i].z};
        }
        const test::cross_product face{test::subtract(p[1], p[0]), test::subtract(p[2], p[0])};
        const double sign = face.along(n) / (is.em * is.em);
        if (std::abs(sign) < (is.off_position > 1e-5 ? 1e-5 : 0.0))
            ++flat;  // slivers that packing bends
        else
            turned += sign * is.winding > 0.0 ? 0u : 1u;
    }
    CHECK(turned == 0);
    CHECK(flat < size.triangles / 4);

    // Closed, when every vertex that was equal still is.
    std::vector<test::full_vertex> welded;
    for (const vec3 p : mesh.position) welded.push_back({p, {}, {}});
    CHECK(test::examine(welded, mesh.index).unmatched_edges == 0);

    // In place: front at depth 0, in the engine's unit, readable from the front; bevels between cap and
    // wall, leaning like both.
    const bool has_bevels = plan.parts().size() == 5;
    for (const part where : plan.parts()) {
        const auto range = plan.range(where);
        REQUIRE(range.vertex_count > 0);
        for (std::uint32_t i = range.first_vertex; i < range.first_vertex + range.vertex_count; ++i) {
            const double depth = along(mesh.position[i], is.toward) / is.em, facing = along(mesh.normal[i], is.toward);
            if (where == part::front) CHECK(std::abs(depth) <= is.off_position);
            if (where == part::back) CHECK(std::abs(depth + 0.2) <= is.off_position);
            if (where > part::side) {
                const double into = where == part::front_bevel ? -depth : 0.2 + depth;
                CHECK(std::abs(into - bevel / 2) <= bevel / 2 + is.off_position);
                CHECK(std::abs(facing - (where == part::front_bevel ? 1.0 : -1.0) * std::sqrt(0.5)) <=
                      2.0 * is.off_direction);
            } else {
                CHECK(std::abs(facing - (where == part::front  ? 1.0
                                         : where == part::back ? -1.0
                                                               : 0.0)) <= is.off_direction);
            }
            CHECK(std::abs(test::dot(mesh.normal[i], mesh.normal[i]) - 1.0) <= 3.0 * is.off_direction + 1e-6);
        }
    }
    const auto l = plan.range(0, part::front);  // the letter L
    double low = 1e9, high = -1e9, left = 1e9, right = -1e9, middle_x = 0.0, middle_y = 0.0;
    for (std::uint32_t i = l.first_vertex; i < l.first_vertex + l.vertex_count; ++i) {
        const double x = along(mesh.position[i], is.right) / is.em, y = along(mesh.position[i], is.up) / is.em;
        low = (std::min)(low, y), high = (std::max)(high, y), left = (std::min)(left, x), right = (std::max)(right, x);
        middle_x += x / l.vertex_count, middle_y += y / l.vertex_count;
    }
    const double cap_height = 0.729 - (has_bevels ? 2.0 * bevel : 0.0);  // DejaVu Sans', 1493 of 2048
    CHECK(high - low == Catch::Approx(cap_height).margin(0.001));
    CHECK(middle_x < (left + right) / 2);
    CHECK(middle_y < (low + high) / 2);

    // Texture: a tile an em. On caps by the place in the text, v = 0 where the engine has it; on walls upright, and
    // everywhere but on bevels, whose u is kept on the way inwards, as long as what it lies on.
    if (!mesh.uv.empty()) {
        REQUIRE(mesh.uv.size() == size.vertices);
        const double off = is.off_uv + is.off_position * 3.0;
        for (const part where : plan.parts()) {
            if (where > part::side) continue;
            const auto range = plan.range(where);
            for (std::uint32_t i = range.first_vertex; i < range.first_vertex + range.vertex_count; ++i) {
                const vec3 p = mesh.position[i];
                const double rise = where == part::side ? 1.0 + along(p, is.toward) / is.em : along(p, is.up) / is.em,
                             v = is.v_down ? 1.0 - rise : rise, u = along(p, is.right) / is.em;
                if ((where != part::side && std::abs(as_double(mesh.uv[i].x) - u) > off) ||
                    std::abs(as_double(mesh.uv[i].y) - v) > off)
                    FAIL("vertex " << i << " has u " << mesh.uv[i].x << ", v " << mesh.uv[i].y << " for " << u << ", "
                                   << v);
            }
            for (std::uint32_t i = range.first_index; i < range.first_index + range.index_count; ++i) {
                const std::uint32_t a = mesh.index[i], b = mesh.index[i % 3 == 2 ? i - 2 : i + 1];
                const vec3 d = test::subtract(mesh.position[b], mesh.position[a]);
                const double far = std::sqrt(test::dot(d, d)) / is.em,
                             in_texture = std::hypot(as_double(mesh.uv[b].x) - as_double(mesh.uv[a].x),
                                                     as_double(mesh.uv[b].y) - as_double(mesh.uv[a].y));
                if (std::abs(in_texture - far) > 3.0 * off)
                    FAIL("an edge of " << far << " em has " << in_texture << " in the texture");
            }
        }
    }

    // Tangents: where u grows, at right angles, and their sign as the engine's normal maps have it.
    if (!mesh.tangent.empty()) {
        REQUIRE(mesh.tangent.size() == size.vertices);
        for (std::size_t i = 0; i < mesh.tangent.size(); ++i) {
            const vec4 t = mesh.tangent[i];
            const vec3 n = mesh.normal[i];
            if (std::abs(n.x * t.x + n.y * t.y + n.z * t.z) > 3.0f * static_cast<float>(is.off_direction))
                FAIL("leans");
            if (std::abs(std::abs(t.w) - 1.0f) > 0.0f) FAIL("a sign is no sign");
        }
        for (const part where : {part::front, part::back}) {
            const auto range = plan.range(where);
            const std::size_t i = range.first_vertex;
            const vec4 t = mesh.tangent[i];
            CHECK(along({t.x, t.y, t.z}, is.right) > 1.0 - 2.0 * is.off_direction);
            const test::cross_product b{mesh.normal[i], {t.x, t.y, t.z}};
            CHECK(b.along(is.up) * t.w * (is.green_up ? 1.0 : -1.0) > 0.9);
        }
    }
}

/// The same text planned and written again takes no memory from the library's source.
template <class Write>
void needs_no_memory_again(bench& b, const text_options& o, Write write)
{
    for (int warm = 0; warm < 2; ++warm) {
        auto plan = b.mesher.plan(word, o);
        REQUIRE(plan);
        REQUIRE(result<void>{write(*plan)});
    }
    const std::size_t before = b.memory.requests;
    auto plan = b.mesher.plan(word, o);
    REQUIRE(plan);
    REQUIRE(result<void>{write(*plan)});
    CHECK(b.memory.requests == before);
}

}  // namespace recipes
