// SPDX-License-Identifier: MIT
//
// A long text, built on all processors, cut into meshes that 16-bit indices can number. An executor of your own job
// system serves as well as thread_pool: see typemesh/core/executor.hpp.
//
//     07_workers_and_chunks FONT

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/adapt/threads.hpp>
#include <typemesh/typemesh.hpp>

#include <cstdio>
#include <string>
#include <vector>

struct vertex {
    float position[3], normal[3], uv[2];
};
template <>
struct typemesh::vertex_traits<vertex> {
    static constexpr auto wants = attribute::position | attribute::normal | attribute::uv;
    vertex operator()(const surface_point<wants>& s) const noexcept
    {
        return {{s.position.x, s.position.y, s.position.z}, {s.normal.x, s.normal.y, s.normal.z}, {s.uv.x, s.uv.y}};
    }
};

int main(int argc, char** argv)
{
    using namespace typemesh;
    if (argc < 2) return std::puts("usage: 07_workers_and_chunks FONT"), 2;
    auto font = harfbuzz_font::open(argv[1]);
    if (!font) return std::puts(font.error().message()), 1;

    std::string text;
    for (int i = 0; i < 1000; ++i) text += "Line " + std::to_string(i) + " of a long text\n";

    thread_pool pool;  // each worker needs a font of its own: here, a view of the one that was opened
    auto workers = workers_of(pool, [&](std::size_t) noexcept { return harfbuzz_font::wrap(font->handle()); });
    if (!workers) return std::puts(workers.error().message()), 1;

    text_mesher mesher{*font};
    auto plan = mesher.plan(text, {.tolerance = quality::low}, *workers);
    if (!plan) return std::puts(plan.error().message()), 1;

    text_chunks chunks;
    if (const auto written = chunks.cut(*plan); !written) return std::puts(written.error().message()), 1;
    std::vector<vertex> vertices(chunks.size().vertices);
    std::vector<std::uint16_t> indices(chunks.size().indices());
    if (const auto written = chunks.write(*plan, into(std::span{vertices}, std::span{indices}), pool); !written)
        return std::puts(written.error().message()), 1;

    std::printf("%zu vertices in %zu chunks by %zu workers\n", vertices.size(), chunks.view().size(), pool.workers());
    for (const text_chunk& c : chunks.view()) {
        const mesh_range r = c.range();
        std::printf("    draw %u indices from %u on, base vertex %u\n", r.index_count, r.first_index, r.first_vertex);
    }
}
