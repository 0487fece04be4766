// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/workspace.hpp>

#include <cstddef>
#include <cstring>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// An array of plain values in scratch memory that grows by doubling; what it grew out of stays taken until the scope
/// ends.
template <class T>
struct growing {
    workspace::scope& scratch;
    T* values = nullptr;
    std::size_t count = 0;
    std::size_t room = 0;

    explicit growing(workspace::scope& from) noexcept : scratch{from} {}

    /// False when there is no memory; then it is as it was.
    [[nodiscard]] bool add(const T& value) noexcept
    {
        if (count == room && !reserve(room == 0 ? 256 : 2 * room)) return false;
        values[count++] = value;
        return true;
    }

    /// Room for `more` values, at least as many as there are. False when there is no memory; then it is as it was.
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
