// SPDX-License-Identifier: MIT
#pragma once

// Work whose memory fails at each of its requests.

#include "support/catch.hpp"
#include "support/counting_memory.hpp"

#include <typemesh/core/error.hpp>

#include <cstddef>

namespace test {

/// Calls use(memory) with a memory whose first request fails and all later ones, then all from the second on, and so on up
/// to a memory that suffices. `use` must return error::out_of_memory each time but the last, and hold nothing when it is
/// done. Returns how many requests it needs.
template <class Use>
std::size_t check_each_failure(const Use& use)
{
    for (std::size_t at = 1;; ++at) {
        counting_memory failing{.fail_at = at};
        const typemesh::error e = use(failing.source());
        CHECK(failing.bytes_held == 0);
        if (failing.requests < at) {
            CHECK_FALSE(e);
            return at - 1;
        }
        REQUIRE(e == typemesh::error::out_of_memory);
    }
}

}  // namespace test
