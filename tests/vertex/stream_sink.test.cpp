// SPDX-License-Identifier: MIT

#include <typemesh/vertex/stream_sink.hpp>

#include <array>
#include <cstring>
#include <vector>

#include "support/catch.hpp"

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

TEST_CASE("stream_sink writes each attribute into an array of its own", "[vertex]")
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

TEST_CASE("a stream with a stride leaves the bytes between its elements alone", "[vertex]")
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

TEST_CASE("streams may lie in one interleaved array, and one may be packed by its own author", "[vertex]")
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
    for (std::uint32_t i = 0; i < 3; ++i) sink.vertex(only<attribute::position | attribute::normal>(numbered(i)));
    sink.triangle(0, 1, 2);
    sink.end();
    CHECK(vertices[2].position == float3{2.0f, 2.25f, 2.5f});
    CHECK(normals[2][2] == 127);
}

TEST_CASE("stream_sink says what does not fit before it writes anything", "[vertex]")
{
    std::vector<float3> positions(4, float3{9, 9, 9});
    std::vector<float2> uvs(3, float2{9, 9});
    std::vector<std::uint16_t> indices(3, 77);
    stream_sink sink{std::span{indices}, stream<attribute::position, float3>{positions},
                     stream<attribute::uv, float2>{uvs}};
    CHECK_FALSE(sink.begin({3, 1}));
    const error shortest = sink.begin({4, 1});
    CHECK(shortest == error::buffer_too_small);
    CHECK(shortest.count == 4);
    const error few = sink.begin({3, 2});
    CHECK(few == error::buffer_too_small);
    CHECK(few.count == 6);
    const error many = sink.begin({65536, 1});
    CHECK(many == error::index_overflow);
    CHECK(many.count == 65536);
    CHECK(positions == std::vector<float3>(4, float3{9, 9, 9}));
    CHECK(indices == std::vector<std::uint16_t>(3, 77));
}
