// SPDX-License-Identifier: MIT
//
// Several workers, and large texts: extruded, curve normals, texture coordinates, 1/800 em, 32-byte vertices, 32-bit
// indices, no glyph cache, buffers and scratch memory warm.
//
//     cold/10000      10,000 different characters of a Chinese font, shaped, built and written
//     large/C         C characters of Latin text (quality::low), each different one built once, all written
//
// "speedup" is the time of one worker by that of all, rounds taken in turns, the best of each; "cpu" the same by
// processor time (1: sharing the work costs nothing), which holds on a busy machine too; "in_order" is the share of one
// worker's time that is not shared out. "memory" is the most that the mesher ever held, and mesher and workers, by the
// size of the output; "each" is one worker's processor time for one character.
//
//     bench_threads [WORKERS | --rows]     fonts are looked for under $TYPEMESH_FONT_DIR (default /usr/share/fonts); rows as
//                                          README.md has them, of two workers

#include "full_vertex.hpp"

#include <typemesh/adapt/harfbuzz.hpp>
#include <typemesh/adapt/threads.hpp>
#include <typemesh/typemesh.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <string>
#include <vector>

namespace {

using namespace typemesh;
using vertex = bench::full_vertex;

struct timing {
    double wall = 1e30, cpu = 1e30;

    void keep_best(const timing& t)
    {
        wall = std::min(wall, t.wall);
        cpu = std::min(cpu, t.cpu);
    }
};

timing time_of(auto&& work)
{
    using clock = std::chrono::steady_clock;
    const std::clock_t cpu = std::clock();  // of all threads
    const auto wall = clock::now();
    work();
    return {std::chrono::duration<double>(clock::now() - wall).count(),
            static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC};
}

/// The heap, with the bytes that are held, and the most that ever were.
struct counted_heap {
    std::atomic<std::size_t> held{0}, most{0};

    memory source() noexcept
    {
        return {this,
                [](void* user, std::size_t bytes, std::size_t alignment) noexcept {
                    auto& self = *static_cast<counted_heap*>(user);
                    const std::size_t now = self.held += bytes;
                    std::size_t seen = self.most;
                    while (now > seen && !self.most.compare_exchange_weak(seen, now)) {
                    }
                    return heap().allocate(nullptr, bytes, alignment);
                },
                [](void* user, void* block, std::size_t bytes, std::size_t alignment) noexcept {
                    static_cast<counted_heap*>(user)->held -= bytes;
                    heap().deallocate(nullptr, block, bytes, alignment);
                }};
    }
};

/// An executor that would have two workers, and measures how long they would be at work.
struct watched_worker {
    double seconds = 0.0;

    [[nodiscard]] static std::size_t workers() noexcept { return 2; }
    template <class Task>
    void run(std::size_t n, const Task& task) noexcept
    {
        seconds += time_of([&] { one_worker{}.run(n, task); }).cpu;
    }
};

std::string path_of(const char* font)
{
    const char* folder = std::getenv("TYPEMESH_FONT_DIR");
    return std::string{folder != nullptr ? folder : "/usr/share/fonts"} + "/" + font;
}

bool rows = false;

void measure(const std::string& name, harfbuzz_font& font, const auto& text, std::size_t characters, double tolerance,
             std::size_t workers, int rounds)
{
    const text_options options{.tolerance = tolerance};
    const auto clone = [&](std::size_t) noexcept { return harfbuzz_font::wrap(font.handle()); };
    counted_heap memory_of_one, memory_of_many;
    text_mesher alone{font, memory_of_one.source()}, mesher{font, memory_of_many.source()};
    thread_pool pool{workers};
    auto team = workers_of(pool, clone, memory_of_many.source());
    std::vector<vertex> vertices, others;
    std::vector<std::uint32_t> indices, other_indices;
    const auto by_one = [&] {
        if (!alone.build(text, into(vertices, indices), options)) std::abort();
    };
    const auto by_many = [&] {
        if (!mesher.build(text, into(others, other_indices), options, *team)) std::abort();
    };
    if (!team) std::abort();
    by_one();
    by_many();
    if (indices != other_indices) std::abort();
    timing one, many;
    for (int i = 0; i < rounds; ++i) {
        one.keep_best(time_of(by_one));
        many.keep_best(time_of(by_many));
    }
    watched_worker watched;
    auto watched_team = workers_of(watched, clone);
    double all = time_of([&] { (void)alone.build(text, into(vertices, indices), options, *watched_team); }).cpu;
    watched.seconds = 0.0;
    all = time_of([&] { (void)alone.build(text, into(vertices, indices), options, *watched_team); }).cpu;

    const double output = static_cast<double>(vertices.size() * sizeof(vertex) + indices.size() * 4);
    if (rows) {
        const auto row = [&name](const char* counter, double value) {
            std::printf("kernel\tbench_threads\t%s\t%s\t%.3g\n", name.c_str(), counter, value);
        };
        row("speedup", one.wall / many.wall);
        row("speedup_cpu", one.cpu / many.cpu);
        row("in_order", 1.0 - watched.seconds / all);
        row("memory_of_one", static_cast<double>(memory_of_one.most) / output);
        return row("memory_of_all", static_cast<double>(memory_of_many.most) / output);
    }
    std::printf(
        "%-18s %2zu workers  one %8.1f ms wall %8.1f cpu   all %8.1f wall %8.1f cpu   speedup %.2f  cpu %.2f  "
        "in_order %.3f  each %7.0f ns  %8.1f MB  memory %.2f, %.2f\n",
        name.c_str(), pool.workers(), 1e3 * one.wall, 1e3 * one.cpu, 1e3 * many.wall, 1e3 * many.cpu,
        one.wall / many.wall, one.cpu / many.cpu, 1.0 - watched.seconds / all,
        1e9 * one.cpu / static_cast<double>(characters), output / 1e6, static_cast<double>(memory_of_one.most) / output,
        static_cast<double>(memory_of_many.most) / output);
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv)
{
    rows = argc > 1 && std::strcmp(argv[1], "--rows") == 0;
    const std::size_t workers = argc > 1 && !rows ? std::strtoul(argv[1], nullptr, 10) : 2;
    if (auto font = harfbuzz_font::open(path_of("truetype/wqy/wqy-microhei.ttc").c_str())) {
        std::u16string text;
        for (char16_t i = 0; i < 10'000; ++i) {
            text += static_cast<char16_t>(0x4E00 + i);
            if (i % 100 == 99) text += u'\n';
        }
        measure("cold/10000", *font, text, 10'000, quality::high, workers, 7);
    } else {
        std::fprintf(stderr, "left out: %s (Debian package fonts-wqy-microhei)\n", font.error().message());
    }
    if (auto font = harfbuzz_font::open(path_of("truetype/liberation/LiberationSans-Regular.ttf").c_str())) {
        std::ifstream in{TYPEMESH_TEST_DATA "/workload/long-latin.txt"};
        std::string line, text;
        std::getline(in, line);
        for (const std::size_t characters : {1'000u, 10'000u, 100'000u}) {
            while (text.size() < characters) text += line.substr(0, characters - text.size()) + '\n';
            text.resize(characters);
            measure("large/" + std::to_string(characters), *font, text, characters, quality::low, workers, 7);
        }
    } else {
        std::fprintf(stderr, "left out: %s (Debian package fonts-liberation)\n", font.error().message());
    }
}
