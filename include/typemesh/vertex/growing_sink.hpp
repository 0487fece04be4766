// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/core/impl/attempt.hpp>
#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/impl/index_writer.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// A contiguous container that can be resized: std::vector, and the containers of most engines.
template <class C>
concept sizable_array = requires(C& c, std::size_t n) {
    typename C::value_type;
    { c.resize(n) };
    { c.data() } -> std::same_as<typename C::value_type*>;
};

/// Resizes two containers of the caller to the size of the mesh, then writes like array_sink. The old elements are
/// replaced. The sink refers to the containers until end(). base_vertex is added to every index.
///
/// resize() of a std::vector first sets new elements to zero; if this is too slow, see uninitialised_allocator.hpp.
///
/// If a container throws because it is out of memory, the result is error::out_of_memory (if exceptions are enabled).
/// Both containers are then unchanged if they have reserve().
template <sizable_array Vertices, sizable_array Indices, vertex_writer Writer>
class growing_sink {
    using vertex_type = typename Vertices::value_type;
    using index_type = typename Indices::value_type;

public:
    static constexpr attribute wants = Writer::wants;

    growing_sink(Vertices& vertices, Indices& indices, Writer writer, std::uint32_t base_vertex = 0) noexcept
        : vertices_{&vertices}, indices_{&indices}, index_{base_vertex}, writer_{std::move(writer)}
    {
    }

    error begin(mesh_size exact) noexcept { return begin_numbering(exact, exact.vertices); }
    /// See chunked_sink: the index type must only be wide enough for the vertices of one chunk.
    error begin_chunks(mesh_size exact, std::uint32_t most) noexcept { return begin_numbering(exact, most); }
    /// See ranged_sink.
    [[nodiscard]] growing_sink subrange(mesh_range range) const noexcept
        requires std::is_copy_constructible_v<Writer>
    {
        growing_sink sub = *this;
        sub.next_vertex_ += range.first_vertex;
        sub.index_.skip(range.first_index);
        return sub;
    }
    void vertex(const surface_point<wants>& s) noexcept
    {
        TYPEMESH_ASSERT(next_vertex_ != nullptr && next_vertex_ < vertices_->data() + vertices_->size(),
                        "more vertices were written than the sink can hold");
        *next_vertex_++ = writer_(s);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) noexcept
    {
        TYPEMESH_ASSERT(index_.fits_before(indices_->data() + indices_->size()),
                        "more triangles were written than the sink can hold");
        index_.triangle(a, b, c);
    }
    void end() noexcept {}

private:
    error begin_numbering(mesh_size exact, std::uint64_t numbered) noexcept
    {
        if (error e = index_.numbers(numbered)) return e;
        if (!resize_both(exact.vertices, exact.indices())) return error::out_of_memory;
        next_vertex_ = vertices_->data();
        index_.start(indices_->data());
        return {};
    }

    /// On a 32-bit machine, counts that std::size_t cannot hold do not fit into memory.
    template <std::unsigned_integral Count>
    bool resize_both(Count vertices, Count indices) noexcept
    {
        return std::in_range<std::size_t>(vertices) && std::in_range<std::size_t>(indices) &&
               resize(static_cast<std::size_t>(vertices), static_cast<std::size_t>(indices));
    }
    bool resize(std::size_t vertices, std::size_t indices) noexcept
    {
        constexpr bool reserve = requires {
            vertices_->reserve(vertices);
            indices_->reserve(indices);
        };
        return detail::attempt([&] {
            if constexpr (reserve) {
                vertices_->reserve(vertices);
                indices_->reserve(indices);
            }
            vertices_->resize(vertices);
            indices_->resize(indices);
        });
    }

    Vertices* vertices_;
    Indices* indices_;
    vertex_type* next_vertex_ = nullptr;
    index_writer<index_type> index_;
    Writer writer_;
};

/// A sink that resizes two containers: `std::vector<my_vertex>` and `std::vector<std::uint32_t>`, or the like.
template <sizable_array Vertices, sizable_array Indices>
[[nodiscard]] auto into(Vertices& vertices, Indices& indices, std::uint32_t base_vertex = 0) noexcept
{
    require_vertex_traits<typename Vertices::value_type>();
    return growing_sink<Vertices, Indices, vertex_traits<typename Vertices::value_type>>{
        vertices, indices, {}, base_vertex};
}

/// A sink that resizes two containers, with a writer of your own, which may have state.
template <sizable_array Vertices, sizable_array Indices, vertex_writer Writer>
[[nodiscard]] auto into(Vertices& vertices, Indices& indices, Writer writer, std::uint32_t base_vertex = 0) noexcept
{
    return growing_sink<Vertices, Indices, Writer>{vertices, indices, std::move(writer), base_vertex};
}

/// A sink that resizes two containers, with a lambda: see lambda_writer.
template <sizable_array Vertices, sizable_array Indices, vertex_lambda Make>
[[nodiscard]] auto into(Vertices& vertices, Indices& indices, Make make, std::uint32_t base_vertex = 0) noexcept
{
    return into(vertices, indices, writer_of<typename Vertices::value_type>(std::move(make)), base_vertex);
}

}  // namespace typemesh::inline TYPEMESH_ABI
