// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/buffer.hpp>
#include <typemesh/core/memory.hpp>
#include <typemesh/offset/impl/collapse.hpp>

#include <cstddef>

namespace typemesh::inline TYPEMESH_ABI::detail {

/// Collapses, the next one first: a binary heap.
class collapse_queue {
public:
    explicit collapse_queue(memory source) noexcept : heap_{source} {}

    [[nodiscard]] bool reserve(std::size_t size) noexcept { return heap_.reserve(size); }
    [[nodiscard]] bool empty() const noexcept { return heap_.empty(); }
    [[nodiscard]] const collapse& first() const noexcept { return heap_[0]; }

    /// False if out of memory.
    [[nodiscard]] bool push(const collapse& c) noexcept
    {
        if (!heap_.push_back(c)) return false;
        std::size_t i = heap_.size() - 1;
        for (; i != 0 && c < heap_[(i - 1) / 2]; i = (i - 1) / 2) heap_[i] = heap_[(i - 1) / 2];
        heap_[i] = c;
        return true;
    }

    collapse pop() noexcept
    {
        const collapse top = heap_[0], last = heap_.back();
        heap_.truncate(heap_.size() - 1);
        const std::size_t size = heap_.size();
        std::size_t i = 0;
        for (std::size_t child = 1; child < size; child = 2 * i + 1) {
            if (child + 1 < size && heap_[child + 1] < heap_[child]) ++child;
            if (!(heap_[child] < last)) break;
            heap_[i] = heap_[child];
            i = child;
        }
        if (size != 0) heap_[i] = last;
        return top;
    }

private:
    buffer<collapse> heap_;
};

}  // namespace typemesh::inline TYPEMESH_ABI::detail
