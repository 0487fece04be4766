// SPDX-License-Identifier: MIT

#include <typemesh/vertex/mesh_sink.hpp>

#include <cstdint>

#include "support/catch.hpp"

using namespace typemesh;

namespace {

struct nowhere {
    static constexpr auto wants = attribute::none;
    int ends = 0;
    error begin(mesh_size) noexcept { return {}; }
    void vertex(const surface_point<wants>&) noexcept {}
    void triangle(std::uint32_t, std::uint32_t, std::uint32_t) noexcept {}
};
struct quiet : nowhere {
    void end() noexcept { ++ends; }
};
struct with_error : nowhere {
    error what = {};
    error end() noexcept { return ++ends, what; }
};
struct counts : nowhere {
    int end() noexcept { return ++ends; }
};

}  // namespace

static_assert(mesh_sink<quiet> && mesh_sink<with_error> && !mesh_sink<counts> && !mesh_sink<nowhere>);

TEST_CASE("a sink ends once, and returns its error if it has one", "[vertex]")
{
    quiet silent;
    CHECK_FALSE(end_of(silent));
    CHECK(silent.ends == 1);
    with_error loud;
    CHECK_FALSE(end_of(loud));
    loud.what = error::not_written;
    CHECK(end_of(loud) == error::not_written);
    CHECK(loud.ends == 2);
}
