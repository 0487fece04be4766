// SPDX-License-Identifier: MIT
//
// Every layout, twice warmed up, then counted: what the library takes from its memory source, and what anybody takes
// from operator new, aligned or not, while a plan is made and written.

#include "engines/stand_in/d3d11.hpp"
#include "engines/stand_in/d3d9.hpp"
#include "engines/stand_in/eigen.hpp"
#include "engines/stand_in/gl.hpp"
#include "engines/stand_in/godot.hpp"
#include "engines/stand_in/unreal.hpp"
#include "engines/stand_in/vulkan.hpp"

#include "engines/direct3d11.hpp"
#include "engines/direct3d9.hpp"
#include "engines/eigen.hpp"
#include "engines/gltf.hpp"
#include "engines/godot.hpp"
#include "engines/opengl.hpp"
#include "engines/three.hpp"
#include "engines/unity.hpp"
#include "engines/unreal.hpp"
#include "engines/vulkan.hpp"

#include <typemesh/vertex/octahedral.hpp>
#include <typemesh/vertex/octahedral_tangent.hpp>

#include "recipe_laws.hpp"
#include "support/counted_allocations.hpp"

using namespace recipes;

namespace {

/// Memory enough for any layout of the word.
struct room {
    std::vector<std::byte> a{4'000'000}, b{4'000'000}, c{4'000'000};
    [[nodiscard]] std::span<float> floats(std::size_t first, std::size_t count)
    {
        return {reinterpret_cast<float*>(a.data()) + first, count};
    }
    template <class T>
    [[nodiscard]] std::span<T> vertices()
    {
        return {reinterpret_cast<T*>(a.data()), a.size() / sizeof(T)};
    }
    template <class T>
    [[nodiscard]] std::span<T> indices()
    {
        return {reinterpret_cast<T*>(b.data()), b.size() / sizeof(T)};
    }
};

/// Into memory of the caller's: nothing is taken from anywhere.
template <class Write>
void takes_nothing(bench& b, const text_options& o, Write write)
{
    needs_no_memory_again(b, o, [&](const auto& plan) {
        const std::size_t before = test::allocations;
        const result<void> written = write(plan);
        CHECK(test::allocations == before);
        return written.error();
    });
}

}  // namespace

TEST_CASE("the counter counts every block of the heap", "[engines]") { CHECK(test::every_allocation_counts()); }

TEST_CASE("a real font's text is planned and written without operator new after warm-up", "[engines]")
{
    auto font = harfbuzz_font::open(font_file("truetype/dejavu/DejaVuSans.ttf").c_str());
    REQUIRE(font);
    text_mesher mesher{*font};  // over the heap, which is where a user's memory comes from
    room r;
    const auto made = [&] {
        auto plan = mesher.plan(word);
        return plan && plan->write(into(r.vertices<engines::opengl::vertex>(), r.indices<std::uint32_t>())).has_value();
    };
    bool warm = made();
    warm = made() && warm;
    const std::size_t before = test::allocations;
    const bool again = made();
    const std::size_t asked = test::allocations - before;
    CHECK(warm);
    CHECK(again);
    CHECK(asked == 0);
}

