// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/vertex/stream_sink.hpp>

#include <cstddef>
#include <span>
#include <type_traits>
#include <utility>

namespace typemesh::inline TYPEMESH_ABI {

/// An array of any values computed from surface points, for stream_sink: element i is the result of `make` for vertex
/// i.
///
///     make(surface_point<Wants>) noexcept -> element
///
/// computed_stream and constant_stream make it:
///
///     auto places = computed_stream<attribute::position>(
///         std::span{packed}, [box](const surface_point<attribute::position>& s) noexcept { return box(s.position); });
///     auto colours = constant_stream(std::span{array}, rgba8{1.0f, 0.5f, 0.0f});
template <attribute Wants, class T, class Make>
struct computed_elements {
    static constexpr attribute wants = Wants;

    void* data = nullptr;            ///< the first element, aligned for T
    std::size_t capacity = 0;        ///< the number of elements
    std::size_t stride = sizeof(T);  ///< bytes from one element to the next
    Make make;

    /// Writes element i.
    void put(std::size_t i, const surface_point<wants>& s) const noexcept
    {
        *reinterpret_cast<T*>(static_cast<std::byte*>(data) + i * stride) = make(s);
    }
};

/// A stream over an array.
template <attribute Wants, class T, std::size_t N, class Make>
[[nodiscard]] constexpr auto computed_stream(std::span<T, N> elements, Make make) noexcept
{
    static_assert(std::is_convertible_v<std::invoke_result_t<const Make&, const surface_point<Wants>&>, T>,
                  "typemesh: make(surface_point<Wants>) must return an element");
    return computed_elements<Wants, T, Make>{elements.data(), elements.size(), sizeof(T), std::move(make)};
}

/// A stream of Ts in a block of bytes: the first T is `offset` bytes from the start of the block, then one T follows
/// every `bytes_apart` bytes.
template <attribute Wants, class T, class Make>
[[nodiscard]] auto computed_stream(std::span<std::byte> bytes, std::size_t offset, std::size_t bytes_apart,
                                   Make make) noexcept
{
    const auto place = stream<attribute::position, T>::in(bytes, offset, bytes_apart);
    return computed_elements<Wants, T, Make>{place.data, place.capacity, bytes_apart, std::move(make)};
}

/// A stream that gives every vertex one constant element: a colour, a material number.
template <class T, std::size_t N>
[[nodiscard]] constexpr auto constant_stream(std::span<T, N> elements, T value) noexcept
{
    return computed_stream<attribute::none>(elements,
                                            [value](const surface_point<attribute::none>&) noexcept { return value; });
}

}  // namespace typemesh::inline TYPEMESH_ABI
