// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/text/text_report.hpp>
#include <typemesh/vertex/bounds3.hpp>
#include <typemesh/vertex/mesh_range.hpp>
#include <typemesh/vertex/part.hpp>

#include <cstddef>
#include <cstdint>
#include <span>

namespace typemesh_web {

/// The names of parts, as typemesh::part counts them; the parts of a ring come before the parts of the letter within it.
inline constexpr const char* part_names[] = {"front",      "back",         "side",        "front_bevel",
                                             "back_bevel", "letter_front", "letter_back", "letter_side"};

/// A vector as streams write it into arrays of numbers.
struct float3 {
    float x, y, z;
};

/// An array's bytes from a number on. The span's type is written out: older standard libraries take a temporary view for a constant one.
inline std::span<std::byte> bytes_of(typemesh::buffer<float>& b, std::size_t from = 0) noexcept
{
    return std::as_writable_bytes(std::span<float>{b.data(), b.size()}.subspan(from));
}

/// As JavaScript reads it: five numbers of 32 bits.
struct web_part {
    std::uint32_t name, first_index, index_count, first_vertex, vertex_count;
};

/// A letter of an instanced text: its glyph, and its parts among all.
struct web_letter {
    std::uint32_t glyph, first_part, part_count;
};

/// A mesh in arrays that keep their memory from text to text.
struct mesh_arrays {
    typemesh::buffer<float> position, normal, uv;
    typemesh::buffer<std::uint32_t> index;
    typemesh::buffer<web_part> parts;
    typemesh::buffer<web_letter> letters;
    typemesh::buffer<std::uint32_t> instances;  ///< which letter each is
    typemesh::buffer<float> translations;       ///< three each
    typemesh::buffer<std::uint32_t> letter_of;  ///< for each vertex the row of its letter, if that is wanted
    typemesh::buffer<float> letter_rows;        ///< five each: pivot, word (-1: a bar has none), line
    typemesh::buffer<std::uint32_t> tints;      ///< for each vertex, if tags give colours: red, green, blue from the
                                                ///< lowest byte on, and in the highest 255 where they give none
    typemesh::bounds3 bounds{};
    typemesh::text_report report;
    std::uint64_t contour_points = 0;
    std::uint32_t lines = 0;
    double advance = 0.0;            ///< of the longest line, in em
    double plan_microseconds = 0.0;  ///< shaping, building, placing: all but writing

    [[nodiscard]] std::size_t vertices() const noexcept { return position.size() / 3; }
    [[nodiscard]] std::size_t triangles() const noexcept { return index.size() / 3; }

    void clear() noexcept
    {
        position.clear(), normal.clear(), uv.clear(), index.clear();
        parts.clear(), letters.clear(), instances.clear(), translations.clear();
        letter_of.clear(), letter_rows.clear(), tints.clear();
        bounds = {}, report = {}, contour_points = 0, lines = 0, advance = 0.0, plan_microseconds = 0.0;
    }

    /// Adds room for exactly so many, not set; false when memory runs out.
    [[nodiscard]] bool make_room(std::size_t vertex_count, std::size_t index_count) noexcept
    {
        const std::size_t all = vertices() + vertex_count;
        return position.reserve(3 * all) && normal.reserve(3 * all) && uv.reserve(2 * all) &&
               index.reserve(index.size() + index_count) &&
               (vertex_count == 0 || append_all(vertex_count, index_count));
    }

    /// Adds what one solid's letters lack.
    void add(const typemesh::text_report& r) noexcept
    {
        if (report.glyphs == 0) {
            report = r;
            return;
        }
        if (report.missing == 0) report.first_missing = r.first_missing;
        if (report.refused == 0) report.first_refusal = r.first_refusal;
        report.glyphs += r.glyphs, report.missing += r.missing, report.refused += r.refused;
        report.narrowed += r.narrowed;
    }

    /// Adds a part, unless it is empty; false when memory runs out.
    [[nodiscard]] bool add_part(typemesh::part p, const typemesh::mesh_range& r) noexcept
    {
        return r.index_count == 0 || parts.push_back({static_cast<std::uint32_t>(p), r.first_index, r.index_count,
                                                      r.first_vertex, r.vertex_count});
    }

private:
    bool append_all(std::size_t vertex_count, std::size_t index_count) noexcept
    {
        return position.append(3 * vertex_count) != nullptr && normal.append(3 * vertex_count) != nullptr &&
               uv.append(2 * vertex_count) != nullptr && index.append(index_count) != nullptr;
    }
};

}  // namespace typemesh_web
