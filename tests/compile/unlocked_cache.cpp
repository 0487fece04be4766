// SPDX-License-Identifier: MIT

// A cache without a lock cannot serve several workers. The message must say what to write.

#include <typemesh/typemesh.hpp>

struct pair_of_workers {
    static std::size_t workers() noexcept { return 2; }
    template <class Task>
    void run(std::size_t n, const Task& task) noexcept
    {
        for (std::size_t i = 0; i < n; ++i) task(i, i % 2);
    }
};
using drawings = typemesh::transformed_outlines<const typemesh::recorded_outlines>;

bool plan(typemesh::recorded_outlines& font, const typemesh::glyph_run& run, typemesh::glyph_cache<>& cache,
          typemesh::glyph_workers<pair_of_workers, drawings>& team)
{
    auto mesher = typemesh::text_mesher{font}.with(typemesh::cached_in{cache, 1});
    return static_cast<bool>(mesher.plan(run, {}, team));
}
