// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/array_view.hpp>
#include <typemesh/core/buffer.hpp>

#include <cstddef>
#include <cstdint>

namespace typemesh::inline TYPEMESH_ABI {

/// Finds values in a table that belongs to someone else, who may change it: a value that has been changed there may be
/// found no more, but none is found that is not there.
///
///     Value      with == and hash_of(value), which is equal for equal ones
///
/// A table with open addressing, at most half full.
template <class Value>
class value_index {
public:
    explicit value_index(memory source = heap()) noexcept : slots_{source} {}

    void clear() noexcept
    {
        slots_.clear();
        known_ = used_ = 0;
    }

    /// The number of a value that equals this one, among those that have been read; table.size() if there is none.
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

    /// Takes note of the values at the table's end that are new to it. Returns false when memory runs out; it then
    /// knows none.
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

    /// Empties the slots and makes room for twice as many values as these.
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

    buffer<std::uint32_t> slots_;  // number + 1, or 0: free
    std::size_t known_ = 0;        // values of the table that have been read
    std::size_t used_ = 0;         // slots; some may be of values that the table has lost
};

}  // namespace typemesh::inline TYPEMESH_ABI
