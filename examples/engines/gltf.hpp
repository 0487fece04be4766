// SPDX-License-Identifier: MIT
#pragma once

// glTF 2.0, as one binary file in memory (GLB): one mesh, one primitive per part, one buffer. Right-handed, y up, front
// faces counter-clockwise, facing +z; v downwards, normal maps with green up: a tangent's w is negated. Each
// part has a material of its own, named after it (front, back, side, front_bevel, back_bevel), for colours and textures
// of yours: without one a primitive is drawn as bare metal, which mirrors a black surrounding.
//
//     plain        48 bytes per vertex: floats
//     quantised    20 bytes per vertex, by KHR_mesh_quantization (required by the file):
//                    POSITION   unsigned short x 3, normalised, at 0     each letter has a box, a mesh and a node of its
//                    NORMAL     byte x 3, normalised, at 8               own, whose translation and scale undo it: one
//                    TANGENT    byte x 4, normalised, at 12              scale for all axes, so normals stay as they are
//                    TEXCOORD_0 unsigned short x 2, normalised, at 16    beyond [0, 1] as in texture_mapping::em, the
//                                                                        default: the materials' KHR_texture_transform
//                                                                        undoes it. It belongs to a texture, so each
//                                                                        material has a white one, of one pixel: what
//                                                                        you put in its place keeps its transform
//
// A step of a quantised letter is 1/65,535 of its longest side; triangles lower than that may flip over, which
// turned_by_quantising(plan) counts. The letters share the accessors of all vertices: an importer that copies those for
// every primitive is better served by plain.
//
// Indices are unsigned short up to 65,535 vertices (65,535 itself is left out by the format), else unsigned int.
//
//     std::vector<std::byte> glb;
//     if (const auto written = engines::gltf::write(*plan, engines::gltf::layout::quantised, glb); !written) return written.error();

#include <typemesh/core/orientation.hpp>
#include <typemesh/extrude/part_sizes.hpp>
#include <typemesh/text/text_options.hpp>
#include <typemesh/text/text_plan.hpp>
#include <typemesh/vertex/computed_stream.hpp>
#include <typemesh/vertex/normalised.hpp>
#include <typemesh/vertex/position_box.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <span>
#include <string>

namespace engines::gltf {

enum class layout { plain, quantised };

[[nodiscard]] inline typemesh::text_options options() noexcept
{
    typemesh::text_options o;
    o.frame = typemesh::right_handed_y_up;
    return o;
}

struct float2 {
    float u, v;
};
struct float3 {
    float x, y, z;
};
struct float4 {
    float x, y, z, w;
};
struct snorm8x3 {
    typemesh::snorm8 x, y, z;
};
struct snorm8x4 {
    typemesh::snorm8 x, y, z, w;
};
struct unorm16x2 {
    typemesh::unorm16 u, v;
};

/// Formats numbers as JSON.
inline void say(std::string& out, const char* format, auto... values)
{
    const int length = std::snprintf(nullptr, 0, format, values...);
    if (length <= 0) return;
    const std::size_t before = out.size(), more = static_cast<std::size_t>(length);
    out.resize(before + more + 1);  // snprintf adds a terminating zero
    std::snprintf(out.data() + before, more + 1, format, values...);
    out.resize(before + more);
}

/// A PNG of one white pixel.
inline constexpr unsigned char white_pixel[] = {
    0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48, 0x44, 0x52, 0x00,
    0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00, 0x00, 0x3A, 0x7E, 0x9B, 0x55, 0x00,
    0x00, 0x00, 0x0A, 0x49, 0x44, 0x41, 0x54, 0x78, 0xDA, 0x63, 0xF8, 0x0F, 0x00, 0x01, 0x01, 0x01, 0x00,
    0x1C, 0xB0, 0x8C, 0x99, 0x00, 0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};

/// A sink that writes nothing: finds the range of texture coordinates, [0, 1] at least.
struct uv_range {
    static constexpr auto wants = typemesh::attribute::uv;
    float2 low{0.0f, 0.0f}, high{1.0f, 1.0f};

    typemesh::error begin(typemesh::mesh_size) noexcept { return {}; }
    void vertex(const typemesh::surface_point<wants>& s) noexcept
    {
        low = {s.uv.x < low.u ? s.uv.x : low.u, s.uv.y < low.v ? s.uv.y : low.v};
        high = {s.uv.x > high.u ? s.uv.x : high.u, s.uv.y > high.v ? s.uv.y : high.v};
    }
    void triangle(std::uint32_t, std::uint32_t, std::uint32_t) noexcept {}
    void end() noexcept {}

