// SPDX-License-Identifier: MIT

#include <typemesh/vertex/half.hpp>
#include <typemesh/vertex/octahedral.hpp>
#include <typemesh/vertex/stream_sink.hpp>
#include <typemesh/vertex/ten_bit.hpp>

#include <array>
#include <cstring>
#include <vector>

#include "refusals.hpp"
#include "support/catch.hpp"
#include "support/guarded_bytes.hpp"

using namespace typemesh;

namespace {

struct float3 {
    float x, y, z;
    friend bool operator==(const float3&, const float3&) = default;
};
struct float2 {
    float u, v;
    friend bool operator==(const float2&, const float2&) = default;
};

/// A stream of one's own: a normal in four signed bytes.
struct packed_normals {
    static constexpr auto wants = attribute::normal;
    std::array<signed char, 4>* data;
    std::size_t capacity;

    void put(std::size_t i, const surface_point<wants>& s) const noexcept
    {
        const auto byte = [](float f) { return static_cast<signed char>(f * 127.0f); };
        data[i] = {byte(s.normal.x), byte(s.normal.y), byte(s.normal.z), 0};
    }
};

surface_point<attribute::position | attribute::normal | attribute::uv> numbered(std::uint32_t i)
{
    const auto f = static_cast<float>(i);
    surface_point<attribute::position | attribute::normal | attribute::uv> s;
    s.position = {f, f + 0.25f, f + 0.5f};
    s.normal = {0.0f, 0.0f, 1.0f};
    s.uv = {-f, f};
    return s;
}

}  // namespace

static_assert(vertex_stream<stream<attribute::uv, float2>>);
static_assert(vertex_stream<packed_normals>);

TEST_CASE("stream_sink writes each attribute into its own array", "[vertex]")
{
    std::vector<float3> positions(4), normals(4);
    std::vector<float2> uvs(4);
    std::vector<std::uint16_t> indices(6);
    stream_sink sink{std::span{indices}, stream<attribute::position, float3>{positions},
                     stream<attribute::normal, float3>{normals}, stream<attribute::uv, float2>{uvs}};
    static_assert(mesh_sink<decltype(sink)>);
    static_assert(sink.wants == (attribute::position | attribute::normal | attribute::uv));
    REQUIRE_FALSE(sink.begin({4, 2}));
    for (std::uint32_t i = 0; i < 4; ++i) sink.vertex(numbered(i));
    sink.triangle(0, 1, 2);
    sink.triangle(1, 3, 2);
    sink.end();
    for (std::size_t i = 0; i < 4; ++i) {
        const auto f = static_cast<float>(i);
        CHECK(positions[i] == float3{f, f + 0.25f, f + 0.5f});
        CHECK(normals[i] == float3{0.0f, 0.0f, 1.0f});
        CHECK(uvs[i] == float2{-f, f});
    }
    CHECK(indices == std::vector<std::uint16_t>{0, 1, 2, 1, 3, 2});
}

TEST_CASE("a stream with a stride does not write between its elements", "[vertex]")
{
    for (const std::size_t stride : {std::size_t{12}, std::size_t{16}, std::size_t{20}, std::size_t{64}}) {
        std::vector<float> bytes(5 * stride / sizeof(float) + 4, -7.0f);
        std::vector<std::uint32_t> indices;
        stream_sink sink{std::span{indices}, stream<attribute::position, float3>{bytes.data() + 2, 5, stride}};
        static_assert(sink.wants == attribute::position);
        REQUIRE_FALSE(sink.begin({5, 0}));
        for (std::uint32_t i = 0; i < 5; ++i) sink.vertex(only<attribute::position>(numbered(i)));
        sink.end();
        for (std::size_t k = 0; k < bytes.size(); ++k) {
            const std::size_t step = stride / sizeof(float), i = (k - 2) / step, part = (k - 2) % step;
            INFO("float " << k << " at stride " << stride);
            if (k < 2 || i >= 5 || part >= 3)
                CHECK(bytes[k] == -7.0f);
            else
                CHECK(bytes[k] == static_cast<float>(i) + 0.25f * static_cast<float>(part));
        }
    }
}

