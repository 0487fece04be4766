// SPDX-License-Identifier: MIT

// Must not compile: an error was true when something was wrong, and calls returned one.

#include <typemesh/typemesh.hpp>

#include <cstdint>
#include <span>

using namespace typemesh;

bool written(const text_mesher<>::plan_type& plan, std::span<vec3> vertices, std::span<std::uint32_t> indices)
{
    const auto place = [](const surface_point<attribute::position>& s) noexcept { return s.position; };
    if (error e = plan.write(into(vertices, indices, place))) return false;
    return true;
}