    [[nodiscard]] float2 scale() const noexcept { return {high.u - low.u, high.v - low.v}; }
    [[nodiscard]] bool is_unit() const noexcept
    {
        return !(low.u < 0.0f) && !(low.v < 0.0f) && !(high.u > 1.0f) && !(high.v > 1.0f);
    }
    [[nodiscard]] unorm16x2 operator()(typemesh::vec2 uv) const noexcept
    {
        return {(uv.x - low.u) / scale().u, (uv.y - low.v) / scale().v};
    }
};

inline constexpr const char* part_names[typemesh::max_parts] = {"front",      "back",   "side",   "front_bevel",
                                                                "back_bevel", "part 5", "part 6", "part 7"};

/// The materials of the parts that are drawn, in the parts' order: painted, not metal, the sides darker. Where `packed`
/// texture coordinates go beyond [0, 1] each has a white texture with the transform that undoes them.
template <class Plan>
void say_materials(std::string& json, const Plan& plan, const uv_range* packed)
{
    std::string texture;
    if (packed != nullptr && !packed->is_unit()) {
        json += R"("images":[{"mimeType":"image/png","bufferView":2}],"textures":[{"source":0}],)";
        say(texture,
            R"("baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[%.9g,%.9g],"scale":[%.9g,%.9g]}}},)",
            typemesh::as_double(packed->low.u), typemesh::as_double(packed->low.v),
            typemesh::as_double(packed->scale().u), typemesh::as_double(packed->scale().v));
    }
    using typemesh::part;
    const char* before = R"("materials":[)";
    for (const part p : plan.parts()) {
        if (plan.range(p).index_count == 0) continue;
        say(json,
            R"(%s{"name":"%s","pbrMetallicRoughness":{%s"baseColorFactor":%s,"metallicFactor":0,"roughnessFactor":0.45}})",
            before, part_names[static_cast<std::size_t>(p)], texture.c_str(),
            p == part::side  ? "[0.617,0.061,0.03,1]"
            : p > part::side ? "[0.939,0.287,0.089,1]"
                             : "[0.871,0.138,0.051,1]");
        before = ",";
    }
    json += "],";
}

/// The cube around one letter, to which the positions of its vertices are relative.
template <class Plan>
[[nodiscard]] typemesh::position_box box_of(const Plan& plan, std::size_t glyph) noexcept
{
    const typemesh::placement at = plan.place(glyph);
    const typemesh::built_glyph& shape = *plan.glyphs()[glyph].built;
    const typemesh::point from = shape.around().low, to = shape.around().high;
    const typemesh::vec3 low = at.position({from.x, from.y, 0.0}), high = at.position({to.x, to.y, 0.0});
    return typemesh::position_box::cube_around({low.x, low.y, plan.bounds().low.z},
                                               {high.x, high.y, plan.bounds().high.z});
}

/// How many triangles of one cap, and of the bevels round it, of every letter flip over or become flat in the quantised
/// layout; walls on their rims may become flat with them.
template <class Plan>
[[nodiscard]] std::uint64_t turned_by_quantising(const Plan& plan) noexcept
{
    std::uint64_t turned = 0;
    for (std::size_t i = 0; i < plan.glyphs().size(); ++i) {
        const typemesh::placement at = plan.place(i);
        const typemesh::position_box box = box_of(plan, i);
        const auto corner = [&](typemesh::grid_point point) noexcept {
            const typemesh::box_position p = box(at.position(point, 0.0f));
            return typemesh::grid_point{p.x.bits, p.y.bits};
        };
        plan.each_seen_from_front(i, [&](auto a, auto b, auto c) noexcept {
            turned += typemesh::orientation(corner(a), corner(b), corner(c)) > 0 ? 0u : 1u;
        });
    }
    return turned;
}

/// Where the vertices and indices go, whatever the layout.
template <class Index, class Plan>
[[nodiscard]] typemesh::result<void> write_buffer(const Plan& plan, layout how, const uv_range& uv,
                                                  std::span<std::byte> vertices, std::span<Index> indices) noexcept
{
    using namespace typemesh;
    const auto turned = []<class T>(T) noexcept {
        return [](const surface_point<attribute::tangent>& s) noexcept {
            return T{s.tangent.x, s.tangent.y, s.tangent.z, -s.tangent.w};
        };
    };
    if (how == layout::plain) {
        return plan.write(stream_sink{indices, stream<attribute::position, float3>::in(vertices, 0, 48),
                                      stream<attribute::normal, float3>::in(vertices, 12, 48),
                                      computed_stream<attribute::tangent, float4>(vertices, 24, 48, turned(float4{})),
                                      stream<attribute::uv, float2>::in(vertices, 40, 48)});
    }
    for (std::size_t i = 0; i < plan.glyphs().size(); ++i) {
        const position_box box = box_of(plan, i);
        const auto written = plan.write(
            glyph_span{i, i + 1},
            stream_sink{
                indices,
                computed_stream<attribute::position, box_position>(
                    vertices, 0, 20,
                    [box](const surface_point<attribute::position>& s) noexcept { return box(s.position); }),
                stream<attribute::normal, snorm8x3>::in(vertices, 8, 20),
                computed_stream<attribute::tangent, snorm8x4>(vertices, 12, 20, turned(snorm8x4{})),
                computed_stream<attribute::uv, unorm16x2>(
                    vertices, 16, 20, [uv](const surface_point<attribute::uv>& s) noexcept { return uv(s.uv); })});
        if (!written) return written;
    }
    return {};
}

