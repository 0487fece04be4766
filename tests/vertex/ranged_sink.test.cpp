// SPDX-License-Identifier: MIT
#include "refusals.hpp"
#include "support/catch.hpp"

#include <typemesh/vertex/growing_sink.hpp>
#include <typemesh/vertex/ranged_sink.hpp>
#include <typemesh/vertex/stream_sink.hpp>

#include <memory>
#include <vector>

using namespace typemesh;

namespace {

struct position_writer {
    static constexpr auto wants = attribute::position;
    vec3 operator()(const surface_point<wants>& s) const noexcept { return s.position; }
};

/// A writer with state that cannot be copied.
struct owning_writer : position_writer {
    std::unique_ptr<int> own;
};

/// A file: what has been written is gone.
struct tape {
    static constexpr auto wants = attribute::position;
    error begin(mesh_size) noexcept { return {}; }
    void vertex(const surface_point<wants>&) noexcept {}
    void triangle(std::uint32_t, std::uint32_t, std::uint32_t) noexcept {}
    void end() noexcept {}
};

using array = array_sink<vec3, std::uint16_t, position_writer>;
using growing = growing_sink<std::vector<vec3>, std::vector<std::uint16_t>, position_writer>;
using streams = stream_sink<std::uint16_t, stream<attribute::position, vec3>, stream<attribute::uv, vec2>>;

}  // namespace

static_assert(chunked_sink<array> && chunked_sink<growing> && chunked_sink<streams>);
static_assert(mesh_sink<tape> && !ranged_sink<tape>);
static_assert(mesh_sink<array_sink<vec3, std::uint16_t, owning_writer>> &&
              !ranged_sink<array_sink<vec3, std::uint16_t, owning_writer>>);

TEST_CASE("subranges that are written backwards make the same mesh, and nothing else is written", "[vertex][ranged]")
{
    std::vector<vec3> vertices(12, vec3{-1, -1, -1});
    std::vector<std::uint16_t> indices(14, 999);
    array sink{std::span{vertices}.subspan(1, 10), std::span{indices}.subspan(1, 12), position_writer{}, 100u};
    REQUIRE_FALSE(sink.begin({10, 4}));
    for (const std::uint32_t k : {1u, 0u}) {
        auto piece = sink.subrange({5 * k, 5, 6 * k, 6});
        for (std::uint32_t i = 0; i < 5; ++i) {
            surface_point<attribute::position> s;
            s.position.x = static_cast<float>(5 * k + i);
            piece.vertex(s);
        }
        for (std::uint32_t i = 0; i < 2; ++i) piece.triangle(2 * k + i, 8, 9);
    }
    sink.end();
    CHECK(vertices.front() == vec3{-1, -1, -1});
    CHECK(vertices.back() == vec3{-1, -1, -1});
    for (std::uint32_t i = 0; i < 10; ++i) CHECK(vertices[i + 1].x == static_cast<float>(i));
    CHECK(indices == std::vector<std::uint16_t>{999, 100, 108, 109, 101, 108, 109, 102, 108, 109, 103, 108, 109, 999});
}

TEST_CASE("an index type must number the largest chunk, not all of them", "[vertex][ranged]")
{
    std::vector<vec3> vertices(1000);
    std::vector<std::uint8_t> indices(30);
    array_sink<vec3, std::uint8_t, position_writer> sink{vertices, indices, {}, 55u};
    CHECK(sink.begin({1000, 10}) == error::index_overflow);
    CHECK_FALSE(sink.begin_chunks({1000, 10}, 200));
    test::check_refused(sink.begin_chunks({1000, 10}, 201), error::index_overflow, 256);
    CHECK(sink.begin_chunks({1001, 10}, 3) == error::buffer_too_small);
    CHECK(sink.begin_chunks({1000, 11}, 3) == error::buffer_too_small);
}
