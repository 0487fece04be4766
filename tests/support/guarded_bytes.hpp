// SPDX-License-Identifier: MIT
#pragma once

#include "support/guarded_memory.hpp"

#include <cstddef>
#include <cstring>
#include <span>

namespace test {

/// Bytes that end at a page that must not be touched. It also detects whether anything was written to them.
class guarded_bytes {
public:
    explicit guarded_bytes(std::size_t count) : memory_{count, true} { std::memset(bytes().data(), 0xEE, count); }

    [[nodiscard]] std::span<std::byte> bytes() const { return memory_.elements(); }
    template <class T>
    [[nodiscard]] std::span<T> as() const
    {
        return {reinterpret_cast<T*>(bytes().data()), bytes().size() / sizeof(T)};
    }
    [[nodiscard]] bool untouched() const
    {
        for (const std::byte b : bytes())
            if (b != std::byte{0xEE}) return false;
        return true;
    }

private:
    guarded_memory<std::byte> memory_;
};

}  // namespace test