/// Nodes and meshes of the quantised layout: one per letter, below one node for the text. The first accessor of indices
/// is number 4; they follow letter by letter, part by part.
template <class Plan>
void say_letters(std::string& json, const Plan& plan)
{
    using namespace typemesh;
    const std::size_t letters = plan.glyphs().size();
    json += R"("nodes":[{"name":"text","children":[)";
    for (std::size_t i = 0; i < letters; ++i) say(json, i != 0 ? ",%zu" : "%zu", i + 1);
    json += "]}";
    for (std::size_t i = 0; i < letters; ++i) {
        const position_box box = box_of(plan, i);
        say(json, R"(,{"mesh":%zu,"name":"glyph %u","translation":[%.9g,%.9g,%.9g],"scale":[%.9g,%.9g,%.9g]})", i,
            plan.glyphs()[i].id, as_double(box.offset.x), as_double(box.offset.y), as_double(box.offset.z),
            as_double(box.scale.x), as_double(box.scale.y), as_double(box.scale.z));
    }
    json += R"(],"meshes":[)";
    int accessor = 4;
    for (std::size_t i = 0; i < letters; ++i) {
        say(json, R"(%s{"name":"glyph %u","primitives":[)", i != 0 ? "," : "", plan.glyphs()[i].id);
        int material = -1;
        const char* before = "";
        for (const part p : plan.parts()) {
            if (plan.range(p).index_count != 0) ++material;
            if (plan.range(i, p).index_count == 0) continue;  // a cap that its bevels have closed
            say(json,
                R"(%s{"attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2,"TEXCOORD_0":3},"indices":%d,"material":%d})",
                before, accessor++, material);
            before = ",";
        }
        json += "]}";
    }
    json += "]";
}

