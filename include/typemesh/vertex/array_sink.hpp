// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/vertex/impl/index_writer.hpp>
#include <typemesh/vertex/ranged_sink.hpp>
#include <typemesh/vertex/vertex_lambda.hpp>
#include <typemesh/vertex/vertex_traits.hpp>

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// Writes whole vertices and indices into two arrays of the caller, which may be mapped GPU memory. Each element is
/// written once, in ascending order, and never read. Both arrays must stay in place until end(). base_vertex is added
/// to every index.
///
/// Fails in begin(), before anything is written:
///        error::buffer_too_small  a span is too short; count = the number of elements that it needs
///        error::index_overflow    Index cannot number base_vertex + vertices; count = that sum
template <class Vertex, class Index, vertex_writer Writer>
class array_sink {
public:
    static constexpr attribute wants = Writer::wants;

    array_sink(std::span<Vertex> vertices, std::span<Index> indices, Writer writer,
               std::uint32_t base_vertex = 0) noexcept
        : vertices_{vertices}, indices_{indices}, index_{base_vertex}, writer_{std::move(writer)}
    {
    }

    error begin(mesh_size exact) noexcept { return begin_numbering(exact, exact.vertices); }
    /// See chunked_sink: Index must only be wide enough for the vertices of one chunk.
    error begin_chunks(mesh_size exact, std::uint32_t most) noexcept { return begin_numbering(exact, most); }
    /// See ranged_sink.
    [[nodiscard]] array_sink subrange(mesh_range range) const noexcept
        requires std::is_copy_constructible_v<Writer>
    {
        array_sink sub = *this;
        sub.next_vertex_ += range.first_vertex;
        sub.index_.skip(range.first_index);
        return sub;
    }
    void vertex(const surface_point<wants>& s) noexcept
    {
        TYPEMESH_ASSERT(next_vertex_ != nullptr && next_vertex_ < vertices_.data() + vertices_.size(),
                        "more vertices were written than the sink can hold");
        *next_vertex_++ = writer_(s);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        TYPEMESH_ASSERT(index_.fits_before(indices_.data() + indices_.size()),
                        "more triangles were written than the sink can hold");
        index_.triangle(a, b, c);
    }
    void end() noexcept {}

private:
    error begin_numbering(mesh_size exact, std::uint64_t vertices) noexcept
    {
        if (error e = index_.numbers(vertices)) return e;
        if (exact.vertices > vertices_.size()) return error::short_of("vertices", exact.vertices);
        if (exact.indices() > indices_.size()) return error::short_of("indices", exact.indices());
        next_vertex_ = vertices_.data();
        index_.start(indices_.data());
        return {};
    }

    std::span<Vertex> vertices_;
    std::span<Index> indices_;
    Vertex* next_vertex_ = nullptr;
    index_writer<Index> index_;
    Writer writer_;
};

/// Names the missing specialisation in a compile error.
template <class Vertex>
constexpr void require_vertex_traits() noexcept
{
    static_assert(
        mesh_vertex<Vertex>,
        "typemesh: this vertex type has no usable typemesh::vertex_traits<Vertex>. Specialise it for your vertex: "
        "`static constexpr auto wants = ...` and `Vertex operator()(const surface_point<wants>&) const noexcept`; "
        "see typemesh/vertex/vertex_traits.hpp.");
}

/// A sink over two arrays; the writer is the vertex type's own vertex_traits.
template <class Vertex, std::size_t V, class Index, std::size_t I>
[[nodiscard]] auto into(std::span<Vertex, V> vertices, std::span<Index, I> indices,
                        std::uint32_t base_vertex = 0) noexcept
{
    require_vertex_traits<Vertex>();
    return array_sink<Vertex, Index, vertex_traits<Vertex>>{vertices, indices, {}, base_vertex};
}

/// A sink over two arrays with a writer of your own, which may have state.
template <class Vertex, std::size_t V, class Index, std::size_t I, vertex_writer Writer>
[[nodiscard]] auto into(std::span<Vertex, V> vertices, std::span<Index, I> indices, Writer writer,
                        std::uint32_t base_vertex = 0) noexcept
{
    return array_sink<Vertex, Index, Writer>{vertices, indices, std::move(writer), base_vertex};
}

/// A sink over two arrays with a lambda: see lambda_writer.
template <class Vertex, std::size_t V, class Index, std::size_t I, vertex_lambda Make>
[[nodiscard]] auto into(std::span<Vertex, V> vertices, std::span<Index, I> indices, Make make,
                        std::uint32_t base_vertex = 0) noexcept
{
    return into(vertices, indices, writer_of<Vertex>(std::move(make)), base_vertex);
}

// Pointers carry no size.
template <class Vertex, class Index, class... More>
[[nodiscard]] auto into(Vertex*, Index*, More...) noexcept
{
    static_assert(sizeof(Vertex) == 0,
                  "typemesh: into() needs the sizes: replace the pointers by "
                  "`std::span{vertices, how_many}` and `std::span{indices, how_many}`.");
    return into(std::span<Vertex>{}, std::span<Index>{});
}

}  // namespace typemesh::inline TYPEMESH_ABI
