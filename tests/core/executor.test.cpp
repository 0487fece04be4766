// SPDX-License-Identifier: MIT
#include "support/catch.hpp"

#include <typemesh/core/executor.hpp>

#include <numeric>
#include <vector>

using namespace typemesh;

namespace {

struct no_count {
    template <class Task>
    void run(std::size_t, const Task&) noexcept;
};
struct may_throw {
    std::size_t workers() const noexcept;
    template <class Task>
    void run(std::size_t, const Task&);
};

}  // namespace

static_assert(executor<one_worker> && executor<const one_worker>);
static_assert(!executor<no_count> && !executor<may_throw> && !executor<int>);

TEST_CASE("one worker does every task once, in order, as worker 0", "[executor]")
{
    for (const std::size_t n : {0u, 1u, 7u}) {
        std::vector<std::size_t> done, expected(n);
        std::iota(expected.begin(), expected.end(), std::size_t{0});
        one_worker{}.run(n, [&](std::size_t i, std::size_t worker) noexcept {
            CHECK(worker == 0);
            done.push_back(i);
        });
        CHECK(done == expected);
    }
}
