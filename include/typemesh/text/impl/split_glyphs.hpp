// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/assert.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/triangle.hpp>
#include <typemesh/extrude/extrude.hpp>
#include <typemesh/glyph/built_glyph.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Glyphs with more vertices than a mesh may have, split into pieces that fit. Each piece has the numbers of the
/// vertices that it uses, ascending, and its triangles over these. Vertices of several pieces are repeated.
///
/// Pieces take the extruder's triangles in its own order (front, back, side), each as many as fit. Unused vertices are
/// omitted.
class split_glyphs {
public:
    explicit split_glyphs(memory source) noexcept : used_{source}, triangles_{source}, pieces_{source}, place_{source}
    {
    }

    void clear() noexcept
    {
        used_.clear();
        triangles_.clear();
        pieces_.clear();
    }

    /// The number of pieces of all glyphs, and the size of each part of one piece.
    [[nodiscard]] std::uint32_t size() const noexcept { return static_cast<std::uint32_t>(pieces_.size()); }
    [[nodiscard]] const part_sizes& sizes(std::size_t number) const noexcept { return pieces_[number].sizes; }

    /// Splits a glyph into pieces of at most `most` vertices, most >= 3, and appends them to the existing ones.
    ///
    /// Fails  error::out_of_memory, error::too_large; the content is then meaningless until clear()
    /// Cost   O(n + t) for n vertices and t triangles, plus for each piece the numbers from its lowest vertex to its
    ///        highest, in each part
    template <extruder Extruder>
    error split(const built_glyph& built, const Extruder& how, bool turned, std::uint32_t most) noexcept
    {
        const auto [vertices, triangles] = built.sizes().total();
        const first_vertices first = built.sizes().vertices.starts();
        if (vertices > 0xFFFF'FFFEu || triangles_.size() + triangles > 0xFFFF'FFFFu) return error::too_large;
        place_.clear();
        std::uint32_t* place = place_.append(static_cast<std::size_t>(vertices));
        if (place == nullptr || !triangles_.reserve(triangles_.size() + static_cast<std::size_t>(triangles)))
            return error::out_of_memory;
        for (std::size_t i = 0; i < vertices; ++i) place[i] = unused;

        collector to{*this, first, most};
        for (const part p : parts_of<Extruder>) {
            to.now = p;
            write_triangles(p, built.planned<Extruder>(), how, first, turned, to);
        }
        to.close();
        return to.failure;
    }

    /// Writes one piece of the glyph that it was split from: all vertices, then all triangles, which are numbered from
    /// 0.
    template <extruder Extruder, mesh_sink Sink>
    void write(std::size_t number, const built_glyph& built, const Extruder& how, const placement& at,
               Sink& sink) const noexcept
    {
        const piece& one = pieces_[number];
        picker<Sink> to{sink, used_.view().subspan(one.first_used, one.used_count)};
        for (const part p : parts_of<Extruder>) {
            if (one.sizes.vertices[p] != 0)
                write_vertices(p, built.planned<Extruder>(), how, at, to);
            else
                to.number += built.sizes().vertices[p];
        }
        for (const triangle t : triangles_.view().subspan(one.first_triangle, one.triangle_count))
            sink.triangle(t.a, t.b, t.c);
    }

private:
    static constexpr std::uint32_t unused = 0xFFFF'FFFFu;

    struct piece {
        part_sizes sizes;
        std::uint32_t used_count = 0, triangle_count = 0;
        std::size_t first_used = 0, first_triangle = 0;
    };

    /// The sink for the triangles of a whole glyph, with the glyph's own numbers.
    struct collector {
        static constexpr attribute wants = attribute::none;

        split_glyphs& to;
        first_vertices first;
        std::uint32_t most;
        part now = part::front;
        piece open = {{}, 0, 0, to.used_.size(), to.triangles_.size()};
        std::uint32_t lowest[max_parts] = {};   // the range of vertices that the open piece uses in each part,
        std::uint32_t highest[max_parts] = {};  // if it uses any
        error failure = {};

        error begin(mesh_size) noexcept { return {}; }
        void vertex(const surface_point<wants>&) noexcept {}
        void end() noexcept {}

        void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
        {
            if (failure) return;
            const std::uint32_t* place = to.place_.data();
            const auto fresh = static_cast<std::uint32_t>((place[a] == unused) + (place[b] == unused && b != a) +
                                                          (place[c] == unused && c != a && c != b));
            if (fresh > most - open.used_count) close();
            if (failure) return;
            for (const std::uint32_t v : {a, b, c}) use(v);
            to.triangles_.push_back_unchecked({a, b, c});
            ++open.triangle_count;
            ++open.sizes.triangles[now];
        }

        void use(std::uint32_t v) noexcept
        {
            if (to.place_[v] != unused) return;
            to.place_[v] = 0;
            ++open.used_count;
            std::size_t k = max_parts - 1;
            while (v < first.of[k]) --k;
            if (open.sizes.vertices.of[k]++ == 0) lowest[k] = highest[k] = v;
            if (v < lowest[k]) lowest[k] = v;
            if (v > highest[k]) highest[k] = v;
        }

        /// Numbers the vertices of the open piece, and begins another one.
        void close() noexcept
        {
            if (failure || open.triangle_count == 0) return;
            std::uint32_t* used = to.used_.append(open.used_count);
            if (used == nullptr) {
                failure = error::out_of_memory;
                return;
            }
            std::uint32_t* place = to.place_.data();
            std::uint32_t number = 0;
            for (std::size_t k = 0; k < max_parts; ++k) {
                if (open.sizes.vertices.of[k] == 0) continue;
                for (std::uint32_t v = lowest[k]; v <= highest[k]; ++v) {
                    if (place[v] == unused) continue;
                    used[number] = v;
                    place[v] = number++;
                }
            }
            for (typemesh::triangle& t : to.triangles_.view().subspan(open.first_triangle))
                t = {place[t.a], place[t.b], place[t.c]};
            for (std::uint32_t i = 0; i < number; ++i) place[used[i]] = unused;
            if (!to.pieces_.push_back(open)) failure = error::out_of_memory;
            open = {{}, 0, 0, to.used_.size(), to.triangles_.size()};
        }
    };

    /// Forwards only the vertices of one piece from all vertices of a glyph.
    template <mesh_sink Sink>
    struct picker {
        static constexpr attribute wants = Sink::wants;

        Sink& sink;
        array_view<const std::uint32_t> left;
        std::uint32_t number = 0;

        error begin(mesh_size) noexcept { return {}; }
        void vertex(const surface_point<wants>& v) noexcept
        {
            if (!left.empty() && left.front() == number) {
                sink.vertex(v);
                left = left.subspan(1);
            }
            ++number;
        }
        void triangle(std::uint32_t, std::uint32_t, std::uint32_t) noexcept {}
        void end() noexcept {}
    };

    buffer<std::uint32_t> used_;
    triangle_list triangles_;
    buffer<piece> pieces_;
    buffer<std::uint32_t> place_;  // scratch of split(): for each of the glyph's vertices, its number in the piece
};

}  // namespace typemesh::inline TYPEMESH_ABI
