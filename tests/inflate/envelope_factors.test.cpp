// SPDX-License-Identifier: MIT

#include <typemesh/inflate/impl/conjugate_gradients.hpp>
#include <typemesh/inflate/impl/envelope_factors.hpp>

#include "random_matrix.hpp"
#include "support/counting_memory.hpp"

using namespace typemesh;

TEST_CASE("envelope factors solve random systems, also in parts that are not connected", "[inflate]")
{
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        const inflating::random_matrix a{seed};
        detail::envelope_factors direct;
        REQUIRE(direct.order(a.view()));
        std::vector<double> u(a.load.size());
        REQUIRE(direct.solve(a.view(), a.load.data(), u.data()));
        CHECK(a.residual(u) < 1e-12);
        for (const double value : u) CHECK(value > 0.0);
    }
}

TEST_CASE("the work on a strip grows with its length, however its unknowns are numbered", "[inflate]")
{
    const auto work_on = [](std::size_t length, std::uint64_t seed) {
        detail::envelope_factors direct;
        const inflating::random_matrix a = inflating::random_matrix::strip(length, 5, seed);
        REQUIRE(direct.order(a.view()));
        return direct.work();
    };
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        const double one = work_on(100, seed);
        CHECK(one < 100 * 5 * 0.5 * 11 * 11);  // rows of at most two levels of 5
        CHECK(work_on(400, seed) < 4.4 * one);
    }
}

TEST_CASE("envelope factors without memory say so, and ask for none once they are warm", "[inflate]")
{
    const inflating::random_matrix a{1};
    std::vector<double> u(a.load.size());
    bool was_asked = true;
    for (std::size_t nth = 1; was_asked; ++nth) {
        test::counting_memory memory{.fail_at = nth, .fail_once = true};
        detail::envelope_factors direct{memory.source()};
        const bool done = direct.order(a.view()) && direct.solve(a.view(), a.load.data(), u.data());
        was_asked = memory.requests >= nth;
        CHECK(done != was_asked);
        memory.fail_at = 0;
        REQUIRE((direct.order(a.view()) && direct.solve(a.view(), a.load.data(), u.data())));
        const std::size_t warm = memory.requests;
        REQUIRE((direct.order(a.view()) && direct.solve(a.view(), a.load.data(), u.data())));
        CHECK(memory.requests == warm);
    }
}
