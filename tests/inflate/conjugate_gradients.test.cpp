// SPDX-License-Identifier: MIT

#include <typemesh/inflate/impl/conjugate_gradients.hpp>

#include "random_matrix.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;

TEST_CASE("conjugate gradients solve random systems, and say when the steps do not suffice", "[inflate]")
{
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        const inflating::random_matrix a{seed};
        detail::conjugate_gradients stepwise;
        REQUIRE(stepwise.open(a.view()));
        std::vector<double> u(a.load.size());
        const int steps = stepwise.solve(a.load.data(), u.data(), 1e-10, 1000);
        CHECK(steps <= static_cast<int>(a.load.size()));
        CHECK(a.residual(u) < 1e-8);
        if (steps < 2) continue;
        CHECK(stepwise.solve(a.load.data(), u.data(), 1e-10, steps - 1) == steps);
        CHECK(stepwise.solve(a.load.data(), u.data(), 1e-10, steps) == steps);
    }
}

TEST_CASE("conjugate gradients without memory say so, and ask for none once they are warm", "[inflate]")
{
    const inflating::random_matrix a{1};
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        detail::conjugate_gradients stepwise{memory.source()};
        const bool done = stepwise.open(a.view());
        was_asked = memory.requests >= nth;
        CHECK(done != was_asked);
        memory.fail_at = 0;
        REQUIRE(stepwise.open(a.view()));
        const std::size_t warm = memory.requests;
        REQUIRE(stepwise.open(a.view()));
        CHECK(memory.requests == warm);
    }
}
