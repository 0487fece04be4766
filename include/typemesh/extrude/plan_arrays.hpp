// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace typemesh::inline TYPEMESH_ABI {

namespace detail {

template <class T>
struct growing_array {
    buffer<T> values;
};

template <class T>
struct read_array {
    array_view<const T> values;
};

[[nodiscard]] constexpr std::size_t rounded_up_to_8(std::size_t bytes) noexcept
{
    return (bytes + 7) & ~std::size_t{7};
}

/// Stores an array as bytes, and moves `block` behind it, to a multiple of 8 bytes.
template <class T>
void store_array(array_view<const T> array, std::byte*& block) noexcept
{
    if (!array.empty()) std::memcpy(block, array.data(), array.size_bytes());
    block += rounded_up_to_8(array.size_bytes());
}
/// The array that store_array() has stored, and moves `block` behind it.
template <class T>
[[nodiscard]] array_view<const T> stored_array(std::uint64_t count, const std::byte*& block) noexcept
{
    const T *first = reinterpret_cast<const T*>(block), *last = first + count;
    const array_view<const T> array{first, static_cast<std::size_t>(last - first)};
    block += rounded_up_to_8(array.size_bytes());
    return array;
}

template <class T, class... Values>
inline constexpr int times_among = (0 + ... + int{std::same_as<T, Values>});

/// The plan data of an extruder that has none.
struct no_plan_data {
    struct view {};

    explicit no_plan_data(memory = {}) noexcept {}
    void clear() noexcept {}
    [[nodiscard]] view read() const noexcept { return {}; }
    [[nodiscard]] std::size_t bytes() const noexcept { return 0; }
    void copy_to(std::byte*) const noexcept {}
    [[nodiscard]] static view read_from(const std::byte*) noexcept { return {}; }
};

template <class E>
struct plan_data {
    using type = no_plan_data;
};
template <class E>
    requires requires { typename E::plan_data; }
struct plan_data<E> {
    using type = typename E::plan_data;
};

}  // namespace detail

/// The results of an extruder's plan() that writing needs: one array for each of several types.
///
///     using plan_data = plan_arrays<side_point, grid_point, triangle>;     in the extruder
///     data.of<grid_point>()       in plan(): a buffer, empty at first
///     s.data.of<grid_point>()     when it writes: a span of the values that plan() left there
///
/// The arrays are stored in the glyph's single block, where they are copied as bytes. The types must therefore be plain
/// values that refer to nothing outside, with an alignment of at most 8. For two arrays of one type, wrap one type in a
/// struct.
template <class... Values>
class plan_arrays : detail::growing_array<Values>... {
    static_assert(sizeof...(Values) != 0, "typemesh: plan_arrays need a type; without plan data, declare no plan_data");
    static_assert((std::is_trivially_copyable_v<Values> && ...),
                  "typemesh: plan_arrays are copied as bytes, so they hold trivially copyable types");
    static_assert(((alignof(Values) <= 8) && ...), "typemesh: plan_arrays hold types of an alignment of at most 8");
    static_assert(((detail::times_among<Values, Values...> == 1) && ...),
                  "typemesh: plan_arrays have one array of each type; give a second one a struct of its own");

public:
    /// Read access to the arrays, wherever they are stored.
    class view : detail::read_array<Values>... {
        friend class plan_arrays;

    public:
        template <class T>
        [[nodiscard]] array_view<const T> of() const noexcept
        {
            static_assert(detail::times_among<T, Values...> == 1,
                          "typemesh: these plan_arrays have no array of this type");
            return detail::read_array<T>::values;
        }
        /// The number of bytes that copy_to() writes for these arrays; a multiple of 8.
        [[nodiscard]] std::size_t bytes() const noexcept
        {
            return (std::size_t{0} + ... +
                    (8 + detail::rounded_up_to_8(detail::read_array<Values>::values.size_bytes())));
        }
    };

    explicit plan_arrays(memory source = heap()) noexcept : detail::growing_array<Values>{buffer<Values>{source}}... {}

    template <class T>
    [[nodiscard]] buffer<T>& of() noexcept
    {
        static_assert(detail::times_among<T, Values...> == 1, "typemesh: these plan_arrays have no array of this type");
        return detail::growing_array<T>::values;
    }

    /// Empties all arrays; their storage is kept.
    void clear() noexcept { (detail::growing_array<Values>::values.clear(), ...); }

    /// The arrays as they are now; growth invalidates the view.
    [[nodiscard]] view read() const noexcept
    {
        view all;
        ((static_cast<detail::read_array<Values>&>(all).values = detail::growing_array<Values>::values.view()), ...);
        return all;
    }

    // --- as bytes: for the storage of a glyph

    /// The number of bytes that copy_to() writes; a multiple of 8.
    [[nodiscard]] std::size_t bytes() const noexcept { return read().bytes(); }

    ///     block   [ count | values, up to a multiple of 8 bytes ][ count | ... ] ...        aligned to 8
    void copy_to(std::byte* block) const noexcept { (copy(detail::growing_array<Values>::values.view(), block), ...); }

    /// The arrays in a block that copy_to() wrote.
    [[nodiscard]] static view read_from(const std::byte* block) noexcept
    {
        view all;
        (find(static_cast<detail::read_array<Values>&>(all).values, block), ...);
        return all;
    }

private:
    template <class T>
    static void copy(array_view<const T> array, std::byte*& block) noexcept
    {
        const std::uint64_t count = array.size();
        std::memcpy(block, &count, 8);
        block += 8;
        detail::store_array(array, block);
    }

    template <class T>
    static void find(array_view<const T>& array, const std::byte*& block) noexcept
    {
        std::uint64_t count = 0;
        std::memcpy(&count, block, 8);
        block += 8;
        array = detail::stored_array<T>(count, block);
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI
