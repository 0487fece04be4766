// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Finds values in a table that it does not own and that may change. A value that was changed there may not be found
/// any more, but a value that is not in the table is never found.
///
///     Value      with == and hash_of(value); equal values have equal hashes
///
/// The index is a hash table with open addressing, at most half full.
template <class Value>
class value_index {
public:
    explicit value_index(memory source = heap()) noexcept : slots_{source} {}

    void clear() noexcept
    {
        slots_.clear();
        known_ = used_ = 0;
    }

    /// The number of an equal value, among the values that have been read; table.size() if there is none.
    ///
    /// Cost  O(1) on average
    [[nodiscard]] std::size_t find(array_view<const Value> table, const Value& value) const noexcept
    {
        if (slots_.empty()) return table.size();
        const std::size_t mask = slots_.size() - 1;
        for (std::size_t at = place_of(value, mask); slots_[at] != 0; at = (at + 1) & mask) {
            const std::size_t number = slots_[at] - 1;
            if (number < table.size() && table[number] == value) return number;
        }
        return table.size();
    }

    /// Adds the values at the table's end that are new to the index. Returns false when out of memory, and is then
    /// empty.
    ///
    /// Cost  O(new values), on average over many calls
    [[nodiscard]] bool read(array_view<const Value> table) noexcept
    {
        if (known_ > table.size()) known_ = table.size();
        const std::size_t fresh = table.size() - known_;
        if (2 * (used_ + fresh) > slots_.size() && !grow(table.size())) {
            clear();
            return false;
        }
        for (; known_ < table.size(); ++known_) add(table[known_]);
        return true;
    }

private:
    [[nodiscard]] static std::size_t place_of(const Value& value, std::size_t mask) noexcept
    {
        return static_cast<std::size_t>(hash_of(value)) & mask;
    }

    void add(const Value& value) noexcept
    {
        const std::size_t mask = slots_.size() - 1;
        std::size_t at = place_of(value, mask);
        while (slots_[at] != 0) at = (at + 1) & mask;
        slots_[at] = static_cast<std::uint32_t>(known_ + 1);
        ++used_;
    }

    /// Empties the slots and reserves space for twice `values`.
    [[nodiscard]] bool grow(std::size_t values) noexcept
    {
        std::size_t wanted = 64;
        while (wanted < 4 * values) wanted *= 2;
        slots_.clear();
        std::uint32_t* all = slots_.append(wanted);
        if (all == nullptr) return false;
        for (std::size_t i = 0; i < wanted; ++i) all[i] = 0;
        known_ = used_ = 0;
        return true;
    }

    buffer<std::uint32_t> slots_;  // number + 1; 0: free
    std::size_t known_ = 0;        // values of the table that have been read
    std::size_t used_ = 0;         // used slots; some may belong to values that the table has lost
};

}  // namespace typemesh::inline TYPEMESH_ABI
