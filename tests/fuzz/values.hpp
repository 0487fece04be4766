// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

/// Fuzz targets: each is a function that makes input from a few bytes, runs stages of the library, and returns the first
/// broken law, or "". fuzzer.cpp makes a libFuzzer target of it, replay.hpp a test.
namespace fuzz {

/// Reads numbers from the front of some bytes. After the last byte everything is 0, so that every input has a meaning,
/// and a shorter input a similar one.
class values {
public:
    explicit values(std::span<const std::uint8_t> bytes) noexcept : rest_{bytes} {}

    [[nodiscard]] bool empty() const noexcept { return rest_.empty(); }
    std::uint32_t byte() noexcept
    {
        if (rest_.empty()) return 0;
        const std::uint32_t b = rest_.front();
        rest_ = rest_.subspan(1);
        return b;
    }
    bool flag() noexcept { return (byte() & 1u) != 0; }

    /// `count` bytes, 4 at most, the lowest first.
    std::uint32_t bits(unsigned count) noexcept
    {
        std::uint32_t sum = 0;
        for (unsigned i = 0; i < count; ++i) sum |= byte() << 8 * i;
        return sum;
    }
    /// 0 to bound - 1, from as few bytes as possible.
    std::uint32_t below(std::uint32_t bound) noexcept
    {
        const unsigned count = bound <= 0x100 ? 1 : bound <= 0x1'0000 ? 2 : bound <= 0x100'0000 ? 3 : 4;
        return bits(count) % bound;
    }
    /// low to high, from two bytes: both ends included.
    double between(double low, double high) noexcept { return low + (high - low) * (bits(2) / 65535.0); }

    template <class T, std::size_t n>
    const T& one_of(const T (&all)[n]) noexcept
    {
        return all[below(static_cast<std::uint32_t>(n))];
    }

private:
    std::span<const std::uint8_t> rest_;
};

/// What a target returns.
using broken_law = std::string;

}  // namespace fuzz
