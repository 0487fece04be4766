// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Sorts values in place, without <algorithm>, which takes longer to compile than most of the rest. It is not stable.
///
///     before    before(a, b): whether a must come before b
///
/// Cost   O(n log n)
template <class Value, class Before>
void heap_sort(Value* values, std::size_t n, const Before& before) noexcept
{
    const auto sink = [values, &before](std::size_t root, std::size_t size) noexcept {
        const Value moved = values[root];
        for (std::size_t child = 2 * root + 1; child < size; child = 2 * root + 1) {
            if (child + 1 < size && before(values[child], values[child + 1])) ++child;
            if (!before(moved, values[child])) break;
            values[root] = values[child];
            root = child;
        }
        values[root] = moved;
    };
    for (std::size_t i = n / 2; i-- != 0;) sink(i, n);
    for (std::size_t size = n; size-- > 1;) {
        const Value last = values[size];
        values[size] = values[0];
        values[0] = last;
        sink(0, size);
    }
}

/// The same for keys with a member before().
template <class Key>
void heap_sort(Key* keys, std::size_t n) noexcept
{
    heap_sort(keys, n, [](const Key& a, const Key& b) noexcept { return a.before(b); });
}

}  // namespace typemesh::inline TYPEMESH_ABI::detail