TEST_CASE("every layout takes only the caller's memory", "[engines]")
{
    bench b;
    room r;
    IDirect3DVertexBuffer9 vertices9{std::vector<std::uint8_t>(2'000'000)};
    IDirect3DIndexBuffer9 indices9{D3DFMT_INDEX16, std::vector<std::uint8_t>(2'000'000)};
    takes_nothing(b, engines::direct3d9::options(),
                  [&](const auto& plan) { return engines::direct3d9::fill(plan, vertices9, indices9); });
    takes_nothing(b, engines::direct3d11::options(), [&](const auto& plan) {
        using namespace engines::direct3d11;
        if (const auto done = fill<vertex>(plan, r.a.data(), r.a.size(), r.b.data(), r.b.size(), DXGI_FORMAT_R16_UINT);
            !done)
            return done;
        return fill<packed_vertex>(plan, r.a.data(), r.a.size(), r.b.data(), r.b.size(), DXGI_FORMAT_R32_UINT);
    });
    takes_nothing(b, engines::opengl::options(), [&](const auto& plan) {
        return plan.write(into(r.vertices<engines::opengl::vertex>(), r.indices<std::uint16_t>(), 100));
    });
    takes_nothing(b, engines::vulkan::options(), [&](const auto& plan) {
        engines::vulkan::room buffers{r.a, r.b};
        return buffers.add(plan).error();
    });
    takes_nothing(b, engines::unity::options(), [&](const auto& plan) {
        if (const auto done = engines::unity::write(plan, {r.a, r.c, r.b, true}); !done) return done;
        return engines::unity::write(plan, {r.a, r.c, r.b, false});
    });
    takes_nothing(b, engines::three::options(), [&](const auto& plan) {
        return engines::three::write(
            plan, engines::three::buffer_geometry<>{r.floats(0, 100'000), r.floats(100'000, 100'000),
                                                    r.floats(200'000, 200'000), r.floats(400'000, 100'000),
                                                    r.indices<std::uint32_t>()});
    });
    takes_nothing(b, engines::gltf::options(), [&](const auto& plan) {
        using namespace engines::gltf;
        if (const auto done = write_buffer(plan, engines::gltf::layout::plain, {}, std::span<std::byte>{r.a},
                                           r.indices<std::uint16_t>());
            !done)
            return done;
        return write_buffer(plan, engines::gltf::layout::quantised, {}, std::span<std::byte>{r.a},
                            r.indices<std::uint32_t>());
    });
}

TEST_CASE("every attribute and every packed format is written without allocations", "[engines]")
{
    bench b;
    room r;
    takes_nothing(b, {}, [&](const auto& plan) {
        const std::span<std::byte> bytes{r.a};
        return plan.write(stream_sink{
            r.indices<std::uint32_t>(), 7, stream<attribute::position, vec3>::in(bytes, 0, 80),
            stream<attribute::normal, octahedral32>::in(bytes, 12, 80),
            stream<attribute::normal, octahedral16>::in(bytes, 16, 80),
            stream<attribute::tangent, octahedral_tangent32>::in(bytes, 20, 80),
            stream<attribute::normal, snorm10>::in(bytes, 24, 80), stream<attribute::uv, vec2>::in(bytes, 28, 80),
            stream<attribute::glyph, std::uint32_t>::in(bytes, 36, 80),
            stream<attribute::cluster, std::uint32_t>::in(bytes, 40, 80),
            stream<attribute::part, std::uint32_t>::in(bytes, 44, 80),
            computed_stream<attribute::none, rgba8>(bytes, 48, 80,
                                                    [](const auto&) noexcept { return rgba8{1, 0, 0}; })});
    });
}

TEST_CASE("a recipe that fills an engine's containers allocates nothing else", "[engines]")
{
    bench b;
    FStaticMeshVertexBuffers buffers;
    TArray<std::uint32_t> indices;
    needs_no_memory_again(b, engines::unreal::options(100.0), [&](const auto& plan) {
        if (const auto done = engines::unreal::write(plan, buffers, indices); !done)
            return done.error();  // sizes them, the first time
        const std::size_t before = test::allocations;
        const error e = engines::unreal::write(plan, buffers, indices).error();
        CHECK(test::allocations == before);
        return e;
    });
    Eigen::Matrix3Xf places, normals;
    Eigen::Matrix3Xi triangles;
    needs_no_memory_again(b, engines::eigen::options(), [&](const auto& plan) {
        return engines::eigen::write(plan, places, normals, triangles).error();
    });
    needs_no_memory_again(b, engines::godot_mesh::options(), [&](const auto& plan) {
        ::godot::Array arrays;
        return engines::godot_mesh::write(plan, arrays);
    });
    std::vector<std::byte> file;
    needs_no_memory_again(b, engines::gltf::options(), [&](const auto& plan) {
        return engines::gltf::write(plan, engines::gltf::layout::quantised, file);
    });
}
