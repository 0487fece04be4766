// SPDX-License-Identifier: MIT
#pragma once

#include <typemesh/core/executor.hpp>

#include <cstddef>
#include <cstdint>

namespace test {

/// Several workers without threads: tasks come in an unlikely order, each to the next worker.
struct scrambled_workers {
    std::size_t count = 3;
    std::uint32_t seed = 1;

    [[nodiscard]] std::size_t workers() const noexcept { return count; }

    template <class Task>
    void run(std::size_t n, const Task& task) noexcept
    {
        if (n == 0) return;
        // A step that has no divisor in common with n reaches each task once.
        std::size_t step = seed = seed * 1664525u + 1013904223u;
        const auto common = [](std::size_t a, std::size_t b) {
            while (b != 0) a %= b, std::swap(a, b);
            return a;
        };
        while (common(step, n) != 1) ++step;
        std::size_t i = seed % n;
        for (std::size_t k = 0; k < n; ++k, i = (i + step) % n) task(i, k % count);
    }
};
static_assert(typemesh::executor<scrambled_workers>);

}  // namespace test
