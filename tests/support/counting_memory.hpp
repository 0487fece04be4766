// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/memory.hpp>

#include <cstddef>

namespace test {

/// The heap, counted, failing on request.
struct counting_memory {
    std::size_t requests = 0;
    std::size_t bytes_held = 0;
    std::size_t fail_at = 0;  ///< from this request on (counted from 1) all fail; 0: never fails
    bool fail_once = false;   ///< only that one request fails
    std::size_t peak = 0;     ///< the most bytes that were held at a time

    [[nodiscard]] typemesh::memory source() noexcept
    {
        return {this,
                [](void* user, std::size_t bytes, std::size_t alignment) noexcept -> void* {
                    auto& self = *static_cast<counting_memory*>(user);
                    ++self.requests;
                    if (self.fail_at != 0 &&
                        (self.fail_once ? self.requests == self.fail_at : self.requests >= self.fail_at))
                        return nullptr;
                    self.bytes_held += bytes;
                    if (self.bytes_held > self.peak) self.peak = self.bytes_held;
                    const typemesh::memory heap = typemesh::heap();
                    return heap.allocate(heap.user, bytes, alignment);
                },
                [](void* user, void* block, std::size_t bytes, std::size_t alignment) noexcept {
                    static_cast<counting_memory*>(user)->bytes_held -= bytes;
                    const typemesh::memory heap = typemesh::heap();
                    heap.deallocate(heap.user, block, bytes, alignment);
                }};
    }
};

}  // namespace test
