// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// An array of plain values in scratch memory that grows by doubling. Outgrown storage stays taken until the scope
/// ends.
template <class T>
struct growing {
    workspace::scope& scratch;
    T* values = nullptr;
    std::size_t count = 0;
    std::size_t room = 0;

    explicit growing(workspace::scope& from) noexcept : scratch{from} {}

    /// False if out of memory; then nothing has changed.
    [[nodiscard]] bool add(const T& value) noexcept
    {
        if (count == room && !reserve(room == 0 ? 256 : 2 * room)) return false;
        values[count++] = value;
        return true;
    }

    /// Enlarges the capacity to `more` values, at least the present count. False if out of memory, as in add().
    [[nodiscard]] bool reserve(std::size_t more) noexcept
    {
        T* const larger = scratch.take<T>(more);
        if (larger == nullptr) return false;
        if (count != 0) std::memcpy(static_cast<void*>(larger), values, count * sizeof(T));
        values = larger;
        room = more;
        return true;
    }
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
