// SPDX-License-Identifier: MIT

// A sink whose end() fails: the error reaches the caller of the function that wrote.

#include <typemesh/typemesh.hpp>

#include <cstdint>

#include "support/catch.hpp"
#include "support/executors.hpp"
#include "support/toy_runs.hpp"

using namespace typemesh;

namespace {

/// Takes everything, and stores nothing.
struct full_disk {
    static constexpr auto wants = attribute::position;
    int* ends;

    error begin(mesh_size) noexcept { return {}; }
    error begin_chunks(mesh_size, std::uint32_t) noexcept { return {}; }
    [[nodiscard]] full_disk subrange(mesh_range) const noexcept { return *this; }
    void vertex(const surface_point<wants>&) noexcept {}
    void triangle(std::uint32_t, std::uint32_t, std::uint32_t) noexcept {}
    error end() noexcept { return ++*ends, error::not_written; }
};
static_assert(chunked_sink<full_disk>);

/// A type that end() may not return.
struct tells_by_number : full_disk {
    int end() noexcept { return 0; }
};
static_assert(!mesh_sink<tells_by_number>);

}  // namespace

TEST_CASE("an error at a sink's end is returned by every function that writes", "[stranger]")
{
    test::toy_font font;
    text_mesher mesher{font};
    const text_options options;
    int ends = 0;
    full_disk sink{&ends};
    CHECK(mesher.build("oE", sink, options).error() == error::not_written);

    test::scrambled_workers workers;
    auto team = test::toy_team(workers);
    CHECK(mesher.build("oE", sink, options, *team).error() == error::not_written);

    const auto plan = mesher.plan("oE");
    REQUIRE(plan);
    CHECK(plan->write(sink) == error::not_written);
    CHECK(plan->write(sink, workers) == error::not_written);
    CHECK(plan->write(glyph_span{0, 1}, sink) == error::not_written);
    CHECK(plan->write_meshes(sink) == error::not_written);

    text_chunks chunks;
    for (const std::uint32_t most : {65'535u, 20u}) {
        REQUIRE(chunks.cut(*plan, most));
        ends = 0;
        CHECK(chunks.write(*plan, sink) == error::not_written);
        CHECK(chunks.write(*plan, sink, workers) == error::not_written);
        CHECK(chunks.write(*plan, 0, sink) == error::not_written);
        CHECK(ends == 3);
    }
}
