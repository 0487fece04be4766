// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/layout/impl/text_cluster.hpp>

using namespace typemesh;

TEST_CASE("flags of a cluster join and are found again", "[paragraph]")
{
    constexpr cluster_flags all[] = {cluster_flags::unsafe, cluster_flags::hangs,  cluster_flags::stretches,
                                     cluster_flags::tab,    cluster_flags::silent, cluster_flags::spaced,
                                     cluster_flags::foreign};
    for (const cluster_flags a : all)
        for (const cluster_flags b : all) {
            CHECK(has(a | b, a));
            CHECK(has(a | b, b));
            CHECK(has(a, b) == (a == b));
        }
}