TEST_CASE("streams can share one interleaved array, and an element can have a user's own packing", "[vertex]")
{
    struct vertex {
        float3 position;
        std::array<signed char, 4> normal;
    };
    std::vector<vertex> vertices(3);
    std::vector<std::array<signed char, 4>> normals(3);
    std::vector<std::uint32_t> indices(3);
    stream_sink sink{std::span{indices}, stream<attribute::position, float3>{&vertices[0].position, 3, sizeof(vertex)},
                     packed_normals{normals.data(), normals.size()}};
    REQUIRE_FALSE(sink.begin({3, 1}));
    for (std::uint32_t i = 0; i < 3; ++i) sink.vertex(only < attribute::position | attribute::normal > (numbered(i)));
    sink.triangle(0, 1, 2);
    sink.end();
    CHECK(vertices[2].position == float3{2.0f, 2.25f, 2.5f});
    CHECK(normals[2][2] == 127);
}

TEST_CASE("stream_sink reports what does not fit before it writes anything", "[vertex]")
{
    std::vector<float3> positions(4, float3{9, 9, 9});
    std::vector<float2> uvs(3, float2{9, 9});
    std::vector<std::uint16_t> indices(3, 77);
    stream_sink sink{std::span{indices}, stream<attribute::position, float3>{positions},
                     stream<attribute::uv, float2>{uvs}};
    CHECK_FALSE(sink.begin({3, 1}));
    test::check_refused(sink.begin({4, 1}), error::buffer_too_small, 4);
    test::check_refused(sink.begin({3, 2}), error::buffer_too_small, 6);
    test::check_refused(sink.begin({65536, 1}), error::index_overflow, 65536);
    CHECK(positions == std::vector<float3>(4, float3{9, 9, 9}));
    CHECK(indices == std::vector<std::uint16_t>(3, 77));
}

TEST_CASE("stream_sink adds the base vertex to every index, and counts it towards the index limit", "[vertex]")
{
    std::vector<float2> uvs(3);
    std::vector<std::uint16_t> indices(3);
    stream_sink sink{std::span{indices}, 65000, stream<attribute::uv, float2>{uvs}};
    REQUIRE_FALSE(sink.begin({3, 1}));
    for (std::uint32_t i = 0; i < 3; ++i) sink.vertex(only<attribute::uv>(numbered(i)));
    sink.triangle(0, 1, 2);
    sink.end();
    CHECK(indices == std::vector<std::uint16_t>{65000, 65001, 65002});
    std::vector<float2> many(600);
    stream_sink last{std::span{indices}, 65000, stream<attribute::uv, float2>{many}};
    CHECK_FALSE(last.begin({535, 1}));
    test::check_refused(last.begin({536, 1}), error::index_overflow, 65536);
}

TEST_CASE("every attribute has a stream", "[vertex]")
{
    struct float4 {
        float x, y, z, w;
    };
    std::vector<float4> tangents(2);
    std::vector<std::uint16_t> glyphs(2);
    std::vector<std::uint32_t> clusters(2);
    std::vector<float> parts(2);
    std::vector<std::uint8_t> styles(2);
    std::vector<vec3> curves(2);
    std::vector<std::uint32_t> indices;
    stream_sink sink{std::span{indices},
                     stream<attribute::tangent, float4>{tangents},
                     stream<attribute::glyph, std::uint16_t>{glyphs},
                     stream<attribute::cluster, std::uint32_t>{clusters},
                     stream<attribute::part, float>{parts},
                     stream<attribute::style, std::uint8_t>{styles},
                     stream<attribute::curve, vec3>{curves}};
    static_assert(mesh_sink<decltype(sink)>);
    REQUIRE_FALSE(sink.begin({2, 0}));
    surface_point<sink.wants> s;
    s.tangent = {1, 2, 3, -1};
    s.glyph = 37;
    s.cluster = 4;
    s.part = part::side;
    s.style = style_id{9};
    s.curve = {1, 2, 3};
    sink.vertex(s);
    s.style = style_id{5};
    s.part = part::back;
    sink.vertex(s);
    sink.end();
    CHECK(tangents[1].z == 3.0f);
    CHECK(tangents[1].w == -1.0f);
    CHECK(curves[0] == vec3{1, 2, 3});
    CHECK(glyphs == std::vector<std::uint16_t>{37, 37});
    CHECK(clusters == std::vector<std::uint32_t>{4, 4});
    CHECK(parts == std::vector<float>{2.0f, 1.0f});
    CHECK(styles == std::vector<std::uint8_t>{9, 5});
}

