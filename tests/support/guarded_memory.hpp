// SPDX-License-Identifier: MIT
#pragma once

// Memory that ends where a page ends, the next page being closed: one byte too many and the test program stops. Where
// the system has no such pages, canaries stand in, which the destructor looks at.

#include "support/catch.hpp"

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <span>
#include <vector>

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace test {

class guarded_memory {
public:
#if __has_include(<sys/mman.h>)
    explicit guarded_memory(std::size_t bytes) : size_{bytes}
    {
        const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        mapped_ = (bytes + page - 1) / page * page + page;
        base_ = mmap(nullptr, mapped_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
        if (base_ == MAP_FAILED) std::abort();
        if (mprotect(static_cast<std::byte*>(base_) + mapped_ - page, page, PROT_NONE) != 0) std::abort();
        first_ = static_cast<std::byte*>(base_) + mapped_ - page - bytes;
        std::memset(first_, 0xEE, bytes);
    }
    ~guarded_memory() { munmap(base_, mapped_); }

    /// From now on writing is forbidden as well, to the whole pages that hold the memory.
    void forbid_writing() { mprotect(base_, mapped_ - static_cast<std::size_t>(sysconf(_SC_PAGESIZE)), PROT_READ); }
#else
    explicit guarded_memory(std::size_t bytes) : size_{bytes}, held_(bytes + 128, std::byte{0xEE})
    {
        first_ = held_.data() + 64;
    }
    ~guarded_memory()
    {
        for (std::size_t i = 0; i < 64; ++i)
            if (held_[i] != std::byte{0xEE} || held_[size_ + 64 + i] != std::byte{0xEE}) std::abort();
    }
    void forbid_writing() {}
#endif
    guarded_memory(const guarded_memory&) = delete;
    guarded_memory& operator=(const guarded_memory&) = delete;

    [[nodiscard]] std::span<std::byte> bytes() const { return {first_, size_}; }
    template <class T>
    [[nodiscard]] std::span<T> as() const
    {
        return {reinterpret_cast<T*>(first_), size_ / sizeof(T)};
    }
    [[nodiscard]] bool untouched() const
    {
        for (std::size_t i = 0; i < size_; ++i)
            if (first_[i] != std::byte{0xEE}) return false;
        return true;
    }

private:
    std::size_t size_;
    std::byte* first_ = nullptr;
#if __has_include(<sys/mman.h>)
    void* base_ = nullptr;
    std::size_t mapped_ = 0;
#else
    std::vector<std::byte> held_;
#endif
};

}  // namespace test
