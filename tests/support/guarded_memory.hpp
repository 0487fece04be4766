// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>

#ifdef _WIN32
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#else
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace test {

/// An array between two inaccessible pages: a write one byte too far ends the program.
///
///     | no access | elements .......... rest | no access |      at_end: the rest comes first
template <class T>
class guarded_memory {
public:
    guarded_memory(std::size_t count, bool at_end) : count_{count}
    {
        const std::size_t page = page_size(), bytes = count * sizeof(T), middle = (bytes + page - 1) / page * page;
        length_ = middle + 2 * page;
        base_ = reserve(length_);
        if (base_ == nullptr || !open(base_ + page, middle)) throw std::runtime_error("no memory for a guarded array");
        first_ = reinterpret_cast<T*>(base_ + page + (at_end ? middle - bytes : 0));
    }
    guarded_memory(const guarded_memory&) = delete;
    guarded_memory& operator=(const guarded_memory&) = delete;
    ~guarded_memory() { release(); }

    [[nodiscard]] std::span<T> elements() const { return {first_, count_}; }

private:
#ifdef _WIN32
    static std::size_t page_size()
    {
        SYSTEM_INFO info;
        GetSystemInfo(&info);
        return info.dwPageSize;
    }
    static std::byte* reserve(std::size_t bytes)
    {
        return static_cast<std::byte*>(VirtualAlloc(nullptr, bytes, MEM_RESERVE, PAGE_NOACCESS));
    }
    static bool open(std::byte* at, std::size_t bytes)
    {
        return VirtualAlloc(at, bytes, MEM_COMMIT, PAGE_READWRITE) != nullptr;
    }
    void release() { VirtualFree(base_, 0, MEM_RELEASE); }
#else
    static std::size_t page_size() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }
    static std::byte* reserve(std::size_t bytes)
    {
        void* at = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        return at == MAP_FAILED ? nullptr : static_cast<std::byte*>(at);
    }
    static bool open(std::byte* at, std::size_t bytes) { return mprotect(at, bytes, PROT_READ | PROT_WRITE) == 0; }
    void release() { munmap(base_, length_); }
#endif

    std::byte* base_ = nullptr;
    std::size_t length_ = 0;
    T* first_ = nullptr;
    std::size_t count_ = 0;
};

}  // namespace test
