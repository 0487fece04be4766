// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// A set of unordered pairs of paths; a path may be paired with itself. Add all pairs, then call close().
///
/// Memory is for twice the number of different pairs at most, however often each is added.
class path_pairs {
public:
    explicit path_pairs(memory source = heap()) noexcept : keys_{source} {}

    void clear() noexcept
    {
        keys_.clear();
        tidy_at_ = first_tidy;
    }
    /// False if out of memory. O(log n) on average.
    [[nodiscard]] bool add(std::uint32_t a, std::uint32_t b) noexcept
    {
        const std::uint64_t key = key_of(a, b);
        if (!keys_.empty() && keys_.back() == key) return true;
        if (keys_.size() >= tidy_at_) {
            close();
            tidy_at_ = keys_.size() < first_tidy / 2 ? first_tidy : 2 * keys_.size();
        }
        return keys_.push_back(key);
    }
    void close() noexcept
    {
        std::sort(keys_.begin(), keys_.end());
        keys_.truncate(static_cast<std::size_t>(std::unique(keys_.begin(), keys_.end()) - keys_.begin()));
    }
    /// Makes this an equal set. False if out of memory.
    [[nodiscard]] bool assign(const path_pairs& other) noexcept
    {
        keys_.clear();
        return keys_.append(other.keys_.view());
    }

    [[nodiscard]] bool empty() const noexcept { return keys_.empty(); }
    [[nodiscard]] std::size_t size() const noexcept { return keys_.size(); }
    /// O(log n)
    [[nodiscard]] bool has(std::uint32_t a, std::uint32_t b) const noexcept
    {
        return std::binary_search(keys_.begin(), keys_.end(), key_of(a, b));
    }
    /// Calls found(a, b), a <= b, for each pair, in ascending order.
    template <class Found>
    void each(Found&& found) const noexcept
    {
        for (const std::uint64_t k : keys_) found(static_cast<std::uint32_t>(k >> 32), static_cast<std::uint32_t>(k));
    }

private:
    static constexpr std::size_t first_tidy = 64;

    [[nodiscard]] static std::uint64_t key_of(std::uint32_t a, std::uint32_t b) noexcept
    {
        return a < b ? std::uint64_t{a} << 32 | b : std::uint64_t{b} << 32 | a;
    }

    buffer<std::uint64_t> keys_;
    std::size_t tidy_at_ = first_tidy;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
