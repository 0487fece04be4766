// SPDX-License-Identifier: MIT

// Every operator new of this program is counted here.

#include "support/catch.hpp"
#include "support/mesh_laws.hpp"
#include "support/toy_font.hpp"

#include <typemesh/typemesh.hpp>

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

using namespace typemesh;

namespace {

std::atomic<std::size_t> allocations{0};

void* counted(std::size_t bytes) noexcept
{
    ++allocations;
    return std::malloc(bytes == 0 ? 1 : bytes);
}

/// The block's own begin is kept before what is handed out.
void* counted(std::size_t bytes, std::align_val_t wanted) noexcept
{
    const auto alignment = static_cast<std::size_t>(wanted);
    void* raw = counted(bytes + alignment + sizeof(void*));
    if (raw == nullptr) return nullptr;
    const auto first = reinterpret_cast<std::uintptr_t>(raw) + sizeof(void*) + alignment - 1;
    void** aligned = reinterpret_cast<void**>(first / alignment * alignment);
    aligned[-1] = raw;
    return aligned;
}

void free_aligned(void* block) noexcept
{
    if (block != nullptr) std::free(static_cast<void**>(block)[-1]);
}

void* or_die(void* block) noexcept
{
    if (block == nullptr) std::abort();
    return block;
}

}  // namespace

void* operator new(std::size_t n) { return or_die(counted(n)); }
void* operator new[](std::size_t n) { return or_die(counted(n)); }
void* operator new(std::size_t n, const std::nothrow_t&) noexcept { return counted(n); }
void* operator new[](std::size_t n, const std::nothrow_t&) noexcept { return counted(n); }
void* operator new(std::size_t n, std::align_val_t a) { return or_die(counted(n, a)); }
void* operator new[](std::size_t n, std::align_val_t a) { return or_die(counted(n, a)); }
void* operator new(std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept { return counted(n, a); }
void* operator new[](std::size_t n, std::align_val_t a, const std::nothrow_t&) noexcept { return counted(n, a); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }
void operator delete(void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete[](void* p, const std::nothrow_t&) noexcept { std::free(p); }
void operator delete(void* p, std::align_val_t) noexcept { free_aligned(p); }
void operator delete[](void* p, std::align_val_t) noexcept { free_aligned(p); }
void operator delete(void* p, std::size_t, std::align_val_t) noexcept { free_aligned(p); }
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept { free_aligned(p); }
void operator delete(void* p, std::align_val_t, const std::nothrow_t&) noexcept { free_aligned(p); }
void operator delete[](void* p, std::align_val_t, const std::nothrow_t&) noexcept { free_aligned(p); }

TEST_CASE("after warm-up a text asks nobody for memory, in any layout of the output", "[text]")
{
    test::toy_font font;
    glyph_cache cache;
    const auto asked_by = [&](auto mesher, const text_options& options) {
        std::vector<test::full_vertex> vertices;
        std::vector<std::uint32_t> indices;
        std::vector<std::uint16_t> short_indices;
        std::vector<vec3> positions;
        std::vector<vec2> uvs;
        std::size_t before = 0;
        for (int i = 0; i < 4; ++i) {
            if (i == 2) before = allocations;
            auto plan = mesher.plan("oEi x~o\noEq", options);
            if (!plan) std::abort();
            if (i == 0) {
                vertices.resize(plan->size().vertices);
                positions.resize(vertices.size());
                uvs.resize(vertices.size());
                indices.resize(plan->size().indices());
                short_indices.resize(indices.size());
            }
            stream_sink streams{std::span{short_indices}, stream<attribute::position, vec3>{std::span{positions}},
                                stream<attribute::uv, vec2>{std::span{uvs}}};
            bool failed = false;
            failed |= bool(plan->write(into(std::span{vertices}, std::span{indices})));
            failed |= bool(plan->write(into(std::span{vertices}, std::span{short_indices})));
            failed |= bool(plan->write(into(vertices, indices)));
            failed |= bool(plan->write(streams));
            failed |= bool(plan->write(glyph_span{1, 2}, streams));
            failed |= bool(plan->write_meshes(into(std::span{vertices}, std::span{indices})));
            plan->write_instances([&](const glyph_instance&) noexcept {});
            if (failed) std::abort();
        }
        return allocations - before;
    };
    for (const bool reuse : {true, false}) {
        for (const auto over : {texture_box::text, texture_box::line}) {
            const text_options options{.texture_over = over, .reuse = reuse};
            CHECK(asked_by(text_mesher{font}, options) == 0);
            CHECK(asked_by(text_mesher{font}.with(flat{}).with(constrained_delaunay{}), options) == 0);
            CHECK(asked_by(text_mesher{font}.with(extruded<shared_normals>{}), options) == 0);
            CHECK(asked_by(text_mesher{font}.with(cached_in{cache, 1}), options) == 0);
        }
    }
}
