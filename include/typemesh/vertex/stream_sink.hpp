// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/assert.hpp>
#include <typemesh/core/error.hpp>
#include <typemesh/vertex/array_sink.hpp>
#include <typemesh/vertex/impl/index_writer.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// The number of elements, `stride` bytes apart, that fit into `bytes`; the last element needs no padding after it.
[[nodiscard]] constexpr std::size_t elements_in(std::size_t bytes, std::size_t element, std::size_t stride) noexcept
{
    return bytes < element ? 0 : (bytes - element) / (stride != 0 ? stride : 1) + 1;
}

/// One attribute in an array of its own: element i of type T is `stride` bytes after element i - 1.
///
/// T is constructed from the attribute: T{x, y, z} for positions, normals, curves, pivots and extents, T{u, v} for
/// texture coordinates, T{x, y, z, sign} for tangents, T(number) for glyph, cluster, style, letter, word, line and part
/// (0 front, 1 back, 2 side, 3 and more: further parts). Packed formats are also possible: snorm10, octahedral32, or
/// structures of half, snorm16 and so on. Each element is written whole, once, in ascending order, and never read, so
/// the memory may be mapped.
template <attribute A, class T>
struct stream {
    static constexpr attribute wants = A;
    static_assert(A == attribute::position || A == attribute::normal || A == attribute::uv || A == attribute::tangent ||
                      A == attribute::glyph || A == attribute::cluster || A == attribute::part ||
                      A == attribute::style || A == attribute::curve || A == attribute::letter ||
                      A == attribute::word || A == attribute::line || A == attribute::pivot || A == attribute::extent,
                  "typemesh: a stream holds one attribute; computed_stream takes several");

    void* data = nullptr;      ///< the first element, aligned for T
    std::size_t capacity = 0;  ///< the number of elements
    std::size_t stride = sizeof(T);

    constexpr stream(void* first, std::size_t elements, std::size_t bytes_apart = sizeof(T)) noexcept
        : data{first}, capacity{elements}, stride{bytes_apart}
    {
    }
    constexpr stream(std::span<T> elements) noexcept : data{elements.data()}, capacity{elements.size()} {}

    /// As many elements as fit into a block of bytes. The first element is `offset` bytes from the start of the block:
    /// one attribute of an interleaved vertex of `bytes_apart` bytes.
    [[nodiscard]] static stream in(std::span<std::byte> bytes, std::size_t offset,
                                   std::size_t bytes_apart = sizeof(T)) noexcept
    {
        if (offset > bytes.size()) return {nullptr, 0, bytes_apart};
        return {bytes.data() + offset, elements_in(bytes.size() - offset, sizeof(T), bytes_apart), bytes_apart};
    }

    /// Writes element i.
    void put(std::size_t i, const surface_point<wants>& s) const noexcept
    {
        void* place = static_cast<std::byte*>(data) + i * stride;
        if constexpr (A == attribute::position)
            ::new (place) T{s.position.x, s.position.y, s.position.z};
        else if constexpr (A == attribute::normal)
            ::new (place) T{s.normal.x, s.normal.y, s.normal.z};
        else if constexpr (A == attribute::uv)
            ::new (place) T{s.uv.x, s.uv.y};
        else if constexpr (A == attribute::tangent)
            ::new (place) T{s.tangent.x, s.tangent.y, s.tangent.z, s.tangent.w};
        else if constexpr (A == attribute::curve)
            ::new (place) T{s.curve.x, s.curve.y, s.curve.z};
        else if constexpr (A == attribute::glyph)
            ::new (place) T(static_cast<T>(s.glyph));
        else if constexpr (A == attribute::cluster)
            ::new (place) T(static_cast<T>(s.cluster));
        else if constexpr (A == attribute::part)
            ::new (place) T(static_cast<T>(s.part));
        else if constexpr (A == attribute::style)
            ::new (place) T(static_cast<T>(s.style));
        else if constexpr (A == attribute::letter)
            ::new (place) T(static_cast<T>(s.letter));
        else if constexpr (A == attribute::word)
            ::new (place) T(static_cast<T>(s.word));
        else if constexpr (A == attribute::line)
            ::new (place) T(static_cast<T>(s.line));
        else if constexpr (A == attribute::pivot)
            ::new (place) T{s.pivot.x, s.pivot.y, s.pivot.z};
        else
            ::new (place) T{s.extent.x, s.extent.y, s.extent.z};
    }
};