TEST_CASE("streams in bytes contain as many elements as fit, and write up to exactly the last byte", "[vertex]")
{
    CHECK(elements_in(0, 12, 20) == 0);
    CHECK(elements_in(11, 12, 20) == 0);
    CHECK(elements_in(12, 12, 20) == 1);
    CHECK(elements_in(31, 12, 20) == 1);
    CHECK(elements_in(32, 12, 20) == 2);
    CHECK(elements_in(100, 20, 20) == 5);

    // Interleaved: position at 0, uv at 12, and the last vertex's padding is not there.
    const test::guarded_bytes memory{24 * 6 + 20}, indices{2 * 3};
    stream_sink sink{indices.as<std::uint16_t>(), stream<attribute::position, float3>::in(memory.bytes(), 0, 24),
                     stream<attribute::uv, float2>::in(memory.bytes(), 12, 24)};
    test::check_refused(sink.begin({8, 1}), error::buffer_too_small, 8);
    CHECK(sink.begin({7, 2}) == error::buffer_too_small);
    CHECK(memory.untouched());
    CHECK(indices.untouched());
    REQUIRE_FALSE(sink.begin({7, 1}));
    for (std::uint32_t i = 0; i < 7; ++i) sink.vertex(only < attribute::position | attribute::uv > (numbered(i)));
    sink.triangle(4, 5, 6);
    sink.end();
    for (std::size_t i = 0; i < 7; ++i) {
        float f[5];
        std::memcpy(f, memory.bytes().data() + 24 * i, sizeof f);
        CHECK(f[1] == static_cast<float>(i) + 0.25f);
        CHECK(f[4] == static_cast<float>(i));
        for (std::size_t k = 20; k < 24 && i < 6; ++k) CHECK(memory.bytes()[24 * i + k] == std::byte{0xEE});
    }
    CHECK(indices.as<std::uint16_t>()[2] == 6);
    CHECK(stream<attribute::uv, float2>::in(memory.bytes(), 1000, 24).capacity == 0);
}

TEST_CASE("streams of packed formats are declared like all others", "[vertex]")
{
    struct half2 {
        half u, v;
    };
    struct snorm8x4 {
        snorm8 x, y, z, w = 0.0f;
    };
    std::vector<half2> uvs(3);
    std::vector<snorm8x4> bytes(3);
    std::vector<octahedral32> normals(3);
    std::vector<snorm10> ten(3);
    std::vector<std::uint32_t> indices;
    stream_sink sink{std::span{indices}, stream<attribute::uv, half2>{uvs}, stream<attribute::normal, snorm8x4>{bytes},
                     stream<attribute::normal, octahedral32>{normals}, stream<attribute::normal, snorm10>{ten}};
    REQUIRE_FALSE(sink.begin({3, 0}));
    for (std::uint32_t i = 0; i < 3; ++i) sink.vertex(only < attribute::normal | attribute::uv > (numbered(i)));
    sink.end();
    CHECK(static_cast<float>(uvs[2].u) == -2.0f);
    CHECK(bytes[1].z.bits == 127);
    CHECK(normals[2].decoded() == vec3{0, 0, 1});
    CHECK(ten[0].decoded() == vec4{0, 0, 1, 0});
}

TEST_CASE("a subrange of streams begins at its own vertex and its own index", "[vertex]")
{
    std::vector<typemesh::vec3> places(6);
    std::vector<std::uint32_t> indices(9);
    typemesh::stream_sink sink{std::span{indices},
                               typemesh::stream<typemesh::attribute::position, typemesh::vec3>{std::span{places}}};
    REQUIRE_FALSE(sink.begin({6, 3}));
    auto sub = sink.subrange({2, 3, 6, 3});
    typemesh::surface_point<typemesh::attribute::position> p;
    p.position = {1.0f, 2.0f, 3.0f};
    sub.vertex(p);
    sub.triangle(3, 4, 5);
    for (std::size_t i = 0; i < 6; ++i) CHECK(places[i] == (i == 2 ? p.position : typemesh::vec3{}));
    for (std::size_t i = 0; i < 9; ++i) CHECK(indices[i] == (i < 6 ? 0u : static_cast<std::uint32_t>(i - 3)));
}
