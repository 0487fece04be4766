// SPDX-License-Identifier: MIT
#pragma once

#include "support/catch.hpp"
#include "support/counting_memory.hpp"
#include "support/written_mesh.hpp"

#include <cstddef>

namespace test {

/// Builds a text with memory that fails at each request in turn, once or from then on: the error says so, nothing of the
/// caller's is touched, and the same mesher can build the text afterwards. make(memory) returns what builds into a mesh.
/// Returns how many times it failed.
template <class Mesh>
std::size_t failures_of(const auto& make, const Mesh& expected, bool once, std::size_t first_request = 1)
{
    std::size_t failures = 0;
    for (std::size_t n = first_request; n < 1000; ++n) {
        counting_memory counted{.fail_at = n, .fail_once = once};
        auto build = make(counted.source());
        Mesh m{{{}, {}}, {7}};
        const auto made = build(m);
        if (!made) {
            ++failures;
            CHECK(made.error() == typemesh::error::out_of_memory);
            CHECK(m.vertices.size() == 2);
            CHECK(m.indices.size() == 1);
        } else
            CHECK(made->complete());
        counted.fail_at = 0;
        REQUIRE(build(m));
        if constexpr (requires { m == expected; })
            CHECK(m == expected);
        else
            CHECK(same_bits(m, expected));
        if (counted.requests < n) break;
    }
    return failures;
}

}  // namespace test