/// The requirements of stream_sink on a stream: `wants`, `capacity` in elements, and put(i, point), called once for
/// each i, ascending. computed_stream (computed_stream.hpp) makes one from any function.
template <class S>
concept vertex_stream = requires(const S& s, std::size_t i, const surface_point<S::wants>& p) {
    { S::wants } -> std::convertible_to<attribute>;
    { s.capacity } -> std::convertible_to<std::size_t>;
    { s.put(i, p) } noexcept;
};

/// Writes each attribute into an array of its own (structure of arrays), and the indices into one more.
///
///     stream_sink sink{std::span{indices}, stream<attribute::position, float3>{positions},
///                      stream<attribute::uv, float2>{uvs}};
///
///     stream_sink sink{std::span{indices}, base_vertex, ...};      // base_vertex is added to every index
///
/// Fails in begin(), before anything is written, as array_sink does.
template <class Index, vertex_stream... Streams>
class stream_sink {
public:
    static constexpr attribute wants = (attribute::none | ... | Streams::wants);

    explicit stream_sink(std::span<Index> indices, Streams... streams) noexcept
        : stream_sink{indices, 0u, std::move(streams)...}
    {
    }
    stream_sink(std::span<Index> indices, std::uint32_t base_vertex, Streams... streams) noexcept
        : indices_{indices}, streams_{std::move(streams)...}, index_{base_vertex}
    {
    }

    error begin(mesh_size exact) noexcept { return begin_numbering(exact, exact.vertices); }
    /// See chunked_sink: Index must only be wide enough for the vertices of one chunk.
    error begin_chunks(mesh_size exact, std::uint32_t most) noexcept { return begin_numbering(exact, most); }
    /// See ranged_sink.
    [[nodiscard]] stream_sink subrange(mesh_range range) const noexcept
        requires(std::is_copy_constructible_v<Streams> && ...)
    {
        stream_sink sub = *this;
        sub.next_vertex_ = range.first_vertex;
        sub.index_.skip(range.first_index);
        return sub;
    }
    void vertex(const surface_point<wants>& p) noexcept
    {
        TYPEMESH_ASSERT(can_hold(next_vertex_ + 1), "more vertices were written than the sink can hold");
        std::apply(
            [&](const auto&... s) { (s.put(next_vertex_, only<std::remove_cvref_t<decltype(s)>::wants>(p)), ...); },
            streams_);
        ++next_vertex_;
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
        if (exact.indices() > indices_.size()) return error::short_of("indices", exact.indices());
        if (!can_hold(exact.vertices)) return error::short_of("vertices", exact.vertices);
        next_vertex_ = 0;
        index_.start(indices_.data());
        return {};
    }

    [[nodiscard]] bool can_hold(std::uint64_t vertices) const noexcept
    {
        return std::apply([&](const auto&... s) { return ((vertices <= s.capacity) && ...); }, streams_);
    }

    std::span<Index> indices_;
    std::tuple<Streams...> streams_;
    std::size_t next_vertex_ = 0;
    index_writer<Index> index_;
};

template <class Index, std::size_t I, class... Streams>
stream_sink(std::span<Index, I>, Streams...) -> stream_sink<Index, Streams...>;
template <class Index, std::size_t I, std::integral Base, class... Streams>
stream_sink(std::span<Index, I>, Base, Streams...) -> stream_sink<Index, Streams...>;

}  // namespace typemesh::inline TYPEMESH_ABI
