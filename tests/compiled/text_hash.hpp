// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/typemesh.hpp>

#include <bit>
#include <cstdint>
#include <vector>

namespace test {

/// What a unit makes of a text, and how it is compiled. The same type in all units, whichever namespace typemesh is in.
struct text_hash {
    std::uint64_t hash = 0;
    std::uint64_t vertices = 0;
    const void* own_place = nullptr;  ///< of a variable of typemesh: units that share functions share it
};

text_hash hash_of_header_only_unit(const char* font, const char* text);

}  // namespace test

namespace {  // every unit has its own: typemesh is not the same in all

struct vertex {
    typemesh::vec3 position, normal;
};

}  // namespace

template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position | attribute::normal;
    vertex operator()(const surface_point<wants>& s) const noexcept { return {s.position, s.normal}; }
};

namespace {

test::text_hash hash_of(const char* font_file, const char* text)
{
    auto font = typemesh::harfbuzz_font::open(font_file);
    if (!font) return {};
    typemesh::text_mesher mesher{*font};
    std::vector<vertex> vertices;
    std::vector<std::uint32_t> indices;
    if (!mesher.build(text, typemesh::into(vertices, indices), {.merge = true})) return {};
    test::text_hash made{0xcbf2'9ce4'8422'2325u, vertices.size(), &typemesh::detail::place_of_type<int>};
    const auto add = [&made](std::uint32_t v) { made.hash = (made.hash ^ v) * 0x100'0000'01b3u; };
    for (const vertex& v : vertices)
        for (const float x : {v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z})
            add(std::bit_cast<std::uint32_t>(x));
    for (const std::uint32_t i : indices) add(i);
    return made;
}

}  // namespace
