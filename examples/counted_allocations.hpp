// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>

// Counts what a program requests from the C++ heap, to show that frames request nothing. typemesh requests aligned memory.
inline std::size_t allocations = 0;

void* operator new(std::size_t bytes)
{
    ++allocations;
    if (void* block = std::malloc(bytes)) return block;
    std::abort();
}
void* operator new(std::size_t bytes, std::align_val_t alignment, const std::nothrow_t&) noexcept
{
    ++allocations;
    const auto size = static_cast<std::size_t>(alignment);
    return std::aligned_alloc(size, (bytes + size - 1) / size * size);
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, std::align_val_t) noexcept { std::free(block); }
