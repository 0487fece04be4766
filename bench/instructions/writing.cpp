// SPDX-License-Identifier: MIT
//
// Writing from a plan, and the bytes that letters keep: a program of its own, so that what is compiled here leaves the other
// kernels' code as it is. See kernel.hpp.

#include "full_vertex.hpp"
#include "kernel.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/extrude/bevelled.hpp>
#include <typemesh/typemesh.hpp>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace bench {

struct position_vertex {
    typemesh::vec3 position;
};
struct lit_vertex {
    typemesh::vec3 position, normal;
    typemesh::vec4 tangent;
    typemesh::vec2 uv;
};

}  // namespace bench

template <>
struct typemesh::vertex_traits<bench::position_vertex> {
    static constexpr auto wants = attribute::position;
    bench::position_vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position}; }
};
template <>
struct typemesh::vertex_traits<bench::lit_vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::tangent | attribute::uv;
    bench::lit_vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {s.position, s.normal, s.tangent, s.uv};
    }
};

namespace {

using namespace typemesh;
using namespace bench;

/// Lorem ipsum, planned once and written so many times: what a vertex costs.
template <class Vertex, class Solid>
std::size_t writes(const Solid& solid, const text_options& options, int times)
{
    auto font = open_font(sans);
    auto mesher = text_mesher{font}.with(solid);
    const std::string text = first_line("long-latin.txt");
    const auto plan = mesher.plan(text, options);
    if (!plan) std::abort();
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < times + 1; ++i)
        if (!plan->write(into(vertices, indices))) std::abort();
    return 1;
}

std::size_t chunked_writes(int times)
{
    auto font = open_font(sans);
    text_mesher mesher{font};
    const std::string text = first_line("long-latin.txt");
    const auto plan = mesher.plan(text);
    text_chunks chunks;
    std::vector<full_vertex> vertices;
    std::vector<std::uint16_t> indices;
    if (!plan || !chunks.cut(*plan, 4096)) std::abort();
    for (int i = 0; i < times + 1; ++i)
        if (!chunks.write(*plan, into(vertices, indices))) std::abort();
    return 1;
}

/// Bytes that a letter keeps in a cache, on average over the printable ASCII characters.
template <class Solid>
std::size_t kept_bytes(const Solid& solid)
{
    auto font = open_font(sans);
    glyph_cache cache;
    std::string text;
    for (char c = '!'; c <= '~'; ++c) text += c;
    std::vector<full_vertex> vertices;
    std::vector<std::uint32_t> indices;
    auto mesher = text_mesher{font}.with(solid).with(cached_in{cache, 1});
    if (!mesher.build(text, into(vertices, indices))) std::abort();
    return cache.statistics().bytes / cache.statistics().entries;
}

/// A frame turned by the rotation of 2/3, 1/3, 2/3: nothing of it is along an axis.
constexpr frame tilted{.right = {2.0f / 3, 1.0f / 3, 2.0f / 3},
                       .up = {-2.0f / 3, 2.0f / 3, 1.0f / 3},
                       .toward = {-1.0f / 3, -2.0f / 3, 2.0f / 3}};

constexpr kernel kernels[] = {
    {"write", "text", "lorem ipsum, extruded, written from its plan: position, normal, texture coordinates",
     [](int n) { return writes<full_vertex>(extruded<>{}, {}, n); }},
    {"write_positions", "text", "the same, positions alone",
     [](int n) { return writes<position_vertex>(extruded<>{}, {}, n); }},
    {"write_tangents", "text", "the same, with tangents",
     [](int n) { return writes<lit_vertex>(extruded<>{}, {}, n); }},
    {"write_tilted", "text", "the same without tangents, in a frame along no axis",
     [](int n) { return writes<full_vertex>(extruded<>{}, {.frame = tilted}, n); }},
    {"write_bevelled", "text", "the same in the usual frame, with round bevels",
     [](int n) { return writes<full_vertex>(bevelled{.profile = round_profile()}, {}, n); }},
    {"write_chunks", "text", "extruded, in chunks of at most 4,096 vertices, 16-bit indices", chunked_writes},
    {"kept_extruded", "byte", "a letter in a glyph_cache, extruded, the average of ASCII",
     [](int) { return kept_bytes(extruded<>{}); }},
    {"kept_bevelled", "byte", "the same with a round bevel",
     [](int) { return kept_bytes(bevelled{.profile = round_profile()}); }},
    {"mesher", "byte", "text_mesher over HarfBuzz", [](int) { return sizeof(text_mesher<>); }},
};

}  // namespace

int main(int argc, char** argv) { return run_one_of(kernels, argc, argv); }
