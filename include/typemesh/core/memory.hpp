// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/version.hpp>

#include <cstddef>
#include <new>

namespace typemesh::inline TYPEMESH_ABI {

/// The source of scratch memory: three pointers, so that no container and no signature needs an allocator parameter.
///
/// `allocate` returns at least `bytes` bytes aligned to `alignment` (a power of two), or null. After null, the call
/// that needed the bytes fails with error::out_of_memory and leaves all objects usable. `deallocate` gets the size and
/// alignment that were passed to `allocate`. Only one thread at a time uses a memory source, unless its author allows
/// several threads.
struct memory {
    void* user = nullptr;  ///< passed to both functions
    void* (*allocate)(void* user, std::size_t bytes, std::size_t alignment) noexcept = nullptr;
    void (*deallocate)(void* user, void* block, std::size_t bytes, std::size_t alignment) noexcept = nullptr;
};

/// The C++ heap, without exceptions.
[[nodiscard]] inline memory heap() noexcept
{
    return {nullptr,
            [](void*, std::size_t bytes, std::size_t alignment) noexcept -> void* {
                return ::operator new(bytes, std::align_val_t{alignment}, std::nothrow);
            },
            [](void*, void* block, std::size_t, std::size_t alignment) noexcept {
                ::operator delete(block, std::align_val_t{alignment});
            }};
}

}  // namespace typemesh::inline TYPEMESH_ABI
