// SPDX-License-Identifier: MIT
#pragma once

// Counts every operator new of a program: plain, array, nothrow, and aligned, which typemesh::heap() calls. Include it in
// one source file of the program. (C's malloc is not counted, because font libraries written in C use it.)

#include <typemesh/core/memory.hpp>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace test {

inline std::atomic<std::size_t> allocations{0};  ///< so far, by the whole program

namespace detail {

inline void* counted(std::size_t bytes) noexcept
{
    ++allocations;
    return std::malloc(bytes == 0 ? 1 : bytes);
}

/// The start of the block is stored just before the returned pointer.
inline void* counted(std::size_t bytes, std::align_val_t wanted) noexcept
{
    const auto alignment = static_cast<std::size_t>(wanted);
    void* raw = counted(bytes + alignment + sizeof(void*));
    if (raw == nullptr) return nullptr;
    const auto first = reinterpret_cast<std::uintptr_t>(raw) + sizeof(void*) + alignment - 1;
    void** aligned = reinterpret_cast<void**>(first / alignment * alignment);
    aligned[-1] = raw;
    return aligned;
}

inline void free_aligned(void* block) noexcept
{
    if (block != nullptr) std::free(static_cast<void**>(block)[-1]);
}

inline void* or_die(void* block) noexcept
{
    if (block == nullptr) std::abort();
    return block;
}

}  // namespace detail

/// Whether a block of typemesh::heap() of every alignment counts, and a plain one. Otherwise a count of 0 means nothing.
inline bool every_allocation_counts() noexcept
{
    const typemesh::memory heap = typemesh::heap();
    const std::size_t before = allocations;
    std::size_t asked = 0;
    for (std::size_t alignment = 1; alignment <= 4096; alignment *= 2, ++asked) {
        void* block = heap.allocate(heap.user, 100, alignment);
        if (block == nullptr || reinterpret_cast<std::uintptr_t>(block) % alignment != 0) return false;
        heap.deallocate(heap.user, block, 100, alignment);
    }
    void* (*volatile ask)(std::size_t) = &::operator new;  // a call that no compiler leaves out
    void (*volatile give_back)(void*) = &::operator delete;
    give_back(ask(100));
    return allocations - before == asked + 1;
}

}  // namespace test

void* operator new(std::size_t n) { return test::detail::or_die(test::detail::counted(n)); }
void* operator new[](std::size_t n) { return test::detail::or_die(test::detail::counted(n)); }
void* operator new(std::size_t n, const std::nothrow_t&) noexcept { return test::detail::counted(n); }
void* operator new[](std::size_t n, const std::nothrow_t&) noexcept { return test::detail::counted(n); }
void* operator new(std::size_t n, std::align_val_t a) { return test::detail::or_die(test::detail::counted(n, a)); }
void* operator new[](std::size_t n, std::align_val_t a) { return test::detail::or_die(test::detail::counted(n, a)); }
void* operator new(std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept
{
    return test::detail::counted(n, a);
}
void* operator new[](std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept
{
    return test::detail::counted(n, a);
}
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { test::detail::free_aligned(p); }
void operator delete[](void* p, std::align_val_t) noexcept { test::detail::free_aligned(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { test::detail::free_aligned(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { test::detail::free_aligned(p); }
void operator delete(void* p, std::align_val_t, const std::nothrow_t&) noexcept { test::detail::free_aligned(p); }
void operator delete[](void* p, std::align_val_t, const std::nothrow_t&) noexcept { test::detail::free_aligned(p); }
