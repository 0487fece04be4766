// SPDX-License-Identifier: MIT
#include "support/catch.hpp"
#include "support/executors.hpp"

#include <typemesh/core/impl/executor_ref.hpp>

#include <vector>

using namespace typemesh;

TEST_CASE("an executor runs the same tasks through its reference as directly", "[executor]")
{
    test::scrambled_workers several{3};
    for (const std::size_t n : {0u, 1u, 100u}) {
        const executor_ref refers{several};
        CHECK(refers.workers() == 3);
        std::vector<int> done(n);
        bool known = true;
        refers.run(n, [&](std::size_t i, std::size_t worker) noexcept {
            ++done[i];
            known = known && worker < 3;
        });
        CHECK(known);
        for (const int times : done) CHECK(times == 1);
    }
    one_worker single;
    CHECK(executor_ref{single}.workers() == 1);
}