/// Replaces `out`, a container of bytes, by the file; an empty text gives a scene without nodes.
template <class Plan, class Bytes>
[[nodiscard]] typemesh::result<void> write(const Plan& plan, layout how, Bytes& out)
{
    using namespace typemesh;
    const mesh_size size = plan.size();
    const bool wide = !index_can_number<std::uint16_t>(size.vertices), packed = how == layout::quantised;
    const std::size_t stride = packed ? 20 : 48, vertex_bytes = stride * size.vertices,
                      index_bytes = (wide ? 4 : 2) * size.indices();
    const auto low = plan.bounds().low, high = plan.bounds().high;
    uv_range uv;
    if (packed) {
        if (const auto written = plan.write(uv); !written) return written.error();
    }
    const std::size_t pixel_bytes = uv.is_unit() ? 0 : sizeof white_pixel, pixel_at = vertex_bytes + index_bytes,
                      bytes = (pixel_at + pixel_bytes + 3) / 4 * 4;

    std::string json = R"({"asset":{"version":"2.0","generator":"typemesh"},"scene":0,)";
    if (size.triangles == 0) {
        json += R"("scenes":[{}]})";
    } else {
        json += R"("scenes":[{"nodes":[0]}],)";
        if (packed)
            say(json, R"("extensionsUsed":["KHR_mesh_quantization"%s],"extensionsRequired":["KHR_mesh_quantization"],)",
                uv.is_unit() ? "" : R"(,"KHR_texture_transform")");
        say_materials(json, plan, packed ? &uv : nullptr);
        if (packed) {
            say_letters(json, plan);
        } else {
            json += R"("nodes":[{"name":"text","mesh":0}],"meshes":[{"name":"text","primitives":[)";
            int accessor = 4;
            for (const part p : plan.parts()) {
                if (plan.range(p).index_count == 0) continue;
                say(json,
                    R"(%s{"attributes":{"POSITION":0,"NORMAL":1,"TANGENT":2,"TEXCOORD_0":3},"indices":%d,"material":%d})",
                    accessor > 4 ? "," : "", accessor, accessor - 4);
                ++accessor;
            }
            json += "]}]";
        }
        say(json,
            R"(,"buffers":[{"byteLength":%zu}],"bufferViews":[{"buffer":0,"byteLength":%zu,"byteStride":%zu,"target":34962},)",
            bytes, vertex_bytes, stride);
        say(json, R"({"buffer":0,"byteOffset":%zu,"byteLength":%zu,"target":34963})", vertex_bytes, index_bytes);
        if (pixel_bytes != 0) say(json, R"(,{"buffer":0,"byteOffset":%zu,"byteLength":%zu})", pixel_at, pixel_bytes);
        json += R"(],"accessors":[)";
        const auto n = static_cast<unsigned>(size.vertices);
        if (packed) {
            int last[3] = {0, 0, 0};
            for (std::size_t i = 0; i < plan.glyphs().size(); ++i) {
                const placement place = plan.place(i);
                const point to = plan.glyphs()[i].built->around().high;
                const vec3 corner = place.position({to.x, to.y, 0.0});
                const box_position p = box_of(plan, i)({corner.x, corner.y, high.z});
                const int bits[3] = {p.x.bits, p.y.bits, p.z.bits};
                for (std::size_t k = 0; k < 3; ++k) last[k] = bits[k] > last[k] ? bits[k] : last[k];
            }
            say(json,
                R"({"bufferView":0,"componentType":5123,"normalized":true,"count":%u,"type":"VEC3","min":[0,0,0],"max":[%d,%d,%d]},)",
                n, last[0], last[1], last[2]);
            say(json,
                R"({"bufferView":0,"byteOffset":8,"componentType":5120,"normalized":true,"count":%u,"type":"VEC3"},)",
                n);
            say(json,
                R"({"bufferView":0,"byteOffset":12,"componentType":5120,"normalized":true,"count":%u,"type":"VEC4"},)",
                n);
            say(json,
                R"({"bufferView":0,"byteOffset":16,"componentType":5123,"normalized":true,"count":%u,"type":"VEC2"})",
                n);
        } else {
            say(json,
                R"({"bufferView":0,"componentType":5126,"count":%u,"type":"VEC3","min":[%.9g,%.9g,%.9g],"max":[%.9g,%.9g,%.9g]},)",
                n, low.x, low.y, low.z, high.x, high.y, high.z);
            say(json, R"({"bufferView":0,"byteOffset":12,"componentType":5126,"count":%u,"type":"VEC3"},)", n);
            say(json, R"({"bufferView":0,"byteOffset":24,"componentType":5126,"count":%u,"type":"VEC4"},)", n);
            say(json, R"({"bufferView":0,"byteOffset":40,"componentType":5126,"count":%u,"type":"VEC2"})", n);
        }
        const auto say_indices = [&](const mesh_range& range) {
            if (range.index_count == 0) return;
            say(json, R"(,{"bufferView":1,"byteOffset":%zu,"componentType":%d,"count":%u,"type":"SCALAR"})",
                std::size_t{range.first_index} * (wide ? 4u : 2u), wide ? 5125 : 5123, range.index_count);
        };
        for (std::size_t i = 0; i < (packed ? plan.glyphs().size() : 1); ++i)
            for (const part p : plan.parts()) say_indices(packed ? plan.range(i, p) : plan.range(p));
        json += "]}";
    }
    json.resize((json.size() + 3) / 4 * 4, ' ');

    const bool filled = size.triangles != 0;
    const std::size_t file = 20 + json.size() + (filled ? 8 + bytes : 0);
    if (file > 0xFFFF'FFFFu) return error::too_large;
    out.resize(file);
    std::byte* at = out.data();
    const auto word = [&at](std::size_t value) {  // little endian
        for (int i = 0; i < 4; ++i) *at++ = static_cast<std::byte>(value >> (8 * i) & 0xFF);
    };
    word(0x4654'6C67), word(2), word(file);
    word(json.size()), word(0x4E4F'534A);
    std::memcpy(at, json.data(), json.size());
    if (!filled) return {};
    at += json.size();
    word(bytes), word(0x004E'4942);
    std::memset(at, 0, bytes);  // the gaps between attributes, and the end
    if (pixel_bytes != 0) std::memcpy(at + pixel_at, white_pixel, pixel_bytes);
    const std::span vertices{at, vertex_bytes};
    if (wide)
        return write_buffer(plan, how, uv, vertices,
                            std::span{reinterpret_cast<std::uint32_t*>(at + vertex_bytes), index_bytes / 4});
    return write_buffer(plan, how, uv, vertices,
                        std::span{reinterpret_cast<std::uint16_t*>(at + vertex_bytes), index_bytes / 2});
}

}  // namespace engines::gltf
